#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Denoises a surface or a point cloud with the ParaView plugin, on a bare Debian 12 (as root or with
# sudo):
#
#   bash Examples/demo.sh                                     a real model that gets noise
#   bash Examples/demo.sh --points                            the same, its points alone
#   bash Examples/demo.sh scan.ply --method "Guided normal"   your own: PLY OBJ STL OFF VTP VTK
#   bash Examples/demo.sh scan.xyz                            a cloud: also XYZ XYZN PTS ASC
#
# Options are those of Examples/Python/demo.py; --help lists them. What is missing is installed, and
# the plugin is built once, in build-paraview. Results go to $OUT, by default ./out. $MODEL is
# another model than fandisk, one of CGAL's meshes such as bunny00.

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
  fetch_model || fail "cannot get the model"
  arguments=(--truth "$truth" "${view[@]}")
  # Noise in all directions distorts triangles, which the Tukey filter evens out again.
  [[ " $* " == *" --points "* ]] || arguments+=(--method "Tukey, wide then narrow")
fi

echo "-- denoising ${surface:-$truth}"
run_script demo.py "${arguments[@]}" "$@" || exit 1
