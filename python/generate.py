"""Writes what follows from the library: gusset_mesh/_options.py, the keywords of structs of options, from the description of the interface
(`make build/interface.json`); and gusset_mesh/filters.pyi, the types of the filters, from the plugin's table.

    generate.py [--check]      run where the package can be imported; --check says whether the files are what it would write
"""

import json
import os
import pathlib
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
INTERFACE = HERE.parent / "build/interface.json"
#: Structs whose fields are keywords, by the names that they have here.
STRUCTS = {
    "WeldOptions": "weld_options", "OrientOptions": "orient_options", "BoundaryOptions": "boundary_options", "StitchOptions": "stitch_options",
    "FillOptions": "fill_options", "TrimOptions": "trim_options", "JoinOptions": "join_options", "AlignOptions": "alignment_options",
    "OutlineOptions": "outline_options", "OffsetOptions": "offset_options", "NetMeshOptions": "net_mesh_options",
    "ConcatenateOptions": "concatenate_options", "SurfaceOptions": "surface_options", "NearestOptions": "nearest_options", "ContourOptions": "contour_options",
    "IntersectionOptions": "intersection_options", "SheetMeshOptions": "sheet_mesh_options", "DevelopOptions": "develop_options",
}
NUMBERS = {"uint32_t": "int", "size_t": "int", "int64_t": "int", "double": "float"}


def whole(field):
    """The text of a field."""
    return " ".join([field["brief"], *field.get("text", [])]).strip()


def words_of(choice):
    """The values of a choice, by what their names do not share."""
    names = [value["name"] for value in choice["values"]]
    shared = os.path.commonprefix([name + "_" for name in names]).rpartition("_")[0] + "_"
    return {value["name"].removeprefix(shared).lower(): value["value"] for value in choice["values"]}


def kind_of(field, names, words):
    """What a keyword takes, or None if the field is none of its own."""
    kind, pointers = field["type"], field.get("pointers", [])
    stem = field["name"].removesuffix("_count")
    if field["name"] in ("struct_size", "reserved") or stem != field["name"] and {stem, f"{stem}s", f"{stem}es"} & names - {"row", "rows"}:
        return None  # it counts an array
    if kind.endswith("_options"):
        return f"options:{next(made for made, name in STRUCTS.items() if f'gusset_{name}' == kind)}" if pointers else None
    if pointers or kind == "gusset_indices":
        return "array"
    if kind.startswith("gusset_") and kind not in words:
        return None  # a struct of its own has no keyword
    if kind in words:
        return "choice"
    return "row" if "sizes" in field else "flag" if "flag" in field else NUMBERS[kind]


def described(interface):
    """Of each struct the fields: name, kind, words for its values, the field and value that it is read for, text."""
    words = {choice["name"]: words_of(choice) for choice in interface["choices"] if "bits" not in choice}
    numbers = {value["name"]: value["value"] for choice in interface["choices"] for value in choice["values"]}
    for made, name in STRUCTS.items():
        fields = next(struct["fields"] for struct in interface["structs"] if struct["name"] == f"gusset_{name}")
        kinds = {field["name"]: field["type"] for field in fields}
        out = []
        for field in fields:
            what = kind_of(field, set(kinds), words)
            if what is None:
                continue
            needs = None
            if "when" in field:
                other, value = field["when"].split(" ")[:2]
                value = next((word for word, number in words.get(kinds[other], {}).items() if number == numbers.get(value.rstrip(","))), value)
                needs = (other, value)
            taken = words.get(field["type"], {}) if what == "choice" else {}
            only = [numbers[name] for name in field.get("values", "").split(", ") if name]
            taken = {word: number for word, number in taken.items() if not only or number in only}
            out.append((field["name"], what, taken, needs, whole(field)))
        yield made, name, out


def annotation(what, words):
    if what == "choice":
        return f"Literal[{', '.join(repr(word) for word in words)}]"
    if what.startswith("options:"):
        return what.removeprefix("options:")
    return {"array": "ArrayLike", "row": "Sequence[float]", "flag": "bool"}.get(what, what)


def written():
    interface = json.loads(INTERFACE.read_text("utf-8"))
    out = ['"""Keywords of structs of options, with what the C headers say of them. Written by generate.py; do not edit."""\n\n'
           "# fmt: off\nfrom __future__ import annotations\n\nimport sys\nfrom collections.abc import Sequence\nfrom typing import Any, Literal, Optional\n\n"
           "from numpy.typing import ArrayLike\n\nif sys.version_info >= (3, 12):\n    from typing import TypedDict, Unpack\nelse:\n"
           "    from typing_extensions import TypedDict, Unpack\n\n"
           "__all__ = [\"FIELDS\", \"Unpack\", " + ", ".join(f'"{name}"' for name in STRUCTS) + "]\n"]
    table = ["\n\n#: By struct: of each keyword its kind, the numbers of its words, and the field and word that it is read for.\n"
             "FIELDS: dict[str, dict[str, tuple[str, dict[str, int], Optional[tuple[str, str]]]]] = {\n"]
    # Those that others have in them come first.
    for made, name, listed in sorted(described(interface), key=lambda one: any(what.startswith("options:") for _, what, *_ in one[2])):
        out.append(f"\n\nclass {made}(TypedDict, total=False):\n    \"\"\"Fields of ``gusset_{name}``; what is not given is as by default.\"\"\"\n\n")
        table.append(f"    \"gusset_{name}\": {{\n")
        for field, what, words, needs, text in listed:
            if text:
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
