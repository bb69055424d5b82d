//! Meshes, curves and points as primitives.

use super::gltf_binary::{Binary, Target};
use super::gltf_colour::{ColourConverter, linear_from_srgb};
use super::gltf_faces_read::{POLYGON_EXTENSION, POLYGON_EXTRAS};
use super::gltf_faces_write::Triangles;
use super::gltf_materials_write::{MaterialWriter, named_object};
use super::gltf_mesh::ORIGIN_ATTRIBUTE;
use super::gltf_split::{SplitVertices, are_normals_rounded, are_texcoords_rounded, split_vertices};
use crate::document::{Curves, Document, PointCloud};
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::material::NO_MATERIAL;
use crate::mesh::{Domain, Mesh, Positions, Values};
use crate::options::WriteOptions;
use crate::precision::check_rounding;
use crate::repeated_points::count_repeated_points;
use std::borrow::Cow;
use std::collections::TryReserveError;

/// A mesh as JSON text.
pub(super) struct WrittenMesh {
    pub(super) json: String,
    /// Point of the mesh to which the file's positions are relative.
    pub(super) origin: [f64; 3],
    pub(super) has_polygons: bool,
}

/// Content of all meshes that the file does not hold.
#[derive(Default)]
pub(super) struct MeshLosses {
    are_positions_rounded: bool,
    are_normals_rounded: bool,
    are_texcoords_rounded: bool,
    has_face_colours: bool,
    has_missing_texcoords: bool,
    narrow_faces: usize,
    empty_meshes: usize,
    properties: Vec<String>,
}

impl MeshLosses {
    pub(super) fn into_losses(self, document: &Document) -> Vec<Loss> {
        let mut losses = Vec::new();
        let rounded: Vec<&str> = [
            (self.are_positions_rounded, "positions"),
            (self.are_normals_rounded, "normals"),
            (self.are_texcoords_rounded, "texture coordinates"),
        ]
        .into_iter()
        .filter_map(|(is_rounded, name)| is_rounded.then_some(name))
        .collect();
        match &rounded[..] {
            [] => {}
            [one] => losses.push(format!("{one} rounded to single precision")),
            [first @ .., last] => losses.push(format!("{} and {last} rounded to single precision", first.join(", "))),
        }
        if self.has_face_colours {
            losses.push("colours of faces, which glTF files do not hold".into());
        }
        losses.extend(self.properties.iter().map(|name| format!("{name}, which glTF files do not hold")));
        if self.narrow_faces > 0 {
            let noun = if self.narrow_faces == 1 { "face" } else { "faces" };
            losses.push(format!("{} {noun} of fewer than three corners", self.narrow_faces));
        }
        if self.empty_meshes > 0 {
            let noun = if self.empty_meshes == 1 { "mesh" } else { "meshes" };
            losses.push(format!("{} {noun} without faces, which glTF files do not hold", self.empty_meshes));
        }
        if self.has_missing_texcoords {
            losses.push("which corners lack texture coordinates: glTF files hold some for each".into());
        }
        if let Some(unit) = document.metres_per_unit.filter(|&unit| unit != 1.0) {
            losses.push(format!("the unit of length, {unit} metres: numbers stay, and glTF files are in metres"));
        }
        losses.into_iter().map(|text| Loss(crate::error::printable(&text))).collect()
    }

    fn add_mesh(&mut self, mesh: &Mesh) {
        self.are_normals_rounded |= are_normals_rounded(mesh);
        self.are_texcoords_rounded |= are_texcoords_rounded(mesh);
        self.has_face_colours |= !mesh.face_colours.is_empty();
        self.has_missing_texcoords |=
            matches!(&mesh.texcoords, Values::Corners(all) if all.iter().any(|pair| pair[0].is_nan()));
        for property in &mesh.properties {
            let domain = if property.domain == Domain::Vertices { "vertices" } else { "faces" };
            let name = format!("{} of {domain}", property.name);
            if !self.properties.contains(&name) {
                self.properties.push(name);
            }
        }
    }
}

