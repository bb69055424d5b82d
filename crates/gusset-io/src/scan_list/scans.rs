//! Scans of a list in one scene.

use super::pose::{Pose, placed_direction, placed_point, product};
use crate::document::{Document, Placement, PointCloud};
use crate::error::{Note, Place, ReadError, ReadErrorKind, printable};
use crate::format::Format;
use crate::material::{ImageData, NO_MATERIAL, NativeMaterial};
use crate::mesh::Positions;
use crate::options::ReadOptions;
use crate::resources::Resources;
use crate::text_encoding::owned_text;
use gusset_base::alloc;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Reads a scan of any format.
pub(crate) type ReadScan = fn(&[u8], Format, &dyn Resources, &ReadOptions) -> Result<Document, ReadError>;

/// Document that grows with the scans.
pub(super) struct Scene<'a> {
    pub(super) document: Document,
    /// For each name: the scan's only mesh and its transform, or the line of a scan that cannot be repeated.
    loaded: BTreeMap<String, Result<(u32, Pose), Place>>,
    ledger: Ledger<'a>,
    options: &'a ReadOptions,
    read_scan: ReadScan,
}

impl<'a> Scene<'a> {
    pub(super) fn new(resources: &'a dyn Resources, options: &'a ReadOptions, read_scan: ReadScan) -> Self {
        Self {
            document: Document::default(),
            loaded: BTreeMap::new(),
            ledger: Ledger::new(resources),
            options,
            read_scan,
        }
    }

    /// Returns whether no scan was added.
    pub(super) fn is_empty(&self) -> bool {
        self.loaded.is_empty()
    }

    /// Adds a scan that a line names.
    pub(super) fn add(&mut self, name: &str, pose: &Pose, line: Place) -> Result<(), ReadError> {
        let name = plain_name(name);
        match self.loaded.get(&name) {
            Some(&Ok((mesh, transform))) => {
                let transform = product(pose, &transform);
                alloc::check_reserve()?;
                self.document.placements.try_reserve(1)?;
                self.document.placements.push(Placement { name: stem(&name).into(), mesh, transform });
                return Ok(());
            }
            Some(Err(first)) => {
                let first = if let Place::Line(line) = first { *line } else { 0 };
                let text = format!("{name} is named in line {first} too; only scans of one mesh can be repeated");
                return Err(ReadError::malformed(line, text));
            }
            None => {}
        }
        let scan = self.load(&name).map_err(|error| ReadError { place: line, ..error })?;
        let only_mesh = match (&scan.placements[..], scan.points.positions.is_empty(), scan.curves.closed.is_empty()) {
            ([only], true, true) => Ok((self.document.meshes.len() as u32 + only.mesh, only.transform)),
            _ => Err(line),
        };
        self.append(scan, &name, pose)?;
        self.loaded.insert(name, only_mesh);
        Ok(())
    }

    fn load(&self, name: &str) -> Result<Document, ReadError> {
        let format = match Format::from_name(name) {
            Some(Format::ScanList) => {
                return Err(ReadError::unsupported(format!("{name}: a list of scans cannot name another list")));
            }
            Some(format) => format,
            None => {
                return Err(ReadError::unsupported(format!(
                    "{name}: the extension is unknown; rename the file after its format"
                )));
            }
        };
        let bytes = self.ledger.load(name)?;
        let beside = Beside { folder: folder(name), ledger: &self.ledger };
        (self.read_scan)(&bytes, format, &beside, self.options).map_err(|error| ReadError {
            message: printable(&match error.place {
                Place::Whole => format!("{name}: {}", error.message),
                _ => format!("{name}:{error}"),
            }),
            ..error
        })
    }

