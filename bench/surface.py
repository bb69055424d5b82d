"""The cases of surfaces. All but one of the peers are in the program in C++; Open CASCADE from Python, in two versions, is a program for
environments of their own."""

import json
import subprocess
import sys

from timing import Outcome

CASES = ("build", "near", "far", "line", "ray", "plane")
SIZES = ("1e6-wavy", "1e4", "1e6", "equal-accuracy", "1e7", "spline")
OTHERS = ("memory", "memory-equal-accuracy", "threads-near", "threads-far", "ssi", "ssi-exact")
BY_KERNELS = ("near-spline", "far-spline", "line-spline", "plane-spline", "ssi")
# The unit of each case, and its divisor in milliseconds. As the program in C++ has it.
UNITS = {"ms": 1, "us": 1e-3}
SECONDS = 120


def wanted(only):
    cases = [f"{case}-{size}{order}" for case in CASES for size in SIZES for order in ("", "-sorted")]
    return any(only in f"carcass/{case}" for case in (*cases, *OTHERS))


def run(report, tools, folder, only, slow):
    out, questions = folder / "surface.json", folder / "surface-questions.json"
    command = [tools / "surface", "--only", only, "--out", out, "--questions", questions, *(["--slow"] if slow else [])]
    sys.stdout.flush()
    subprocess.run(command, check=True)
    report.merge(out)
    if any(only in f"carcass/{case}" for case in BY_KERNELS):
        for name in "ocp-7.8.1", "ocp-newest":
            in_python(report, name, tools.parent / f"bench-{name}" / "bin" / "python", questions, only)


def in_python(report, name, python, questions, only):
    """Adds the peer to our entries that the C++ program has just made."""
    said = ask(python, questions, only)
    for case in BY_KERNELS:
        ours = next((e for e in report.entries if e["id"].startswith(f"carcass/{case}/")), None)
        if ours is None:
            continue
        for suffix in "", "-anew":
            found = said if isinstance(said, str) else said.get(case + suffix)
            if found is None or (suffix and isinstance(said, str)):
                continue
            quality = {key: value for key, value in ours["quality"].items() if key != "peer"}
            if isinstance(found, str) or "failed" in found:
                theirs = Outcome(failed=found if isinstance(found, str) else found["failed"])
            else:
                questions_asked = found["quality"].get("queries", 1)
                theirs = found["time"] / questions_asked / UNITS[ours["unit"]]
                quality["peer"] = found["quality"]
            report.add(f"carcass/{case}", name + suffix, ours["ours"], theirs, quality, ours["unit"])


def ask(python, questions, only):
    """The answers of the program, or why it gives none."""
    if not python.exists():
        return "cadquery-ocp is not installed"
    try:
        command = [python, "bench/ocp_peer.py", questions, only]
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS)
        return json.loads(done.stdout.splitlines()[-1])
    except subprocess.TimeoutExpired:
        return f"not done in {SECONDS} s"
    except (IndexError, ValueError):
        return f"died: {(done.stderr.strip().splitlines() or [f'exit status {done.returncode}'])[-1]}"
