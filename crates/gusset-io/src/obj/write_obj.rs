//! Documents as OBJ files.

use super::write_mtl::{UsedMaterials, one_line, write_library};
use super::write_values::{Numbers, ValueLines};
use crate::document::{Document, Placement, PointCloud, determinant, transformed_normal, transformed_point};
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::material::NO_MATERIAL;
use crate::mesh::{Domain, Mesh, Positions};
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::text::TextWriter;
use gusset_base::alloc;
use std::io;

/// Writes an OBJ file, and a material library beside it if faces have materials. Vertices are written once, however many a mesh has at
/// seams.
pub(crate) fn write_obj(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let materials = UsedMaterials::from_document(document)?;
    let mut losses = Vec::new();
    let library = match write_library(document, &materials, target, &mut losses) {
        Err(error) if error.kind == WriteErrorKind::Unsupported => {
            losses.push(Loss(format!("materials, which need a file beside the OBJ file: {error}")));
            None
        }
        library => library?,
    };
    let mut writer = ObjWriter {
        text: TextWriter::new(&mut *target.main_file)?,
        materials: &materials,
        current_material: Some(NO_MATERIAL),
        vertices: 0,
        texcoords: ValueLines::new("vt"),
        normals: ValueLines::new("vn"),
    };
    if let Some(library) = library {
        writer.write_line("mtllib", &library)?;
    }
    let is_cloud = document.placements.is_empty() && document.curves.closed.is_empty();
    for (number, placement) in document.placements.iter().enumerate() {
        writer.write_object(document, placement, number)?;
    }
    writer.write_curves(document)?;
    writer.write_points(&document.points, is_cloud)?;
    writer.text.finish()?;
    add_losses(document, is_cloud, &mut losses);
    Ok(losses)
}

fn add_losses(document: &Document, is_cloud: bool, losses: &mut Vec<Loss>) {
    let mut add = |is_lost: bool, what: String| {
        let loss = Loss(what);
        if is_lost && !losses.contains(&loss) {
            losses.push(loss);
        }
    };
    let has_opacity = |colours: &[[f32; 4]]| colours.iter().any(|colour| colour[3] != 1.0);
    let placed = || document.placements.iter().map(|placement| &document.meshes[placement.mesh as usize]);
    add(placed().any(|mesh| !mesh.face_colours.is_empty()), "colours of faces, which OBJ files do not hold".into());
    let opacity = placed().any(|mesh| has_opacity(&mesh.vertex_colours)) || has_opacity(&document.points.colours);
    add(opacity, "the opacity of vertices, which OBJ files do not hold".into());
    add(placed().any(has_split_colours), "colours that differ at one vertex, which OBJ files do not hold".into());
    for property in placed().flat_map(|mesh| &mesh.properties) {
        let domain = if property.domain == Domain::Vertices { "vertices" } else { "faces" };
        add(true, format!("{} of {domain}, which PLY files alone hold", property.name));
    }
    let has_normals = !document.points.normals.is_empty() && !is_cloud;
    add(has_normals, "normals of points, which OBJ files hold only without meshes and curves".into());
}

/// Returns whether vertices that are written as one have different colours.
fn has_split_colours(mesh: &Mesh) -> bool {
    let colours = &mesh.vertex_colours;
    !colours.is_empty()
        && mesh.merge.iter().zip(colours).any(|(&kept, colour)| colours[kept as usize][..3] != colour[..3])
}

struct ObjWriter<'a, 'b> {
    text: TextWriter<'b>,
    materials: &'a UsedMaterials,
    /// Material of the last `usemtl`; `None` if the next face must name its own.
    current_material: Option<u32>,
    /// Number of lines written.
    vertices: u64,
    texcoords: ValueLines<2>,
    normals: ValueLines<3>,
}

impl ObjWriter<'_, '_> {
    fn write_line(&mut self, keyword: &str, value: &str) -> io::Result<()> {
        self.text.text(keyword)?;
        self.text.bytes(b" ")?;
        self.text.text(value)?;
        self.text.bytes(b"\n")
    }

    fn write_object(&mut self, document: &Document, placement: &Placement, number: usize) -> io::Result<()> {
        let mesh = &document.meshes[placement.mesh as usize];
        let is_one_of_several = document.placements.len() > 1;
        let name = one_line(if placement.name.is_empty() { &mesh.name } else { &placement.name })?;
        if !name.is_empty() {
            self.write_line("o", &name)?;
        } else if is_one_of_several {
            self.write_line("o", &format!("object_{}", number + 1))?;
        }
        if number > 0 {
            self.current_material = None;
        }
        let transform = (placement.transform != Placement::IDENTITY).then_some(&placement.transform);
        let vertices = self.write_mesh_vertices(mesh, transform)?;
        let texcoords = self.texcoords.write(&mut self.text, &mesh.texcoords, |pair| pair)?;
        let normals = self.normals.write(&mut self.text, &mesh.normals, |normal| {
            transform.map_or(normal, |matrix| transformed_normal(matrix, normal))
        })?;
        let faces =
            Faces { mesh, vertices, texcoords, normals, is_mirrored: transform.is_some_and(|m| determinant(m) < 0.0) };
        self.write_faces(&faces)?;
        alloc::check_reserve().map_err(|_| io::ErrorKind::OutOfMemory.into())
    }

