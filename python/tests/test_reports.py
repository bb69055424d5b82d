"""Reports say what their structs hold, in the types and shapes that they promise."""

import gc
import pickle
import typing
import weakref

import numpy as np
import pytest
import shapes

import gusset_mesh as gm
from gusset_mesh._handles import create
from gusset_mesh._library import ffi, lib
from gusset_mesh._records import Record, RecordArray
from gusset_mesh._reports import FacingView

TUBE = shapes.tube()
NET = gm.Net(shapes.grid(6, 9, lambda u, v: u * v))
WAVES = gm.Surface(shapes.grid(16, 16, lambda u, v: np.sin(3 * u) * np.cos(2 * v), (3.0, 3.0)))
ARC = gm.Outline([[0, 0], [1, 1], [2, 0]])


def rows_of_pieces():
    """Two squares with a gap, a third one that is too far for any joint."""
    square = shapes.grid(3, 3).reshape(-1, 3), shapes.quads(3, 3)
    return [(square[0] + [x, 0, 0], square[1]) for x in (0.0, 1.25, 50.0)]


REPORTS = {
    "stitch": lambda: gm.stitch(shapes.cap(), shapes.cap(-1), rows="count", row_count=2).report,
    "fill": lambda: gm.fill(TUBE, refine="rim_density").report,
    "weld": lambda: gm.weld(TUBE).report,
    "sew": lambda: gm.sew(TUBE).report,
    "orient": lambda: gm.orient(TUBE).report,
    "check": lambda: gm.check(TUBE).report,
    "certify": lambda: gm.certify([TUBE], TUBE).report,
    "join": lambda: gm.join(rows_of_pieces()).report,
    "develop": lambda: gm.develop(TUBE).report,
    "align": lambda: gm.align([TUBE, TUBE]).report,
    "trim": lambda: gm.trim([TUBE, TUBE]).report,
    "boundary": lambda: gm.boundary_loops(TUBE).report,
    "loop": lambda: gm.boundary_loops(TUBE)[0],
    "quality": lambda: gm.fill(TUBE).quality,
    "origins": lambda: gm.fill(TUBE).origins.view("faces"),
    "net_mesh": lambda: NET.mesh(texture=True).report,
    "net_measure": NET.measure,
    "sheet": lambda: WAVES.sheets[0].report,
    "sheet_mesh": lambda: WAVES.sheets[0].mesh().report,
    "surface": lambda: WAVES.report,
    "paths": lambda: WAVES.section([0, 0, 0.2], [0, 0, 1], [0, 0.1]).report,
    "hits": lambda: WAVES.hits([[1, 1, 5], [9, 9, 9]], [0, 0, -1]).report,
    "outline": lambda: ARC.report,
    "curve": lambda: ARC.curve.report,
    "places": lambda: ARC.curve.intersect(gm.Curve.through([[0, 0.5, 0], [2, 0.5, 0]])).report,
    "measures": lambda: ARC.curve.measure(),
}


def flat(value):
    """The numbers of a field of cffi, in a row."""
    ctype = ffi.typeof(value)
    if ctype.kind == "struct" and ctype.cname.startswith("struct gusset_indices"):
        return [value.data[k] for k in range(value.count)]
    return [one for k in range(len(value)) for one in (flat(value[k]) if ffi.typeof(value).item.kind in ("array", "struct") else [value[k]])]


def check_record(record):
    """Compares each property with the field that it reads, and with its annotation. Returns the number of fields."""
    seen = 0
    for name, made in vars(type(record)).items():
        if not isinstance(made, property):
            continue
        seen += 1
        value, hint = getattr(record, name), typing.get_type_hints(made.fget)["return"]
        field = getattr(record._struct, name)
        kind = typing.get_origin(hint) or hint
        assert isinstance(value, (str if kind is typing.Literal else kind)), name
        if kind in (int, float, bool, str):
            assert value == (ffi.string(field).decode() if kind is str and field else field), name
        elif kind is typing.Literal:
            assert value in typing.get_args(hint), name
        elif kind is frozenset:
            assert value <= set(typing.get_args(typing.get_args(hint)[0])), name
        elif kind is np.ndarray:
            scalar = typing.get_args(typing.get_args(hint)[1])[0]
            assert value.dtype.type is scalar, name
            is_lent = scalar not in (np.bool_, np.str_)
            assert not (is_lent and value.size and value.flags.writeable), name
            if is_lent and (ffi.typeof(field).kind != "pointer" or value.size):
                given = flat(field) if ffi.typeof(field).kind != "pointer" else ffi.unpack(field, value.size)
                assert np.array_equal(value.reshape(-1), np.array(given, value.dtype), equal_nan=value.dtype.kind == "f"), name
        elif kind is list:
            seen += sum(check_record(one) for one in value)
        elif isinstance(value, Record):
            seen += check_record(value)
        elif isinstance(value, RecordArray):
            seen += sum(check_elements(value))
    return seen


def check_elements(records):
    """Compares the first and last structs of an array with its columns."""
    for k in {0, len(records) - 1} if len(records) and records.array.ndim == 1 else ():
        one = records[k]
        for name in [name for name, made in vars(type(one)).items() if isinstance(made, property)]:
            value, column = getattr(one, name), getattr(records, name)
            if isinstance(value, frozenset):
                words = gm.choices.NUMBERS[column._choice]
                assert value == {word for word in words if column[word][k]}
            elif isinstance(value, Record):
                assert repr(column[k]) == repr(value)
            else:
                assert np.array_equal(column[k], value)
        yield check_record(one)


