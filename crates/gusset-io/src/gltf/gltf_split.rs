//! Vertices of a glTF file: one for each combination of position, normal and texture coordinates that corners have.

use crate::error::WriteError;
use crate::mesh::{Mesh, Values};
use gusset_base::alloc;
use std::borrow::Cow;
use std::collections::{HashMap, TryReserveError};

/// A mesh whose normals and texture coordinates are at its vertices, in the numbers of the file.
pub(super) struct SplitVertices<'m> {
    /// Vertex of each corner.
    pub(super) corners: Cow<'m, [u32]>,
    /// For each vertex, the mesh's vertex; `None` if no vertex is split.
    pub(super) mesh_vertex_of_file_vertex: Option<Vec<u32>>,
    pub(super) normals: Option<Vec<[f32; 3]>>,
    /// With v from the upper edge of the image.
    pub(super) texcoords: Option<Vec<[f32; 2]>>,
}

/// Returns a number of the file; 0 if it is missing.
fn single(value: f64) -> f32 {
    if value.is_nan() { 0.0 } else { value as f32 }
}

fn normal_in_file(normal: [f64; 3]) -> [f32; 3] {
    normal.map(single)
}

fn texcoord_in_file([u, v]: [f64; 2]) -> [f32; 2] {
    [single(u), single(1.0 - v)]
}

/// Splits vertices whose corners differ in the file.
pub(super) fn split_vertices(mesh: &Mesh) -> Result<SplitVertices<'_>, WriteError> {
    let normals = at_vertices(&mesh.normals, mesh, normal_in_file)?;
    let texcoords = at_vertices(&mesh.texcoords, mesh, texcoord_in_file)?;
    let is_whole = normals.is_some() || mesh.normals.is_absent();
    if is_whole && (texcoords.is_some() || mesh.texcoords.is_absent()) {
        return Ok(SplitVertices {
            corners: Cow::Borrowed(&mesh.corners),
            mesh_vertex_of_file_vertex: None,
            normals,
            texcoords,
        });
    }
    let mut split = Splitter {
        mesh,
        normals: if normals.is_some() { normals } else { missing(&mesh.normals, mesh)? },
        texcoords: if texcoords.is_some() { texcoords } else { missing(&mesh.texcoords, mesh)? },
        origins: alloc::collect(0..mesh.positions.len() as u32)?,
        is_taken: alloc::filled(false, mesh.positions.len())?,
        vertex_of_known_values: HashMap::new(),
    };
    let mut corners = Vec::new();
    corners.try_reserve_exact(mesh.corners.len())?;
    for corner in 0..mesh.corners.len() {
        corners.push(split.corner_vertex(corner)?);
    }
    let Splitter { normals, texcoords, origins, .. } = split;
    Ok(SplitVertices { corners: Cow::Owned(corners), mesh_vertex_of_file_vertex: Some(origins), normals, texcoords })
}

/// Returns values at vertices; `None` if the mesh lacks them or corners of a vertex differ.
fn at_vertices<const N: usize, const M: usize>(
    values: &Values<N>,
    mesh: &Mesh,
    convert: impl Fn([f64; N]) -> [f32; M],
) -> Result<Option<Vec<[f32; M]>>, TryReserveError> {
    let mut made = Vec::new();
    match values {
        Values::Absent => return Ok(None),
        Values::Vertices(all) => {
            made.try_reserve_exact(all.len())?;
            made.extend(all.iter().map(|&value| convert(value)));
        }
        Values::Corners(all) => {
            made.try_reserve_exact(mesh.positions.len())?;
            made.resize(mesh.positions.len(), [f32::NAN; M]);
            for (&vertex, &value) in mesh.corners.iter().zip(all) {
                let (own, value) = (&mut made[vertex as usize], convert(value));
                if own[0].is_nan() {
                    *own = value;
                } else if own.map(f32::to_bits) != value.map(f32::to_bits) {
                    return Ok(None);
                }
            }
            // Vertices without faces.
            made.iter_mut().filter(|value| value[0].is_nan()).for_each(|value| *value = [0.0; M]);
        }
    }
    Ok(Some(made))
}

fn missing<const N: usize, const M: usize>(
    values: &Values<N>,
    mesh: &Mesh,
) -> Result<Option<Vec<[f32; M]>>, WriteError> {
    if values.is_absent() {
        return Ok(None);
    }
    Ok(Some(alloc::filled([0.0; M], mesh.positions.len())?))
}

struct Splitter<'m> {
    mesh: &'m Mesh,
    normals: Option<Vec<[f32; 3]>>,
    texcoords: Option<Vec<[f32; 2]>>,
    origins: Vec<u32>,
    is_taken: Vec<bool>,
    /// Vertices by the mesh's vertices and the bits of their values.
    vertex_of_known_values: HashMap<(u32, [u32; 5]), u32>,
}

impl Splitter<'_> {
    fn corner_vertex(&mut self, corner: usize) -> Result<u32, WriteError> {
        let vertex = self.mesh.corners[corner];
        let normal = self.mesh.normals.at_corner(corner, vertex).map_or([0.0; 3], normal_in_file);
        let texcoord = texcoord_in_file(self.mesh.texcoords.at_corner(corner, vertex).unwrap_or([f64::NAN; 2]));
        let [x, y, z] = normal.map(f32::to_bits);
        let [u, v] = texcoord.map(f32::to_bits);
        let is_first = !self.is_taken[vertex as usize];
        let next = if is_first { vertex } else { self.origins.len() as u32 };
        self.vertex_of_known_values.try_reserve(1)?;
        let made = *self.vertex_of_known_values.entry((vertex, [x, y, z, u, v])).or_insert(next);
        if made == next {
            self.is_taken[vertex as usize] = true;
            if !is_first {
                alloc::push(&mut self.origins, vertex)?;
            }
            if let Some(normals) = &mut self.normals {
                alloc::grow(normals, self.origins.len(), [0.0; 3])?;
                normals[made as usize] = normal;
            }
            if let Some(texcoords) = &mut self.texcoords {
                alloc::grow(texcoords, self.origins.len(), [0.0; 2])?;
                texcoords[made as usize] = texcoord;
            }
        }
        Ok(made)
    }
}

/// Returns whether the file's normals differ from the mesh's ones.
pub(super) fn are_normals_rounded(mesh: &Mesh) -> bool {
    let is_rounded = |x: f64| !x.is_nan() && f64::from(x as f32) != x;
    match &mesh.normals {
        Values::Absent => false,
        Values::Vertices(all) | Values::Corners(all) => all.iter().flatten().any(|&x| is_rounded(x)),
    }
}

/// Returns whether the texture coordinates that the file gives back differ from the mesh's ones.
pub(super) fn are_texcoords_rounded(mesh: &Mesh) -> bool {
    let is_rounded = |&pair: &[f64; 2]| {
        let [u, v] = texcoord_in_file(pair).map(f64::from);
        !pair[0].is_nan() && [u, 1.0 - v] != pair
    };
    match &mesh.texcoords {
        Values::Absent => false,
        Values::Vertices(all) | Values::Corners(all) => all.iter().any(is_rounded),
    }
}
