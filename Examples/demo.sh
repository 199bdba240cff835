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
# Files come first, then options, which --help lists. A file of your own is given to Denoise Surface,
# which finds the method by itself; the model to "Tukey, wide then narrow", and its points to Robust
# Point Normal. What is missing is installed, and the plugin is built once, in build-paraview. Results
# go to $OUT, by default ./out. $MODEL is another model than fandisk, one of CGAL's meshes such as
# bunny00.

# shellcheck source=Examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh" || exit 1

show_help Python/demo "$@"
take_files 1 "$@"
prepare

arguments=("${files[@]}")
if [ ${#files[@]} -eq 0 ]; then
  # Noise in all directions distorts triangles, which the Tukey filter evens out again.
  method="Tukey, wide then narrow"
  ! has_option --points || method="Robust point normal"
  arguments=(--method "$method")
  if ! has_option --truth; then
    fetch_model
    arguments+=(--truth "$truth" "${view[@]}")
  fi
fi

echo "-- denoising ${files[0]:-a model with noise}"
run_script Python/demo "${arguments[@]}" "${options[@]}" || exit 1
