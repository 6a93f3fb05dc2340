#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Uses the plugin in ParaView's window as a user does, by mouse and keys on a virtual display, and
# takes the pictures of the user guide: contour, menu, recovery, preview, points picked, what they
# chose. Needs xvfb, openbox, xdotool, imagemagick and libqt5svg5. Look at the pictures: nothing else
# tells whether all went well.
#
#   tour.sh PARAVIEW-PREFIX PLUGIN-FOLDER PICTURES-FOLDER

set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$1/usr
export PV_PLUGIN_PATH=$2
pictures=$(realpath "$3")
work=$(mktemp -d)
export ARRIS_VOLUME=$here/../../../Data/bracket.mha
export HOME=$work XDG_RUNTIME_DIR=$work PYTHONPATH=$prefix/lib/python3/dist-packages
export DISPLAY=:${ARRIS_DISPLAY:-77} LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
cd "$work"

start() # command...: in the background, ended with this script
{
  "$@" >>log 2>&1 &
  started+=($!)
}
started=()
trap 'kill "${started[@]}" 2>/dev/null || true; sleep 1; rm -rf "$work"' EXIT
start Xvfb "$DISPLAY" -screen 0 1400x900x24 +extension GLX -nolisten tcp
sleep 2
start openbox
start "$prefix/bin/paraview" --dr --script="$here/tour.py"
for ((i = 0; i < 120; ++i)); do
  [[ -e ready ]] && break
  sleep 0.5
done
[[ -e ready ]] || { echo "ParaView did not start"; cat log; exit 1; }
sleep 3

click() # x y
{
  xdotool mousemove "$1" "$2"
  sleep 0.3
  xdotool click 1
  sleep 1
}
drag() # x y x y
{
  xdotool mousemove "$1" "$2"
  sleep 0.2
  xdotool mousedown 1
  sleep 0.2
  xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2))
  sleep 0.2
  xdotool mousemove "$3" "$4"
  sleep 0.3
  xdotool mouseup 1
  sleep 1
}
apply()
{
  xdotool key alt+a
  sleep "${1:-8}"
}
shot() # name
{
  import -window root -crop 1400x862+0+0 -resize 1000x -colors 96 "PNG8:$pictures/$1.png"
}
window=$(xdotool search --name '^ParaView' | tail -n 1)
xdotool windowsize "$window" 1400 880 windowmove "$window" 0 0
sleep 2
drag 297 500 440 500 # a wider panel

# The menu, then the recovery.
click 216 10
click 240 186
shot paraview-menu
click 575 236
apply 40
shot paraview-recovered

# The preview, from the contour, with the recovery hidden.
click 78 218
click 216 10
click 240 186
click 550 211
apply
click 12 240
shot paraview-preview

# Some points of the front edge picked on the contour; copied; applied.
click 12 218
click 12 284
click 12 306
click 78 218
click 1300 800
xdotool key d
sleep 1
drag 1006 678 1011 683
sleep 1
click 110 262
click 210 655
shot paraview-picked
apply
click 12 218
click 12 284
click 12 306
click 90 284
click 140 412
xdotool mousemove 210 700
for ((i = 0; i < 25; ++i)); do
  xdotool click 5
done
sleep 1
shot paraview-chosen
