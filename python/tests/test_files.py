"""Files: against numpy and bytes by hand, against other readers, and with hostile bytes."""

import gc
import os
import pickle
import threading
import tracemalloc

import file_bytes
import numpy as np
import pytest
import shapes

import gusset_mesh as gm
from gusset_mesh import _library, files

pytestmark = pytest.mark.skipif(not file_bytes.has_files(), reason="the library was built without files: `make files`")

QUAD = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0.1], [0, 1, 0]]), [[0, 1, 2, 3]]


def arrays(document):
    """All arrays of a document by name."""
    for number, one in enumerate(document.meshes):
        named = {"points": one.mesh.points, "corners": one.mesh.corners, **vars(one), **one.vertex_properties, **one.face_properties}
        yield from ((f"{number} {name}", value) for name, value in named.items() if isinstance(value, np.ndarray))


def same_bits(a, b):
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()


@pytest.mark.parametrize("order", ["<", ">"])
def test_attributes_of_binary_ply_bit_for_bit(tmp_path, order):
    data, vertices, faces = file_bytes.ply(order, vertex_count=50, face_count=70)
    (tmp_path / "a.ply").write_bytes(data)
    document = gm.read(tmp_path / "a.ply")
    one = document.meshes[0]
    assert same_bits(document.mesh.points, np.stack([vertices[axis] for axis in "xyz"], axis=1).astype("<f8"))
    assert (document.mesh.faces == faces["vertex"]).all() and document.mesh.offsets is None
    assert one.normals_at == "vertices"
    assert same_bits(one.normals, np.stack([vertices[name] for name in ("nx", "ny", "nz")], axis=1).astype("<f8"))
    colours = np.stack([vertices[name] for name in ("red", "green", "blue", "alpha")], axis=1)
    assert one.vertex_colours.dtype == np.float32 and (np.rint(one.vertex_colours * 255) == colours).all()
    assert same_bits(one.vertex_properties["quality"], vertices["quality"].astype("<f8"))
    assert same_bits(one.face_properties["label"], faces["label"].astype("<f8"))
    assert one.vertex_types["quality"] == np.float32 and one.face_types["label"] == np.int16
    assert document.notes == [] and document.folder == tmp_path


def test_points_keep_their_precision(tmp_path):
    for dtype in (np.float32, np.float64):
        points = np.random.default_rng(1).normal(size=(4, 3)).astype(dtype)
        assert gm.save(tmp_path / "a.ply", (points, QUAD[1])) == []
        assert same_bits(gm.read(tmp_path / "a.ply").mesh.points, points)
        assert gm.save(tmp_path / "a.ply", (points, QUAD[1]), text=True) == []
        assert (tmp_path / "a.ply").read_bytes().startswith(b"ply\nformat ascii 1.0\n")
        assert same_bits(gm.read(tmp_path / "a.ply").mesh.points, points)


def test_polygons_of_several_sizes(tmp_path):
    (tmp_path / "a.ply").write_text(file_bytes.TEXT_PLY)
    mesh = gm.read(tmp_path / "a.ply").mesh
    assert [face.tolist() for face in mesh.faces] == [[0, 1, 2, 3], [0, 1, 4]]
    assert mesh.points.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]


def test_arrays_are_views_of_one_buffer(tmp_path):
    (tmp_path / "a.ply").write_bytes(file_bytes.ply("<", 3000, 5000)[0])
    document = gm.read(tmp_path / "a.ply")
    found = dict(arrays(document))
    assert len(found) == 6
    first = min(array.ctypes.data for array in found.values())
    last = max(array.ctypes.data + array.nbytes for array in found.values())
    assert last - first <= sum(array.nbytes for array in found.values()) + 8 * 20 + 4 * 5001
    assert not any(array.flags.writeable or array.flags.owndata for array in found.values())
    # Arrays live longer than the document.
    points, copy = document.mesh.points, document.mesh.points.copy()
    del document, found
    gc.collect()
    for _ in range(20):
        gm.read(tmp_path / "a.ply")
    assert same_bits(points, copy)


def test_big_arrays_are_not_copied_by_python(tmp_path):
    data = file_bytes.ply("<", 200_000, 300_000)[0]
    (tmp_path / "a.ply").write_bytes(data)
    gm.read(tmp_path / "a.ply")
    tracemalloc.start()
    document = gm.read(tmp_path / "a.ply")
    kept, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    # The bytes of the file, and for a moment whether all faces have one size.
    assert kept < 100_000 and peak < len(data) + 10 * 300_000
    assert document.mesh.face_count == 300_000


