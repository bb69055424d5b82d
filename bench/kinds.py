"""Random cases of each kind of fault that people report, as ../shared/data/cases has them: `make kinds`. Each kind has 200 cases
of random sizes, rotations and units. Trimesh and plain geometry judge the default result. A case is right, or the library said
what is wrong, by a refusal or in the report, or the result is wrong in silence. The program fails if a kind has fewer than
98 % right, or one case wrong in silence."""

import argparse
import re
import sys
import zlib

import numpy as np

import gusset_mesh as gm
from kind_curves import CURVES
from kind_judge import Look
from kind_meshes import MESHES

CASES, LEAST_SHARE = 200, 0.98
#: Words in a report about a result that differs from the request.
SAID = re.compile(r"not joined|left open|not welded: [1-9]|cuts other faces|remain|refus|not simple|intersect: |skipped|stay.* open")


def outcome(kind, number):
    """'right', 'said' or 'silent' for one case, and the words."""
    case = kind(np.random.default_rng([zlib.crc32(kind.__name__.encode()), number]))
    try:
        made, text = case.run()
    except gm.Error as error:
        return "said", f"{type(error).__name__}: {error}"
    look = made if case.raw else made and Look(made)
    if look is not None and case.right(look):
        return "right", ""
    seen = look if case.raw or look is None else vars(look)
    return ("said" if SAID.search(str(text)) else "silent"), f"{seen} | {text}"


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--only", default="", help="kinds whose names contain this")
    options.add_argument("--cases", type=int, default=CASES, help="cases of each kind")
    options.add_argument("--show", type=int, default=3, help="how many failures of each kind are described")
    options = options.parse_args()
    failed = False
    print(f"{'kind':<18} {'right':>6} {'said':>6} {'silent':>6}")
    for kind in (*MESHES, *CURVES):
        if options.only not in kind.__name__:
            continue
        found = [outcome(kind, number) for number in range(options.cases)]
        right, said, silent = (sum(word == state for state, _ in found) for word in ("right", "said", "silent"))
        print(f"{kind.__name__:<18} {right:>6} {said:>6} {silent:>6}", flush=True)
        wrong = [(number, *one) for number, one in enumerate(found) if one[0] != "right"]
        for number, state, words in wrong[:options.show]:
            print(f"    case {number}, {state}: " + " / ".join(words.strip().splitlines()), file=sys.stderr)
        failed |= right < LEAST_SHARE * options.cases or silent > 0
    sys.exit(failed)


if __name__ == "__main__":
    main()
