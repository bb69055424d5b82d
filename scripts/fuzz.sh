#!/bin/sh
# The fuzzers, built for libFuzzer and run one after the other: scripts/fuzz.sh SECONDS [TARGET]. `make fuzz` calls
# it. libFuzzer needs only stable features of the compiler. Corpora grow in build/fuzz; failing inputs are left beside
# them. Targets that read files add valid and hostile files to their corpus.
set -eu
seconds=$1
only=${2:-}
host=$(rustc -vV | sed -n 's/^host: //p')
folder=${FUZZ_DIR:-build/fuzz}
mkdir -p "$folder"

# Instruments edges and comparisons of the library only, with overflow checks. The target triple keeps build scripts
# uninstrumented.
RUSTFLAGS="--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares -Cdebug-assertions -Ccodegen-units=8" \
    "${CARGO:-cargo}" build --locked -p gusset-fuzz --bins --features libfuzzer --release --target "$host" --target-dir "$folder/target"

failed=0
printf '%-18s %12s %8s %9s  %s\n' target executions seconds crashes 'slow or hung' >"$folder/report.txt"
for source in fuzz/fuzz_targets/*.rs; do
    name=$(basename "$source" .rs)
    [ -z "$only" ] || [ "$only" = "$name" ] || continue
    mkdir -p "$folder/corpus/$name" "$folder/found/$name"
    # Files are longer than cases of other functions.
    case $name in read_*) longest=6000 ;; *) longest=1000 ;; esac
    "$folder/target/$host/release/$name" "$folder/corpus/$name" -artifact_prefix="$folder/found/$name/" -max_total_time="$seconds" \
        -max_len="$longest" -timeout=20 -rss_limit_mb=4096 -print_final_stats=1 >"$folder/$name.log" 2>&1 || failed=1
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/$name.log")
    count() { find "$folder/found/$name" -name "$1-*" | wc -l; }
    printf '%-18s %12s %8s %9s  %s\n' "$name" "${runs:-0}" "$seconds" "$(count crash)" \
        "$(($(count timeout) + $(count slow-unit) + $(count oom)))" >>"$folder/report.txt"
done
cat "$folder/report.txt"
exit $failed
