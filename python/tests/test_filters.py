"""Every filter of the table is called from Python."""

import inspect
import pathlib
import subprocess
import sys

import numpy as np
import pytest
import shapes
import trimesh

import gusset_mesh as gm
from gusset_mesh import filters

HERE = pathlib.Path(__file__).resolve().parent
SHEET = shapes.grid(7, 9, lambda u, v: 0.2 * np.sin(3 * u) * np.cos(2 * v)).reshape(-1, 3), shapes.quads(7, 9)
BESIDE = SHEET[0] + [0, 1.2, 0], SHEET[1]
STEEP = (SHEET[0] - [0.5, 0.5, 0])[:, [2, 1, 0]] + [0.5, 0.5, 0.1], SHEET[1]
BOX = np.array([[x, y, z] for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]) * 1.5, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
angle = np.linspace(0, 2 * np.pi, 20, endpoint=False)
RINGS = gm.Curves([np.stack([np.cos(angle), np.sin(angle), 0 * angle + k], axis=1) for k in range(4)], closed=True)
PAIR = gm.Curves([RINGS[0], RINGS[1]], closed=True)
LINES = gm.Curves([[[x, 0, 0.3 * x], [x, 0.5, 0.1], [x, 1, 0]] for x in (0.0, 0.4, 0.7, 1.0)])
ACROSS = gm.Curves([[[0.0, y, 0], [0.4, y, 0.1], [0.7, y, 0.2], [1.0, y, 0.3]] for y in (0.0, 0.5, 1.0)])
ASIDE = gm.Curves([RINGS[0], RINGS[0] + [3, 0, 0]], closed=True)
CROSSING = gm.Curves([[[-2.0, 0.1, 0], [-1, 0.2, 0], [2, 0.1, 0]], [[0.3, -2.0, 0], [0.2, -1, 0], [0.1, 2, 0]]])
INPUTS = {
    "stitch": (shapes.cap(), shapes.cap(-1)), "join": (shapes.cap(), shapes.cap(-1)), "align": (shapes.cap(), shapes.cap()),
    "trim": (shapes.cap(), shapes.cap()), "fill": (shapes.tube(),), "develop": (shapes.tube(),),
    "smooth_intersect": (SHEET, STEEP), "net_join": (SHEET, BESIDE), "net_analyse": (SHEET, BESIDE), "smooth_distance": (SHEET, BESIDE),
    "net_settle": (SHEET, BESIDE), "morph": (SHEET, BESIDE), "unite": (BOX, (BOX[0] + 1, BOX[1])), "lattice": (SHEET, BOX, (BOX[0] * [1, 1, 2], BOX[1])),
    "section": (BOX,), "facing_arcs": (ASIDE,), "strip": (PAIR,), "curve_meet": (CROSSING,), "curve_nearest": (RINGS, LINES), "loft": (RINGS,),
    "smooth_net": (ACROSS, LINES), "smooth_curve": (SHEET, CROSSING), "smooth_nearest": (SHEET, CROSSING), "net_lathe": (gm.Curves([LINES[0]]),), "curve_offset": (gm.Curves([RINGS[0]], closed=True),), "curve_svg": (gm.Curves([RINGS[0]], closed=True),),
}
GENERAL = {gm.filters._plugin.MESH: SHEET, gm.filters._plugin.CURVES: RINGS}
KINDS = {gm.filters._plugin.MESH: gm.Mesh, gm.filters._plugin.CURVES: gm.Curves, gm.filters._plugin.TEXT: filters.Report}
PARAMS = {"smooth_net": {"tolerance": 0.5}}


def inputs_of(one):
    return INPUTS.get(one.script_name, tuple(GENERAL[kind] for kind in one.input_kinds))


