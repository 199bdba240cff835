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
benchmark_packages=(libbenchmark-dev libcgal-dev libtbb-dev)

# What is only unpacked goes there.
unpacked=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/surface-denoising

# Debian's plain VTK 9.1 must not be installed beside ParaView's Python, so it is only unpacked.
unpacked_vtk_packages=(libvtk9-dev libvtk9.1 libvtk9.1-qt libvtk9-java vtk9 python3-vtk9)

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "This needs root or sudo: $*" >&2
    return 1
  fi
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

# unpack_packages <folder> <package>...: what is in the packages, below the folder; nothing is installed.
unpack_packages() {
  local folder=$1 package
  shift
  mkdir -p "$folder/packages" || return 1
  # The folder may belong to a user that apt's own download account cannot write for.
  (cd "$folder/packages" && as_root apt-get update -qq &&
    apt-get download -qq -o APT::Sandbox::User=root "$@") || return 1
  for package in "$folder"/packages/*.deb; do
    dpkg -x "$package" "$folder" || return 1
  done
  rm -r "$folder/packages"
}

# fetch_plain_vtk <folder>: unpack VTK 9.1 there, once. Afterwards plain_vtk is its prefix.
fetch_plain_vtk() {
  plain_vtk="$1/usr"
  [ -e "$1/complete" ] && return 0
  echo "-- unpacking VTK 9.1 into $1"
  rm -rf "$1"
  unpack_packages "$1" "${unpacked_vtk_packages[@]}" && touch "$1/complete"
}

# fetch_cgal_data <folder>: the archive of CGAL's models, unpacked there, once, unless Debian has it
# installed (without documentation, as in small images, it does not). Afterwards cgal_data is its name.
fetch_cgal_data() {
  local archive=usr/share/doc/libcgal-dev/data.tar.gz
  cgal_data=/$archive
  [ ! -e "$cgal_data" ] || return 0
  cgal_data=$1/data.tar.gz
  [ ! -e "$cgal_data" ] || return 0
  echo "-- fetching CGAL's models into $1"
  rm -rf "$1"
  unpack_packages "$1" libcgal-demo && mv "$1/$archive" "$cgal_data" && rm -r "${1:?}/usr"
}

# extract_model <name> <file>: one of CGAL's models, whole or not at all.
extract_model() {
  if ! tar -xzf "$cgal_data" -O "data/meshes/$1.off" >"$2.part"; then
    rm -f "$2.part"
    echo "There is no model $1.off in $cgal_data." >&2
    return 1
  fi
  mv "$2.part" "$2"
}
