"""Certificates from Python, and what verify.py says of them."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import gusset_mesh as gm

VERIFY = pathlib.Path(__file__).resolve().parents[2] / "tools/verify/verify.py"

POINTS = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.5, 0.5]]
CLOSED = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
OPEN = [*CLOSED[1:], [1, 4, 2]]


def write_obj(path, points, faces):
    rows = ["v " + " ".join(map(repr, map(float, point))) for point in points]
    rows += ["f " + " ".join(str(vertex + 1) for vertex in face) for face in faces]
    path.write_text("\n".join(rows) + "\n")


class Certificates(unittest.TestCase):
    def test_facts(self):
        made = gm.certify([(POINTS, OPEN)], (POINTS, CLOSED))
        self.assertTrue(made.holds)
        claims = made.claims()
        self.assertEqual((claims["kept_faces"], claims["new_faces"], claims["lost_faces"], claims["turned_faces"]), (3, 1, [[3]], [[]]))
        self.assertEqual(claims["farthest_vertex"]["at"], [0.5, 0.5, 0.5])
        self.assertAlmostEqual(claims["farthest_vertex"]["distance"], 0.75 ** 0.5)
        self.assertEqual(repr(made), "<Certificate: 3 faces kept, 1 lost, 1 new>")
        self.assertFalse(gm.certify([], (POINTS, OPEN)).holds)

    def test_verify_confirms_and_refutes(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            write_obj(folder / "open.obj", POINTS, OPEN)
            write_obj(folder / "closed.obj", POINTS, CLOSED)
            made = gm.certify([(POINTS, OPEN)], (POINTS, CLOSED))
            text = made.to_json([folder / "open.obj"], folder / "closed.obj")
            for lie in (None, {"closed": False}, {"lost_faces": [[2]]}, {"farthest_vertex": None}):
                certificate = json.loads(text)
                certificate["claims"].update(lie or {})
                (folder / "stated.json").write_text(json.dumps(certificate))
                done = subprocess.run([sys.executable, VERIFY, folder / "stated.json"], capture_output=True, text=True)
                self.assertEqual(done.returncode, 1 if lie else 0, done.stdout + done.stderr)
            with self.assertRaises(ValueError):
                made.to_json([], folder / "closed.obj")

    def test_bad_input_is_named(self):
        with self.assertRaises(gm.InputError):
            gm.certify([(POINTS, [[0, 1, 9]])], (POINTS, CLOSED))


if __name__ == "__main__":
    unittest.main()