    /// Writes each vertex that represents itself.
    fn write_mesh_vertices(&mut self, mesh: &Mesh, transform: Option<&[[f64; 4]; 3]>) -> io::Result<VertexNumbers> {
        let start = self.vertices + 1;
        let count = mesh.positions.len();
        let mut numbers = Vec::new();
        if !mesh.merge.is_empty() {
            numbers.try_reserve_exact(count).map_err(|_| io::ErrorKind::OutOfMemory)?;
        }
        for vertex in 0..count {
            if !mesh.merge.is_empty() {
                numbers.push(self.vertices + 1);
                if mesh.merge[vertex] as usize != vertex {
                    continue;
                }
            }
            let colour = mesh.vertex_colours.get(vertex);
            match transform {
                Some(matrix) => {
                    self.write_vertex_double(transformed_point(matrix, mesh.positions.get(vertex)), colour)?;
                }
                None => self.write_vertex(&mesh.positions, vertex, colour)?,
            }
        }
        for (vertex, &kept) in mesh.merge.iter().enumerate() {
            numbers[vertex] = numbers[kept as usize];
        }
        Ok(VertexNumbers { first_number: start, number_of_vertex: numbers })
    }

    fn write_vertex(&mut self, positions: &Positions, index: usize, colour: Option<&[f32; 4]>) -> io::Result<()> {
        match positions {
            Positions::F64(points) => self.write_vertex_double(points[index], colour),
            Positions::F32(points) => {
                self.text.bytes(b"v")?;
                for part in points[index] {
                    self.text.bytes(b" ")?;
                    self.text.single(part)?;
                }
                self.write_vertex_end(colour)
            }
        }
    }

    fn write_vertex_double(&mut self, point: [f64; 3], colour: Option<&[f32; 4]>) -> io::Result<()> {
        self.text.bytes(b"v")?;
        for part in point {
            self.text.bytes(b" ")?;
            self.text.double(part)?;
        }
        self.write_vertex_end(colour)
    }

    fn write_vertex_end(&mut self, colour: Option<&[f32; 4]>) -> io::Result<()> {
        if let Some([red, green, blue, _]) = colour {
            for part in [red, green, blue] {
                self.text.bytes(b" ")?;
                // A part above 1 would make readers take all colours for bytes.
                self.text.single(if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) })?;
            }
        }
        self.vertices += 1;
        self.text.bytes(b"\n")
    }

    fn write_faces(&mut self, faces: &Faces<'_>) -> io::Result<()> {
        let mesh = faces.mesh;
        let has_materials = !self.materials.names.is_empty();
        for face in 0..mesh.face_count() {
            let range = mesh.face_range(face);
            if range.len() < 3 {
                continue;
            }
            if has_materials {
                self.use_material(mesh.face_materials.get(face).copied().unwrap_or(NO_MATERIAL))?;
            }
            self.text.bytes(b"f")?;
            let is_textured = faces.texcoords.has_face(mesh, face);
            let has_normals = faces.normals.has_face(mesh, face);
            for place in range.clone() {
                let corner =
                    if faces.is_mirrored && place > range.start { range.end - (place - range.start) } else { place };
                let vertex = mesh.corners[corner];
                self.text.bytes(b" ")?;
                self.text.integer(faces.vertices.number_in_file(vertex))?;
                if is_textured {
                    self.text.bytes(b"/")?;
                    self.text.integer(faces.texcoords.get(corner, vertex))?;
                }
                if has_normals {
                    self.text.bytes(if is_textured { b"/" } else { b"//" })?;
                    self.text.integer(faces.normals.get(corner, vertex))?;
                }
            }
            self.text.bytes(b"\n")?;
        }
        Ok(())
    }

    fn use_material(&mut self, material: u32) -> io::Result<()> {
        if self.current_material == Some(material) {
            return Ok(());
        }
        self.current_material = Some(material);
        self.text.bytes(b"usemtl ")?;
        self.text.text(self.materials.name(material))?;
        self.text.bytes(b"\n")
    }

    fn write_curves(&mut self, document: &Document) -> io::Result<()> {
        let curves = &document.curves;
        let start = self.vertices + 1;
        for point in 0..curves.positions.len() {
            self.write_vertex(&curves.positions, point, None)?;
        }
        for (curve, ends) in curves.offsets.windows(2).enumerate() {
            if ends[0] == ends[1] {
                continue;
            }
            self.text.bytes(b"l")?;
            let closing = curves.closed[curve].then_some(ends[0]);
            for point in (ends[0]..ends[1]).chain(closing) {
                self.text.bytes(b" ")?;
                self.text.integer(start + u64::from(point))?;
            }
            self.text.bytes(b"\n")?;
        }
        Ok(())
    }

    /// Writes points, and their normals if nothing else has normals.
    fn write_points(&mut self, points: &PointCloud, is_cloud: bool) -> io::Result<()> {
        let start = self.vertices + 1;
        for point in 0..points.positions.len() {
            self.write_vertex(&points.positions, point, points.colours.get(point))?;
        }
        for normal in points.normals.iter().filter(|_| is_cloud) {
            self.text.bytes(b"vn")?;
            for part in normal {
                self.text.bytes(b" ")?;
                self.text.attribute(*part)?;
            }
            self.text.bytes(b"\n")?;
        }
        for number in start..=self.vertices {
            self.text.bytes(b"p ")?;
            self.text.integer(number)?;
            self.text.bytes(b"\n")?;
        }
        Ok(())
    }
}

/// Numbers of vertices in the file.
struct VertexNumbers {
    first_number: u64,
    /// Number of each vertex; empty if they follow each other from `first_number`.
    number_of_vertex: Vec<u64>,
}

impl VertexNumbers {
    fn number_in_file(&self, vertex: u32) -> u64 {
        self.number_of_vertex.get(vertex as usize).copied().unwrap_or(self.first_number + u64::from(vertex))
    }
}

struct Faces<'a> {
    mesh: &'a Mesh,
    vertices: VertexNumbers,
    texcoords: Numbers,
    normals: Numbers,
    is_mirrored: bool,
}
