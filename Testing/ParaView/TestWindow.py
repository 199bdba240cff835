# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin can be loaded into a window of ParaView that is open already. The window looks at every
file of proxies as soon as it is there, unlike scripts, and ends if the base of a proxy is missing."""

import os
import subprocess

SCRIPT = """
import os
from paraview.simple import LoadPlugin, Sphere
LoadPlugin({plugin!r}, remote=False, ns=globals())
DenoiseSurface(Input=Sphere()).UpdatePipeline()
with open("loaded", "w") as file:
    file.write("yes")
os._exit(0)
"""

config = os.environ.pop("PV_PLUGIN_CONFIG_FILE")  # or the plugin is there before the window
plugin = os.path.join(os.path.dirname(config), "SurfaceDenoising", "SurfaceDenoising.so")
assert os.path.exists(plugin), plugin
with open("load.py", "w") as file:
    file.write(SCRIPT.format(plugin=plugin))
if os.path.exists("loaded"):
    os.remove("loaded")
# Settings of the user are not read.
result = subprocess.run(["paraview", "--dr", "--script=load.py"], timeout=200, check=False,
                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
assert os.path.exists("loaded"), result.stdout[-4000:]
assert result.returncode == 0 and "ERR" not in result.stdout, result.stdout[-4000:]