@pytest.mark.parametrize("name", REPORTS)
def test_fields_are_what_the_struct_holds(name):
    report = REPORTS[name]()
    assert check_record(report) >= 3 and repr(report).startswith(f"{type(report).__name__}(")


def test_weights_give_the_new_vertices_of_a_flat_patch():
    made = gm.fill((shapes.grid(12, 12).reshape(-1, 3), np.delete(shapes.quads(12, 12), [48, 49, 50, 59, 60, 61, 70, 71, 72], axis=0)),
                   refine="rim_density", keep="borders")
    report, points = made.report, made.mesh.points
    new = len(points) - len(report.parents)
    assert len(report.parents) > 3 and report.weights.shape == report.parents.shape
    assert np.allclose(points[new:], np.einsum("ij,ijk->ik", report.weights, points[report.parents]), atol=1e-12)
    assert sorted(report.holes.status.tolist()) == ["filled", "kept"]
    assert made.holes[made.holes.status == "filled"].vertex_count.tolist() == [len(report.parents)]


def test_rows_and_meridians_of_a_stitch():
    made = gm.stitch(shapes.cap(), shapes.cap(-1), rows="count", row_count=2)
    report = made.report
    assert report.matrix.shape == (4, len(report.meridians)) and report.closed and report.finish == "strip"
    for side in (0, 1):
        rim = np.append(report.rim[side], report.rim[side][0])
        assert np.array_equal(rim[report.meridians[:, side]], report.matrix[-side])
    plain = gm.stitch(shapes.cap(), shapes.cap(-1), finish="blend").report
    assert plain.finish == "blend" and plain.parents.shape[1] == 3


def test_arrays_of_arrays_and_their_counts():
    angle = np.linspace(0, 2 * np.pi, 12, endpoint=False) + 0.1
    loops = [np.stack([radius * np.cos(angle[::step]), radius * np.sin(angle[::step]), height + 0.1 * np.cos(angle[::step])], axis=1)
             for radius, step, height in ((1.0, 1, 0.0), (2.0, 2, 3.0))]
    given = [argument for loop in loops for argument in (ffi.cast("double *", loop.ctypes.data), len(loop))]
    view = FacingView.read(create("facing", *given, ffi.NULL))
    assert view.centre.dtype == np.float64 and np.allclose(view.centre, [loop.mean(axis=0) for loop in loops], atol=1e-12)
    assert np.allclose(view.normal[0], -view.normal[1]) and view.taken.shape == (2, 2)
    for loop, centre, normal, distances, runs in zip(loops, view.centre, view.normal, view.distances, view.runs):
        assert np.allclose(distances, (loop - centre) @ normal / np.linalg.norm(normal), atol=1e-12) and len(distances) == len(loop)
        assert runs[:, 1].sum() == (distances > 0).sum()


def test_words_and_bits_are_the_constants():
    assert set(gm.choices.NUMBERS["gusset_hole_status"].items()) >= {("filled", lib.GUSSET_HOLE_FILLED), ("not_free", lib.GUSSET_HOLE_NOT_FREE)}
    # A missing face leaves an edge without a second face; an edge with three faces is not manifold.
    fan = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 0]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
    assert gm.check(fan).report.properties.isdisjoint({"manifold", "closed"})
    assert gm.check(gm.fill(TUBE).mesh).report.properties == {"closed", "manifold", "oriented", "orientable"}
    open_chains = gm.boundary_loops(fan, non_manifold="stop")
    assert all("open" in chain.flags for chain in open_chains)
    edges = [loop.edge_flags["non_manifold"] for loop in gm.boundary_loops(fan)]
    assert np.concatenate(edges).sum() == 3
    with pytest.raises(ValueError, match="there are"):
        open_chains[0].edge_flags["broken"]
    joined = gm.join(rows_of_pieces()).report
    assert [joint.outcome for joint in joined.joints] == ["joined"] and {loop.reason for loop in joined.left} == {"too_far"}
    assert gm.align([TUBE, TUBE]).report.pieces.reason.tolist()[0] == "trusted"
    assert ARC.curve.measure("length").defined == {"length"} and "moments" in ARC.curve.measure(["moments", "area"]).defined


def test_common_parts_of_curves_have_four_places():
    line, part = gm.Curve.through([[0, 0, 0], [1, 0, 0]]), gm.Curve.through([[0.25, 0, 0], [0.75, 0, 0]])
    overlaps = line.intersect(part).report.overlaps
    assert overlaps.t.shape == (1, 4) and np.allclose(overlaps.t, [[0.25, 0.75, 0, 1]])
    assert overlaps[0, 1].t == pytest.approx(0.75)


def test_structs_live_as_long_as_they_are_used():
    hole, holes = gm.fill(TUBE).holes[1], gm.fill(TUBE).holes
    part, found = holes[holes.face_first > holes.face_first.min()], WAVES.nearest([[1, 1, 5]])
    nearest, owner = found[0], weakref.ref(found.array)
    del found
    before = repr(hole), repr(nearest)
    for _ in range(50):
        gm.fill(shapes.tube(columns=30))
    gc.collect()
    assert owner() is not None
    assert (repr(hole), repr(nearest)) == before and len(part) == 1 and part[0].rim_count == 24
    copy = pickle.loads(pickle.dumps(holes))
    assert np.array_equal(np.asarray(copy), np.asarray(holes)) and copy[-1].length == holes[-1].length
    assert [one.face_first for one in holes[::-1]] == holes.face_first[::-1].tolist()
    with pytest.raises(IndexError):
        holes[2]
