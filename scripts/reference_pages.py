#!/usr/bin/env python3
"""Doxygen's filter for the pages: names of the interface in `code` become links to the reference, outside blocks of code; and
links to pictures and programs lead to where the site has them, beside its pages. Pages about the Rust sources name types of Rust,
which are not the C++ classes of the same name. Links to an `<a id>` become doxygen's own, because it does not find the page
of others. `build/docs/classes.xml` is doxygen's own list of classes."""

import json
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent
FUNCTIONS = {function["name"] for function in json.loads((ROOT / "build/interface.json").read_text())["functions"]}
ABOUT_RUST = re.search(r"docs/decisions/|(^|/)(ARCHITECTURE|CONTRIBUTING|rust)\.md$", sys.argv[1])
COMPOUNDS = [] if ABOUT_RUST else ElementTree.parse(ROOT / "build/docs/classes.xml").iterfind("compound/name")
CLASSES = {name.text.removeprefix("gusset::") for name in COMPOUNDS}


def link(match):
    name = match[1]
    bare = name.removeprefix("gusset::")
    target = name if name in FUNCTIONS else f"gusset::{bare}" if bare in CLASSES else None
    return f"[{name}](@ref {target})" if target else match[0]


def linked(text):
    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
    return "".join(part if part.startswith("```") else re.sub(r"(?<!\[)`([\w:]+)`", link, beside(part)) for part in parts)


def beside(text):
    text = re.sub(r"\]\((?:[\w./-]+\.md)#([\w-]+)\)", r"](@ref \1)", text)
    return re.sub(r"\]\((?:(?:\.\./)+(?:[\w/]+/)?|docs/)([\w.]+\.(?!md)\w+)\)", r"](\1)", text)


if __name__ == "__main__":
    print(linked(Path(sys.argv[1]).read_text()), end="")
