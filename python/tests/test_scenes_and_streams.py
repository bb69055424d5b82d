"""Scenes and streams of nets."""

import threading

import numpy as np
import pytest
import shapes

import gusset_mesh as gm

SHEET = gm.Net(shapes.grid(4, 5, lambda u, v: u * v))
SHIFT = np.array([[1, 0, 0, 5], [0, 1, 0, 0], [0, 0, 1, 0.0]])
TURN = np.array([[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, 2, 1.0]])


def matrix(rows):
    return np.vstack([np.reshape(rows, (3, 4)), [0, 0, 0, 1]])


def nested():
    """Two groups: the inner one, with a sheet, is in the outer one twice."""
    scene = gm.Scene()
    sheet, inner, outer = scene.add(SHEET), scene.add_group(), scene.add_group()
    scene.add_child(inner, sheet)
    scene.add_child(outer, inner)
    scene.add_child(outer, inner)
    scene.set_entry(sheet, transform=TURN)
    scene.set_entry(outer, transform=SHIFT)
    return scene, sheet, inner, outer


def test_instances_are_products_of_maps():
    scene, sheet, inner, outer = nested()
    assert scene.report.net_instances == 2 and scene.report.nets == 1 and scene.report.groups == 2 and scene.report.levels == 3
    assert scene.children(outer).tolist() == [inner, inner] and scene.entry(outer).child_count == 2
    found = scene.world_transforms()
    worlds = {}
    for k, one in enumerate(found):
        above = np.eye(4) if one.parent == 2**32 - 1 else worlds[one.parent]
        worlds[k] = above @ matrix(scene.entry(one.entry).transform.rows)
        assert np.allclose(matrix(one.world.rows), worlds[k])
    joined = scene.flatten()
    assert joined.shape == (8, 5)
    moved = SHEET.nodes @ TURN[:, :3].T + TURN[:, 3] + [5, 0, 0]
    assert np.allclose(joined.nodes, np.concatenate([moved, moved]))


def test_what_is_hidden_is_left_out():
    scene, sheet, inner, outer = nested()
    alone = scene.add(SHEET)
    assert scene.flatten().shape == (12, 5)
    scene.set_entry(inner, visible=False)
    assert scene.flatten().shape == (4, 5) and not scene.entry(inner).visible and scene.entry(sheet).visible
    scene.remove_child(outer, inner)
    assert scene.children(outer).tolist() == [inner]
    scene.remove(alone)
    with pytest.raises(gm.InputError) as caught:
        scene.entry(alone)
    assert (caught.value.element, caught.value.index) == ("entry", alone) or caught.value.name == "no_such_element"
    with pytest.raises(gm.InputError) as caught:
        scene.flatten()
    assert caught.value.name == "empty_scene"
    with pytest.raises(gm.InputError) as caught:
        scene.add_child(inner, outer)
    assert caught.value.name == "scene_cycle"


def test_a_scene_of_a_joined_net():
    parts = [SHEET, SHEET.translate([0, 0, 9])]
    scene = gm.Scene.unflatten(gm.Net.concatenate(parts, direction="down"))
    assert scene.entry(0).kind == "group"
    for part, entry in zip(parts, scene.children(0)):
        assert np.array_equal(scene.net(int(entry)).nodes, part.nodes)
    # The scene has a net as it was.
    entry = scene.add(SHEET)
    scene.set_entry(entry, net=SHEET.translate([1, 0, 0]), transform=matrix(TURN))
    assert np.array_equal(scene.net(entry).nodes, SHEET.nodes + [1, 0, 0]) and np.array_equal(scene.entry(entry).transform.rows, TURN)


def test_a_callback_cannot_change_the_scene_that_is_read():
    scene, big = gm.Scene(), gm.Net(shapes.grid(400, 400))
    for _ in range(4):
        scene.add(big)
    said = []

    def change(part, what):
        try:
            scene.add(big)
        except RuntimeError as error:
            said.append(str(error))
            raise

    with pytest.raises(RuntimeError, match="in use"):
        scene.flatten(progress=change)
    assert said and scene.flatten().shape == (1600, 400)


