//! A mesh of the file: the primitives' vertices and faces as one mesh, and its lines and points.

use super::gltf_accessors::{Accessor, Accessors, Component};
use super::gltf_buffers::{Buffers, malformed};
use super::gltf_colour::{ColourConverter, srgb_from_linear};
use super::gltf_faces_read::{Mode, append_faces, checked_indices};
use super::gltf_notes::Unread;
use super::gltf_strands::{LoosePoint, Strands};
use super::gltf_unite::{are_origins_right, merge_equal_positions, unite_vertices};
use crate::budget::Budget;
use crate::error::{Note, ReadError, ReadErrorKind};
use crate::json_tape::Value;
use crate::material::NO_MATERIAL;
use crate::mesh::{Mesh, Positions, Values};
use gusset_base::alloc;
use std::collections::BTreeMap;

/// Vertex attribute of files of this library: two halves of the number of the vertex from which this one was split.
pub(super) const ORIGIN_ATTRIBUTE: &str = "_VERTEX";

const ATTRIBUTES: [&str; 5] = ["POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0", ORIGIN_ATTRIBUTE];

/// Accessors of a primitive, as in [`ATTRIBUTES`].
type VertexSource = [Option<usize>; 5];

const DRACO: &str = "KHR_draco_mesh_compression";

/// Reads one mesh.
pub(super) struct MeshReader<'r, 'a> {
    pub(super) accessors: &'r mut Accessors<'a>,
    pub(super) notes: &'r mut Vec<Note>,
    pub(super) unread: &'r mut Unread,
    /// Whether vertices at equal positions get a common representative.
    pub(super) merges: bool,
    mesh: Mesh,
    strands: Strands,
    /// First vertex and number of vertices of known attributes: primitives often share them.
    vertex_ranges_of_known_sources: BTreeMap<VertexSource, [u32; 2]>,
    normals: Vec<[f64; 3]>,
    texcoords: Vec<[f64; 2]>,
    origins: Vec<u32>,
    has_origins: bool,
}

impl<'r, 'a> MeshReader<'r, 'a> {
    pub(super) fn new(
        accessors: &'r mut Accessors<'a>,
        notes: &'r mut Vec<Note>,
        unread: &'r mut Unread,
        merges: bool,
    ) -> Self {
        Self {
            accessors,
            notes,
            unread,
            merges,
            mesh: Mesh::default(),
            strands: Strands::default(),
            vertex_ranges_of_known_sources: BTreeMap::new(),
            normals: Vec::new(),
            texcoords: Vec::new(),
            origins: Vec::new(),
            has_origins: false,
        }
    }

