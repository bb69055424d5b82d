"""Writes what follows from the library. From the description of the interface (`make build/interface.json`): gusset_mesh/choices.py, the words of
choices; gusset_mesh/_options.py, the keywords of structs of options; gusset_mesh/_reports.py, a class for each struct that a function fills.
From the plugin's table: gusset_mesh/filters.pyi, the types of the filters.

    generate.py [--check]      run where the package can be imported; --check says whether the files are what it would write
"""

import json
import os
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
INTERFACE = HERE.parent / "build/interface.json"
#: Structs with keywords, besides structs of options.
WITH_KEYWORDS = {"gusset_net_primitive"}
#: Structs without a class: the errors of a call, and Leus's search, which the package leaves out.
WITHOUT_CLASS = {"gusset_error_report", "gusset_mask_report", "gusset_reference_report"}
NUMBERS = {
    "uint8_t": "np.uint8", "uint32_t": "np.uint32", "int32_t": "np.int32", "uint64_t": "np.uint64", "int64_t": "np.int64",
    "size_t": "np.uintp", "float": "np.float32", "double": "np.float64",
}
WIDTH = 118


def camel(name):
    """``FillReport`` of ``gusset_fill_report``."""
    return "".join(part.capitalize() for part in name.removeprefix("gusset_").split("_"))


def whole(described):
    """The text of a field or a struct."""
    return " ".join([described["brief"], *described.get("text", [])]).strip()


def wrapped(text, indent, first=""):
    return textwrap.fill(text, WIDTH, initial_indent=indent + first, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False) + "\n"


def documented(text, indent):
    """A docstring."""
    lines = wrapped(text.replace("\\", "\\\\"), indent, '"""').rstrip("\n")
    closing = f"\n{indent}" if "\n" in lines or len(lines) > WIDTH else ""
    return f'{lines}{closing}"""\n'


class Interface:
    """The description of the interface, by name."""

    def __init__(self):
        described = json.loads(INTERFACE.read_text("utf-8"))
        self.choices = {choice["name"]: choice for choice in described["choices"]}
        self.structs = {struct["name"]: struct["fields"] for struct in described["structs"]}
        self.texts = {struct["name"]: whole(struct) for struct in described["structs"]}
        self.handles = {handle["name"] for handle in described["handles"]}
        self.functions = described["functions"]
        self.words = {name: words_of(choice) for name, choice in self.choices.items()}
        self.numbers = {value["name"]: value["value"] for choice in self.choices.values() for value in choice["values"]}

    def choice(self, field):
        """The choice of a field and whether its constants are bits; or None."""
        name = field.get("choice")
        name = field["type"] if name is True else name
        return name and (name, "bits" in self.choices[name])


def words_of(choice):
    """The values of a choice by word: the part of the name that differs."""
    names = [value["name"] for value in choice["values"]]
    shared = os.path.commonprefix([name + "_" for name in names]).rpartition("_")[0] + "_"
    return {value["name"].removeprefix(shared).lower(): value["value"] for value in choice["values"]}


def choices(interface):
    out = ['"""Words for the choices of the interface, and their numbers. Written by generate.py; do not edit."""\n\n'
           "# fmt: off\nfrom typing import Literal\n"]
    table = ["\n#: By choice the numbers of its words.\nNUMBERS: dict[str, dict[str, int]] = {\n"]
    for name, choice in interface.choices.items():
        words = interface.words[name]
        text = choice["brief"] + (" Several words may be combined." if "bits" in choice else "")
        out.append("\n" + wrapped(text, "#: ") + wrapped(f"{camel(name)} = Literal[{', '.join(map(repr, words))}]", "    ").lstrip())
        table.append(wrapped(f"{name!r}: {words!r},", "    "))
    return "".join([*out, *table, "}\n"])


def counters(fields):
    """The fields that count arrays."""
    return {name for field in fields for name in re.findall(r"[a-z]\w*", field.get("shape", "") or "")}


def keyword(interface, field):
    """The type of a keyword and the arguments of its Keyword; None if the field has no keyword."""
    kind, choice, pointers = field["type"], interface.choice(field), field.get("pointers", [])
    if kind.endswith("_options") and pointers:
        return camel(kind), ["options"]
    if kind in interface.handles or kind in interface.structs and kind != "gusset_indices" and not pointers:
        return None  # the function has an argument for it
    if pointers or kind == "gusset_indices":
        return "ArrayLike", ["array", *([f"shape={tuple(field['shape'].split(' '))!r}"] if "shape" in field else [])]
    if choice:
        name, bits = choice
        only = [interface.numbers[value] for value in field.get("values", "").split(", ") if value]
        words = {word: number for word, number in interface.words[name].items() if not only or number in only}
        made = f"Literal[{', '.join(map(repr, words))}]" if only else f"choices.{camel(name)}"
        table = repr(words) if only else f"choices.NUMBERS[{name!r}]"
        return (f"Union[{made}, Collection[{made}]]", ["bits", table]) if bits else (made, ["choice", table])
    number = "float" if kind in ("double", "float") else "int"
    if "sizes" in field:
        return f"Sequence[{number}]", ["row"]
    return ("bool", ["flag"]) if "flag" in field else (number, [number])