@pytest.mark.parametrize("name", filters.all_filters)
def test_each_filter_runs(name):
    one = filters.all_filters[name]
    given = inputs_of(one)
    outputs = one.run(*given, **PARAMS.get(name, {}))
    assert [type(out) for out in outputs] == [KINDS[kind] for kind in one.output_kinds]
    for out in outputs:
        if isinstance(out, gm.Mesh):
            assert out.face_count > 0 and np.isfinite(out.points).all()
        elif isinstance(out, filters.Report):
            assert out and all(type(number) in (bool, int, float) for number in out.values.values())
    again = getattr(filters, name)(*given, threads=1, **PARAMS.get(name, {}))
    first = again if isinstance(again, (gm.Mesh, gm.Curves, str)) else again[0]
    if isinstance(first, (gm.Mesh, gm.Curves)):
        assert first.points.tobytes() == outputs[0].points.tobytes()
    else:
        assert str(first) == str(outputs[0])


@pytest.mark.parametrize("name", filters.all_filters)
def test_each_filter_tells_of_itself(name):
    one = filters.all_filters[name]
    assert one.help in one.__doc__ and all(f"{param}: " in one.__doc__ for param in one.param_ids)
    assert set(one.param_ids) <= set(inspect.signature(one).parameters)
    with pytest.raises(TypeError, match="no parameter"):
        one(*inputs_of(one), nothing_of_the_kind=1)
    for param in one.params:
        word = gm.filters._plugin.text(param.id)
        if param.choice_count:
            with pytest.raises(ValueError, match="there are"):
                one(*inputs_of(one), **{word: "nothing of the kind"})
        elif param.arity == 1:
            with pytest.raises(gm.InputError):
                one(*inputs_of(one), **{word: float("nan")})


def test_words_and_places_are_the_same():
    plain = filters.fill(shapes.tube(), finish="blend")[0]
    assert plain.points.tobytes() == filters.fill(shapes.tube(), finish=2)[0].points.tobytes()
    assert plain.vertex_count > shapes.tube()[0].shape[0]


def test_reports_have_numbers():
    said = filters.check(trimesh.creation.box())
    assert said.values["vertices"] == 8 and type(said.values["vertices"]) is int
    assert said.values["closed"] is True
    measured = filters.fill(shapes.tube())[1].values
    assert type(measured["smallest_angle"]) is type(measured["area"]) is float and 0 < measured["smallest_angle"] < 1.1


def test_inputs_of_two_precisions():
    # Coordinates that both hold.
    faces = shapes.quads(3, 3)
    left, right = (shapes.grid(3, 3).reshape(-1, 3) + [x, 0, 0] for x in (0.0, 1.25))
    both = gm.filters.join((left, faces), (right, faces))[0]
    mixed = gm.filters.join((left.astype(np.float32), faces), (right, faces))[0]
    assert mixed.points.dtype == np.float64 and np.array_equal(mixed.points, both.points)


def test_failures_are_raised():
    points, faces = shapes.cap()
    bad = points.copy()
    bad[4] = np.inf
    with pytest.raises(gm.InputError) as caught:
        filters.stitch((points, faces), (bad, faces))
    assert (caught.value.element, caught.value.index, caught.value.input) == ("vertex", 4, 1)
    with pytest.raises(gm.InputError):
        filters.weld()
    with pytest.raises(gm.InputError):
        filters.weld((points, faces), (points, faces))


def test_outputs_carry_values():
    outputs = filters.all_filters["stitch"].run(shapes.cap(), shapes.cap(-1), origins=True)
    assert outputs.has_origins()
    got = outputs.carry([np.full((len(shapes.cap()[1]), 2), k) for k in (7, 9)], "faces", "nearest")
    assert set(np.unique(got)) == {7, 9} and got.shape == (outputs[0].face_count, 2)


def test_generated_files_are_up_to_date():
    made = subprocess.run([sys.executable, HERE.parent / "generate.py", "--check"], cwd=HERE.parent, capture_output=True, text=True)
    assert made.returncode == 0, made.stderr


def test_types():
    pytest.importorskip("mypy")
    made = subprocess.run([sys.executable, "-m", "mypy"], cwd=HERE.parent, capture_output=True, text=True)
    assert made.returncode == 0, made.stdout
