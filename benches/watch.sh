#!/usr/bin/env bash
# From the save of a scene to the figure on the screen of a browser, in milliseconds: the least, the median and the
# largest of so many saves (default 100). Needs Chromium. The page says when the frame with the new
# figure has been drawn, and how much later that is than the time the file system gives the file.
# Usage: benches/watch.sh [SCENE.ron] [SAVES]
set -euo pipefail
cd "$(dirname "$0")/.."
scene=${1:-configs/hertz.ron} saves=${2:-100}
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
program=${PROGRAM:-${CARGO_TARGET_DIR:-target}/release/springbed}
[ -n "${PROGRAM:-}" ] || cargo build --release --quiet
work=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; wait 2>/dev/null || true; rm -rf "$work"' EXIT
cp "$(dirname "$scene")"/*.csv "$work" 2>/dev/null || true
cp "$scene" "$work/scene.ron"
"$program" watch "$work/scene.ron" > "$work/address" 2> "$work/said" &
until [ -s "$work/address" ]; do sleep 0.05; done
"$browser" --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --remote-debugging-port=0 --user-data-dir="$work/profile" \
    "$(cat "$work/address")" > /dev/null 2>&1 &
drawn() { grep -c 'drawing ' "$work/said" || true; }
until [ "$(drawn)" -ge 1 ]; do sleep 0.1; done
for ((save = 1; save <= saves; save++)); do
    sleep "0.$((RANDOM % 3 + 3))$((RANDOM % 10))"
    printf '// save %d\n' "$save" | cat "$scene" - > "$work/next"
    mv "$work/next" "$work/scene.ron"
    for ((wait = 0; wait < 100; wait++)); do
        [ "$(drawn)" -gt "$save" ] && break
        sleep 0.05
    done
done
grep 'drawing ' "$work/said" | tail -n +2 | sed 's/.*: \([0-9]*\) ms.*/\1/' | sort -n |
    awk '{ t[NR] = $1 } END { printf "%d saves: least %d ms, median %d ms, largest %d ms\n", NR, t[1], t[int((NR + 1) / 2)], t[NR] }'