def options(interface):
    structs = {name: fields for name, fields in interface.structs.items() if name.endswith("_options") or name in WITH_KEYWORDS}
    out = ['"""Keywords of structs of options, with what the C headers say of them. Written by generate.py; do not edit."""\n\n'
           "# fmt: off\nfrom __future__ import annotations\n\nimport sys\nfrom collections.abc import Collection, Sequence\n"
           "from typing import Literal, NamedTuple, Optional, Union\n\nfrom numpy.typing import ArrayLike\n\nfrom . import choices\n\n"
           "if sys.version_info >= (3, 12):\n    from typing import TypedDict, Unpack\nelse:\n    from typing_extensions import TypedDict, Unpack\n\n"
           '__all__ = ["FIELDS", "Keyword", "Unpack"]\n\n\n'
           'class Keyword(NamedTuple):\n    """How a keyword becomes a field."""\n\n    kind: str\n    #: The numbers of its words.\n'
           "    words: dict[str, int] = {}\n    #: The field and the word or number that it is read for.\n    needs: Optional[tuple[str, str]] = None\n"
           "    #: The sizes of an array: see `@shape` in the headers.\n    shape: tuple[str, ...] = ()\n"]
    table = ["\n\n#: By struct.\nFIELDS: dict[str, dict[str, Keyword]] = {\n"]
    # Options that are fields of other options come first.
    for name, fields in sorted(structs.items(), key=lambda one: any(field["type"].endswith("_options") for field in one[1])):
        out.append(f"\n\nclass {camel(name)}(TypedDict, total=False):\n    \"\"\"Fields of ``{name}``; what is not given is as by default.\"\"\"\n\n")
        table.append(f"    \"{name}\": {{\n")
        kinds = {field["name"]: field["type"] for field in fields}
        for field in fields:
            made = keyword(interface, field)
            if made is None or field["name"] in counters(fields) | {"struct_size", "reserved"}:
                continue
            taken, arguments = made
            arguments[0] = repr(arguments[0])
            if "when" in field:
                other, value = field["when"].split(" ")[:2]
                words = interface.words.get(kinds[other], {})
                value = next((word for word, number in words.items() if number == interface.numbers.get(value.rstrip(","))), value)
                arguments.append(f"needs={(other, value)!r}")
            out.append(wrapped(whole(field), "    #: ") if whole(field) else "")
            out.append(f"    {field['name']}: {taken}\n")
            table.append(f"        \"{field['name']}\": Keyword({', '.join(arguments)}),\n")
        table.append("    },\n")
    return "".join([*out, *table, "}\n"])


