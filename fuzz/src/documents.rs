//! Checks of readers of files: documents are valid, memory stays within its bound, and what is written reads back.

use crate::memory::measured;
use gusset_io::{
    Document, Format, MAX_MEMORY_PER_FILE_BYTE, Mesh, Positions, ReadError, ReadErrorKind, ReadOptions, Resources,
    Target, Values, WriteErrorKind, WriteOptions, read, write,
};
use std::cell::Cell;
use std::collections::BTreeMap;

/// Expectations of the target of a format.
#[derive(Clone, Copy)]
pub(crate) struct Expected {
    pub(crate) format: Format,
    /// Memory in bytes that a file of any size may take.
    pub(crate) least_memory: u64,
    /// Whether a file holds positions and polygons as they are.
    pub(crate) is_exact: bool,
    /// Whether numbers in a file are rounded, so that a file that was read and written again may differ in them.
    pub(crate) is_rounded: bool,
}

impl Expected {
    pub(crate) fn new(format: Format) -> Self {
        Self { format, least_memory: 1 << 20, is_exact: false, is_rounded: false }
    }
}

/// Files in memory, and the bytes that were loaded.
#[derive(Default)]
pub(crate) struct Files {
    pub(crate) files: BTreeMap<String, Vec<u8>>,
    loaded: Cell<u64>,
}

impl Files {
    pub(crate) fn new(files: &[(&str, &[u8])]) -> Self {
        let files = files.iter().map(|(name, bytes)| ((*name).to_owned(), bytes.to_vec())).collect();
        Self { files, loaded: Cell::new(0) }
    }
}

impl Resources for Files {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let Some(bytes) = self.files.get(name) else {
            return Err(ReadError::new(ReadErrorKind::Unreadable, format!("{name}: the file does not exist")));
        };
        self.loaded.set(self.loaded.get() + bytes.len() as u64);
        Ok(bytes.clone())
    }
}

/// Reads a file; if it is valid, writes its content and reads it again.
///
/// # Panics
/// If the document is invalid, takes more memory than readers may take, or changes when it is written and read.
pub(crate) fn check(bytes: &[u8], files: &Files, expected: Expected) {
    let format = expected.format;
    let options = ReadOptions::default();
    files.loaded.set(0);
    let (result, memory) = measured(|| read(bytes, format, files, &options));
    let sources = bytes.len() as u64 + files.loaded.get();
    let most = MAX_MEMORY_PER_FILE_BYTE * sources + expected.least_memory;
    assert!(memory <= most, "{memory} bytes for files of {sources}");
    let document = match result {
        Ok(document) => document,
        Err(error) => {
            assert!(!error.message.is_empty() && !error.message.chars().any(char::is_control), "{error:?}");
            return;
        }
    };
    assert_valid(&document);
    if is_empty(&document) {
        return;
    }
    assert!(size(&document) <= most, "{} bytes of a document of files of {sources}", size(&document));
    for text in [false, true] {
        let Some((first, beside)) = written(&document, format, files, text) else { continue };
        let again = reread(&first, &beside, format);
        assert_eq!(document.curves.closed.is_empty(), again.curves.closed.is_empty(), "curves come or go");
        if expected.is_exact {
            let is_single = document.meshes.iter().all(|mesh| matches!(mesh.positions, Positions::F32(_)));
            assert_eq!(shape(&document, is_single), shape(&again, is_single), "the mesh changes");
        }
        // The first file may lose what its format does not hold; the second and the third hold all of it.
        let Some((second, beside)) = written(&again, format, &beside, text) else {
            panic!("a read file is not writable")
        };
        let again = reread(&second, &beside, format);
        let Some((third, _)) = written(&again, format, &beside, text) else { panic!("a read file is not writable") };
        if !expected.is_rounded {
            expect_equal(&second, &third);
        }
    }
}

fn is_empty(document: &Document) -> bool {
    let has_points = document.meshes.iter().any(|mesh| !mesh.positions.is_empty());
    !has_points && document.points.positions.is_empty() && document.curves.positions.is_empty()
}

fn reread(bytes: &[u8], files: &Files, format: Format) -> Document {
    let document = match read(bytes, format, files, &ReadOptions::default()) {
        Ok(document) => document,
        Err(error) => panic!("a written file is not readable: {error}"),
    };
    assert_valid(&document);
    document
}

