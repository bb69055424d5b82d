//! Triangles of a primitive as faces: lists, strips and fans, and polygons that were cut into them.

use super::gltf_buffers::malformed;
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::json_tape::Value;
use crate::mesh::Mesh;
use gusset_base::alloc;

/// Triangles that follow each other and begin at the same vertex are one polygon.
pub(super) const POLYGON_EXTENSION: &str = "FB_ngon_encoding";

/// Member of a primitive's `extras`: polygons that no fan of triangles covers. Each entry lists the first triangle, the number of
/// triangles, and the polygon's vertices.
pub(super) const POLYGON_EXTRAS: &str = "gusset_polygons";

/// Kinds of primitives.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Mode {
    Points,
    Lines,
    LineLoop,
    LineStrip,
    Triangles,
    TriangleStrip,
    TriangleFan,
}

impl Mode {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        Some(match code {
            0 => Self::Points,
            1 => Self::Lines,
            2 => Self::LineLoop,
            3 => Self::LineStrip,
            4 => Self::Triangles,
            5 => Self::TriangleStrip,
            6 => Self::TriangleFan,
            _ => return None,
        })
    }

    pub(super) fn has_faces(self) -> bool {
        matches!(self, Self::Triangles | Self::TriangleStrip | Self::TriangleFan)
    }
}

/// Appends a primitive's triangles as faces. `indices` are vertices of the mesh, already checked.
pub(super) fn append_faces(
    mesh: &mut Mesh,
    primitive: Value<'_>,
    mode: Mode,
    mut indices: Vec<u32>,
    first_vertex: u32,
    notes: &mut Vec<Note>,
) -> Result<(), ReadError> {
    if mesh.corners.len() as u64 + 3 * indices.len() as u64 >= u64::from(u32::MAX) {
        return Err(ReadError::new(ReadErrorKind::TooLarge, "a mesh has more than 2^32 - 2 corners; split it"));
    }
    if mode != Mode::Triangles {
        return append_strip(mesh, mode, &indices);
    }
    note_rest(indices.len() % 3, notes)?;
    let (triangles, _) = indices.as_chunks::<3>();
    let is_grouped = primitive.get("extensions").and_then(|all| all.get(POLYGON_EXTENSION)).is_some();
    let polygons = primitive.get("extras").and_then(|extras| extras.get(POLYGON_EXTRAS));
    if !is_grouped && polygons.is_none() {
        let (start, count) = (mesh.corners.len() as u32, triangles.len() as u32);
        mesh.face_offsets.try_reserve(count as usize)?;
        mesh.face_offsets.extend((1..=count).map(|face| start + 3 * face));
        if start == 0 {
            indices.truncate(3 * count as usize);
            mesh.corners = indices;
        } else {
            mesh.corners.try_reserve(indices.len())?;
            mesh.corners.extend_from_slice(triangles.as_flattened());
        }
        return Ok(());
    }
    mesh.corners.try_reserve(indices.len())?;
    let mut place = 0;
    for polygon in polygons.into_iter().flat_map(Value::items) {
        match read_polygon_entry(polygon, triangles, place, first_vertex)? {
            Some((first, count, vertices)) => {
                append_fans(mesh, &triangles[place..first], is_grouped)?;
                append_face(mesh, &vertices)?;
                place = first + count;
            }
            None => {
                alloc::push(
                    notes,
                    Note::new(Place::Whole, "lists of polygons in extras do not fit the triangles and are ignored"),
                )?;
                break;
            }
        }
    }
    append_fans(mesh, &triangles[place..], is_grouped)
}

/// Notes indices after the last triangle.
fn note_rest(count: usize, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let text = match count {
        0 => return Ok(()),
        1 => "1 index follows after the last triangle and is ignored",
        _ => "2 indices follow after the last triangle and are ignored",
    };
    alloc::push(notes, Note::new(Place::Whole, text))?;
    Ok(())
}