def test_many_threads_change_a_scene():
    scene = gm.Scene()
    group = scene.add_group()

    def work():
        for _ in range(200):
            scene.add_child(group, scene.add(SHEET))
            scene.world_transforms()

    threads = [threading.Thread(target=work) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert scene.report.nets == 1200 and len(set(scene.children(group).tolist())) == 1200


@pytest.mark.parametrize("bad", [
    lambda s: s.add(None), lambda s: s.add("net"), lambda s: s.add_child(0, 9), lambda s: s.add_child(-1, 0), lambda s: s.add_child(2**32, 0), lambda s: s.remove(7),
    lambda s: s.remove_child(1, 0), lambda s: s.children(0), lambda s: s.net(1), lambda s: s.entry(1.5), lambda s: s.set_entry(1, net=SHEET), lambda s: s.set_entry(9),
    lambda s: s.set_entry(0, transform=np.eye(3)), lambda s: s.set_entry(0, transform=np.full((3, 4), np.nan)), lambda s: gm.Scene.unflatten(SHEET, "left"),
    lambda s: gm.Scene.unflatten(3), lambda s: s.flatten(mode="glue"),
])
def test_what_scenes_refuse(bad):
    scene = gm.Scene()
    scene.add(SHEET)
    scene.add_group()
    with pytest.raises((ValueError, TypeError)):
        bad(scene)
    assert scene.report.nets == 1 and scene.report.groups == 1


BALL = gm.Net.primitive(shape="sphere", radius=1, rows=65, columns=129)


def test_streams_keep_what_they_promise():
    holed = np.array(BALL.nodes)
    holed[5, 7] = np.nan
    net = gm.Net(holed, "two_poles")
    for mode in ("lossless", "raw"):
        assert np.array_equal(gm.Net.decode(net.encode(mode=mode)).nodes, net.nodes, equal_nan=True)
    sizes = []
    for bits in (10, 16):
        data = BALL.encode(bits=bits)
        report = gm.stream_inspect(data[:128])
        assert (report.rows, report.columns, report.bits) == (65, 129, bits)
        again = gm.Net.decode(bytes(data))
        assert np.abs(again.nodes - BALL.nodes).max() <= max(report.step) / 2 + 1e-15 and again.gluing.sides == BALL.gluing.sides
        sizes.append(len(data))
    assert sizes[0] < sizes[1] < len(BALL.encode(mode="lossless")) < len(BALL.encode(mode="raw"))


def test_streams_that_arrive_in_pieces():
    data = BALL.encode(mode="lossless", rows_per_block=16)
    decoder = gm.StreamDecoder()
    rows = [decoder.push(data[k:k + 999]) for k in range(0, len(data) // 2, 999)]
    assert rows == sorted(rows) and 16 <= rows[-1] < 65
    preview = decoder.preview()
    assert np.array_equal(preview.nodes, BALL.nodes[:rows[-1]]) and preview.gluing.sides == set()
    with pytest.raises(gm.InputError):
        decoder.finish()
    decoder = gm.StreamDecoder()
    decoder.push(memoryview(data.tobytes()))
    assert np.array_equal(decoder.finish().nodes, BALL.nodes)


def test_scenes_come_back():
    scene, sheet, inner, outer = nested()
    hidden = scene.add(BALL)
    scene.set_entry(hidden, visible=False)
    scene.remove(scene.add_group())
    data = scene.encode(mode="lossless")
    back = gm.Scene.decode(data.tobytes())
    assert back.children(outer).tolist() == [inner, inner] and not back.entry(hidden).visible
    assert np.array_equal(back.entry(sheet).transform.rows, scene.entry(sheet).transform.rows)
    assert np.array_equal(back.flatten().nodes, scene.flatten().nodes) and np.array_equal(back.net(hidden).nodes, BALL.nodes)
    assert np.array_equal(back.encode(mode="lossless"), data) and back.add_group() == scene.add_group()
    for bad in (b"", data[:-1], BALL.encode()):
        with pytest.raises(gm.InputError):
            gm.Scene.decode(bad)


def test_damaged_streams_are_refused():
    data = BALL.encode(mode="lossless")
    random = np.random.default_rng(5)
    refused = 0
    for _ in range(200):
        damaged = np.array(data)
        damaged[random.integers(len(data))] ^= 1 << random.integers(8)
        try:
            gm.Net.decode(damaged)
        except gm.InputError as error:
            refused += error.element in ("byte", "none", "count")
    assert refused > 190
    for bad in (b"", b"x" * 500, data[:100], data[:-1]):
        with pytest.raises(gm.InputError):
            gm.Net.decode(bad)
    with pytest.raises(gm.InputError) as caught:
        gm.Net.decode(data, node_limit=100)
    assert caught.value.name == "too_large"


@pytest.mark.parametrize("bad", [
    lambda: gm.Net.decode("text"), lambda: gm.Net.decode(np.zeros(9)), lambda: gm.Net.decode(BALL.encode()[::2]), lambda: gm.Net.decode(b"", node_limit=-1),
    lambda: BALL.encode(mode="zip"), lambda: BALL.encode(bits=99), lambda: BALL.encode(mode="raw", bits=12), lambda: BALL.encode(rows_per_block=-1),
    lambda: gm.stream_inspect(b"short"), lambda: gm.StreamDecoder(-1), lambda: gm.StreamDecoder().preview(), lambda: gm.StreamDecoder().push(None),
    lambda: gm.StreamDecoder().push(b"y" * 200),
])
def test_what_streams_refuse(bad):
    with pytest.raises((ValueError, TypeError)):
        bad()
