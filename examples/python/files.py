"""Files in docs/guides/python.md, as a program: files.py"""

import tempfile
from pathlib import Path

import numpy as np

import gusset_mesh as gm

scratch = tempfile.TemporaryDirectory()
folder = Path(scratch.name)
faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]
up = np.array([[0, 0, 2], [1, 0, 1], [0, 1, 1], [-1, 0, 1], [0, -1, 1.0]])
for name, points, colour in (("up.ply", up, [1, 0.5, 0, 1]), ("down.ply", up * [1, -1, -1], [0, 0.5, 1, 1])):
    gm.save(folder / name, gm.FileMesh(gm.Mesh(points, faces), vertex_colours=np.tile(colour, (5, 1))))

#! [join]
pieces = [gm.read(folder / "up.ply"), gm.read(folder / "down.ply")]
made = gm.join(pieces)
losses = gm.save(folder / "joined.ply", made)
print(gm.read(folder / "joined.ply").mesh, "closed:", gm.check(made).is_closed, "losses:", losses)
#! [join]

#! [attributes]
colours = made.carry([piece.meshes[0].vertex_colours for piece in pieces])
heights = made.mesh.points[:, 2]
content = gm.FileMesh(made.mesh, vertex_colours=colours, vertex_properties={"height": heights.astype(np.float32)})
gm.save(folder / "coloured.ply", content)
again = gm.read(folder / "coloured.ply").meshes[0]
print(again.vertex_colours[5], again.vertex_properties["height"].max(), again.vertex_types["height"])
#! [attributes]

(folder / "torn.ply").write_bytes((folder / "coloured.ply").read_bytes()[:300])
#! [errors]
try:
    gm.read(folder / "torn.ply")
except gm.InputError as error:
    print(error)
#! [errors]
