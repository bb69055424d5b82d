"""The modules of the package import each other in one direction: imports within functions count too."""

import ast
import pathlib

PACKAGE = pathlib.Path(__file__).resolve().parents[1] / "gusset_mesh"


def imports(source, modules):
    """The modules of the package that a module imports, anywhere in its source."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        names = []
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            names = [node.module.split(".")[0]] if node.module else [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "gusset_mesh":
            names = node.module.split(".")[1:2] or [alias.name for alias in node.names]
        elif isinstance(node, ast.Import):
            names = [alias.name.split(".")[1] for alias in node.names if alias.name.startswith("gusset_mesh.")]
        # A name that is not a module is one that `__init__` has.
        found.update(name if name in modules else "__init__" for name in names)
    return found


def circle(graph):
    """The modules of a circle, in order; empty if there is none."""
    done, path = set(), []

    def visit(module):
        if module in path:
            return path[path.index(module):]
        if module in done:
            return []
        path.append(module)
        found = next((found for other in sorted(graph.get(module, ())) if (found := visit(other))), [])
        path.pop()
        done.add(module)
        return found

    return next((found for module in sorted(graph) if (found := visit(module))), [])


def package():
    """The source of each module, without the extension module."""
    return {path.stem: path.read_text("utf-8") for path in PACKAGE.glob("*.py")}


def test_no_circle():
    sources = package()
    assert len(sources) > 15
    graph = {name: imports(source, sources) for name, source in sources.items()}
    assert circle(graph) == []


def test_planted_circles_are_found():
    sources = package()
    graph = {name: imports(source, sources) for name, source in sources.items()}
    late = "def late():\n    from .filters import all_filters\n    return all_filters\n"
    graph["_plugin"] |= imports(late, sources)
    assert set(circle(graph)) == {"_plugin", "filters"}
    assert imports("from . import filters, lib", sources) == {"filters", "__init__"}
    assert imports("import gusset_mesh.mesh\nfrom gusset_mesh.net import Net", sources) == {"mesh", "net"}
