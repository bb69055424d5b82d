#!/usr/bin/env bash
# Compiles each header that programs include alone, in every supported standard. With `parts`, also compiles each part
# of the wrapper alone; one compiler suffices for this.
#   headers.sh PREFIX C_COMPILER C++_COMPILER [parts]
set -euo pipefail
include=$1/include cc=$2 cxx=$3 parts=${4:-}
read -ra eigen <<<"$(pkg-config --cflags eigen3 | sed 's/-I/-isystem /g')"
strict=(-fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror "-I$include" "${eigen[@]}")

# One compilation a line: compiler, language, standard, header. Headers of other libraries lie in system folders,
# where compilers do not warn.
cd "$include"
jobs=$(
  for header in *.h gusset/*.h; do
    for standard in c99 c11 c17 c2x; do echo "$cc c $standard $header"; done
    echo "$cxx c++ c++11 $header"
  done
  for header in *.hpp gusset/openmesh.hpp gusset/cgal.hpp gusset/eigen.hpp; do
    for standard in c++17 c++20; do echo "$cxx c++ $standard $header"; done
  done
  for header in ${parts:+gusset/*.hpp}; do
    case $header in */openmesh.hpp | */cgal.hpp | */eigen.hpp) ;; *) echo "$cxx c++ c++17 $header" ;; esac
  done
)
one() { # The words of a line, then the flags.
  local compiler=$1 language=$2 standard=$3 header=$4
  shift 4
  # Includes it twice, because a header may be included again. A separate main file avoids warnings that apply to main
  # files.
  printf '#include <%s>\n#include <%s>\n' "$header" "$header" | "$compiler" -x "$language" "-std=$standard" "$@" - ||
    { echo "FAILED: $header as $standard by $compiler" >&2; return 1; }
}
export -f one
xargs -P "$(nproc)" -L 1 bash -c 'one "${@: -4}" "${@:1:$#-4}"' one "${strict[@]}" <<<"$jobs"

# After every header of C99, whose macros could clash: <complex.h> has `complex`.
standard=(assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdarg stdbool stddef stdint stdio
  stdlib string tgmath time wchar wctype)
for header in *.h; do
  { printf '#include <%s.h>\n' "${standard[@]}"; echo "#include <$header>"; } | "$cc" -x c -std=c99 "${strict[@]}" - ||
    { echo "FAILED: $header after the headers of C99" >&2; exit 1; }
done
echo "$(wc -l <<<"$jobs") compilations, and C after its own headers"
