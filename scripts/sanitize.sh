#!/usr/bin/env bash
# Runs the C and C++ tests and the library under a sanitizer: scripts/sanitize.sh address|thread [TESTS]. `make
# sanitize` calls it.
#
# The stable compiler has the passes and the runtimes, behind a variable. Rust's standard library is not instrumented,
# because its sources are not installed. C and C++ are compiled by gcc for the same runtime, and for the sanitizer of
# undefined
# behaviour. TESTS is a regular expression of ctest; by default it selects all tests that call the library in their
# own process.
set -euo pipefail
cd "$(dirname "$0")/.."
kind=$1
case $kind in
address) default='^(c|cpp|real|plugin|reference|threads|examples|torture|differential)/' runtime=asan extra=-fsanitize=undefined,address ;;
thread) default='^(threads|plugin|reference)/' runtime=tsan extra=-fsanitize=thread ;;
*) echo "no sanitizer of this name: $kind" >&2 && exit 2 ;;
esac
tests=${2:-$default}
host=$(rustc -vV | sed -n 's/^host: //p')
folder=$PWD/build/sanitize/$kind prefix=$PWD/build/sanitize/$kind/prefix
mkdir -p "$prefix/lib"

RUSTC_BOOTSTRAP=1 CARGO_PROFILE_RELEASE_OPT_LEVEL=1 \
    RUSTFLAGS="-Zsanitizer=$kind -Cunsafe-allow-abi-mismatch=sanitizer -Cdebug-assertions -Ccodegen-units=8 -Cdebuginfo=line-tables-only -Cforce-frame-pointers=yes" \
    "${CARGO:-cargo}" rustc --locked -p gusset --lib --features reserve --crate-type cdylib --release --target "$host" --target-dir "$folder/target"
"${MAKE:-make}" --no-print-directory -s install-data PREFIX="$prefix" DESTDIR=
version=$(sed -n 's/^version = "\(.*\)\..*"/\1/p' Cargo.toml | head -n 1)
cp "$folder/target/$host/release/libgusset.so" "$prefix/lib/libgusset.so.$version"
ln -sf "libgusset.so.$version" "$prefix/lib/libgusset.so"

# Programs link the whole runtime of the Rust compiler, which is newer than gcc's, and share it with the library.
library=$(rustc --print sysroot)/lib/rustlib/$host/lib/librustc-stable_rt.$runtime.a
link="-fno-sanitize=all -rdynamic -Wl,--whole-archive $library -Wl,--no-whole-archive -lubsan -lpthread -ldl -lm -lrt"
cmake -S cpp_tests -B "$folder/cpp" -DGUSSET_PREFIX="$prefix" -DVALGRIND=VALGRIND-NOTFOUND -DCMAKE_EXE_LINKER_FLAGS="$link" \
    -DCMAKE_C_FLAGS="-g -fno-omit-frame-pointer $extra" -DCMAKE_CXX_FLAGS="-g -fno-omit-frame-pointer $extra" >"$folder/cmake.log" ||
    { cat "$folder/cmake.log"; exit 1; }
# The programs of these tests: ctest lists no commands before they are built.
targets=$(find "$folder/cpp" -name CTestTestfile.cmake -exec sed -n 's/^add_test(\([^ ]*\) "\([^"]*\)".*/\1 \2/p' {} + |
    awk -v tests="$tests" -v folder="$folder/cpp/" '$1 ~ tests && index($2, folder) == 1 { sub(/.*\//, "", $2); print $2 }' | sort -u)
# shellcheck disable=SC2086 # a list of words
env -u MAKELEVEL -u MAKEFLAGS cmake --build "$folder/cpp" --parallel 2 --target $targets
# Excludes tests that compile, tests of the program, and tests with their own allocator, which the sanitizers replace.
# The allocator of the sanitizers must refuse requests beyond memory.
ASAN_OPTIONS=allocator_may_return_null=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1 \
    ctest --test-dir "$folder/cpp" --output-on-failure --no-tests=error --parallel 2 -R "$tests" -E 'refused_|/valgrind|real/filters|plugin/memory'
