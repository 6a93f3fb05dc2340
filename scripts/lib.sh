# Shared by the scripts in this folder, which source it. Debian 12 is assumed.

set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

# What a build needs: the compiler, VTK with its Python, and the program's libraries. libopenmpi-dev
# and libdouble-conversion-dev are asked for by VTK's own CMake files, libx11-dev, libgl-dev,
# libglew-dev and libpng-dev by those of its rendering.
build_packages=(
  build-essential cmake
  libvtk9-dev python3-vtk9
  libeigen3-dev libcli11-dev nlohmann-json3-dev
  libopenmpi-dev libdouble-conversion-dev
  libpng-dev libx11-dev libgl-dev libglew-dev)

# What drawing needs: a display of its own, and a software renderer for it.
display_packages=(xvfb xauth libgl1-mesa-dri)

# What the tests need on top.
test_packages=(libgtest-dev python3-numpy)

# What the plugin's icon and help pages need.
plugin_packages=(qtbase5-dev qttools5-dev qttools5-dev-tools qtxmlpatterns5-dev-tools)

say() # message...: one line that stands out, with the seconds since the start
{
  printf '\n== %s (%d s)\n' "$*" "$SECONDS"
}

as_root() # command...
{
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

missing_packages() # package...: prints those that are not installed
{
  local package
  for package in "$@"; do
    if [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) != installed ]]; then
      printf '%s\n' "$package"
    fi
  done
}

refresh_package_lists() # once a run at most
{
  if [[ -z ${package_lists_are_fresh:-} ]]; then
    as_root apt-get update -qq
    package_lists_are_fresh=yes
  fi
}

install_packages() # package...: installs those that are missing
{
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [[ ${#missing[@]} -eq 0 ]]; then
    return
  fi
  say "Installing Debian packages: ${missing[*]}"
  refresh_package_lists
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends "${missing[@]}" \
    </dev/null >/dev/null
}

on_own_display() # command...: runs it under an X server of its own; if it fails, once more
{
  local status=0
  xvfb-run -a -s "-screen 0 1280x1024x24" "$@" || status=$?
  # On a machine just started Xvfb has been seen to abort once, and its client with it.
  if [[ $status -ne 0 ]]; then
    echo "Ended with status $status; trying once more."
    status=0
    xvfb-run -a -s "-screen 0 1280x1024x24" "$@" || status=$?
  fi
  return "$status"
}