/// Writes a mesh. Returns `None` if it has no faces.
pub(super) fn write_mesh(
    mesh: &Mesh,
    binary: &mut Binary,
    materials: &mut MaterialWriter<'_>,
    options: &WriteOptions,
    lost: &mut MeshLosses,
) -> Result<Option<WrittenMesh>, WriteError> {
    lost.narrow_faces += (0..mesh.face_count()).filter(|&face| mesh.face_range(face).len() < 3).count();
    if (0..mesh.face_count()).all(|face| mesh.face_range(face).len() < 3) {
        lost.empty_meshes += 1;
        return Ok(None);
    }
    lost.add_mesh(mesh);
    let origin = far_origin(&mesh.positions);
    let moved = check_rounding(mesh, origin, options.lossy, "write OBJ or PLY, which hold double precision")?;
    lost.are_positions_rounded |= moved > 0.0;
    let split = split_vertices(mesh)?;
    if split.mesh_vertex_of_file_vertex.as_ref().is_some_and(|origins| origins.len() >= u32::MAX as usize) {
        let message = "a glTF mesh has at most 2^32 - 2 vertices";
        return Err(WriteError::new(WriteErrorKind::Unsupported, message));
    }
    let attributes = write_vertices(mesh, &split, origin, binary)?;
    let has_polygons = (0..mesh.face_count()).any(|face| mesh.face_range(face).len() > 3);
    let mut json = named_object(&mesh.name)?;
    json.push_str(if json.len() > 1 { ",\"primitives\":[" } else { "\"primitives\":[" });
    for (place, (material, faces)) in faces_by_material(mesh)?.into_iter().enumerate() {
        let faces = write_faces(mesh, &split, &faces, has_polygons, binary)?;
        json.try_reserve(faces.len() + attributes.len() + 64)?;
        if place > 0 {
            json.push(',');
        }
        json.push_str(&format!("{{\"attributes\":{attributes}"));
        json.push_str(&faces);
        if material != NO_MATERIAL {
            json.push_str(&format!(",\"material\":{}", materials.find_or_write_material(material, binary)?));
        }
        json.push('}');
    }
    json.push_str("]}");
    Ok(Some(WrittenMesh { json, origin, has_polygons }))
}

/// Returns a point near all points if they are far from 0 and single precision rounds them; otherwise 0. Multiples of a power of 2 that
/// exceeds the extent keep differences exact.
fn far_origin(positions: &Positions) -> [f64; 3] {
    let Positions::F64(points) = positions else { return [0.0; 3] };
    let is_exact = |point: &[f64; 3]| point.iter().all(|&x| f64::from(x as f32) == x || x.is_nan());
    if points.iter().all(is_exact) {
        return [0.0; 3];
    }
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points.iter().filter(|point| point.iter().all(|x| x.is_finite())) {
        low = std::array::from_fn(|axis| low[axis].min(point[axis]));
        high = std::array::from_fn(|axis| high[axis].max(point[axis]));
    }
    let extent = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
    let farthest = (0..3).map(|axis| low[axis].abs().max(high[axis].abs())).fold(0.0, f64::max);
    if !(extent.is_finite() && farthest.is_finite() && farthest > 2.0 * extent) {
        return [0.0; 3];
    }
    let step = if extent > 0.0 { extent.log2().ceil().exp2() } else { 1.0 };
    std::array::from_fn(|axis| {
        let middle = low[axis] + 0.5 * (high[axis] - low[axis]);
        let origin = (middle / step).round() * step;
        if origin.is_finite() { origin } else { 0.0 }
    })
}

/// Returns positions in the numbers of the file.
fn file_positions<'m>(
    positions: &'m Positions,
    vertices: Option<&[u32]>,
    origin: [f64; 3],
) -> Result<Cow<'m, [[f32; 3]]>, TryReserveError> {
    let single = |point: [f64; 3]| std::array::from_fn(|axis| (point[axis] - origin[axis]) as f32);
    let mut made = Vec::new();
    match (positions, vertices) {
        (Positions::F32(points), None) => return Ok(Cow::Borrowed(points)),
        (Positions::F32(points), Some(vertices)) => {
            made.try_reserve_exact(vertices.len())?;
            made.extend(vertices.iter().map(|&vertex| points[vertex as usize]));
        }
        (Positions::F64(points), None) => {
            made.try_reserve_exact(points.len())?;
            made.extend(points.iter().map(|&point| single(point)));
        }
        (Positions::F64(points), Some(vertices)) => {
            made.try_reserve_exact(vertices.len())?;
            made.extend(vertices.iter().map(|&vertex| single(points[vertex as usize])));
        }
    }
    Ok(Cow::Owned(made))
}

