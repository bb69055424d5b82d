"""Writes what follows from the library: gusset_mesh/_options.py, the keywords of structs of options, from gusset.h; and
gusset_mesh/filters.pyi, the types of the filters, from the plugin's table.

    generate.py [--check]      run where the package can be imported; --check says whether the files are what it would write
"""

import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
HEADER = HERE.parent / "include/gusset.h"
#: Structs whose fields are keywords, by the names that they have here.
STRUCTS = {
    "WeldOptions": "weld_options", "OrientOptions": "orient_options", "BoundaryOptions": "boundary_options", "StitchOptions": "stitch_options",
    "FillOptions": "fill_options", "TrimOptions": "trim_options", "JoinOptions": "join_options", "AlignOptions": "alignment_options",
    "OutlineOptions": "outline_options", "OffsetOptions": "offset_options", "NetMeshOptions": "net_mesh_options",
    "ConcatenateOptions": "concatenate_options", "SurfaceOptions": "surface_options", "NearestOptions": "nearest_options", "ContourOptions": "contour_options",
    "IntersectionOptions": "intersection_options", "SheetMeshOptions": "sheet_mesh_options", "DevelopOptions": "develop_options",
}
NUMBERS = {"uint32_t": "int", "size_t": "int", "int64_t": "int", "double": "float"}


def sentences(comment):
    """A comment of C as text."""
    return " ".join(line.strip().removeprefix("*").strip() for line in comment.strip().splitlines())


def fields(header, struct):
    """The fields of a struct: text, type, name."""
    body = re.search(rf"typedef struct {struct} \{{(.*?)\n\}} {struct};", header, re.S).group(1)
    for comment, declaration in re.findall(r"/\*\*(.*?)\*/\s*([^/;]*);", body, re.S):
        kind, name = re.match(r"(.*?)(\w+(?:\[\d+\])?)$", " ".join(declaration.split())).groups()
        if name not in ("struct_size", "reserved"):
            yield sentences(comment), kind.strip(), name


def choices(header, text):
    """The constants that a field takes: their names by the words for them. Empty if it takes numbers."""
    family = re.match(r"(?:[\w ]+: )?GUSSET_([A-Z0-9_]+?)_\.\.\.", text)
    if family:
        names = re.findall(rf"#define (GUSSET_{family.group(1)}_[A-Z0-9_]+) (\d+)", header)
        # Of families within families, as GUSSET_NORMAL_ and GUSSET_NORMAL_KIND_, none is in use here.
        return {name.removeprefix(f"GUSSET_{family.group(1)}_").lower(): int(number) for name, number in names}
    listed = re.match(r"((?:GUSSET_[A-Z0-9_]+(?:, | or )?)+)[.:]", text)
    several = re.findall(r"GUSSET_[A-Z0-9_]+", listed.group(1)) if listed else []
    several = [*dict.fromkeys(several + (re.findall(r"(?:^|\. )(GUSSET_[A-Z0-9_]+):", text) if several else []))]
    if len(several) < 2:
        return {}
    common = several[0].split("_")[1]
    return {name.removeprefix(f"GUSSET_{common}_").lower(): int(re.search(rf"#define {name} (\d+)", header).group(1)) for name in several}


def described(header):
    """Of each struct the fields: name, kind, words for its values, the field and value that it is read for, text."""
    for made, name in STRUCTS.items():
        listed = list(fields(header, f"gusset_{name}"))
        words = {field: choices(header, text) for text, _, field in listed}
        counted = {field.removesuffix("_count") for _, _, field in listed if field.endswith("_count")}
        out = []
        for text, kind, field in listed:
            plain = re.sub(r"\[\d+\]", "", field)
            if field.endswith("_count") and any(f"{stem}_count" == field and (f"{stem}s" in words or stem in words or f"{stem}es" in words)
                                                for stem in counted) and field not in ("row_count",):
                continue  # it counts an array
            reads = re.search(r"(?:[Rr]ead for|With) GUSSET_([A-Z0-9_]+)", text)
            needs = out[-1][3] if text.startswith("The same") and out else None
            for other, values in words.items():
                for word in values:
                    if reads and reads.group(1).endswith(f"_{word.upper()}") and other != field and needs is None:
                        family = reads.group(1).removesuffix(f"_{word.upper()}")
                        mine = next(t for t, _, f in listed if f == other)
                        if f"GUSSET_{family}_" in mine:
                            needs = (other, word)
            flag = re.search(r"if (\w+) is 1", text)
            needs = (flag.group(1), "1") if flag else needs
            if kind.startswith("struct") and "*" not in kind and "gusset_indices" not in kind:
                continue  # a struct of its own has no keyword
            if kind.endswith("_options *"):
                what = "options:" + next(k for k, v in STRUCTS.items() if f"gusset_{v} " in kind + " ")
            elif "*" in kind or "gusset_indices" in kind:
                what = "array"
            elif words[field]:
                what = "choice"
            elif "[" in field:
                what = "row"
            elif re.search(r"\b0 or 1\.|\b1: ", text) and kind == "uint32_t" and not re.search(r"0 to |0: \d", text):
                what = "flag"
            else:
                what = NUMBERS.get(kind, "int")
            out.append((plain, what, words[field], needs, text))
        yield made, name, out


