#!/usr/bin/env bash
# Paints in the real editor, kills it in the middle of a stroke, opens it again, accepts the recovered work, saves it and compares:
# nothing that the last copy held is lost, and that copy holds the stroke that was going on.
# Usage: kill_and_reopen.sh BIOTOPE. Ends with 77 (skipped) where there is no Xvfb or xdotool.
set -euo pipefail
biotope=$1
for tool in Xvfb xdotool unzip; do
  command -v "$tool" >/dev/null || { echo "skipped: there is no $tool"; exit 77; }
done

work=$(mktemp -d)
editor=
screen=
finish() {
  [ -n "$editor" ] && kill -9 "$editor" 2>/dev/null || true
  [ -n "$screen" ] && kill "$screen" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT

export XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state HOME=$work LIBGL_ALWAYS_SOFTWARE=1
state=$XDG_STATE_HOME/biotope
mkdir -p "$XDG_CONFIG_HOME/biotope" "$state" "$work/scenes"
cat >"$XDG_CONFIG_HOME/biotope/settings.json" <<EOF
{"first_steps_closed": true, "autosave_seconds": 1, "last_folder": "$work/scenes", "animate": false, "quality_level": "low",
 "window": {"width": 1000, "height": 640}, "brush": {"radius": 12, "strength": 0.9}}
EOF

# A small hill, so that everything is computed in moments.
awk 'BEGIN {
  n = 96
  print "ncols", n; print "nrows", n; print "xllcorner 0"; print "yllcorner 0"; print "cellsize 20"
  for (y = 0; y < n; ++y) { for (x = 0; x < n; ++x) printf "%.1f ", 600 + 120 * sin(x / 17) * cos(y / 23) + x; print "" }
}' >"$work/hill.asc"

# Without -noreset the server starts anew, and is not there for a moment, whenever a tool that was its only client ends.
exec 3< <(exec Xvfb -displayfd 1 -screen 0 1000x640x24 -nolisten tcp -noreset 2>/dev/null & echo "pid $!"; wait)
while read -r line <&3; do
  case $line in
    pid*) screen=${line#pid } ;;
    [0-9]*) export DISPLAY=:$line; break ;;
  esac
done

fail() {
  echo "failed: $*" >&2
  exit 1
}
# Waits up to $1 seconds until the rest of the line succeeds.
until_true() {
  local end=$((SECONDS + $1))
  shift
  while [ "$SECONDS" -le "$end" ]; do
    "$@" && return 0
    sleep 0.1
  done
  return 1
}
title() { xdotool getwindowname "$window" 2>/dev/null || true; }
titled() { [[ $(title) == $1 ]]; }
found_window() { window=$(xdotool search --onlyvisible --name Biotope 2>/dev/null | head -n 1) && [ -n "$window" ]; }
copy_file() { ls "$state"/recovery-*.biotope 2>/dev/null | head -n 1; }
has_copy() { [ -n "$(copy_file)" ]; }
paint_of() { unzip -p "$1" 'layers/*.tif' | cksum; }
copy_differs() { [ "$(paint_of "$(copy_file)" 2>/dev/null)" != "$1" ]; }

start_editor() {
  "$biotope" "$@" >"$work/editor.log" 2>&1 &
  editor=$!
  until_true 20 found_window || fail "no window: $(cat "$work/editor.log")"
  xdotool windowfocus "$window" 2>/dev/null || true
}

# A stroke on the map, in the left half of the window; $1 and $2 are where it begins.
stroke() {
  xdotool mousemove "$1" "$2" mousedown 1
  for i in 1 2 3 4; do
    sleep 0.08
    xdotool mousemove $(($1 + 12 * i)) $(($2 + 5 * i))
  done
  sleep 0.08
  [ "${3:-}" = hold ] || { xdotool mouseup 1; sleep 0.15; }
}
painted() {
  stroke 150 250
  titled '\* *'
}

until_true 15 xdotool getmouselocation >/dev/null 2>&1 || fail "the display does not answer"
start_editor "$work/hill.asc"
until_true 20 titled 'hill - Biotope' || fail "the terrain was not opened: '$(title)'"
xdotool key 2  # Climate: the moisture is shown
xdotool key b
# The first strokes may come before the maps under the brush are known: it says so and paints nothing.
until_true 12 painted || fail "nothing was painted"
until_true 8 has_copy || fail "unsaved work was not copied"
before=$(paint_of "$(copy_file)")

stroke 180 330 hold
until_true 8 copy_differs "$before" || fail "a stroke that goes on was not copied"
kill -9 "$editor"
wait "$editor" 2>/dev/null || true
xdotool mouseup 1
copy=$(copy_file)
[ -n "$copy" ] || fail "the copy did not survive the kill"
lost=$(paint_of "$copy")
cp "$copy" "$work/rescued.biotope"

start_editor "$work/hill.asc"
until_true 20 titled 'hill - Biotope' || fail "the editor did not start again: '$(title)'"
# 'Unsaved work was found': open it. The dialog may still be opening when the first key comes.
recovered() {
  xdotool key Return
  sleep 0.6
  titled '\* *'
}
until_true 20 recovered || fail "the recovered work was not opened: '$(title)'"
# So may the dialog that asks for a name: an attempt that came too early is given up and made again.
saved() {
  xdotool key ctrl+s
  sleep 0.8
  xdotool key ctrl+a type --delay 40 rescued
  xdotool keydown Return
  sleep 0.15
  xdotool keyup Return
  sleep 0.8
  [ -f "$work/scenes/rescued.biotope" ] || { xdotool key Escape; return 1; }
}
until_true 25 saved || fail "the recovered work was not saved: '$(title)'"
until_true 5 titled 'rescued - Biotope' || fail "the title does not tell that it is saved: '$(title)'"
[ "$(paint_of "$work/scenes/rescued.biotope")" = "$lost" ] || fail "the recovered paint is not what the copy held"
"$biotope" info "$work/scenes/rescued.biotope" >/dev/null || fail "the saved scene cannot be read"
echo "painted, killed in a stroke, recovered and saved: the same paint"
