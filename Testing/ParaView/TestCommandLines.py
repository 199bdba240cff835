# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of the examples say how they are called before they install, build or fetch anything,
and so they refuse what they cannot read."""

import os
import subprocess

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples")


def run(script, *arguments):
    """Exit code and output. Nothing can be written, so that no script comes as far as building."""
    done = subprocess.run(["bash", os.path.join(EXAMPLES, script + ".sh"), *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                          universal_newlines=True, env={**os.environ, "OUT": "file/out"})
    return done.returncode, done.stdout


open("file", "w").close()
for script, option in (("demo", "--range-scale"), ("compare", "--parameters"),
                       ("Survey/survey", "--nicola")):
    for arguments in (("--help",), ("-h",), ("--output", "none", "--help")):
        code, text = run(script, *arguments)
        assert code == 0 and option in text and "--output" in text, (script, code, text)
        assert "bash Examples/{}.sh".format(script) in text and "$OUT" in text, text
        assert "SPDX" not in text and "\n-- " not in text, text
    code, text = run(script, "--points")
    assert code == 1 and "cannot write to file/out" in text, (script, code, text)

for script in ("demo", "compare"):
    for arguments, complaint in ((("missing.ply",), "there is no file missing.ply"),
                                 (("--method", "robust", "file"), "files come before options: file"),
                                 (("--truth", "file"), "cannot write")):
        code, text = run(script, *arguments)
        assert code == 1 and complaint in text, (script, arguments, code, text)