fn append_face(mesh: &mut Mesh, vertices: &[u32]) -> Result<(), ReadError> {
    mesh.corners.try_reserve(vertices.len())?;
    mesh.face_offsets.try_reserve(1)?;
    mesh.corners.extend_from_slice(vertices);
    mesh.face_offsets.push(mesh.corners.len() as u32);
    Ok(())
}

fn append_strip(mesh: &mut Mesh, mode: Mode, indices: &[u32]) -> Result<(), ReadError> {
    mesh.corners.try_reserve(3 * indices.len())?;
    for (k, window) in indices.windows(3).enumerate() {
        let &[a, b, c] = window else { continue };
        let triangle = if mode == Mode::TriangleFan {
            [indices[0], b, c]
        } else if k % 2 == 1 {
            [b, a, c]
        } else {
            [a, b, c]
        };
        // Triangles without area join strips; they are not content.
        if triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0] {
            append_face(mesh, &triangle)?;
        }
    }
    Ok(())
}

/// Appends triangles, or the polygons that successive triangles with the same first vertex form.
fn append_fans(mesh: &mut Mesh, triangles: &[[u32; 3]], is_grouped: bool) -> Result<(), ReadError> {
    mesh.face_offsets.try_reserve(triangles.len())?;
    let mut open: Option<(u32, u32)> = None;
    for triangle in triangles {
        if is_grouped && open == Some((triangle[0], triangle[1])) {
            mesh.corners.push(triangle[2]);
            if let Some(end) = mesh.face_offsets.last_mut() {
                *end += 1;
            }
        } else {
            append_face(mesh, triangle)?;
        }
        open = Some((triangle[0], triangle[2]));
    }
    Ok(())
}

/// Reads an entry of [`POLYGON_EXTRAS`]: the first triangle, the number of triangles, and the polygon's vertices. Returns `None` if it
/// does not fit the triangles from `place` on.
fn read_polygon_entry(
    entry: Value<'_>,
    triangles: &[[u32; 3]],
    place: usize,
    first_vertex: u32,
) -> Result<Option<(usize, usize, Vec<u32>)>, ReadError> {
    let mut numbers = entry.items().map(Value::whole_number);
    let mut next = || numbers.next().flatten().and_then(|number| usize::try_from(number).ok());
    let own = next().zip(next()).and_then(|(first, count)| {
        let own = triangles.get(first..first.checked_add(count)?).filter(|_| first >= place)?;
        Some((first, own))
    });
    let Some((first, own)) = own else { return Ok(None) };
    let mut vertices = Vec::new();
    for number in entry.items().skip(2) {
        let vertex = number.whole_number().and_then(|vertex| u32::try_from(vertex).ok()?.checked_add(first_vertex));
        let Some(vertex) = vertex else { return Ok(None) };
        alloc::push(&mut vertices, vertex)?;
    }
    let mut sorted = alloc::copied(&vertices)?;
    sorted.sort_unstable();
    let is_known = |vertex: &u32| sorted.binary_search(vertex).is_ok();
    let has_all = own.iter().flatten().all(is_known);
    let mut used = alloc::copied(own.as_flattened())?;
    used.sort_unstable();
    let all_used = sorted.iter().all(|vertex| used.binary_search(vertex).is_ok());
    Ok((vertices.len() >= 3 && has_all && all_used).then_some((first, own.len(), vertices)))
}

/// Returns a primitive's vertices in the mesh. Refuses vertices that do not exist.
pub(super) fn checked_indices(
    mut indices: Vec<u32>,
    mode: Mode,
    [first, count]: [u32; 2],
    [mesh, primitive, first_face]: [usize; 3],
) -> Result<Vec<u32>, ReadError> {
    if let Some(place) = indices.iter().position(|&index| index >= count) {
        let what = if mode == Mode::Triangles {
            format!("face {}, corner {}", first_face + place / 3, place % 3)
        } else {
            format!("index {place}")
        };
        return Err(malformed(format!(
            "mesh {mesh}, primitive {primitive}, {what}: vertex {} does not exist (the mesh has {count})",
            indices[place]
        )));
    }
    if first > 0 {
        indices.iter_mut().for_each(|index| *index += first);
    }
    Ok(indices)
}