def test_documents_and_results_are_meshes(tmp_path):
    upper, lower = shapes.cap(1), shapes.cap(-1)
    for name, piece in (("a.ply", upper), ("b.ply", lower)):
        gm.save(tmp_path / name, piece)
    made = gm.join([gm.read(tmp_path / "a.ply"), gm.read(tmp_path / "b.ply")])
    assert same_bits(made.mesh.points, gm.join([upper, lower]).mesh.points)
    assert gm.save(tmp_path / "joined.ply", made) == []
    again = gm.read(tmp_path / "joined.ply")
    assert gm.check(again).is_closed and gm.check(again.meshes[0]).is_closed and gm.check(made).is_closed
    assert gm.filters.check(again).values["vertices"] == again.mesh.vertex_count
    several = gm.Document(meshes=again.meshes * 2)
    with pytest.raises(ValueError, match="2 meshes"):
        gm.check(several)
    with pytest.raises(ValueError, match="no mesh"):
        gm.check(gm.Document())
    assert repr(again) == f"<Document: Mesh: {again.mesh.vertex_count} vertices, {again.mesh.face_count} faces>"


@pytest.mark.parametrize("extension", ["ply", "off", "obj", "glb", "stl"])
def test_documents_round_trip(tmp_path, extension):
    file_bytes.require(extension, tmp_path)
    written = file_bytes.document()
    losses = gm.save(tmp_path / f"a.{extension}", written)
    document = gm.read(tmp_path / f"a.{extension}")
    one, again = written.meshes[0], document.meshes[0]
    assert len(again.mesh.triangles()) == len(one.mesh.triangles())
    # Text has the shortest digits that give the same single.
    corners = [mesh.points[mesh.triangles()].astype(np.float32).reshape(-1, 9).tolist() for mesh in (one.mesh, again.mesh)]
    assert sorted(corners[0]) == sorted(corners[1])
    assert gm.check(again).is_closed == gm.check(one).is_closed
    if extension != "stl":
        assert np.allclose(np.unique(again.vertex_colours, axis=0), np.unique(one.vertex_colours, axis=0), atol=1 / 255)
    if extension in ("obj", "glb"):
        assert [material.name for material in document.materials] == ["red", "blue"]
        named = [document.materials[index].name for index in again.face_materials]
        assert sorted(named) == sorted(written.materials[index].name for index in one.face_materials)
    else:
        assert any("materials" in loss for loss in losses)
    if extension == "ply":
        assert same_bits(again.vertex_properties["quality"], one.vertex_properties["quality"].astype(np.float64))
        assert again.vertex_types["quality"] == np.int32 and again.face_types["big"] == np.float64
        assert same_bits(again.normals, one.normals)


def test_scenes_keep_their_meshes(tmp_path):
    file_bytes.require("glb", tmp_path)
    turn = np.array([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0.0]])
    meshes = [gm.FileMesh(gm.Mesh(*shapes.cap()), "cap"), gm.FileMesh(gm.Mesh(*shapes.tube()), "tube")]
    placements = [files.Placement("left", 0, np.eye(3, 4)), files.Placement("right", 0, turn), files.Placement("middle", 1, np.eye(3, 4))]
    gm.save(tmp_path / "a.glb", gm.Document(meshes=meshes, placements=placements), lossy=True)
    scene = gm.read(tmp_path / "a.glb", scene=True)
    assert sorted(one.name for one in scene.meshes) == ["cap", "tube"]
    assert [one.name for one in scene.placements] == ["left", "right", "middle"]
    assert np.allclose(scene.placements[1].transform, turn)
    joined = gm.read(tmp_path / "a.glb")
    assert joined.mesh.face_count == 2 * meshes[0].mesh.face_count + meshes[1].mesh.face_count
    with pytest.raises(ValueError, match="2 meshes"):
        gm.check(scene)


