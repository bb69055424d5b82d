#!/usr/bin/env bash
# make lint: refuses openings and phrases that read like a translation, in comments, pages and docstrings, and functions called `of`.
# Begin a sentence with its subject or a verb. Write "is not a X", "lacks", "except" and "at most N", and repeat the noun instead of
# "that of". The program in tools/gusset is exempt until the command in Rust replaces it, as is the page that quotes its messages.
set -euo pipefail
cd "$(dirname "$0")/.."

opening='(Of|What|Whatever|Whoever|That|Those|Such)\b'
phrase='\b(is|are|was|were|be) no\b(?! longer| more than| less than| later than)|\b(that|those) of\b|\bbut for\b|\bso many\b'
comment='^\s*(//[/!]?|/?\*+|#+|""")\s?'
files=('*.rs' '*.h' '*.hpp' '*.c' '*.cpp' '*.cxx' '*.py' '*.js' '*.mjs' '*.ts' '*.sh' Makefile)
pages=('*.md')
exempt=(':!docs/benchmarks.md' ':!examples/page/three' ':!scripts/lint-prose.sh')

found=0
refuse() { # What is wrong, then a pattern and files.
  local what=$1 pattern=$2
  shift 2
  if git grep -nP -e "$pattern" -- "$@" "${exempt[@]}"; then
    echo "FAILED: $what" >&2
    found=1
  fi
}
refuse 'a comment has a sentence that opens with Of, What, Whatever, Whoever, That, Those or Such' "$comment(.*[.:;!?] )?$opening(?! is the\b)" "${files[@]}"
refuse 'a page has a sentence that opens with Of, What, Whatever, Whoever, That, Those or Such' "^(.*[.:;!?|] )?$opening(?! is the\b)(?![^.?]*\?)" "${pages[@]}"
refuse 'a comment says "is no", "that of", "but for" or "so many"' "$comment.*($phrase)" "${files[@]}"
refuse 'a page says "is no", "that of", "but for" or "so many"' "$phrase" "${pages[@]}"
refuse 'a function is called `of`: it needs a verb, or from_x' '\bfn of(_\w+)?\b' '*.rs'
exit $found
