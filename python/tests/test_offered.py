"""Every function of C is offered in Python, or is listed here with the reason why not."""

import ast
import json
import pathlib
import re

import file_bytes
import pytest

from gusset_mesh import files

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python/gusset_mesh"

#: Functions that Python omits on purpose. The name of a new C function is added to the package, or here.
WITHOUT = {
    "gusset_choice_text": "choices are words",
    "gusset_abi": "the package has the library that it was built with",
    "gusset_context_get_progress": "progress= is called with it",
    "gusset_context_set_log": "reports say the same",
    "gusset_net_edit": "nets do not change: Net(nodes) makes another",
    "gusset_net_read": "Net.nodes is an array of numpy's",
    "gusset_sheet_mask_chain": "a search of the papers, which Surface answers faster",
    "gusset_sheet_mask_elements": "the same",
    "gusset_sheet_mask_measure": "the same",
    "gusset_sheet_reference_mask": "the same",
    "gusset_curve_reference_mask": "the same",
    "gusset_sheet_normals_by_sections": "normals as a paper has them: Surface.evaluate gives exact ones",
}


def called(sources):
    """The names of the C functions that modules call: by name, by what they create, or to read reports."""
    found, kinds, getters, read = set(), set(), {}, set()
    for source in sources:
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.ClassDef):
                getters |= {node.name: one.value.value for one in node.body if isinstance(one, ast.Assign) and one.targets[0].id == "_GETTER"}
            elif isinstance(node, ast.Attribute) and node.attr.startswith("gusset_"):
                found.add(node.attr)
            elif isinstance(node, ast.Attribute) and node.attr == "read" and isinstance(node.value, ast.Name):
                read.add(node.value.id)
            elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name) and node.targets[0].id == "REPORT":
                read.add(node.value.id)
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.args and isinstance(node.args[0], ast.Constant):
                first = node.args[0].value
                if node.func.id in ("create", "_create"):
                    kinds.add(first)
                    name = next((one.value.value for one in node.keywords if one.arg == "name"), first)
                    found.add(f"gusset_{name}_create")
                elif node.func.id in ("result", "_result"):
                    found |= {f"gusset_{first}", "gusset_result_destroy"}
    return found | {f"gusset_{kind}_destroy" for kind in kinds} | {getters[name] for name in read & set(getters)}


def package():
    return [path.read_text("utf-8") for path in sorted(PACKAGE.glob("*.py"))]


def symbols():
    return set((ROOT / "include/gusset.symbols").read_text("utf-8").split())


def test_every_function_of_c_is_offered_or_listed():
    listed, offered = symbols(), called(package())
    assert len(listed) > 200
    assert listed - offered - set(WITHOUT) == set()
    # A function that Python offers, or that C lost, must leave the list.
    assert set(WITHOUT) & offered == set() and set(WITHOUT) <= listed


def test_a_function_that_nobody_calls_is_found():
    without = [source.replace('"net_morph"', '"net_copy"') for source in package()]
    assert symbols() - called(without) - set(WITHOUT) == {"gusset_net_morph_create"}


def test_every_function_of_files_is_called():
    header = (ROOT / "include/gusset_files.h").read_text("utf-8")
    source = (PACKAGE / "files.py").read_text("utf-8")
    table = header[header.index("typedef struct gusset_files {"):header.index("} gusset_files;")]
    functions = re.findall(r"\(\*(\w+)\)\(", table)
    assert len(functions) == 7
    assert [name for name in functions if f"_table().{name}" not in source] == []
    flags = re.findall(r"/// Flag of \w+: .*\n#define (\w+)", header)
    assert len(flags) == 4 and all(f"lib.{name}" in source for name in flags)


def test_the_page_of_documents_shows_what_read_gives(tmp_path, monkeypatch):
    if not file_bytes.has_files():
        pytest.skip("the library was built without files: `make files`")
    page = (ROOT / "docs/guides/files.md").read_text("utf-8")
    shown = json.loads(page[page.index("```text\n{\n") + 8:].partition("```")[0])
    given = []

    def unpacked(description, memory):
        given.append((json.loads(description.tobytes()), memory.size))
        return files.Document()
    monkeypatch.setattr(files, "unpacked", unpacked)
    files.save(tmp_path / "a.ply", ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]))
    files.read(tmp_path / "a.ply")
    assert given == [(shown, 168)]
    # Each member is described in a table or a sentence.
    members = {name for one in (shown, shown["meshes"][0], shown["points"], shown["curves"]) for name in one}
    assert all(f"`{name}`" in page or f'"{name}"' in page.partition("## Example")[0] for name in members)