def test_points_and_curves(tmp_path):
    cloud = files.Points(np.random.default_rng(2).normal(size=(9, 3)), np.tile([0, 0, 1.0], (9, 1)), np.full((9, 4), 0.2, np.float32))
    assert gm.save(tmp_path / "a.ply", cloud) == []
    again = gm.read(tmp_path / "a.ply")
    assert same_bits(again.points.points, cloud.points) and same_bits(again.points.normals, cloud.normals)
    assert again.points.colours == pytest.approx(cloud.colours, abs=0.002) and "9 points" in repr(again)
    file_bytes.require("obj", tmp_path)
    curves = gm.Curves([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[5, 0, 0], [6, 0, 0]]], closed=[True, False])
    gm.save(tmp_path / "a.obj", curves)
    again = gm.read(tmp_path / "a.obj").curves
    assert len(again) == 2 and again.closed.tolist() == [1, 0] and same_bits(again.points, curves.points)


def test_other_readers_agree(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    points, faces = shapes.cap()
    gm.save(tmp_path / "a.ply", (points, faces))
    loaded = trimesh.load(tmp_path / "a.ply", process=False)
    assert np.array_equal(loaded.vertices, points) and np.array_equal(loaded.faces, faces)
    ball = trimesh.creation.icosphere(subdivisions=2)
    for extension in ("ply", "off", "obj", "stl", "glb"):
        if not file_bytes.is_there(extension, tmp_path):
            continue
        ball.export(tmp_path / f"b.{extension}")
        document = gm.read(tmp_path / f"b.{extension}")
        assert gm.check(document).is_closed and document.mesh.face_count == len(ball.faces)
        gm.save(tmp_path / f"c.{extension}", document, lossy=True)
        again = trimesh.load(tmp_path / f"c.{extension}", force="mesh")
        assert again.volume == pytest.approx(ball.volume, rel=1e-5)


def test_meshio_agrees(tmp_path):
    meshio = pytest.importorskip("meshio")
    points, faces = shapes.cap()
    meshio.write(tmp_path / "a.ply", meshio.Mesh(points, [("triangle", faces)]))
    mesh = gm.read(tmp_path / "a.ply").mesh
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.faces, faces)


def test_names(tmp_path):
    names = ["gr\u00f6\u00dfe \u7db2.ply", os.fsdecode(b"caf\xe9.ply"), "A.PLY", "new\nline.ply", ".hidden.ply"]
    for name in names:
        gm.save(tmp_path / name, QUAD)
        assert gm.read(tmp_path / name).mesh.face_count == 1
        assert gm.read(str(tmp_path / name)).mesh.face_count == 1
    assert sorted(os.listdir(tmp_path)) == sorted(names)

    class Name:
        def __fspath__(self):
            return str(tmp_path / names[0])
    assert gm.read(Name()).mesh.face_count == 1
    before = os.getcwd()
    os.chdir(tmp_path)
    try:
        gm.save("here.ply", QUAD)
        assert gm.read("here.ply").mesh.face_count == 1
    finally:
        os.chdir(before)
    # Messages can be printed.
    (tmp_path / names[1]).write_bytes(b"ply\n")
    with pytest.raises(gm.InputError, match=r"caf.*ply: ") as caught:
        gm.read(tmp_path / names[1])
    str(caught.value).encode("utf-8")


def test_names_of_files_beside(tmp_path):
    file_bytes.require("obj", tmp_path)
    (tmp_path / "made").mkdir()
    for name in ("red \u7db2.obj", os.fsdecode(b"caf\xe9.obj")):
        gm.save(tmp_path / "made" / name, file_bytes.document())
        assert [material.name for material in gm.read(tmp_path / "made" / name).materials] == ["red", "blue"]
    assert len(os.listdir(tmp_path / "made")) == 4


def test_errors(tmp_path):
    with pytest.raises(FileNotFoundError, match="absent.ply"):
        gm.read(tmp_path / "absent.ply")
    (tmp_path / "folder.ply").mkdir()
    with pytest.raises(IsADirectoryError, match="folder.ply"):
        gm.read(tmp_path / "folder.ply")
    os.mkfifo(tmp_path / "pipe.ply")
    with pytest.raises(OSError, match="Not a regular file.*pipe.ply"):
        gm.read(tmp_path / "pipe.ply")
    with pytest.raises(TypeError):
        gm.read(None)
    with pytest.raises(ValueError, match="null"):
        gm.read("a\0.ply")
    for name in ("a.xyzzy", "a", "ply"):
        (tmp_path / name).write_bytes(b"ply")
        with pytest.raises(gm.InputError, match=rf"{name}: .*\.obj, \.ply"):
            gm.read(tmp_path / name)
        with pytest.raises(gm.InputError, match=r"\.obj, \.ply"):
            gm.save(tmp_path / name, QUAD)
    (tmp_path / "a.ply").write_text(file_bytes.TEXT_PLY.replace("0.5 0.5 1", "0.5 word 1"))
    with pytest.raises(gm.InputError, match='a.ply: line 15: .*vertex 4.*"word"') as caught:
        gm.read(tmp_path / "a.ply")
    assert caught.value.name == "bad_file" and isinstance(caught.value, ValueError)
    copy = pickle.loads(pickle.dumps(caught.value))
    assert str(copy) == str(caught.value) and copy.name == "bad_file"
    (tmp_path / "a.ply").write_text(file_bytes.TEXT_PLY.replace("3 0 1 4", "3 0 1 17"))
    with pytest.raises(gm.InputError, match=r"face 1, corner 2: vertex 17 does not exist \(the mesh has 5\)"):
        gm.read(tmp_path / "a.ply")


