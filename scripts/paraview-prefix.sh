#!/usr/bin/env bash
# Downloads ParaView's Debian packages and unpacks them into a folder, without installing them: its
# Python package and that of Debian's VTK cannot be installed together. What they depend on comes
# with libvtk9-dev. Does nothing if that folder is there.
#
#   scripts/paraview-prefix.sh [FOLDER]     default: build-paraview/prefix

source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

prefix=${1:-$repository/build-paraview/prefix}
packages=(paraview paraview-dev python3-paraview libqt5help5 libqt5opengl5 libqt5sql5)

if [[ -e $prefix/.complete ]]; then
  echo "ParaView is in $prefix"
  exit
fi

say "Unpacking ParaView into $prefix"
work=$prefix.work
rm -rf "$prefix" "$work"
mkdir -p "$work/packages" "$work/prefix"
if ! apt-cache show "${packages[@]}" >/dev/null 2>&1; then
  refresh_package_lists
fi
download() { (cd "$work/packages" && apt-get -qq -o APT::Sandbox::User=root download "${packages[@]}"); }
if ! download; then # the lists may name versions that are gone
  refresh_package_lists
  download
fi
for package in "$work"/packages/*.deb; do
  dpkg -x "$package" "$work/prefix"
done
rm -r "$work/packages"
touch "$work/prefix/.complete"
mv "$work/prefix" "$prefix"
rmdir "$work"
echo "ParaView is in $prefix"
