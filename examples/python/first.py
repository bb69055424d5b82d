import numpy as np

import gusset_mesh as gm

faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]]
up = np.array([[0, 0, 2], [1, 0, 1], [0, 1, 1], [-1, 0, 1], [0, -1, 1.0]])
down = up * [1, -1, -1]
made = gm.join([(up, faces), (down, faces)])
print(made.mesh, gm.check(made.mesh))
for joint in made.joints:
    print(f"gap {joint.gap:.3f}: {joint.outcome}, {joint.face_count} faces")
heights = made.carry([up[:, 2], down[:, 2]])  # carries arrays of vertices, corners or faces over to the result