    /// Reads all primitives. `material` gives the document's index of a material of the file.
    pub(super) fn read(
        mut self,
        json: Value<'a>,
        index: usize,
        mut material: impl FnMut(usize, &mut Buffers<'a>) -> Result<u32, ReadError>,
    ) -> Result<(Mesh, Strands), ReadError> {
        self.mesh.name = json.get("name").and_then(Value::text).unwrap_or_default().into_owned();
        for (place, primitive) in json.get("primitives").into_iter().flat_map(Value::items).enumerate() {
            let faces = self.mesh.face_count();
            self.read_primitive(primitive, [index, place, faces])?;
            let added = self.mesh.face_count() - faces;
            if added > 0 {
                let own = match primitive.get("material") {
                    None => NO_MATERIAL,
                    Some(value) => {
                        let index = value.whole_number().map_or(usize::MAX, |whole| whole as usize);
                        material(index, &mut self.accessors.buffers)?
                    }
                };
                self.accessors.buffers.budget.take_bytes_of::<u32>(added as u64)?;
                self.mesh.face_materials.try_reserve(added)?;
                self.mesh.face_materials.resize(self.mesh.face_count(), own);
            }
        }
        if self.mesh.face_materials.iter().all(|&material| material == NO_MATERIAL) {
            self.mesh.face_materials.clear();
        }
        self.finish()
    }

    fn read_primitive(&mut self, primitive: Value<'a>, place: [usize; 3]) -> Result<(), ReadError> {
        let [mesh, number, _] = place;
        let mode = primitive.get("mode").map_or(Some(4), Value::whole_number).and_then(Mode::from_code);
        let mode = mode.ok_or_else(|| malformed(format!("mesh {mesh}, primitive {number} has an unknown mode")))?;
        let attributes = primitive.get("attributes");
        let mut source = VertexSource::default();
        for (key, value) in attributes.into_iter().flat_map(Value::members) {
            match ATTRIBUTES.iter().position(|name| key.equals_text(name)) {
                Some(kind) => source[kind] = value.whole_number().map(|index| index as usize),
                None => self.unread.add_attribute(&key.text().unwrap_or_default()),
            }
        }
        self.unread.has_morph_targets |=
            primitive.get("targets").is_some_and(|targets| targets.items().next().is_some());
        let is_draco = primitive.get("extensions").is_some_and(|all| all.get(DRACO).is_some());
        let Some(position) = source[0] else {
            return Err(malformed(format!("mesh {mesh}, primitive {number} has no positions")));
        };
        let positions = self.accessors.open_accessor(position, self.notes)?;
        if is_draco && !positions.has_bytes() {
            return Err(draco_error());
        }
        let count = u32::try_from(positions.count).unwrap_or(u32::MAX);
        let indices = match primitive.get("indices") {
            Some(index) => {
                let index =
                    index.whole_number().ok_or_else(|| malformed("the indices of a primitive are not an accessor"))?;
                self.accessors.open_accessor(index as usize, self.notes)?.read_indices(&mut self.accessors.buffers)?
            }
            None => {
                let mut all = self.accessors.buffers.budget.allocate_vector(u64::from(count))?;
                all.extend(0..count);
                all
            }
        };
        if !mode.has_faces() {
            let indices = checked_indices(indices, mode, [0, count], place)?;
            return self.strands(mode, &source, &positions, &indices);
        }
        let range = match self.vertex_ranges_of_known_sources.get(&source) {
            Some(&range) => range,
            None => {
                let range = self.find_or_read_vertices(&source, &positions)?;
                self.vertex_ranges_of_known_sources.insert(source, range);
                range
            }
        };
        let indices = checked_indices(indices, mode, range, place)?;
        let count = indices.len() as u64;
        let (faces, corners) = if mode == Mode::Triangles { (count / 3, count) } else { (count, 3 * count) };
        self.accessors.buffers.budget.take_bytes_of::<u32>(faces + corners)?;
        append_faces(&mut self.mesh, primitive, mode, indices, range[0], self.notes)?;
        self.accessors.buffers.budget.give_back_bytes_of::<u32>(count);
        Ok(())
    }

    /// Appends the vertices of a primitive. Returns the first one and their number.
    fn find_or_read_vertices(
        &mut self,
        source: &VertexSource,
        positions: &Accessor<'a>,
    ) -> Result<[u32; 2], ReadError> {
        let (start, count) = (self.mesh.positions.len(), positions.count);
        if start as u64 + count as u64 >= u64::from(u32::MAX) {
            return Err(ReadError::new(ReadErrorKind::TooLarge, "a mesh has more than 2^32 - 2 vertices; split it"));
        }
        append_positions(&mut self.mesh.positions, positions, self.accessors)?;
        if let Some(normals) = self.read_attribute::<3, f64>(source[1], count, "NORMAL", |x| x)? {
            append_padded(&mut self.normals, normals, start, [f64::NAN; 3])?;
        }
        if let Some(mut texcoords) = self.read_attribute::<2, f64>(source[2], count, "TEXCOORD_0", |x| x)? {
            // In glTF, v runs down from the upper left of the image.
            texcoords.iter_mut().for_each(|pair| pair[1] = 1.0 - pair[1]);
            append_padded(&mut self.texcoords, texcoords, start, [f64::NAN; 2])?;
        }
        if let Some(colours) = self.read_colours(source[3], count)? {
            append_padded(&mut self.mesh.vertex_colours, colours, start, [1.0; 4])?;
        }
        self.origins(source[4], start, count)?;
        Ok([start as u32, count as u32])
    }

    /// Reads an attribute of vertices; `None` if the primitive lacks it.
    fn read_attribute<const N: usize, T: Copy>(
        &mut self,
        accessor: Option<usize>,
        count: usize,
        name: &str,
        convert: impl Fn(f64) -> T,
    ) -> Result<Option<Vec<[T; N]>>, ReadError> {
        let Some(index) = accessor else { return Ok(None) };
        let accessor = self.accessors.open_accessor(index, self.notes)?;
        if accessor.count != count {
            return Err(malformed(format!(
                "{name} has {} elements, and POSITION has {count}; accessor {index} is of another mesh",
                accessor.count
            )));
        }
        accessor.read_vectors(&mut self.accessors.buffers, convert).map(Some)
    }

    fn read_colours(&mut self, accessor: Option<usize>, count: usize) -> Result<Option<Vec<[f32; 4]>>, ReadError> {
        let Some(index) = accessor else { return Ok(None) };
        let mut made = if self.accessors.open_accessor(index, self.notes)?.width == 4 {
            self.read_attribute::<4, f32>(accessor, count, "COLOR_0", |x| x as f32)?.unwrap_or_default()
        } else {
            let opaque = self.read_attribute::<3, f32>(accessor, count, "COLOR_0", |x| x as f32)?.unwrap_or_default();
            let mut made = self.accessors.buffers.budget.allocate_vector(count as u64)?;
            made.extend(opaque.iter().map(|&[r, g, b]| [r, g, b, 1.0]));
            self.accessors.buffers.budget.give_back_bytes_of::<[f32; 3]>(count as u64);
            made
        };
        let mut converter = ColourConverter::new(srgb_from_linear);
        made.iter_mut().for_each(|colour| *colour = converter.convert(*colour));
        Ok(Some(made))
    }

    /// Reads from which vertex each one was split. Ignores numbers that cannot be right.
    fn origins(&mut self, accessor: Option<usize>, start: usize, count: usize) -> Result<(), ReadError> {
        let halves = self.read_attribute::<2, u32>(accessor, count, ORIGIN_ATTRIBUTE, |x| x as u32)?;
        self.accessors.buffers.budget.take_bytes_of::<u32>(count as u64)?;
        self.origins.try_reserve(count)?;
        self.has_origins |= halves.is_some();
        let own = |vertex: usize| halves.as_ref().map(|all| all[vertex][0] as usize + 65536 * all[vertex][1] as usize);
        // An origin that is itself split is not one.
        let is_origin = |vertex: usize| own(vertex) == Some(vertex);
        self.origins.extend((0..count).map(|vertex| {
            let origin = own(vertex).filter(|&origin| origin < count && is_origin(origin)).unwrap_or(vertex);
            (start + origin) as u32
        }));
        if halves.is_some() {
            self.accessors.buffers.budget.give_back_bytes_of::<[u32; 2]>(count as u64);
        }
        Ok(())
    }

    fn strands(
        &mut self,
        mode: Mode,
        source: &VertexSource,
        positions: &Accessor<'a>,
        indices: &[u32],
    ) -> Result<(), ReadError> {
        let count = positions.count;
        let points = positions.read_vectors::<3, f64>(&mut self.accessors.buffers, |x| x)?;
        if mode != Mode::Points {
            return self.strands.append_lines(mode, indices, &points, &mut self.accessors.buffers.budget);
        }
        let normals = self.read_attribute::<3, f64>(source[1], count, "NORMAL", |x| x)?;
        let colours = self.read_colours(source[3], count)?;
        self.strands.has_normals |= normals.is_some();
        self.strands.has_colours |= colours.is_some();
        self.accessors.buffers.budget.take_bytes_of::<LoosePoint>(indices.len() as u64)?;
        self.strands.points.try_reserve(indices.len())?;
        self.strands.points.extend(indices.iter().map(|&vertex| {
            let vertex = vertex as usize;
            LoosePoint {
                position: points[vertex],
                normal: normals.as_ref().map_or([f64::NAN; 3], |all| all[vertex]),
                colour: colours.as_ref().map_or([f32::NAN; 4], |all| all[vertex]),
            }
        }));
        Ok(())
    }

    fn finish(self) -> Result<(Mesh, Strands), ReadError> {
        let Self { mut mesh, accessors, notes, .. } = self;
        let budget: &mut Budget = &mut accessors.buffers.budget;
        let count = mesh.positions.len();
        mesh.normals = padded(self.normals, count, [f64::NAN; 3])?.map_or(Values::Absent, Values::Vertices);
        mesh.texcoords = padded(self.texcoords, count, [f64::NAN; 2])?.map_or(Values::Absent, Values::Vertices);
        mesh.vertex_colours = padded(mesh.vertex_colours, count, [1.0; 4])?.unwrap_or_default();
        if self.has_origins && are_origins_right(&mesh.positions, &self.origins) {
            unite_vertices(&mut mesh, &self.origins, budget)?;
        } else if self.merges {
            merge_equal_positions(&mut mesh, budget, notes)?;
        }
        Ok((mesh, self.strands))
    }
}

/// Makes the error of a primitive whose numbers only Draco holds.
pub(super) fn draco_error() -> ReadError {
    ReadError::unsupported(
        "the file requires the extension KHR_draco_mesh_compression, which is not read; decompress it by \
         gltf-transform cp in.glb out.glb",
    )
}

fn append_padded<T: Copy>(all: &mut Vec<T>, added: Vec<T>, start: usize, missing: T) -> Result<(), ReadError> {
    if start == 0 {
        *all = added;
        return Ok(());
    }
    all.try_reserve((start - all.len()) + added.len())?;
    all.resize(start, missing);
    all.extend_from_slice(&added);
    Ok(())
}

/// Fills an attribute that some primitives lack; `None` if all lack it.
fn padded<T: Copy>(mut all: Vec<T>, count: usize, missing: T) -> Result<Option<Vec<T>>, ReadError> {
    if all.is_empty() {
        return Ok(None);
    }
    alloc::grow(&mut all, count, missing)?;
    Ok(Some(all))
}

/// Appends positions in single precision if all numbers are exact in it.
fn append_positions(all: &mut Positions, added: &Accessor<'_>, accessors: &mut Accessors<'_>) -> Result<(), ReadError> {
    // Normalised integers are fractions, whose error in single precision is far below their own steps.
    let is_single = !matches!(added.component, Component::I32 | Component::U32 | Component::F64);
    let buffers = &mut accessors.buffers;
    let added = if is_single {
        Positions::F32(added.read_vectors(buffers, |x| x as f32)?)
    } else {
        Positions::F64(added.read_vectors(buffers, |x| x)?)
    };
    if all.is_empty() {
        *all = added;
        return Ok(());
    }
    match (&mut *all, &added) {
        (Positions::F32(all), Positions::F32(added)) => {
            all.try_reserve(added.len())?;
            all.extend_from_slice(added);
        }
        _ => {
            buffers.budget.take_bytes_of::<[f64; 3]>((all.len() + added.len()) as u64)?;
            let mut doubles = Vec::new();
            doubles.try_reserve_exact(all.len() + added.len())?;
            doubles.extend(all.iter().chain(added.iter()));
            *all = Positions::F64(doubles);
        }
    }
    Ok(())
}
