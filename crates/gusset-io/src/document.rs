//! The content of a file.

use crate::error::{Note, Place, ReadError, ReadErrorKind, WriteError};
use crate::material::{Image, ImageData, Material, NO_MATERIAL, NativeMaterial};
use crate::mesh::{Mesh, NumberKind, Positions, Property, Values};
use gusset_base::alloc;
use std::borrow::Cow;
use std::sync::Arc;

/// Polylines. Curve `c` has points `offsets[c]` to `offsets[c + 1] - 1`; a closed curve also joins the last point to the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Points.
    pub positions: Positions,
    /// `curve_count + 1` entries from 0.
    pub offsets: Vec<u32>,
    /// Whether each curve is closed.
    pub closed: Vec<bool>,
}

impl Default for Curves {
    fn default() -> Self {
        Self { positions: Positions::default(), offsets: vec![0], closed: Vec::new() }
    }
}

/// Points without faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointCloud {
    /// Points.
    pub positions: Positions,
    /// Normals; may be empty.
    pub normals: Vec<[f64; 3]>,
    /// sRGB and opacity, 0 to 1; may be empty.
    pub colours: Vec<[f32; 4]>,
}

/// A mesh in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Name of the node; may be empty.
    pub name: String,
    /// Index of the mesh.
    pub mesh: u32,
    /// Rows of the 3 x 4 matrix that takes the mesh's points into the scene.
    pub transform: [[f64; 4]; 3],
}

impl Placement {
    /// The matrix that changes nothing.
    pub const IDENTITY: [[f64; 4]; 3] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
}

/// The content of a file: meshes and where they are, curves, points, and what meshes refer to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Meshes in their own coordinates.
    pub meshes: Vec<Mesh>,
    /// The scene. A mesh may occur in it several times, or not at all.
    pub placements: Vec<Placement>,
    /// All polylines, in the coordinates of the scene.
    pub curves: Curves,
    /// All points without faces, in the coordinates of the scene.
    pub points: PointCloud,
    /// Materials.
    pub materials: Vec<Material>,
    /// Images of materials.
    pub images: Vec<Image>,
    /// Metres for each unit of length, if the file says so.
    pub metres_per_unit: Option<f64>,
    /// Deviations from the format that the reader accepted, and content that it left out.
    pub notes: Vec<Note>,
}

impl Document {
    /// Makes a document of one mesh.
    #[must_use]
    pub fn from_mesh(mesh: Mesh) -> Self {
        let placement = Placement { name: mesh.name.clone(), mesh: 0, transform: Placement::IDENTITY };
        Self { meshes: vec![mesh], placements: vec![placement], ..Self::default() }
    }

    /// Leaves out images in files, with a note for each. A document from a stream needs this before it is written to a file, because
    /// the stream has no folder in which names could be looked up.
    pub fn drop_image_files(&mut self) {
        for image in &mut self.images {
            if let ImageData::File(name) = &image.data {
                self.notes.push(Note::new(Place::Whole, format!("image left out: the file {name} was not given")));
                image.data = ImageData::Bytes(Arc::default());
            }
        }
    }

    /// Changes the names of the files that images and materials refer to. A document that moves to another folder needs this, because
    /// names are relative to the folder of its file.
    ///
    /// # Errors
    /// `OutOfMemory`.
    pub fn rename_files(&mut self, rename: impl Fn(&str) -> String) -> Result<(), ReadError> {
        for image in &mut self.images {
            if let ImageData::File(name) = &mut image.data {
                *name = rename(name);
            }
        }
        for material in &mut self.materials {
            if let Some(NativeMaterial::Mtl(lines)) = &mut material.native {
                for line in lines {
                    *line = crate::obj::with_renamed_file(line, &rename)?;
                }
            }
            alloc::check_reserve()?;
        }
        Ok(())
    }

    /// Joins all placed meshes into one, in the coordinates of the scene. Meshes that are placed by the identity keep the bits of their
    /// points.
    ///
    /// # Errors
    /// `TooLarge` if the scene has more than 2^32 - 2 points or corners, or if repeated meshes hold more than `max_elements` points and
    /// corners. `OutOfMemory`.
    pub fn into_joined(mut self, max_elements: u64) -> Result<Self, ReadError> {
        let mesh = match &self.placements[..] {
            [placement] if placement.transform == Placement::IDENTITY => {
                std::mem::take(&mut self.meshes[placement.mesh as usize])
            }
            _ => self.joined_copy(max_elements)?,
        };
        let placement = Placement { name: mesh.name.clone(), mesh: 0, transform: Placement::IDENTITY };
        Ok(Self { meshes: vec![mesh], placements: vec![placement], ..self })
    }