def test_statuses_become_exceptions():
    kinds = {"OUT_OF_MEMORY": gm.OutOfMemory, "BAD_FILE": gm.InputError, "BAD_ARGUMENT": gm.InputError, "INTERNAL": gm.Error}
    for name, kind in kinds.items():
        failure = files._failure(getattr(_library.lib, f"GUSSET_FILES_{name}"), files.Path("a.ply"), "3: why")
        assert type(failure) is kind and str(failure) == "a.ply: line 3: why"


@pytest.mark.parametrize("change, wrong", [
    ({"mesh": gm.Mesh(QUAD[0], [[0, 1, 17]])}, r"corner 2: vertex 17 does not exist \(the mesh has 4\)"),
    ({"mesh": gm.Mesh(QUAD[0], [[0, 1]])}, "face 0 has 2 corners"),
    ({"normals": np.zeros((3, 3))}, "normals have 3 entries instead of 4"),
    ({"normals": np.zeros((4, 2))}, r"normals: the shape is \(4, 2\), not \(n, 3\)"),
    ({"normals": np.zeros((4, 3)), "normals_at": "faces"}, "normals_at is 'faces'"),
    ({"vertex_colours": np.zeros((4, 3))}, r"vertex_colours: the shape is \(4, 3\), not \(n, 4\)"),
    ({"face_materials": np.zeros(1, int)}, "material 0 does not exist"),
    ({"face_materials": np.array([-1])}, "face_materials: .*whole numbers"),
    ({"face_properties": {"label": np.zeros(2)}}, "property label has 2 values instead of 1"),
])
def test_wrong_meshes_are_not_written(tmp_path, change, wrong):
    (tmp_path / "a.ply").write_bytes(b"old")
    with pytest.raises(ValueError, match=wrong):
        gm.save(tmp_path / "a.ply", gm.FileMesh(**{"mesh": gm.Mesh(*QUAD), **change}))
    assert (tmp_path / "a.ply").read_bytes() == b"old" and os.listdir(tmp_path) == ["a.ply"]


def test_wrong_documents_are_not_written(tmp_path):
    wrong = [
        gm.Document(meshes=[gm.FileMesh(gm.Mesh(*QUAD))], placements=[files.Placement("", 1, np.eye(3, 4))]),
        gm.Document(meshes=[gm.FileMesh(gm.Mesh(*QUAD))], placements=[files.Placement("", 0, np.eye(4))]),
        gm.Document(materials=[files.Material(image=3)]),
        gm.Document(materials=[files.Material(colour=(float("nan"), 0, 0, 1))]),
    ]
    for document in wrong:
        with pytest.raises(ValueError):
            gm.save(tmp_path / "a.ply", document)
    with pytest.raises(TypeError, match="not a mesh"):
        gm.save(tmp_path / "a.ply", 3)
    assert os.listdir(tmp_path) == []


