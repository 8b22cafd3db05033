#!/usr/bin/env bash
# Whole process: median wall time and peak memory of `run configs/hertz.ron` with table, summary and figure.
# Usage: benches/start.sh [RUNS]   (default 101; needs nothing but bash and a build)
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-101}
cargo build --release --quiet
program=target/release/springbed
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

run() { "$program" run configs/hertz.ron --out "$out" --quiet; }

run # once for the caches
for _ in $(seq "$runs"); do
    from=$(date +%s%N)
    run
    echo $(($(date +%s%N) - from))
done | sort -n | awk '{ t[NR] = $1 / 1e6 }
    END { printf "wall time over %d runs: median %.2f ms, least %.2f ms, largest %.2f ms\n", NR, t[int((NR + 1) / 2)], t[1], t[NR] }'

if [ -x /usr/bin/time ]; then
    /usr/bin/time -f '%M' "$program" run configs/hertz.ron --out "$out" --quiet 2>&1 |
        awk '{ printf "peak memory: %.1f MB\n", $1 / 1024 }'
elif command -v python3 >/dev/null; then
    python3 - "$program" "$out" <<'P'
import resource, subprocess, sys
subprocess.run([sys.argv[1], "run", "configs/hertz.ron", "--out", sys.argv[2], "--quiet"], check=True)
print("peak memory: %.1f MB" % (resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024))
P
else
    echo "peak memory: needs /usr/bin/time or python3"
fi
