#!/usr/bin/env bash
# The C and C++ tests under a sanitizer, with the library instrumented too: scripts/sanitize.sh address|thread [TESTS]. `make sanitize` calls it.
#
# The compiler has the passes and the runtimes, and asks for a variable before it lets them be used; the standard library alone stays as it is,
# as its sources are not installed with the compiler. C and C++ are compiled by gcc for the same runtime, and for the sanitizer of undefined
# behaviour. What TESTS, a regular expression of ctest, names is built and run; by default all that call the library in their own process.
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

# The runtime of the compiler of Rust is the newer one, and the only one: programs are linked with it whole, and lend it to the library.
library=$(rustc --print sysroot)/lib/rustlib/$host/lib/librustc-stable_rt.$runtime.a
link="-fno-sanitize=all -rdynamic -Wl,--whole-archive $library -Wl,--no-whole-archive -lubsan -lpthread -ldl -lm -lrt"
cmake -S cpp_tests -B "$folder/cpp" -DGUSSET_PREFIX="$prefix" -DVALGRIND=VALGRIND-NOTFOUND -DCMAKE_EXE_LINKER_FLAGS="$link" \
    -DCMAKE_C_FLAGS="-g -fno-omit-frame-pointer $extra" -DCMAKE_CXX_FLAGS="-g -fno-omit-frame-pointer $extra" >"$folder/cmake.log" ||
    { cat "$folder/cmake.log"; exit 1; }
# The programs of these tests: ctest itself knows no commands before they are built.
targets=$(find "$folder/cpp" -name CTestTestfile.cmake -exec sed -n 's/^add_test(\([^ ]*\) "\([^"]*\)".*/\1 \2/p' {} + |
    awk -v tests="$tests" -v folder="$folder/cpp/" '$1 ~ tests && index($2, folder) == 1 { sub(/.*\//, "", $2); print $2 }' | sort -u)
# shellcheck disable=SC2086 # a list of words
env -u MAKELEVEL -u MAKEFLAGS cmake --build "$folder/cpp" --parallel 2 --target $targets
# Compiling is tested elsewhere, and so is the program of the command line; memory is refused by an allocator of the test's own, in whose
# place the sanitizers have theirs. What asks for more memory than there is is to be told so.
ASAN_OPTIONS=allocator_may_return_null=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1 \
    ctest --test-dir "$folder/cpp" --output-on-failure --no-tests=error --parallel 2 -R "$tests" -E 'refused_|/valgrind|real/filters|plugin/memory'
