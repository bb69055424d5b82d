//! The reader and the writer of each format.

use crate::document::Document;
use crate::error::{Loss, ReadError, WriteError, WriteErrorKind};
use crate::format::Format;
use crate::options::{ReadOptions, WriteOptions};
use crate::resources::{Resources, Target};
use crate::{dxf, gltf, obj, off, ply, points, scan_list, stl, svg, three_mf};
use gusset_base::alloc;

/// Reads a file from memory. `resources` gives the files that it refers to.
///
/// # Errors
/// See [`ReadErrorKind`](crate::ReadErrorKind). Takes time linear in the file.
pub fn read(
    bytes: &[u8],
    format: Format,
    resources: &dyn Resources,
    options: &ReadOptions,
) -> Result<Document, ReadError> {
    let document = match format {
        Format::Obj => obj::read_obj(bytes, resources, options),
        Format::Ply => ply::read_ply(bytes, options),
        Format::Stl => stl::read_stl(bytes, options),
        Format::Off => off::read_off(bytes, options),
        Format::Gltf | Format::Glb => gltf::read_gltf(bytes, resources, options),
        Format::ThreeMf => three_mf::read_3mf(bytes, options),
        Format::ScanList => scan_list::read_scan_list(bytes, resources, options, read),
        Format::Xyz => points::read_xyz(bytes, options),
        Format::Csv => points::read_csv(bytes, options),
        Format::Svg => svg::read_svg(bytes, options),
        Format::Dxf => dxf::read_dxf(bytes, options),
    };
    // Small parts of the document may be in the reserve of memory, where they must not stay.
    alloc::check_reserve()?;
    document
}

/// Writes a file of the document's meshes, curves or points. Returns what the format could not hold.
///
/// # Errors
/// See [`WriteErrorKind`].
pub fn write(
    document: &Document,
    format: Format,
    target: &mut Target<'_>,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    match format {
        Format::Obj => obj::write_obj(document, target, options),
        Format::Ply => ply::write_ply(document, target, options),
        Format::Stl => stl::write_stl(document, target, options),
        Format::Off => off::write_off(document, target, options),
        Format::Gltf => gltf::write_gltf(document, target, options),
        Format::Glb => gltf::write_glb(document, target, options),
        Format::ThreeMf => three_mf::write_3mf(document, target, options),
        Format::ScanList => Err(WriteError::new(WriteErrorKind::Unsupported, "lists of scans are read, not written")),
        Format::Xyz => points::write_xyz(document, target, options),
        Format::Csv => points::write_csv(document, target, options),
        Format::Svg => svg::write_svg(document, target, options),
        Format::Dxf => dxf::write_dxf(document, target, options),
    }
}