def annotation(what, words):
    if what == "choice":
        return f"Literal[{', '.join(repr(word) for word in words)}]"
    if what.startswith("options:"):
        return what.removeprefix("options:")
    return {"array": "ArrayLike", "row": "Sequence[float]", "flag": "bool"}.get(what, what)


def written():
    header = HEADER.read_text("utf-8")
    out = ['"""Keywords of structs of options, with what gusset.h says of them. Written by generate.py; do not edit."""\n\n'
           "# fmt: off\nfrom __future__ import annotations\n\nimport sys\nfrom collections.abc import Sequence\nfrom typing import Any, Literal, Optional\n\n"
           "from numpy.typing import ArrayLike\n\nif sys.version_info >= (3, 12):\n    from typing import TypedDict, Unpack\nelse:\n"
           "    from typing_extensions import TypedDict, Unpack\n\n"
           "__all__ = [\"FIELDS\", \"Unpack\", " + ", ".join(f'"{name}"' for name in STRUCTS) + "]\n"]
    table = ["\n\n#: By struct: of each keyword its kind, the numbers of its words, and the field and word that it is read for.\n"
             "FIELDS: dict[str, dict[str, tuple[str, dict[str, int], Optional[tuple[str, str]]]]] = {\n"]
    # Those that others have in them come first.
    for made, name, listed in sorted(described(header), key=lambda one: any(what.startswith("options:") for _, what, *_ in one[2])):
        out.append(f"\n\nclass {made}(TypedDict, total=False):\n    \"\"\"Fields of ``gusset_{name}``; what is not given is as by default.\"\"\"\n\n")
        table.append(f"    \"gusset_{name}\": {{\n")
        for field, what, words, needs, text in listed:
            text = re.sub(r"GUSSET_[A-Z0-9_]*_\.\.\.", "one of the words", text)
            out.append(textwrap.fill(text, 118, initial_indent="    #: ", subsequent_indent="    #: ") + "\n")
            out.append(f"    {field}: {annotation(what, words)}\n")
            table.append(f"        \"{field}\": ({what!r}, {words!r}, {needs!r}),\n")
        table.append("    },\n")
    table.append("}\n")
    text = "".join(out) + "".join(table)
    return text


def parameter(param):
    """A parameter of a filter as a keyword with its type."""
    from gusset_mesh import _plugin
    if param.choice_count:
        kind = f"Union[int, Literal[{', '.join(map(repr, _plugin.choices_of(param)))}]]"
    elif param.arity > 1:
        kind = "Sequence[float]"
    else:
        kind = {_plugin.lib.GUSSET_PARAM_BOOL: "bool", _plugin.lib.GUSSET_PARAM_INT: "int"}.get(param.kind, "float")
    return f"{_plugin.text(param.id)}: {kind} = ..."


def stubs():
    from gusset_mesh import _plugin
    gives = {_plugin.MESH: "Mesh", _plugin.CURVES: "Curves", _plugin.TEXT: "Report"}
    takes = {_plugin.MESH: "MeshLike", _plugin.CURVES: "CurvesLike"}
    out = ['"""Types of the filters. Written by generate.py; do not edit."""\n\n# fmt: off\nfrom collections.abc import Sequence\n'
           "from typing import Any, Literal, Optional, Union\n\nfrom ._call import Progress\n"
           "from ._plugin import Curves as Curves, Filter as Filter, Outputs as Outputs, Report as Report\n"
           "from .mesh import Mesh, MeshLike\n\nCurvesLike = Union[Curves, Any]\nall_filters: dict[str, Filter]\n"]
    for one in _plugin.filters():
        given = []
        for k in range(one._struct.min_inputs):
            given.append(f"input_{k}: {takes[one.input_kinds[min(k, len(one.input_kinds) - 1)]]}")
        if one._struct.max_inputs > one._struct.min_inputs:
            given.append(f"*inputs: {takes[one.input_kinds[-1]]}")
        else:
            given += ["/", "*"] if given else ["*"]
        given += [parameter(param) for param in one.params]
        given += ["threads: int = ...", "progress: Optional[Progress] = ..."]
        results = [gives[kind] for kind in one.output_kinds]
        result = results[0] if len(results) == 1 else f"tuple[{', '.join(results)}]"
        lines = textwrap.fill(", ".join(given), 132, initial_indent="    ", subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)
        out.append(f"\n\ndef {one.script_name}(\n{lines},\n) -> {result}:\n    \"\"\"{one.help}\"\"\"\n")
    return "".join(out)


if __name__ == "__main__":
    options = HERE / "gusset_mesh/_options.py"
    if sys.argv[1:] != ["--check"]:
        options.write_text(written(), "utf-8")
    for file, write in ((options, written), (HERE / "gusset_mesh/filters.pyi", stubs)):
        if sys.argv[1:] != ["--check"]:
            file.write_text(write(), "utf-8")
        elif file.read_text("utf-8") != write():
            sys.exit(f"{file} is not what generate.py writes")
