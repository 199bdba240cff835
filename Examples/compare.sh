#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Denoises a surface or a point cloud with every method of the ParaView plugin, on a bare Debian 12
# (as root or with sudo), and makes a table and a picture of the results:
#
#   bash Examples/compare.sh                               a real model that gets noise
#   bash Examples/compare.sh --points                      the same, its points alone
#   bash Examples/compare.sh scan.ply                      your own: PLY OBJ STL OFF VTP VTK
#   bash Examples/compare.sh scan.xyz                      a cloud: also XYZ XYZN PTS ASC
#   bash Examples/compare.sh noisy.ply truth.ply --parameters cad
#
# Files come first, then options, which --help lists. What is missing is installed, and the plugin is
# built once, in build-paraview. Results go to $OUT, by default ./out. $MODEL is another model than
# fandisk, one of CGAL's meshes such as bunny00.

# shellcheck source=Examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh" || exit 1

show_help Python/compare "$@"
take_files 2 "$@"
prepare

arguments=("${files[@]}")
if [ ${#files[@]} -eq 0 ] && ! has_option --truth; then
  fetch_model
  arguments=(--truth "$truth" "${view[@]}")
fi

echo "-- comparing methods on ${files[0]:-a model with noise}"
run_script Python/compare "${arguments[@]}" "${options[@]}" || exit 1