    fn append(&mut self, mut scan: Document, name: &str, pose: &Pose) -> Result<(), ReadError> {
        let too_large = || {
            ReadError::new(ReadErrorKind::TooLarge, "the scans have more than 2^32 - 1 meshes or images; list fewer")
        };
        let document = &mut self.document;
        let is_first = self.loaded.is_empty();
        let mesh_start = u32::try_from(document.meshes.len()).map_err(|_| too_large())?;
        let material_start = u32::try_from(document.materials.len()).map_err(|_| too_large())?;
        let image_start = u32::try_from(document.images.len()).map_err(|_| too_large())?;
        for material in scan.meshes.iter_mut().flat_map(|mesh| &mut mesh.face_materials) {
            if *material != NO_MATERIAL {
                *material += material_start;
            }
        }
        rename_files(&mut scan, folder(name), image_start)?;
        alloc::reserve(&mut document.meshes, scan.meshes.len())?;
        alloc::reserve(&mut document.materials, scan.materials.len())?;
        alloc::reserve(&mut document.images, scan.images.len())?;
        alloc::reserve(&mut document.placements, scan.placements.len())?;
        alloc::reserve(&mut document.notes, scan.notes.len())?;
        document.meshes.append(&mut scan.meshes);
        document.materials.append(&mut scan.materials);
        document.images.append(&mut scan.images);
        let is_only = scan.placements.len() == 1;
        for placement in scan.placements {
            let name = if is_only || placement.name.is_empty() { stem(name).into() } else { placement.name };
            let transform = product(pose, &placement.transform);
            document.placements.push(Placement { name, mesh: mesh_start + placement.mesh, transform });
        }
        append_points(&mut document.points, scan.points, pose)?;
        append_curves(document, &scan.curves, pose)?;
        document.metres_per_unit =
            scan.metres_per_unit.filter(|_| is_first || document.metres_per_unit == scan.metres_per_unit);
        document.notes.extend(scan.notes.iter().map(|note| {
            let text = match note.place {
                Place::Whole => format!("{name}: {}", note.text),
                Place::Line(line) => format!("{name}:{line}: {}", note.text),
                Place::Byte(byte) => format!("{name}:byte {byte}: {}", note.text),
            };
            Note::new(Place::Whole, text)
        }));
        Ok(alloc::check_reserve()?)
    }
}

/// Makes names of files relative to the list's folder, and numbers images after the images of earlier scans.
fn rename_files(scan: &mut Document, folder: &str, image_start: u32) -> Result<(), ReadError> {
    for image in &mut scan.images {
        if let ImageData::File(name) = &mut image.data
            && !folder.is_empty()
        {
            *name = format!("{folder}{name}");
        }
    }
    for material in &mut scan.materials {
        material.image = material.image.map(|image| image + image_start);
        match &mut material.native {
            // Its lines name files in the folder of the scan.
            Some(NativeMaterial::Mtl(_)) if !folder.is_empty() => material.native = None,
            Some(NativeMaterial::Gltf { textures, .. }) => {
                let mut moved = alloc::with_capacity(textures.len())?;
                for (sampler, image) in textures.iter() {
                    moved.push((owned_text(sampler.as_bytes())?, image.map(|k| k + image_start)));
                }
                *textures = Arc::new(moved);
            }
            _ => {}
        }
        alloc::check_reserve()?;
    }
    Ok(())
}

/// Appends points. Normals and colours stay only if all points have them.
fn append_points(all: &mut PointCloud, added: PointCloud, pose: &Pose) -> Result<(), ReadError> {
    if added.positions.is_empty() {
        return Ok(());
    }
    let before = all.positions.len();
    let is_moved = *pose != Placement::IDENTITY;
    append_positions(&mut all.positions, added.positions, pose)?;
    let placed = added.normals.into_iter().map(|normal| if is_moved { placed_direction(pose, normal) } else { normal });
    append_if_complete(&mut all.normals, placed, before)?;
    append_if_complete(&mut all.colours, added.colours.into_iter(), before)
}

/// Appends values if the first `before` elements and the added elements have them. Removes all otherwise.
fn append_if_complete<T>(
    all: &mut Vec<T>,
    added: impl ExactSizeIterator<Item = T>,
    before: usize,
) -> Result<(), ReadError> {
    if all.len() == before && added.len() > 0 {
        all.try_reserve(added.len())?;
        all.extend(added);
    } else {
        *all = Vec::new();
    }
    Ok(())
}

