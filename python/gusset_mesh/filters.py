"""Every filter of the plugin's table as a function: meshes and curves in, meshes, curves and reports out.

Parameters are keywords; what is not given is what suits the inputs. Choices are words, or their places from 0.

>>> from gusset_mesh import filters
>>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
>>> filters.check(square)[:4]
'4 ve'
"""

from __future__ import annotations

import inspect

from . import _plugin
from ._library import lib, text
from ._plugin import Curves, Filter, Outputs, Report, all_filters

__all__ = ["Curves", "Filter", "Outputs", "Report", "all_filters"]


def _documented(one: Filter) -> None:
    names = [text(p.label) for p in one.params]
    kinds = {_plugin.MESH: "mesh", _plugin.CURVES: "curves", _plugin.TEXT: "report"}
    lines = [one.help, "", f"Gives: {', '.join(kinds[kind] for kind in one.output_kinds)}.", ""]
    for name, label, param in zip(one.param_ids, names, one.params):
        words = f" One of {', '.join(map(repr, _plugin.choices_of(param)))}." if param.choice_count else ""
        within = "" if param.choice_count or param.kind == lib.GUSSET_PARAM_BOOL else f" From {param.min:g} to {param.max:g}."
        lines.append(f"{name}: {label}. {text(param.help)}{words}{within}")
    if one.reference:
        lines += ["", f"Source: {one.reference}"]
    one.__doc__ = "\n".join(lines)
    keyword = inspect.Parameter.KEYWORD_ONLY
    one.__signature__ = inspect.Signature([  # type: ignore[attr-defined]
        inspect.Parameter("inputs", inspect.Parameter.VAR_POSITIONAL),
        *(inspect.Parameter(name, keyword, default=None) for name in one.param_ids if name.isidentifier()),
        inspect.Parameter("threads", keyword, default=0), inspect.Parameter("progress", keyword, default=None),
    ])


for _one in all_filters.values():
    _documented(_one)
globals().update(all_filters)
__all__ += list(all_filters)