def test_mutations_of_files(tmp_path):
    """Flipped, removed, repeated and inserted bytes give a valid document or an InputError."""
    random = np.random.default_rng(7)
    originals = {"ply": [file_bytes.ply("<", 9, 7)[0], file_bytes.TEXT_PLY.encode()]}
    for extension in ("off", "obj", "stl", "glb"):
        if file_bytes.is_there(extension, tmp_path):
            gm.save(tmp_path / f"a.{extension}", file_bytes.document(), lossy=True)
            originals[extension] = [(tmp_path / f"a.{extension}").read_bytes()]
    outcomes = {True: 0, False: 0}
    for extension, number in ((extension, number) for extension in originals for number in range(250)):
        data = bytearray(originals[extension][number % len(originals[extension])])
        for _ in range(random.integers(1, 4)):
            a, b = sorted(random.integers(0, len(data), 2))
            kind = random.integers(0, 4)
            if kind == 0:
                data[a] ^= 1 << random.integers(0, 8)
            elif kind == 1:
                del data[a:min(b, a + 9)]
            elif kind == 2:
                data[a:a] = data[a:min(b, a + 40)]
            else:
                data[a:a] = random.bytes(3)
        path = tmp_path / f"m.{extension}"
        path.write_bytes(data)
        try:
            document = gm.read(path)
            for one in document.meshes:
                assert one.mesh.corners.size == 0 or one.mesh.corners.max() < one.mesh.vertex_count
            gm.save(tmp_path / "again.ply", document, lossy=True)
            outcomes[True] += 1
        except gm.InputError as failure:
            assert str(path) in str(failure) or "again.ply" in str(failure)
            outcomes[False] += 1
    assert min(outcomes.values()) > 20


def test_counts_beyond_the_file(tmp_path):
    (tmp_path / "a.ply").write_text(file_bytes.TEXT_PLY.replace("vertex 5", "vertex 4000000000"))
    with pytest.raises(gm.InputError):
        gm.read(tmp_path / "a.ply")
    (tmp_path / "a.ply").write_bytes(b"")
    with pytest.raises(gm.InputError):
        gm.read(tmp_path / "a.ply")


def test_files_outside_of_the_folder_are_refused(tmp_path):
    inside, outside = tmp_path / "inside", tmp_path / "outside"
    (inside / "scans").mkdir(parents=True)
    outside.mkdir()
    for folder in (inside, inside / "scans", outside):
        gm.save(folder / "a.ply", QUAD)
    os.symlink(outside / "a.ply", inside / "link.ply")
    os.symlink(outside, inside / "folder")
    os.symlink("circle.ply", inside / "circle.ply")
    os.symlink(inside / "a.ply", inside / "scans" / "inner.ply")
    os.mkfifo(inside / "pipe.ply")
    (inside / "scans" / "folder.ply").mkdir()

    def names(name):
        (inside / "list.conf").write_text(f"bmesh {name} 0 0 0 0 0 0 1\n")
        return gm.read(inside / "list.conf")

    for name in ("a.ply", "scans/a.ply", "scans\\a.ply", "./a.ply", "scans/inner.ply"):
        assert names(name).mesh.face_count == 1
    refused = ["../outside/a.ply", str(outside / "a.ply"), "link.ply", "folder/a.ply", "scans/../../outside/a.ply"]
    for name in [*refused, "circle.ply", "pipe.ply", "scans/folder.ply", "absent.ply"]:
        with pytest.raises(gm.InputError, match="cannot be read"):
            names(name)


def test_an_exception_while_a_file_is_fetched_arrives(tmp_path, monkeypatch):
    (tmp_path / "list.conf").write_text("bmesh a.ply 0 0 0 0 0 0 1\n")
    gm.save(tmp_path / "a.ply", QUAD)
    loaded = files._loaded

    def failing(path):
        if path.suffix == ".ply":
            raise MemoryError("planted")
        return loaded(path)
    monkeypatch.setattr(files, "_loaded", failing)
    with pytest.raises(MemoryError, match="planted"):
        gm.read(tmp_path / "list.conf")


def test_failed_saves_leave_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "a.ply"
    gm.save(path, QUAD)
    old = path.read_bytes()

    def refuse(*_):
        raise OSError(28, "No space left on device")
    for name in ("fsync", "replace"):
        with monkeypatch.context() as patch:
            patch.setattr(os, name, refuse)
            with pytest.raises(OSError, match="No space left"):
                gm.save(path, shapes.cap())
        assert path.read_bytes() == old and os.listdir(tmp_path) == ["a.ply"]
    with pytest.raises(gm.InputError, match="a.conf: "):
        gm.save(tmp_path / "a.conf", QUAD)
    with pytest.raises(FileNotFoundError, match="absent/a.ply"):
        gm.save(tmp_path / "absent" / "a.ply", QUAD)
    (tmp_path / "folder.ply").mkdir()
    with pytest.raises(IsADirectoryError, match="folder.ply"):
        gm.save(tmp_path / "folder.ply", QUAD)
    os.mkfifo(tmp_path / "pipe.ply")
    with pytest.raises(OSError, match="Not a regular file.*pipe.ply"):
        gm.save(tmp_path / "pipe.ply", QUAD)
    assert sorted(os.listdir(tmp_path)) == ["a.ply", "folder.ply", "pipe.ply"]