/// Appends positions. Positions under the identity keep their bits.
fn append_positions(all: &mut Positions, added: Positions, pose: &Pose) -> Result<(), ReadError> {
    let is_moved = *pose != Placement::IDENTITY;
    if all.is_empty() && !is_moved {
        *all = added;
        return Ok(());
    }
    if let (Positions::F32(all), Positions::F32(added), false) = (&mut *all, &added, is_moved) {
        all.try_reserve(added.len())?;
        all.extend_from_slice(added);
        return Ok(());
    }
    let mut points = match std::mem::take(all) {
        Positions::F64(points) => points,
        Positions::F32(points) => {
            let mut doubled = Vec::new();
            doubled.try_reserve(points.len() + added.len())?;
            doubled.extend(points.iter().map(|point| point.map(f64::from)));
            doubled
        }
    };
    points.try_reserve(added.len())?;
    points.extend(added.iter().map(|point| if is_moved { placed_point(pose, point) } else { point }));
    *all = Positions::F64(points);
    Ok(())
}

fn append_curves(document: &mut Document, added: &crate::Curves, pose: &Pose) -> Result<(), ReadError> {
    if added.closed.is_empty() {
        return Ok(());
    }
    let curves = &mut document.curves;
    let too_large =
        || ReadError::new(ReadErrorKind::TooLarge, "the scans have more than 2^32 - 1 points of curves; list fewer");
    let start = u32::try_from(curves.positions.len()).map_err(|_| too_large())?;
    u32::try_from(curves.positions.len() + added.positions.len()).map_err(|_| too_large())?;
    append_positions(&mut curves.positions, added.positions.try_clone()?, pose)?;
    alloc::reserve(&mut curves.offsets, added.closed.len())?;
    alloc::reserve(&mut curves.closed, added.closed.len())?;
    curves.offsets.extend(added.offsets[1..].iter().map(|offset| offset + start));
    curves.closed.extend(&added.closed);
    Ok(())
}

/// Counts the bytes of files that are loaded, so that many scans cannot load one large file again and again.
struct Ledger<'a> {
    resources: &'a dyn Resources,
    names: RefCell<BTreeSet<String>>,
    first_bytes: Cell<u64>,
    repeated_bytes: Cell<u64>,
}

/// Largest number of bytes that are loaded again, as a multiple of the bytes of all loaded files.
const MAX_REPEATED: u64 = 16;

impl<'a> Ledger<'a> {
    fn new(resources: &'a dyn Resources) -> Self {
        Self { resources, names: RefCell::default(), first_bytes: Cell::new(0), repeated_bytes: Cell::new(0) }
    }

    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let name = plain_name(name);
        if self.repeated_bytes.get() > MAX_REPEATED * self.first_bytes.get() {
            let text = format!("{name} and other files are loaded too often; read fewer scans that share files");
            return Err(ReadError::new(ReadErrorKind::TooLarge, text));
        }
        let bytes = self.resources.load(&name)?;
        let is_first = self.names.borrow_mut().insert(name);
        let counter = if is_first { &self.first_bytes } else { &self.repeated_bytes };
        counter.set(counter.get() + bytes.len() as u64);
        Ok(bytes)
    }
}

/// Files beside a scan.
struct Beside<'a> {
    /// The scan's folder with a slash behind it, or nothing.
    folder: &'a str,
    ledger: &'a Ledger<'a>,
}

impl Resources for Beside<'_> {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        self.ledger.load(&format!("{}{name}", self.folder))
    }
}

/// Returns the name with slashes, without empty parts and without parts that mean the folder itself.
fn plain_name(name: &str) -> String {
    let name = name.replace('\\', "/");
    let parts: Vec<&str> = name.split('/').filter(|part| !part.is_empty() && *part != ".").collect();
    let plain = parts.join("/");
    if name.starts_with('/') { format!("/{plain}") } else { plain }
}

fn folder(name: &str) -> &str {
    name.rfind('/').map_or("", |end| &name[..=end])
}

fn stem(name: &str) -> &str {
    let file = &name[folder(name).len()..];
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}
