"""Random cases of each kind of fault that people report, as ../shared/data/cases has them: `make kinds`. Each kind has 200 cases
of random sizes, rotations and units. Trimesh, plain geometry and CGAL judge the default result. A case is right, or the library said
what is wrong, by a refusal or in the report, or the result is wrong in silence. Faces may not intersect unless those given do, and
the report counts the boundary loops that there are. The program fails if a kind has fewer than 98 % right, or one case wrong in
silence."""

import argparse
import re
import sys
import zlib

import numpy as np

import gusset_mesh as gm
from kind_cuts import count_cuts, program
from kind_curves import CURVES
from kind_judge import Look
from kind_joints import JOINTS
from kind_meshes import MESHES, united
from kind_nets import NETS

CASES, LEAST_SHARE = 200, 0.98
#: Words in a report about a result that differs from the request.
SAID = re.compile(r"not joined|left open|not welded: [1-9]|cuts other faces|remain|refus|not simple|intersect: |skipped|stay(s|ed)? open(?! unless)")
#: Words in a report about faces that intersect.
CUTS = re.compile(r"cuts? |intersect")


def outcome(kind, number, seed):
    """'right', 'said' or 'silent' for one case, and the words."""
    case = kind(np.random.default_rng([zlib.crc32(kind.__name__.encode()), number, *[seed] * (seed > 0)]))
    try:
        made, text = case.run()
    except gm.Error as error:
        return "said", f"{type(error).__name__}: {error}"
    look = made if case.raw else made and Look(made)
    if look is not None and case.right(look):
        fault = None if case.raw else flaw(case, look, text)
        if fault is None:
            return "right", ""
        return ("said" if CUTS.search(str(text)) else "silent"), f"{fault} | {text}"
    fault = look if case.raw or look is None else {name: value for name, value in vars(look).items() if name != "mesh"}
    return ("said" if SAID.search(str(text)) else "silent"), f"{fault} | {text}"


def flaw(case, look, text):
    """The fault of a mesh that is as expected otherwise, or None."""
    counted = getattr(text, "values", {}).get("boundary_loops")
    if counted is not None and look.loops is not None and counted != len(look.loops):
        return f"the report counts {counted} boundary loops, and there are {len(look.loops)}"
    cuts = count_cuts(*look.mesh)
    if cuts and not (case.given and count_cuts(*Look(gm.Mesh(*united(*case.given))).mesh)):
        return f"{cuts} pairs of faces intersect"
    return None


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--only", default="", help="kinds whose names contain one of these words, between commas")
    options.add_argument("--cases", type=int, default=CASES, help="cases of each kind")
    options.add_argument("--seed", type=int, default=0, help="other cases for each number")
    options.add_argument("--show", type=int, default=3, help="how many failures of each kind are described")
    options = options.parse_args()
    failed = False
    if program() is None:
        print("CGAL or a compiler is not installed: intersections are not judged", file=sys.stderr)
    print(f"{'kind':<18} {'right':>6} {'said':>6} {'silent':>6}")
    for kind in (*MESHES, *JOINTS, *CURVES, *NETS):
        if not any(word in kind.__name__ for word in options.only.split(",")):
            continue
        found = [outcome(kind, number, options.seed) for number in range(options.cases)]
        right, said, silent = (sum(word == state for state, _ in found) for word in ("right", "said", "silent"))
        print(f"{kind.__name__:<18} {right:>6} {said:>6} {silent:>6}", flush=True)
        wrong = [(number, *one) for number, one in enumerate(found) if one[0] != "right"]
        for number, state, words in wrong[:options.show]:
            print(f"    case {number}, {state}: " + " / ".join(words.strip().splitlines()), file=sys.stderr)
        failed |= right < LEAST_SHARE * options.cases or silent > 0
    sys.exit(failed)


if __name__ == "__main__":
    main()