fn expect_equal(second: &[u8], third: &[u8]) {
    if let Some(place) = (0..second.len().max(third.len())).find(|&k| second.get(k) != third.get(k)) {
        let part = |file: &[u8]| {
            let end = file.len().min(place + 60);
            String::from_utf8_lossy(&file[place.saturating_sub(60).min(end)..end]).into_owned()
        };
        panic!("written, read and written again: at byte {place} {:?} becomes {:?}", part(second), part(third));
    }
}

/// Writes a document. Returns the file and those beside it, or `None` if the format cannot hold the content.
fn written(document: &Document, format: Format, files: &Files, text: bool) -> Option<(Vec<u8>, Files)> {
    let mut main = Vec::new();
    let mut beside = Files { files: files.files.clone(), ..Files::default() };
    let mut add = |name: &str, bytes: &[u8]| {
        beside.files.insert(name.to_owned(), bytes.to_vec());
        Ok(())
    };
    let mut target = Target { main_file: &mut main, stem: "mesh", beside: &mut add, resources: files };
    match write(document, format, &mut target, &WriteOptions { text, lossy: true, ..WriteOptions::default() }) {
        Ok(losses) => assert!(losses.iter().all(|loss| !loss.0.is_empty())),
        Err(error) => {
            assert_ne!(error.kind, WriteErrorKind::Unwritable, "{error}");
            return None;
        }
    }
    Some((main, beside))
}

/// Panics if an index does not exist, a length does not agree, or a note has control characters.
fn assert_valid(document: &Document) {
    if let Err(error) = document.check() {
        panic!("the document is invalid: {error}");
    }
    for mesh in &document.meshes {
        assert!((0..mesh.face_count()).all(|face| mesh.face(face).len() > 2), "a face with fewer than 3 corners");
    }
    assert!(document.notes.iter().all(|note| !note.text.chars().any(char::is_control)));
}

/// Returns the positions of the corners of all faces in the scene, as bits that are equal for equal numbers. Rounds positions if they
/// were written with the digits of single precision.
fn shape(document: &Document, is_single: bool) -> Vec<Vec<[u64; 3]>> {
    let joined = document.clone().into_joined(1 << 20).ok();
    let Some(mesh) = joined.and_then(|mut joined| joined.meshes.pop()) else { return Vec::new() };
    let rounded = |x: f64| if is_single { f64::from(x as f32) } else { x };
    let bits = |x: f64| if x.is_nan() { u64::MAX } else { (rounded(x) + 0.0).to_bits() };
    let corner = |vertex: &u32| mesh.positions.get(*vertex as usize).map(bits);
    (0..mesh.face_count()).map(|face| mesh.face(face).iter().map(corner).collect()).collect()
}

/// Returns the memory of the arrays of a document.
fn size(document: &Document) -> u64 {
    fn bytes<T>(values: &[T]) -> usize {
        size_of_val(values)
    }
    fn positions(positions: &Positions) -> usize {
        match positions {
            Positions::F32(points) => bytes(points),
            Positions::F64(points) => bytes(points),
        }
    }
    fn values<const N: usize>(values: &Values<N>) -> usize {
        match values {
            Values::Absent => 0,
            Values::Vertices(values) | Values::Corners(values) => bytes(values),
        }
    }
    let mesh_size = |mesh: &Mesh| {
        positions(&mesh.positions)
            + bytes(&mesh.face_offsets)
            + bytes(&mesh.corners)
            + bytes(&mesh.merge)
            + values(&mesh.normals)
            + values(&mesh.texcoords)
            + bytes(&mesh.vertex_colours)
            + bytes(&mesh.face_colours)
            + bytes(&mesh.face_materials)
            + mesh.properties.iter().map(|property| bytes(&property.values)).sum::<usize>()
    };
    let meshes: usize = document.meshes.iter().map(mesh_size).sum();
    let curves = positions(&document.curves.positions) + bytes(&document.curves.offsets);
    let points = positions(&document.points.positions) + bytes(&document.points.normals);
    let rest = bytes(&document.placements) + bytes(&document.materials) + bytes(&document.notes);
    (meshes + curves + points + bytes(&document.points.colours) + rest) as u64
}
