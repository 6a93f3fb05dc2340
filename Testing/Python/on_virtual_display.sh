#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause
#
# on_virtual_display.sh XVFB-RUN COMMAND...: runs a command on a virtual display; once more if the
# first time failed, as about one start of a display in 25 does. A wrong picture is wrong twice.

xvfb_run=$1
shift
"$xvfb_run" -a -s "-screen 0 1280x1024x24" "$@" && exit 0
echo "Failed; trying once more."
exec "$xvfb_run" -a -s "-screen 0 1280x1024x24" "$@"
