"""Writes the table of speed in README.md, between two marks, from the entries of one full run."""

import re
import time
from pathlib import Path

from report import number

MARKS = "<!-- speed: written by `make bench` -->\n", "<!-- /speed -->"
# Subject, case, and the peers of the columns, where they have the case.
ROWS = [
    ("boundary loops of 10^6 triangles, all defects reported", "boundary-full/coherent-1M"),
    ("the loops only", "boundary/coherent-1M"),
    ("winged-edge table", "winged/coherent-1M"),
    ("strip between rims of 486 and 426 vertices", "join-strip/jagged-486x426"),
    ("strip between rims of 10,000 and 8,000 vertices", "join-strip/10000x8000"),
    ("blend between rims of 486 and 426 vertices", "rows/jagged"),
    ("curves through 34,820 points, time per point", "outline/composite"),
    ("normals of a net of 10^6 nodes", "net/normals-1e6"),
    ("smooth surface through 10^6 nodes", "carcass/build-1e6"),
    ("nearest point on that surface, from a start near it", "carcass/near-1e6"),
    ("nearest point on that surface, from far away", "carcass/far-1e6"),
    ("plane section of that surface, with its points in order", "carcass/plane-1e6"),
    ("intersection of two tori", "carcass/ssi"),
]
# The columns, and the names of their contenders in the cases.
PEERS = {
    "OpenMesh": ["openmesh"],
    "CGAL": ["cgal"],
    "MeshLib": ["meshlib", "meshlib-complex", "meshlib-nicely"],
    "VTK": ["vtk", "vtk-ruled-oriented"],
    "Embree": ["embree"],
    "SISL": ["sisl"],
    "Open CASCADE": ["occt"],
}


def duration(value, unit):
    """With the unit that leaves one to three digits before the point."""
    nanoseconds = value * {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}[unit]
    for size, name in (1e9, "s"), (1e6, "ms"), (1e3, "µs"), (1, "ns"):
        if nanoseconds >= size or name == "ns":
            return f"{number(nanoseconds / size)} {name}"


def cell(entry):
    """How many times as long the peer takes."""
    if entry["ratio"] is None:
        return "failed" if entry.get("failed") else ""
    return f"{number(entry['ratio'])} x"


def table(entries):
    found = {entry["id"]: entry for entry in entries}
    lines = ["| | gusset | " + " | ".join(PEERS) + " |", "|---" * (2 + len(PEERS)) + "|"]
    for subject, case in ROWS:
        mine = [next((found[i] for i in (f"{case}/{name}" for name in names) if i in found), None) for names in PEERS.values()]
        ours = next((entry for entry in mine if entry and entry["ours"]), None)
        if ours:
            cells = [duration(ours["ours"], ours["unit"]), *("" if entry is None else cell(entry) for entry in mine)]
            lines.append(f"| {subject} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def write_readme(entries, path=Path("README.md")):
    text = path.read_text()
    head = (f"The times are medians, measured on two cores on {time.strftime('%Y-%m-%d')}. The first column gives gusset's\n"
            "time. Each other column gives a peer's time divided by gusset's: above 1, gusset is faster. We time gusset and a peer in turn, in one\n"
            "process, on the same arrays. One process runs the C++ peers, another the Python peers. Each process computes\n"
            "its ratios from its own time of gusset. In the rows named strip, VTK leaves the strip open where its ends should meet.\n")
    begin, end = map(re.escape, MARKS)
    new, count = re.subn(f"(?<={begin}).*?(?={end})", lambda _: f"{head}\n{table(entries)}\n", text, flags=re.DOTALL)
    if count != 1:
        raise SystemExit(f"{path}: the marks around the table of speed are missing")
    path.write_text(new)
