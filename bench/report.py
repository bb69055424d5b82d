"""The report: one entry for each case and peer, printed as it comes and kept for the page."""

import json
import math

from timing import Outcome


def plain(value):
    """JSON lacks infinity: it becomes null."""
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    return None if isinstance(value, float) and not math.isfinite(value) else value


def number(value):
    """Three digits, without an exponent where that can be."""
    if value is None:
        return "-"
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:#.3g}".rstrip(".")


class Report:
    def __init__(self):
        self.entries = []
        print(f"{'case':<30} {'peer':<22} {'ours':>10} {'peer':>10}     {'ratio':>9}", flush=True)

    def add(self, case, peer, ours, theirs, quality=None, unit="ms"):
        """`ours` and `theirs` are Outcomes, or numbers."""
        failed = [f"{who}: {outcome.failed}" for who, outcome in (("gusset", ours), (peer, theirs))
                  if isinstance(outcome, Outcome) and outcome.failed]
        mine, other = (o.median if isinstance(o, Outcome) else o for o in (ours, theirs))
        ratio = other / mine if mine and other is not None else None
        entry = {"id": f"{case}/{peer}", "ours": mine, "peer": other, "unit": unit, "ratio": ratio, "quality": plain(quality or {})}
        if isinstance(ours, Outcome):
            entry["runs"] = max(len(ours.times), len(theirs.times))
        if failed:
            entry["failed"] = "; ".join(failed)
        self.entries.append(entry)
        print(f"{case:<30} {peer:<22} {number(mine):>10} {number(other):>10} {unit:<4}{number(ratio):>9}   "
              f"{'; '.join(failed)}", flush=True)

    def merge(self, path):
        """The entries that the benchmarks in C++ wrote; they printed them themselves."""
        with open(path) as file:
            self.entries += json.load(file)

    def write(self, path):
        with open(path, "w") as file:
            json.dump(self.entries, file, indent=2)
            file.write("\n")
