#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the experiments of the survey "Surface Denoising based on Normal Filtering in a Robust
# Statistics Framework" anew, on a bare Debian 12 (as root or with sudo):
#
#   bash Examples/Survey/survey.sh                              on Debian's models, with our noise
#   bash Examples/Survey/survey.sh --fandisk NOISY TRUTH --nicola NOISY TRUTH
#
# Either model may be given alone; --help lists the options. What is missing is installed, and the
# plugin is built once, in build-paraview. Results go to $OUT, by default ./out/survey.

OUT=${OUT:-out/survey}
# shellcheck source=Examples/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh" || exit 1
show_help Survey/survey "$@"
options=("$@")
prepare

arguments=()
add_model() { # <name of the option> <model> <argument>...: Debian's model, unless one is given
  local option=$1 model=$2 truth=$out/$2.off
  shift 2
  ! has_option "$option" || return 0
  fetch_model
  arguments+=("$option" "$truth" "$@")
}
add_model --fandisk fandisk --fandisk-view 1 -1.6 -0.9 --fandisk-up 0 0 -1
add_model --nicola bunny00 --nicola-view 0.4 0.5 1 --nicola-up 0 1 0

echo "-- repeating the survey"
run_script Survey/survey "${arguments[@]}" "${options[@]}" || exit 1