    /// Joins all placed meshes as [`into_joined`](Self::into_joined) does. Borrows a mesh that is placed alone by the identity.
    pub(crate) fn joined(&self) -> Result<Cow<'_, Mesh>, WriteError> {
        if let [placement] = &self.placements[..]
            && placement.transform == Placement::IDENTITY
        {
            return Ok(Cow::Borrowed(&self.meshes[placement.mesh as usize]));
        }
        Ok(self.joined_copy(u64::MAX).map(Cow::Owned)?)
    }

    fn joined_copy(&self, max_elements: u64) -> Result<Mesh, ReadError> {
        let size: u64 = self
            .placements
            .iter()
            .map(|placement| &self.meshes[placement.mesh as usize])
            .map(|mesh| (mesh.positions.len() + mesh.corners.len()) as u64)
            .sum();
        if size > max_elements.min(u64::from(u32::MAX) - 1) {
            return Err(ReadError::new(
                ReadErrorKind::TooLarge,
                format!("the scene has {size} points and corners in all its copies of meshes"),
            ));
        }
        let mut joined = Mesh::default();
        for placement in &self.placements {
            append_placed(&mut joined, &self.meshes[placement.mesh as usize], &placement.transform)?;
        }
        Ok(joined)
    }
}

fn append_placed(joined: &mut Mesh, mesh: &Mesh, transform: &[[f64; 4]; 3]) -> Result<(), ReadError> {
    let (vertices, corners, faces) = (joined.positions.len(), joined.corners.len(), joined.face_count());
    let is_moved = *transform != Placement::IDENTITY;
    append_positions(&mut joined.positions, &mesh.positions, is_moved.then_some(transform), vertices == 0)?;
    let is_mirrored = is_moved && determinant(transform) < 0.0;
    let vertex_start = u32::try_from(vertices).map_err(|_| ReadError::out_of_memory())?;
    let order = corner_order(mesh, is_mirrored)?;
    alloc::reserve(&mut joined.corners, mesh.corners.len())?;
    joined.corners.extend(order.iter().map(|&corner| mesh.corners[corner as usize] + vertex_start));
    alloc::reserve(&mut joined.face_offsets, mesh.face_count())?;
    let corner_start = u32::try_from(corners).map_err(|_| ReadError::out_of_memory())?;
    joined.face_offsets.extend(mesh.face_offsets[1..].iter().map(|offset| offset + corner_start));
    append_merge(joined, mesh, vertices)?;
    let before = [vertices, corners];
    let after = [joined.positions.len(), joined.corners.len()];
    let rotated = |normal: [f64; 3]| if is_moved { transformed_normal(transform, normal) } else { normal };
    let old = std::mem::take(&mut joined.normals);
    joined.normals = appended_values(old, &mesh.normals, before, after, &joined.corners, &order, rotated)?;
    let old = std::mem::take(&mut joined.texcoords);
    joined.texcoords = appended_values(old, &mesh.texcoords, before, after, &joined.corners, &order, |value| value)?;
    append_or_fill(&mut joined.vertex_colours, &mesh.vertex_colours, vertices, mesh.positions.len(), [1.0; 4])?;
    append_or_fill(&mut joined.face_colours, &mesh.face_colours, faces, mesh.face_count(), [1.0; 4])?;
    append_or_fill(&mut joined.face_materials, &mesh.face_materials, faces, mesh.face_count(), NO_MATERIAL)?;
    append_properties(joined, mesh, vertices, faces)?;
    Ok(alloc::check_reserve()?)
}

fn append_positions(
    joined: &mut Positions,
    added: &Positions,
    transform: Option<&[[f64; 4]; 3]>,
    is_first: bool,
) -> Result<(), ReadError> {
    match (&mut *joined, added, transform) {
        (Positions::F32(all), Positions::F32(points), None) => alloc::append(all, points)?,
        (_, Positions::F32(_), None) if is_first => *joined = added.try_clone()?,
        _ => {
            joined.make_double()?;
            let Positions::F64(all) = joined else { unreachable!("made double above") };
            alloc::reserve(all, added.len())?;
            all.extend(added.iter().map(|point| transform.map_or(point, |matrix| transformed_point(matrix, point))));
        }
    }
    Ok(())
}

pub(crate) fn transformed_point(matrix: &[[f64; 4]; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
}

pub(crate) fn determinant(m: &[[f64; 4]; 3]) -> f64 {
    let [cofactors, ..] = cofactor_rows(m);
    m[0][0] * cofactors[0] + m[0][1] * cofactors[1] + m[0][2] * cofactors[2]
}

/// Rows of the cofactor matrix, which takes normals to multiples of the transformed normals.
fn cofactor_rows(m: &[[f64; 4]; 3]) -> [[f64; 3]; 3] {
    let cross =
        |a: [f64; 4], b: [f64; 4]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]
}

