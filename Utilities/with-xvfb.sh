#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a command with an X server of its own, and gives back its exit code: with-xvfb.sh COMMAND [ARGUMENT]...
#
# One server for the whole command, and one that does not reset itself (-noreset): ParaView opens and closes a
# connection to look for a display, and a server that resets when its last client leaves would break the next one.
set -eu

[ $# -gt 0 ] || { echo "usage: $0 COMMAND [ARGUMENT]..." >&2; exit 2; }
command -v Xvfb >/dev/null 2>&1 || { echo "with-xvfb: Xvfb is not installed (package xvfb)" >&2; exit 1; }

folder=$(mktemp -d)
server=
cleanup() {
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap cleanup EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# The server picks a free display, and writes its number into the pipe when it is ready. It has a session of its own:
# Ctrl-C ends the command, which may need the server until it has put things in order.
mkfifo "$folder/display"
setsid Xvfb -displayfd 3 -screen 0 1600x1200x24 -nolisten tcp -noreset 3>"$folder/display" >/dev/null 2>"$folder/log" &
server=$!
read -r display <"$folder/display" || true
if [ -z "${display:-}" ]; then
  cat "$folder/log" >&2
  echo "with-xvfb: the X server did not start" >&2
  exit 1
fi

status=0
DISPLAY=:$display "$@" || status=$?
exit "$status"
