#!/usr/bin/env python3
"""The C++ headers as doxygen reads them: `reference_cpp.py FILE` is its filter.

The wrapper is thin, and the C interface is documented. A member without a comment therefore refers to the C function that it calls or
the field that it is named after, or is one that the standard library requires of ranges; any other needs a comment in the header. Classes get an example: the first part of a guide's program that uses them, or the first program that does.
"""

import functools
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

CONSTANT = re.compile(r"(\w+) = (GUSSET_\w+)(,?)")
SEVERAL = re.compile(r"(\s*)([\w:]+(?:<[\w:<>, ]+>)?) ((?:\w+(?: = [\w.:]+|\{\})?, )+\w+(?: = [\w.:]+|\{\})?);$")
CLASS = re.compile(r"\s*(?:class|struct) (\w+)(?: final)?(?: : [^;]*)?(?: \{|$)")
NO_DECLARATION = re.compile(r"\s*(?://|#|\}|\)|public:|private:|namespace|extern|template|static_assert|friend struct|friend class|$)")
ENDS = re.compile(r".*[;{}:>]\s*(?://.*)?$|\s*//|^$|#")
USUAL = {
    r"\bvalue_type\b": "The type of the elements.",
    r"\b(?:class|struct|using) (?:const_)?iterator\b": "A place in the range.",
    r"\b(?:iterator_category|difference_type|pointer|reference)\b =": "As the standard library requires of iterators.",
    r"\b(?:begin|end)\(\)": "The ends of the range.",
    r"\bsize\(\)": "The number of elements.",
    r"\bempty\(\)": "True if the range has no elements.",
    r"\boperator(?:\+\+|--|->|\*|==|!=|-|\+=?|\[\])": "As in the standard library.",
    r"\biterator\(": "A place in the range.",
    r"\bexplicit \w+\(gusset_\w+ \*owned\)": "Takes over a handle of the C interface.",
    r"\bget\(\)": "The argument of the C interface, still owned by this.",
    r"\bdata\(\)": "The first element.",
    r"\boperator=\(|\w+\((?:const )?\w+ &&?(?: ?other)?\)|~\w+\(\)": "The class describes its copies.",
}


@functools.cache
def interface():
    return json.loads((ROOT / "build/interface.json").read_text())


@functools.cache
def c_functions():
    return {function["name"] for function in interface()["functions"]}


@functools.cache
def c_fields():
    """The structs of the C interface and their fields."""
    return {struct["name"]: {field["name"] for field in struct["fields"]} for struct in interface()["structs"]}


@functools.cache
def programs():
    """The C++ programs that the tests build, those for readers first."""
    folders = [ROOT / "examples" / name for name in ("guides", "cpp", "pictures")]
    paths = [path for folder in folders for path in sorted(folder.glob("*.[ch]pp"), reverse=True)]
    return [(path, path.read_text()) for path in paths + sorted((ROOT / "cpp_tests/cpp").glob("*.[ch]pp"))]


def example(name):
    """Lines about where a class is used."""
    for path, text in programs():
        for block, inside in re.findall(r"^\s*//! \[(\w+)\]\n(.*?)^\s*//! \[\1\]\n", text, re.S | re.M):
            if re.search(rf"\bgusset::{name}\b", inside):
                return ["/// @par Example", f"/// @snippet {path.name} {block}"]
    path = next((path for path, text in programs() if re.search(rf"\b{name}\b", text)), None)
    return ["/// @par Example", f"/// Used in {path.relative_to(ROOT)}, which the tests build and run."] if path else []


def indentation(line):
    return len(line) - len(line.lstrip())


def declaration(lines, at):
    """The lines from one on to the end of what it declares."""
    body = [lines[at]]
    for line in lines[at + 1:]:
        if body[-1].rstrip().endswith((";", "}")) and indentation(body[-1]) == indentation(lines[at]):
            break
        body.append(line)
    return "\n".join(body)


def said_of(lines, at, owner):
    """The text for a declaration without a comment, or None."""
    line = lines[at]
    for pattern, text in USUAL.items():
        if re.search(pattern, line if "operator" in line else line.split("{")[0]):
            return text
    called = [name for name in re.findall(r"\bgusset_\w+", declaration(lines, at)) if name in c_functions()]
    if called:
        return f"See ::{called[0]}."
    variable = re.match(r"[^()]*?(\w+)(?:\{\}| = [^()]*(?:\(\))?[^()]*)?;$", line.strip())
    if variable and owner:
        struct = "gusset_" + re.sub(r"(?<=[a-z])(?=[A-Z])", "_", owner).lower()
        for likely in (struct, struct + "_view", struct + "_options"):
            if variable.group(1) in c_fields().get(likely, ()):
                return f"See ::{likely}::{variable.group(1)}."
    return None


def filtered(path):
    lines, out = path.read_text().splitlines(), []
    owners, hidden, private = [], False, False  # the classes round a line, each with its indentation
    for at, line in enumerate(lines):
        before = lines[at - 1] if at else ""
        hidden = (hidden or line.startswith("namespace detail")) and not line.startswith("} // namespace detail")
        if re.match(r"\s*(?:public:|private:|\};)", line):
            private = "private:" in line
        while owners and line.strip() and indentation(line) <= owners[-1][1] and not re.match(r"\s*(?:public|private):", line):
            owners.pop()
        visible = not hidden and not private and indentation(line) == 4 * len(owners) and not NO_DECLARATION.match(line)
        if visible and ENDS.match(before) and not re.match(r"\s*(?:///|template)", before):
            text = said_of(lines, at, owners[-1][0] if owners else None)
            out += [f"{' ' * indentation(line)}/// {text}"] if text else []
        found = CLASS.match(line)
        if found and not line.endswith(";"):
            if not hidden and before.startswith("///"):
                out += example(found.group(1))
            owners.append((found.group(1), indentation(line)))
        if not line.lstrip().startswith("//"):
            line = CONSTANT.sub(r"\1 = \2\3 ///< See ::\2.\n", line)
        several = SEVERAL.match(line)
        if several and out and out[-1].lstrip().startswith("///"):
            # The comment of the first is that of all.
            space, kind, names = several.groups()
            line = f"\n{out[-1]}\n".join(f"{space}{kind} {name};" for name in names.split(", "))
        out.append(line)
    return f"/** @file\n {lines[0].lstrip('/ ')} */\n" + "\n".join(out) + "\n"


if __name__ == "__main__":
    sys.stdout.write(filtered(Path(sys.argv[1]).resolve()))
