#!/usr/bin/env python3
"""Doxygen's filter for the C headers: puts each item into the group of its file of src/capi, links statuses, and adds to
each function the block of examples/reference that calls it, which the tests compile and run.

`reference.py --check` lists what the comment of a function lacks, and fails if any lacks anything.
"""

import functools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/gusset.h"
COMMENT = r"/\*\*((?:(?!\*/).)*)\*/\s*"
ITEM = re.compile(COMMENT + r"(#define (?P<constant>\w+)|(?P<declaration>(?:GUSSET_\w+\s+)+[^;{}()]*?\b(?P<function>\w+)\([^;]*\)\s*;)|"
                  r"typedef [^;{(]*?\(\*(?P<callback>\w+)\)|typedef (?:struct|enum)?\s*\w+ (?P<tag>\w+)(?:;| \{)|"
                  r"enum (?P<enum>\w+))", re.S)


@functools.cache
def header():
    return HEADER.read_text()


@functools.cache
def statuses():
    return set(re.findall(r"\bGUSSET_ERROR_(\w+) =", header()))


@functools.cache
def groups():
    return set(re.findall(r"@defgroup (\w+)", (ROOT / "docs/reference.dox").read_text()))


@functools.cache
def origins():
    """Where in src/capi each name of the interface is declared: the file, without its ending."""
    found, folder = {}, ROOT / "src/capi"
    for path in sorted({*folder.glob("*.rs"), *folder.glob("*/*.rs")} - {*folder.glob("plugin/*")}):
        declared = r"^\s*pub (?:unsafe )?(?:extern \"C\" )?(?:const|fn|struct|type|enum) (\w+)"
        place = path.relative_to(folder).with_suffix("")
        place = place.parent if place.name == "mod" else place
        found.update((name, place) for name in re.findall(declared, path.read_text(), re.M))
    return found


def group(name):
    """The group named after the folder and the file; or else after the file, or after the longest beginning of its name with
    or without the folder."""
    place = origins().get(name, Path())
    exact = "_".join(place.parts)
    begins = lambda name, one: name == one or name.startswith(one + "_")
    fitting = [one for one in groups() if begins(place.name, one)] or [one for one in groups() if begins(exact, one)]
    return exact if exact in groups() else max(fitting, key=len, default=None)


@functools.cache
def blocks():
    """The examples: file, name and text of each block."""
    found = []
    for path in sorted((ROOT / "examples/reference").glob("*.c")):
        for name, text in re.findall(r"^//! \[(\w+)\]\n(.*?)^//! \[\1\]\n", path.read_text(), re.S | re.M):
            found.append((path.name, name, text))
    return found


def example(name):
    return next(((file, block) for file, block, text in blocks() if re.search(rf"\b{name}\(", text)), None)


def functions():
    """Name, comment and declaration of each function."""
    return [match.group("function", 1, "declaration") for match in ITEM.finditer(header()) if match.group("function")]


def lacks(name, comment, declaration):
    """What a reader of the function's comment would miss."""
    given = [part.split()[-1].lstrip("*") for part in declaration.split("(", 1)[1].rsplit(")", 1)[0].split(",")]
    described = set(re.findall(r"@param(?:\[[\w,]+\])? (\w+)", comment))
    fallible, kind = "gusset_status " in declaration, re.match(r"(?:GUSSET_\w+\s+)+(.*?)\w+\(", declaration, re.S).group(1).strip()
    there = {f"@param {one}": one in described for one in given if one != "void"}
    there |= {f"a parameter for @param {one}": one in given for one in described}
    there["a brief"] = not re.match(r"[\s*]*@", comment)
    there["@return"] = kind == "void" or "@return" in comment
    there["errors in @return"] = not fallible or "or an error: " in re.sub(r"[\s*]+", " ", comment)
    there["@complexity"] = not fallible or "@complexity" in comment or "those of gusset_" in re.sub(r"[\s*]+", " ", comment)
    there["@since"] = "@since" in comment
    there["a group (docs/reference.dox) for its file of src/capi"] = group(name)
    there["an example (examples/reference)"] = example(name)
    return [what for what, present in there.items() if not present]


def page(match):
    """The comment of an item as doxygen takes it."""
    comment, name = match.group(1), next(filter(None, match.group("function", "constant", "callback", "tag", "enum")), None)
    comment = re.sub(r"(?<!\\)([<>#])", r"\\\1", comment)
    comment = re.sub(r"\b[A-Z][A-Z_]+\b", lambda word: f"::GUSSET_ERROR_{word[0]}" if word[0] in statuses() else word[0], comment)
    lines = [f" * @ingroup {group(name)}"] if group(name) else []
    if match.group("function") and (found := example(name)):
        lines += [" * @par Example", f" * From examples/reference/{found[0]}. MUST: the call succeeds; HOLDS: so it is.",
                  f" * @snippet {found[0]} {found[1]}"]
    return f"/**{comment.rstrip()}\n" + "\n".join(lines) + "\n */\n" + match.group(2)


def filtered(path):
    if path == HEADER:
        text = ITEM.sub(page, header())
        # What its first line explains.
        text = re.sub(r"^(#define GUSSET_VERSION_(?:MINOR|PATCH|STRING) .*)", r"/** See ::GUSSET_VERSION_MAJOR. */\n\1", text, flags=re.M)
        title = "The C interface"
    else:
        text = path.read_text()
        title = text.split(".")[0].lstrip("/* ")
    # What is for compilers.
    text = re.sub(r"^#define GUSSET_\w*(?:API|MUST_USE|INLINE_H)\b.*\n", "", text, flags=re.M)
    return f"/** @file\n {title}. */\n{text}"


def check():
    missing = [f"{function[0]} lacks {what}" for function in functions() for what in lacks(*function)]
    # Functions that the header defines need no example: they are in those of others.
    names = {name for name, _, _ in functions()} | set(re.findall(r"^static inline \w+ (gusset_\w+)\(", header(), re.M))
    guides = "".join(path.read_text() for path in sorted((ROOT / "examples/guides").glob("*.c")))
    symbols = (ROOT / "include/gusset.symbols").read_text().split()
    missing += [f"{name} is exported, and in no example" for name in symbols if name not in names and name not in guides]
    for file, block, text in blocks():
        called = set(re.findall(r"\b(gusset_\w+)\(", text))
        missing += [f"examples/reference/{file}, {block}: there is no {name}" for name in sorted(called - names)]
    print("\n".join(missing) or f"{len(functions())} functions, each with all its parts and one of {len(blocks())} examples")
    return 1 if missing else 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--check"]:
        sys.exit(check())
    sys.stdout.write(filtered(Path(sys.argv[1]).resolve()))
