#!/usr/bin/env bash
# Instructions of a Hertz state in a program with all features and in one with none.
set -euo pipefail
cd "$(dirname "$0")/.."
command -v valgrind >/dev/null || { echo "skipped: valgrind is not installed"; exit 0; }

states=10000
count() { # instructions of the example built with the given features, for a number of states
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" 2>&1 | sed -n 's/.*Collected : //p'
}
for features in "--no-default-features" ""; do
    folder=target/instructions${features:+-none}
    # shellcheck disable=SC2086
    cargo build --quiet --release --example library_hertz $features --target-dir "$folder"
    program=$folder/release/examples/library_hertz
    many=$(count "$program" $((2 * states))) few=$(count "$program" $states)
    echo "${features:-all features}: $(((many - few) / states)) instructions per state, $(stat -c %s "$program") bytes of program"
done
