#!/usr/bin/env python3
"""Doxygen's filter for the pages: names of the interface in `code` become links to the reference, outside blocks of code; and
links to pictures and programs lead to where the site has them, beside its pages. Pages about the Rust sources name types of Rust,
which are not the C++ classes of the same name."""

import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CPP = "".join(path.read_text() for path in sorted((ROOT / "include").rglob("*.hpp")))
FUNCTIONS = {function["name"] for function in json.loads((ROOT / "build/interface.json").read_text())["functions"]}
ABOUT_RUST = re.search(r"docs/decisions/|(^|/)(ARCHITECTURE|CONTRIBUTING|rust)\.md$", sys.argv[1])
CLASSES = set() if ABOUT_RUST else set(re.findall(r"^(?:class|struct) (\w+)", CPP, re.M))


def link(match):
    name = match[1]
    bare = name.removeprefix("gusset::")
    target = name if name in FUNCTIONS else f"gusset::{bare}" if bare in CLASSES else None
    return f"[{name}](@ref {target})" if target else match[0]


def linked(text):
    parts = re.split(r"(^```.*?^```$)", text, flags=re.M | re.S)
    return "".join(part if part.startswith("```") else re.sub(r"(?<!\[)`([\w:]+)`", link, beside(part)) for part in parts)


def beside(text):
    return re.sub(r"\]\((?:(?:\.\./)+(?:[\w/]+/)?|docs/)([\w.]+\.(?!md)\w+)\)", r"](\1)", text)


if __name__ == "__main__":
    print(linked(Path(sys.argv[1]).read_text()), end="")
