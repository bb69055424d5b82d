// Shapes by formula, as in python/tests/shapes.py.

import { Curves, Mesh } from "../gusset.js";

const { cos, PI, sin } = Math;

/** A sheet over the unit square, of quads. */
export function sheet(rows = 7, columns = 9, height = (u, v) => 0.2 * sin(3 * u) * cos(2 * v), place = (p) => p) {
  const points = [], faces = [];
  for (let i = 0; i < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const [u, v] = [i / (rows - 1), j / (columns - 1)];
      points.push(place([u, v, height(u, v)]));
    }
  }
  for (let i = 0; i + 1 < rows; i++) {
    for (let j = 0; j + 1 < columns; j++) {
      const a = i * columns + j;
      faces.push([a, a + columns, a + columns + 1, a + 1]);
    }
  }
  return new Mesh(points, faces);
}

/** A tube along z, open at both ends. */
export function tube(rows = 8, columns = 24) {
  const points = [], faces = [];
  for (let i = 0; i < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const a = 2 * PI * j / columns;
      points.push([cos(a), sin(a), i / (rows - 1)]);
    }
  }
  for (let i = 0; i + 1 < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const [a, b] = [i * columns + j, i * columns + (j + 1) % columns];
      faces.push([a, a + columns, b + columns, b]);
    }
  }
  return new Mesh(points, faces);
}

/** A spherical cap about the z axis, with a pole; its rim is open, its normals outwards. */
export function cap(sign = 1, rows = 6, columns = 24, { end = PI / 2 - 0.2, ripple = 0, reals = Float64Array } = {}) {
  const points = [[0, 0, sign]], faces = [];
  for (let i = 1; i <= rows; i++) {
    for (let j = 0; j < columns; j++) {
      const [p, a] = [end * i / rows, 2 * PI * j / columns], r = 1 + ripple * sin(5 * a) * i / rows;
      points.push([r * sin(p) * cos(a), r * sin(p) * sin(a), sign * r * cos(p)]);
    }
  }
  for (let j = 0; j < columns; j++) {
    faces.push([0, 1 + j, 1 + (j + 1) % columns]);
  }
  for (let i = 0; i + 1 < rows; i++) {
    for (let j = 0; j < columns; j++) {
      const [a, b] = [1 + i * columns + j, 1 + i * columns + (j + 1) % columns];
      faces.push([a, a + columns, b + columns], [a, b + columns, b]);
    }
  }
  return new Mesh(reals.from(points.flat()), Uint32Array.from((sign > 0 ? faces : faces.map((face) => face.toReversed?.() ?? [...face].reverse())).flat()));
}

/** Circles one above another. */
export function rings(count = 4, columns = 20, at = (k) => [0, 0, k]) {
  const each = Array.from({ length: count }, (_, k) => Float64Array.from(Array.from({ length: columns }, (_, j) => {
    const a = 2 * PI * j / columns, [x, y, z] = at(k);
    return [x + cos(a), y + sin(a), z];
  }).flat()));
  return new Curves(each, { closed: true });
}

/** Some curves of others. */
export function part(curves, ...which) {
  return new Curves(which.map((c) => curves.curve(c)), { closed: which.map((c) => curves.closed[c]) });
}
