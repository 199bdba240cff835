# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2034
#
# To be sourced: what Debian 12 needs to build and test the project, and how to get it. The lists
# hold what find_package asks for with the few components that the project names; ParaView's own
# dependencies come with it.

build_packages=(cmake g++ ninja-build libeigen3-dev libnanoflann-dev python3-dev
  libdouble-conversion-dev liblz4-dev liblzma-dev libutfcpp-dev)
paraview_packages=(paraview paraview-dev python3-paraview libopenmpi-dev
  qttools5-dev qtxmlpatterns5-dev-tools)
vtk_packages=(libtbb-dev libjsoncpp-dev)
test_packages=(libgtest-dev libcli11-dev xvfb xauth libgl1-mesa-dri)
benchmark_packages=(libbenchmark-dev libcgal-demo libcgal-dev libtbb-dev)

# Debian's plain VTK 9.1 must not be installed beside ParaView's Python, so it is only unpacked.
unpacked_vtk_packages=(libvtk9-dev libvtk9.1 libvtk9.1-qt libvtk9-java vtk9 python3-vtk9)

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# install_packages <package>...: nothing happens if all are there, not even the network is asked.
install_packages() {
  local missing=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "-- installing ${missing[*]}"
  as_root apt-get update -qq &&
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
      "${missing[@]}" >/dev/null
}

# fetch_plain_vtk <folder>: unpack VTK 9.1 there, once. Afterwards plain_vtk is its prefix.
fetch_plain_vtk() {
  plain_vtk="$1/usr"
  [ -e "$1/complete" ] && return 0
  echo "-- unpacking VTK 9.1 into $1"
  rm -rf "$1" && mkdir -p "$1/packages" || return 1
  # The folder may belong to a user that apt's own download account cannot write for.
  (cd "$1/packages" && as_root apt-get update -qq &&
    apt-get download -qq -o APT::Sandbox::User=root "${unpacked_vtk_packages[@]}") || return 1
  local package
  for package in "$1"/packages/*.deb; do
    dpkg -x "$package" "$1" || return 1
  done
  rm -r "$1/packages"
  touch "$1/complete"
}
