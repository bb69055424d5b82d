"""All benchmarks, or those whose case contains --only. See `make bench`."""

import argparse
import subprocess
import sys
import time
from pathlib import Path

import elbows
import files
import fills
import hosts
import surface
import meshes
import outlines
import repairs
import scans
import sections
import truth
import unions
from cases import BOUNDARIES, OUTLINES, Cases
from gusset import Library
from net_cases import CPP as NETS
from page import write_page
from readme import write_readme
from report import Report


def in_cpp(report, tools, folder, only, slow):
    """The hosts in C++, on the same meshes by way of files."""
    wanted = []
    for name, mesh in BOUNDARIES.items():
        if any(only in f"{module}/{name}" for module in ("boundary", "boundary-full", "winged")):
            path = folder / f"{name}.mesh"
            if not path.exists():
                meshes.write(mesh(), path)
            wanted += ["--mesh", f"{name}={path}"]
    if wanted or only in "meridians/index-100000" or only in "attributes/apply/limit":
        out = folder / "cpp.json"
        sys.stdout.flush()
        subprocess.run([tools / "bench", *wanted, "--only", only, "--runs", "5", "--out", out], check=True)
        report.merge(out)
    if any(only in row for row in sections.ROWS if row.endswith("cgal")):
        path, out = folder / "sections.mesh", folder / "sections.json"
        if not path.exists():
            meshes.write(sections.solid(), path)
        sys.stdout.flush()
        subprocess.run([tools / "bench", "--sections", path, "--only", only, "--runs", "5", "--out", out], check=True)
        report.merge(out)
    if any(only in f"outline/{name}" for name in ("section", *OUTLINES)):
        path, out = folder / "all.outlines", folder / "outlines.json"
        outlines.write(outlines.everything(), path)
        sys.stdout.flush()
        subprocess.run([tools / "outlines", "--outlines", path, "--only", only, "--out", out], check=True)
        report.merge(out)
    if any(only in f"net/{name}" for name in NETS):
        out = folder / "nets.json"
        sys.stdout.flush()
        subprocess.run([tools / "nets", "--only", only, "--out", out], check=True)
        report.merge(out)
    if surface.wanted(only):
        surface.run(report, tools, folder, only, slow)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--prefix", type=Path, required=True, help="where gusset is installed")
    options.add_argument("--files", type=Path, required=True, help="libgusset_files.so")
    options.add_argument("--tools", type=Path, required=True, help="where the programs in C++ are")
    options.add_argument("--out", type=Path, required=True, help="the report")
    options.add_argument("--docs", type=Path, help="also write the page and the plot into this folder, and the table into README.md")
    options.add_argument("--only", default="", help="cases that contain this")
    options.add_argument("--slow", action="store_true", help="also what takes half a minute a run")
    options.add_argument("--apart", help="internal: one contender of one case, in this process")
    options = options.parse_args()
    start = time.time()
    folder = options.tools / "meshes"
    folder.mkdir(parents=True, exist_ok=True)
    library = Library(options.prefix)
    if options.apart:
        Cases(library, None, options.tools, folder, "", True).apart(options.apart)
        return
    report = Report()
    in_cpp(report, options.tools, folder, options.only, options.slow)
    Cases(library, report, options.tools, folder, options.only, options.slow).run()
    if truth.wanted(options.only):
        truth.run(library, report, options.tools, folder, options.only, options.docs)
    if elbows.wanted(options.only):
        elbows.run(library, report, options.tools, folder, options.only)
    if fills.wanted(options.only):
        fills.run(library, report, options.tools, folder, options.only)
    if repairs.wanted(options.only):
        repairs.run(options.prefix, report, options.tools, folder, options.only)
    if sections.wanted(options.only):
        sections.run(library, report, options.only)
    if unions.wanted(options.only):
        unions.run(library, report)
    if files.wanted(options.only):
        files.run(options.files, report, folder, options.only)
    if scans.wanted(options.only):
        scans.run(library, report, options.tools, folder, options.only)
    if hosts.wanted(options.only):
        hosts.run(options.prefix, report, options.tools, options.only)
    report.write(options.out)
    print(f"the report is {options.out}; it took {(time.time() - start) / 60:.0f} min")
    if options.docs:
        write_page(report.entries, options.docs, library.version)
        write_readme(report.entries)
        print(f"the page is {options.docs / 'benchmarks.md'}; its main figures are in README.md")


if __name__ == "__main__":
    main()