/// Writes all attributes of vertices. Returns them as a JSON object.
fn write_vertices(
    mesh: &Mesh,
    split: &SplitVertices<'_>,
    origin: [f64; 3],
    binary: &mut Binary,
) -> Result<String, WriteError> {
    let origins = split.mesh_vertex_of_file_vertex.as_deref();
    let points = file_positions(&mesh.positions, origins, origin)?;
    let count = points.len() as u32;
    let origin_of = |vertex: u32| origins.map_or(vertex, |all| all[vertex as usize]);
    let mut text = format!("{{\"POSITION\":{}", binary.push_positions(&points)?);
    let mut add = |name: &str, accessor: u32| text.push_str(&format!(",\"{name}\":{accessor}"));
    if let Some(normals) = &split.normals {
        add("NORMAL", binary.push_elements(normals.iter().copied(), Target::Vertices)?);
    }
    if let Some(texcoords) = &split.texcoords {
        add("TEXCOORD_0", binary.push_elements(texcoords.iter().copied(), Target::Vertices)?);
    }
    if !mesh.vertex_colours.is_empty() {
        // As floats: 8 bits are too few for linear intensities.
        let mut converter = ColourConverter::new(linear_from_srgb);
        let colours = (0..count).map(|vertex| converter.convert(mesh.vertex_colours[origin_of(vertex) as usize]));
        add("COLOR_0", binary.push_elements(colours, Target::Vertices)?);
    }
    // Readers merge equal positions otherwise.
    let is_divided = origins.is_some_and(|all| all.len() > mesh.positions.len()) || !mesh.merge.is_empty();
    if is_divided || count_repeated_points(points.len(), |vertex| Some(points[vertex]))? > 0 {
        let halves = (0..count).map(|vertex| {
            let first = mesh.representative(origin_of(vertex));
            [first as u16, (first >> 16) as u16]
        });
        add(ORIGIN_ATTRIBUTE, binary.push_elements(halves, Target::Vertices)?);
    }
    text.push('}');
    Ok(text)
}

/// Returns the faces of each material, in the order of its first face. Faces without a material come last.
fn faces_by_material(mesh: &Mesh) -> Result<Vec<(u32, Vec<u32>)>, TryReserveError> {
    let count = mesh.face_count() as u32;
    let is_shown = |face: &u32| mesh.face_range(*face as usize).len() >= 3;
    if mesh.face_materials.is_empty() {
        let mut all = Vec::new();
        all.try_reserve_exact(count as usize)?;
        all.extend((0..count).filter(is_shown));
        return Ok(vec![(NO_MATERIAL, all)]);
    }
    let mut places = std::collections::HashMap::new();
    let mut groups: Vec<(u32, Vec<u32>)> = Vec::new();
    let mut last = (NO_MATERIAL, usize::MAX);
    for face in (0..count).filter(is_shown) {
        let material = mesh.face_materials[face as usize];
        if last.1 == usize::MAX || last.0 != material {
            places.try_reserve(1)?;
            groups.try_reserve(1)?;
            let place = *places.entry(material).or_insert_with(|| {
                groups.push((material, Vec::new()));
                groups.len() - 1
            });
            last = (material, place);
        }
        groups[last.1].1.try_reserve(1)?;
        groups[last.1].1.push(face);
    }
    groups.sort_by_key(|(material, _)| *material == NO_MATERIAL);
    Ok(groups)
}

