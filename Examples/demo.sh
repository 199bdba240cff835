#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Denoises a surface with the ParaView plugin, on a bare Debian 12 (as root or with sudo):
#
#   bash Examples/demo.sh                                     a real model that gets noise
#   bash Examples/demo.sh scan.ply --method "Guided normal"   your own: PLY OBJ STL OFF VTP VTK
#
# Options are those of Examples/Python/demo.py; --help lists them. What is missing is installed, and
# the plugin is built once, in build-paraview. Results go to $OUT, by default ./out.

# shellcheck source=Examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh" || exit 1

surface=
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  surface=$1
  shift
  [ -f "$surface" ] || fail "there is no file $surface"
fi
prepare

if [ -n "$surface" ]; then
  arguments=("$surface")
else
  fetch_fandisk || fail "cannot get the model"
  # Noise in all directions distorts triangles, which the Tukey filter evens out again.
  arguments=(--truth "$fandisk" --method "Tukey, wide then narrow" "${fandisk_view[@]}")
fi

echo "-- denoising ${surface:-$fandisk}"
run_script demo.py "${arguments[@]}" "$@" || exit 1