def test_no_file_changes_before_all_are_complete(tmp_path, monkeypatch):
    file_bytes.require("obj", tmp_path)
    path, library = tmp_path / "a.obj", tmp_path / "a.mtl"
    gm.save(path, file_bytes.document())
    old = path.read_bytes(), library.read_bytes()
    calls = []

    def second_fails(handle):
        calls.append(handle)
        if len(calls) == 2:
            raise OSError(28, "No space left on device")
    monkeypatch.setattr(os, "fsync", second_fails)
    with pytest.raises(OSError, match="a.obj"):
        gm.save(path, file_bytes.document("green"))
    assert (path.read_bytes(), library.read_bytes()) == old and sorted(os.listdir(tmp_path)) == ["a.mtl", "a.obj"]


def test_permissions_and_links_stay(tmp_path):
    target, link = tmp_path / "target.ply", tmp_path / "link.ply"
    before = os.umask(0o027)
    try:
        gm.save(target, QUAD)
    finally:
        os.umask(before)
    assert target.stat().st_mode & 0o777 == 0o640
    target.chmod(0o604)
    os.symlink(target.name, link)
    gm.save(link, shapes.cap())
    assert link.is_symlink() and target.stat().st_mode & 0o777 == 0o604
    assert gm.read(target).mesh.vertex_count == len(shapes.cap()[0])


def test_rounding_needs_consent(tmp_path):
    file_bytes.require("stl", tmp_path)
    far = QUAD[0][[0, 1, 2]] + 1e8 + 1 / 3, [[0, 1, 2]]
    with pytest.raises(gm.InputError, match="single precision"):
        gm.save(tmp_path / "a.stl", far)
    assert any("precision" in loss for loss in gm.save(tmp_path / "a.stl", far, lossy=True))


def test_images_come_from_the_folder_of_the_document(tmp_path):
    file_bytes.require("obj", tmp_path)
    file_bytes.require("glb", tmp_path)
    (tmp_path / "other").mkdir()
    (tmp_path / "a.png").write_bytes(file_bytes.PNG)
    (tmp_path / "a.mtl").write_text("newmtl red\nmap_Kd a.png\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl red\nf 1/1 2/2 3/3\n")
    document = gm.read(tmp_path / "a.obj")
    assert document.images[0].data == "a.png"
    gm.save(tmp_path / "other" / "a.glb", document)
    assert gm.read(tmp_path / "other" / "a.glb").images[0].data == file_bytes.PNG
    assert not any("image" in loss for loss in gm.save(tmp_path / "b.obj", document))
    # Files in other folders name the image as seen from there.
    assert not any("image" in loss for loss in gm.save(tmp_path / "other" / "a.obj", document))
    assert "map_Kd ../a.png\n" in (tmp_path / "other" / "a.mtl").read_text()
    document.materials[0].native = None
    gm.save(tmp_path / "other" / "b.obj", document)
    assert "map_Kd ../a.png\n" in (tmp_path / "other" / "b.mtl").read_text()
    (tmp_path / "a.png").unlink()
    assert any("image a.png" in loss for loss in gm.save(tmp_path / "other" / "a.obj", document))


def test_threads(tmp_path):
    caps = [shapes.cap(columns=columns) for columns in range(8, 16)]
    wrong = []

    def work(number):
        path = tmp_path / f"{number}.ply"
        for _ in range(20):
            gm.save(path, caps[number])
            if not same_bits(gm.read(path).mesh.points, caps[number][0]):
                wrong.append(number)
    threads = [threading.Thread(target=work, args=(number,)) for number in range(len(caps))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == [] and len(os.listdir(tmp_path)) == len(caps)


def test_a_library_without_files_says_so(monkeypatch):
    class Without:
        GUSSET_FILES_ABI = 1
    monkeypatch.setattr(files, "lib", Without())
    monkeypatch.setattr(_library, "files", None)
    files._table.cache_clear()
    try:
        with pytest.raises(NotImplementedError, match="feature `files`"):
            files._table()
    finally:
        files._table.cache_clear()