/// Writes faces as triangles. Returns the members of the primitive that describe them.
fn write_faces(
    mesh: &Mesh,
    split: &SplitVertices<'_>,
    faces: &[u32],
    has_polygons: bool,
    binary: &mut Binary,
) -> Result<String, WriteError> {
    let vertices = split.mesh_vertex_of_file_vertex.as_ref().map_or(mesh.positions.len(), Vec::len);
    let mut triangles = Triangles::default();
    // All faces are triangles, and in their order.
    let is_whole = !has_polygons && 3 * faces.len() == split.corners.len();
    if !is_whole {
        triangles.indices.try_reserve(3 * faces.len())?;
        for &face in faces {
            let corners = &split.corners[mesh.face_range(face as usize)];
            if has_polygons {
                triangles.push_face(mesh, face as usize, corners)?;
            } else {
                triangles.indices.extend_from_slice(corners);
            }
        }
    }
    let indices = if is_whole { &split.corners } else { &triangles.indices[..] };
    let mut text = format!(",\"indices\":{}", push_indices(indices, vertices, binary)?);
    if has_polygons {
        text.push_str(&format!(",\"extensions\":{{\"{POLYGON_EXTENSION}\":{{}}}}"));
    }
    if !triangles.polygons.is_empty() {
        text.try_reserve(triangles.polygons.len() + 64)?;
        text.push_str(&format!(",\"extras\":{{\"{POLYGON_EXTRAS}\":["));
        text.push_str(&triangles.polygons);
        text.push_str("]}");
    }
    Ok(text)
}

fn push_indices(indices: &[u32], vertices: usize, binary: &mut Binary) -> Result<u32, TryReserveError> {
    // 65535 may not be an index of 16 bits.
    if vertices < usize::from(u16::MAX) {
        binary.push_elements(indices.iter().map(|&index| [index as u16]), Target::Indices)
    } else {
        binary.push_indices(indices)
    }
}

/// Returns whether the file's positions differ from these.
fn are_rounded(positions: &Positions, origin: [f64; 3]) -> bool {
    let is_rounded = |x: f64| f64::from(x as f32) != x && !x.is_nan();
    match positions {
        Positions::F32(_) => false,
        Positions::F64(points) => points.iter().any(|point| (0..3).any(|axis| is_rounded(point[axis] - origin[axis]))),
    }
}

/// Writes polylines as segments. Returns the mesh and its origin.
pub(super) fn write_curves(
    curves: &Curves,
    binary: &mut Binary,
    lost: &mut MeshLosses,
) -> Result<Option<(String, [f64; 3])>, WriteError> {
    let mut indices: Vec<u32> = Vec::new();
    indices.try_reserve(2 * curves.positions.len())?;
    for (curve, &is_closed) in curves.closed.iter().enumerate() {
        let range = curves.offsets[curve]..curves.offsets[curve + 1];
        indices.extend(range.clone().skip(1).flat_map(|end| [end - 1, end]));
        if is_closed && range.len() > 2 {
            indices.extend([range.end - 1, range.start]);
        }
    }
    if indices.is_empty() {
        return Ok(None);
    }
    let origin = far_origin(&curves.positions);
    lost.are_positions_rounded |= are_rounded(&curves.positions, origin);
    let positions = binary.push_positions(&file_positions(&curves.positions, None, origin)?)?;
    let indices = push_indices(&indices, curves.positions.len(), binary)?;
    let json = format!(
        "{{\"name\":\"curves\",\"primitives\":[{{\"attributes\":{{\"POSITION\":{positions}}},\"indices\":{indices},\"mode\":1}}]}}"
    );
    Ok(Some((json, origin)))
}

/// Writes points without faces. Returns the mesh and its origin.
pub(super) fn write_points(
    points: &PointCloud,
    binary: &mut Binary,
    lost: &mut MeshLosses,
) -> Result<Option<(String, [f64; 3])>, WriteError> {
    if points.positions.is_empty() {
        return Ok(None);
    }
    let origin = far_origin(&points.positions);
    lost.are_positions_rounded |= are_rounded(&points.positions, origin);
    let positions = binary.push_positions(&file_positions(&points.positions, None, origin)?)?;
    let mut attributes = format!("\"POSITION\":{positions}");
    if !points.normals.is_empty() {
        let normals = points.normals.iter().map(|normal| normal.map(|x| if x.is_nan() { 0.0 } else { x as f32 }));
        attributes.push_str(&format!(",\"NORMAL\":{}", binary.push_elements(normals, Target::Vertices)?));
    }
    if !points.colours.is_empty() {
        let mut converter = ColourConverter::new(linear_from_srgb);
        let colours = points.colours.iter().map(|&colour| converter.convert(colour));
        attributes.push_str(&format!(",\"COLOR_0\":{}", binary.push_elements(colours, Target::Vertices)?));
    }
    let json = format!("{{\"name\":\"points\",\"primitives\":[{{\"attributes\":{{{attributes}}},\"mode\":0}}]}}");
    Ok(Some((json, origin)))
}
