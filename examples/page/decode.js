// Reads the files of showcase.hpp: arrays as differences in planes of bytes, and the data that drawing the meshes
// needs.

/** The bytes of a script element: base64 of a gzip stream. */
async function unpacked(id) {
  const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

/** The elements of an array that the JSON describes. */
function elements(buffer, { at, count, bytes }) {
  const planes = new Uint8Array(buffer, at, count * bytes);
  const out = new { 1: Uint8Array, 2: Uint16Array, 4: Uint32Array }[bytes](count);
  let before = 0;
  for (let k = 0; k < count; ++k) {
    let difference = 0;
    for (let plane = 0; plane < bytes; ++plane) {
      difference += planes[plane * count + k] * 2 ** (8 * plane);
    }
    // The typed array takes it modulo its range.
    out[k] = before + difference;
    before = out[k];
  }
  return out;
}

/** A body with its arrays: points as floats, faces by their first corners, colours from 0 to 1 in linear light. */
function decoded(buffer, body) {
  const axes = body.points.map((axis) => elements(buffer, axis));
  const count = axes[0].length;
  const points = new Float32Array(3 * count);
  for (let v = 0; v < count; ++v) {
    for (let k = 0; k < 3; ++k) {
      points[3 * v + k] = body.low[k] + (body.size * axes[k][v]) / 65535;
    }
  }
  const corners = elements(buffer, body.corners);
  // Vertices of faces; other vertices do not affect the view.
  const used = new Uint8Array(count);
  corners.forEach((v) => {
    used[v] = 1;
  });
  const paint = elements(buffer, body.paint);
  const sizes = body.sizes ? elements(buffer, body.sizes) : null;
  const first = new Uint32Array(paint.length + 1);
  for (let f = 0; f < paint.length; ++f) {
    first[f + 1] = first[f] + (sizes ? sizes[f] : 3);
  }
  const linear = (byte) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  const colours = (channels) => {
    if (!channels) return null;
    const [red, green, blue] = channels.map((channel) => elements(buffer, channel));
    const out = new Float32Array(3 * red.length);
    for (let k = 0; k < red.length; ++k) {
      out.set([linear(red[k]), linear(green[k]), linear(blue[k])], 3 * k);
    }
    return out;
  };
  return {
    points, corners, paint, first, used,
    vertexColours: colours(body.vertexColours),
    faceColours: colours(body.faceColours),
    distances: body.distances ? elements(buffer, body.distances) : null,
    curves: body.curves,
  };
}

/** Normals of vertices, from the faces that are there, by their areas. */
function normalsOf({ points, corners, first, paint }, hidden) {
  const normals = new Float32Array(points.length);
  for (let f = 0; f + 1 < first.length; ++f) {
    if (hidden.has(paint[f])) continue;
    let x = 0, y = 0, z = 0;
    for (let c = first[f]; c < first[f + 1]; ++c) {
      const a = 3 * corners[c], b = 3 * corners[c + 1 < first[f + 1] ? c + 1 : first[f]];
      x += (points[a + 1] - points[b + 1]) * (points[a + 2] + points[b + 2]);
      y += (points[a + 2] - points[b + 2]) * (points[a] + points[b]);
      z += (points[a] - points[b]) * (points[a + 1] + points[b + 1]);
    }
    for (let c = first[f]; c < first[f + 1]; ++c) {
      const v = 3 * corners[c];
      normals[v] += x;
      normals[v + 1] += y;
      normals[v + 2] += z;
    }
  }
  for (let v = 0; v < normals.length; v += 3) {
    const length = Math.hypot(normals[v], normals[v + 1], normals[v + 2]) || 1;
    normals[v] /= length;
    normals[v + 1] /= length;
    normals[v + 2] /= length;
  }
  return normals;
}

/** For each paint its triangles, three corners each, their faces, and the edges of these faces. */
function partsOf({ corners, first, paint }, paints, hidden) {
  const parts = paints.map(() => ({ triangles: [], faces: [], edges: [] }));
  const seen = paints.map(() => new Set());
  const vertices = corners.reduce((most, v) => Math.max(most, v), 0) + 1;
  for (let f = 0; f + 1 < first.length; ++f) {
    if (hidden.has(paint[f])) continue;
    const part = parts[paint[f]];
    for (let c = first[f]; c < first[f + 1]; ++c) {
      if (c > first[f] && c + 1 < first[f + 1]) {
        part.triangles.push(corners[first[f]], corners[c], corners[c + 1]);
        part.faces.push(f);
      }
      const a = corners[c], b = corners[c + 1 < first[f + 1] ? c + 1 : first[f]];
      const edge = Math.min(a, b) * vertices + Math.max(a, b);
      if (!seen[paint[f]].has(edge)) {
        seen[paint[f]].add(edge);
        part.edges.push(a, b);
      }
    }
  }
  return parts;
}