class Reports:
    """Classes for the structs that functions fill, and for the elements of their arrays."""

    def __init__(self, interface):
        self.interface = interface
        self.structs = interface.structs
        found = [param["type"] for function in interface.functions for param in function["params"]
                 if param["type"] in self.structs and param.get("pointers") == ["mut"]]
        for name in found:
            found += [field["type"] for field in self.structs[name] if field["type"] in self.structs and field["type"] not in found]
        # A struct with arrays of the caller is not a report.
        self.classes = [name for name in self.structs if name in found and name not in WITHOUT_CLASS | {"gusset_indices"}
                        and not any(field["type"] == "void" or field.get("pointers") == ["mut"] for field in self.structs[name])]
        self.getters = {}
        for function in interface.functions:
            last = function["params"][-1] if function["params"] else {}
            if "_get_" in function["name"] and last["type"] in self.classes and function["result"] == "gusset_status":
                self.getters[last["type"]] = function["name"]

    def is_plain(self, name):
        """Whether a struct contains numbers only."""
        return all(not field.get("pointers") and (field["type"] not in self.structs or self.is_plain(field["type"])) and field["type"] != "gusset_indices"
                   for field in self.structs[name])

    def is_element(self, name):
        """Whether numpy has arrays of a struct."""
        return self.is_plain(name) and self.structs[name][0]["name"] != "struct_size"

    def size(self, name, size):
        """A size of an array, as an expression of Python."""
        if size == "*":
            return "-1"
        size = size.replace("/", " // ").replace("+", " + ")
        field, *rest = size.split(" ", 1)
        if field.isdigit():
            return size
        of = next(one for one in self.structs[name] if one["name"] == field)
        is_array = "shape" in of or of["type"] == "gusset_indices"
        return " ".join([f"len(self.{field})" if is_array else f"self._struct.{field}", *rest])

    def array(self, name, field, read):
        """The type of an array, and the expression that converts what ``read`` gives."""
        kind, choice = field["type"], self.interface.choice(field)
        if kind in self.structs and kind != "gusset_indices":
            return f"{camel(kind)}Array", f"{camel(kind)}Array({read})"
        if choice:
            word = f"choices.{camel(choice[0])}"
            return (f"FlagArray[{word}]", f"FlagArray({read}, {choice[0]!r})") if choice[1] else ("NDArray[np.str_]", f"words({read}, {choice[0]!r})")
        if "flag" in field:
            return "NDArray[np.bool_]", f"{read} != 0"
        return f"NDArray[{NUMBERS['uint32_t' if kind == 'gusset_indices' else kind]}]", read

    def member(self, name, field):
        """The type of a property of a record, and the expression for its value."""
        kind, said, choice = field["type"], field["name"], self.interface.choice(field)
        value = f"self._struct.{said}"
        shape = [self.size(name, size) for size in field.get("shape", "").split(" ") if size]
        if kind == "char":
            return "str", f"text({value})"
        if field.get("pointers") and kind in self.structs and not self.is_element(kind):
            return f"list[{camel(kind)}]", f"self._list({camel(kind)}, {said!r}, {', '.join(shape)})"
        if field.get("pointers") or kind == "gusset_indices" or "sizes" in field:
            if "sizes" in field and (field.get("pointers") or kind == "gusset_indices"):
                (count,) = field["sizes"]
                each = [[size + f"[{k}]" if size.startswith("self._struct.") else size for size in shape] for k in range(count)]
                made = [self.array(name, field, f"self._array({', '.join([repr(said), *sizes, f'part={k}'])})") for k, sizes in enumerate(each)]
                return f"tuple[{', '.join(kind for kind, _ in made)}]", ", ".join(read for _, read in made)
            return self.array(name, field, f"self._array({', '.join([repr(said), *shape])})")
        if kind in self.structs:
            return camel(kind), f"{camel(kind)}({value}, self._owner)"
        if choice:
            word = f"choices.{camel(choice[0])}"
            return (f"frozenset[{word}]", f"flags({value}, {choice[0]!r})") if choice[1] else (word, f"word({value}, {choice[0]!r})")
        if "flag" in field:
            return "bool", f"bool({value})"
        return "float" if kind in ("double", "float") else "int", value

    def column(self, name, field):
        """The type of a property of an array of structs, and the expression for its value."""
        read = f"self.array[{field['name']!r}]"
        if "shape" in field:
            read += f".reshape(*self.array.shape, {field['shape'].replace(' ', ', ')})"
        return self.array(name, field, read)

    def written(self, name, base, members, more=""):
        """A class with a property for each field."""
        text = self.interface.texts[name]
        # The length of an array says what its count says.
        counts = {field["shape"].split(" ")[0] for field in self.structs[name] if "shape" in field and "count" in field["shape"].split(" ")[0]}
        out = [f"\n\nclass {base}:\n{documented(text if text else name, '    ')}\n    __slots__ = ()\n{more}"]
        for field in self.structs[name]:
            if field["name"] in {"struct_size", "reserved"} | counts or field["type"] in self.interface.handles:
                continue
            kind, value = members(name, field)
            out.append(f"\n    @property\n    def {field['name']}(self) -> {kind}:\n{documented(whole(field) or field['name'], '        ')}        return {value}\n")
        return "".join(out)

    def text(self):
        out = ['"""Structs that the library fills, as classes with a property for each field. Written by generate.py; do not edit."""\n\n'
               '# mypy: disable-error-code="no-any-return"\n# fmt: off\nfrom __future__ import annotations\n\n'
               "import numpy as np\nfrom numpy.typing import NDArray\n\nfrom . import choices\nfrom ._library import text\n"
               "from ._records import FlagArray, Record, RecordArray, flags, word, words\n"]
        for name in self.classes:
            getter = f"    _GETTER = {self.getters[name]!r}\n" if name in self.getters else ""
            out.append(self.written(name, f"{camel(name)}(Record)", self.member, f"    _NAME = {name!r}\n{getter}"))
            if self.is_element(name):
                out.append(self.written(name, f"{camel(name)}Array(RecordArray[{camel(name)}])", self.column, f"    RECORD = {camel(name)}\n"))
        return "".join(out)


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
    is_check = sys.argv[1:] == ["--check"]
    described = Interface()
    # Imports of the package come first.
    for name, write in (("choices.py", lambda: choices(described)), ("_options.py", lambda: options(described)),
                        ("_reports.py", lambda: Reports(described).text()), ("filters.pyi", stubs)):
        file = HERE / "gusset_mesh" / name
        if not is_check:
            file.write_text(write(), "utf-8")
        elif file.read_text("utf-8") != write():
            sys.exit(f"{file} is not what generate.py writes")