/// Returns the unit normal of a transformed surface; the normal itself if it has no direction.
pub(crate) fn transformed_normal(matrix: &[[f64; 4]; 3], normal: [f64; 3]) -> [f64; 3] {
    let sign = determinant(matrix).signum();
    let turned = cofactor_rows(matrix).map(|row| sign * (row[0] * normal[0] + row[1] * normal[1] + row[2] * normal[2]));
    let length = turned.iter().map(|part| part * part).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() { turned.map(|part| part / length) } else { normal }
}

/// Corners of a mesh in the order in which they are appended: each face backwards if the transform mirrors, its first corner first.
fn corner_order(mesh: &Mesh, is_mirrored: bool) -> Result<Vec<u32>, ReadError> {
    let mut order = alloc::collect(0..mesh.corners.len() as u32)?;
    if is_mirrored {
        for face in 0..mesh.face_count() {
            let range = mesh.face_range(face);
            if range.len() > 1 {
                order[range.start + 1..range.end].reverse();
            }
        }
    }
    Ok(order)
}

fn append_merge(joined: &mut Mesh, mesh: &Mesh, vertices: usize) -> Result<(), ReadError> {
    if joined.merge.is_empty() && mesh.merge.is_empty() {
        return Ok(());
    }
    if joined.merge.is_empty() {
        joined.merge = alloc::collect(0..vertices as u32)?;
    }
    alloc::reserve(&mut joined.merge, mesh.positions.len())?;
    joined.merge.extend((0..mesh.positions.len() as u32).map(|vertex| mesh.representative(vertex) + vertices as u32));
    Ok(())
}

/// Appends values, at corners if either side has them there. `before` and `after` count vertices and corners; `order` lists the added
/// mesh's corners as they were appended.
fn appended_values<const N: usize>(
    old: Values<N>,
    added: &Values<N>,
    before: [usize; 2],
    after: [usize; 2],
    corners: &[u32],
    order: &[u32],
    change: impl Fn([f64; N]) -> [f64; N],
) -> Result<Values<N>, ReadError> {
    let [vertex_start, corner_start] = before;
    Ok(match (old, added) {
        (Values::Absent, Values::Absent) => Values::Absent,
        (old @ (Values::Absent | Values::Vertices(_)), Values::Absent | Values::Vertices(_)) => {
            let mut all = if let Values::Vertices(all) = old { all } else { Vec::new() };
            let missing = after[0] - all.len();
            alloc::reserve(&mut all, missing)?;
            all.resize(vertex_start, Values::<N>::MISSING);
            if let Values::Vertices(values) = added {
                all.extend(values.iter().map(|&value| change(value)));
            }
            all.resize(after[0], Values::<N>::MISSING);
            Values::Vertices(all)
        }
        (old, added) => {
            let mut all = match old {
                Values::Corners(all) => all,
                old => alloc::collect(
                    (0..corner_start)
                        .map(|corner| old.at_corner(corner, corners[corner]).unwrap_or(Values::<N>::MISSING)),
                )?,
            };
            alloc::reserve(&mut all, order.len())?;
            all.extend(order.iter().zip(&corners[corner_start..]).map(|(&corner, &vertex)| {
                added.at_corner(corner as usize, vertex - vertex_start as u32).map_or(Values::<N>::MISSING, &change)
            }));
            Values::Corners(all)
        }
    })
}

fn append_or_fill<T: Copy>(
    all: &mut Vec<T>,
    added: &[T],
    before: usize,
    count: usize,
    missing: T,
) -> Result<(), ReadError> {
    if all.is_empty() && added.is_empty() {
        return Ok(());
    }
    alloc::grow(all, before, missing)?;
    alloc::append(all, added)?;
    Ok(alloc::grow(all, before + count, missing)?)
}

fn append_properties(joined: &mut Mesh, mesh: &Mesh, vertices: usize, faces: usize) -> Result<(), ReadError> {
    let lengths = |domain| {
        if domain == crate::Domain::Vertices {
            (vertices, joined.positions.len())
        } else {
            (faces, joined.face_offsets.len() - 1)
        }
    };
    let mut all = std::mem::take(&mut joined.properties);
    for property in &mesh.properties {
        if !all.iter().any(|old| is_one_property(old, property)) {
            let values = alloc::filled(0.0, lengths(property.domain).0)?;
            alloc::push(&mut all, Property { name: property.name.clone(), values, ..*property })?;
        }
    }
    for property in &mut all {
        if let Some(added) = mesh.properties.iter().find(|added| is_one_property(property, added)) {
            property.values.truncate(lengths(property.domain).0);
            if property.kind != added.kind {
                // The only type that holds the numbers of all types.
                property.kind = NumberKind::F64;
            }
            alloc::append(&mut property.values, &added.values)?;
        }
        alloc::grow(&mut property.values, lengths(property.domain).1, 0.0)?;
    }
    joined.properties = all;
    Ok(())
}

fn is_one_property(a: &Property, b: &Property) -> bool {
    a.domain == b.domain && a.name == b.name
}
