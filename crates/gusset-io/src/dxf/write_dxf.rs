//! Outlines and points as DXF files.

use super::dxf_units::number_from_metres;
use crate::document::Document;
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::mesh::Positions;
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::scene::are_points_of_curves;
use crate::text::TextWriter;
use std::io;

/// Flags of a polyline: closed, and not in a plane of constant z.
const CLOSED_FLAG: u64 = 1;
const SPATIAL_FLAG: u64 = 8;
/// Flag of a vertex of a polyline that is not in a plane of constant z.
const SPATIAL_VERTEX_FLAG: u64 = 32;

pub(crate) fn write_dxf(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let has_curves = !document.curves.closed.is_empty();
    let has_other_points = !has_curves || !are_points_of_curves(document);
    let has_points = has_other_points && !document.points.positions.is_empty();
    let has_meshes = document.meshes.iter().any(|mesh| !mesh.positions.is_empty());
    if has_meshes && !has_curves && !has_points {
        let message = "DXF files are written from curves and points, and there are none";
        return Err(WriteError::new(WriteErrorKind::Unsupported, message));
    }
    let mut losses = Vec::new();
    if has_meshes {
        losses.push(Loss("meshes, which are not written to DXF files".into()));
    }
    if has_points && !(document.points.colours.is_empty() && document.points.normals.is_empty()) {
        losses.push(Loss("colours and normals of points, which DXF files do not hold".into()));
    }
    let unit = document.metres_per_unit.and_then(number_from_metres);
    if let (Some(metres), None) = (document.metres_per_unit, unit) {
        losses.push(Loss(format!("the unit of {metres} m, for which DXF files have no name")));
    }
    let mut out = TextWriter::new(target.main_file)?;
    out.text("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n")?;
    out.integer(unit.unwrap_or(0) as u64)?;
    out.text("\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n")?;
    for curve in 0..document.curves.closed.len() {
        write_polyline(document, curve, &mut out)?;
    }
    if has_points {
        for point in 0..document.points.positions.len() {
            out.text("0\nPOINT\n8\n0\n")?;
            write_position(&document.points.positions, point, &mut out)?;
        }
    }
    out.text("0\nENDSEC\n0\nEOF\n")?;
    out.finish()?;
    Ok(losses)
}

fn write_polyline(document: &Document, curve: usize, out: &mut TextWriter<'_>) -> io::Result<()> {
    let curves = &document.curves;
    let range = curves.offsets[curve] as usize..curves.offsets[curve + 1] as usize;
    if range.is_empty() {
        return Ok(());
    }
    let elevation = curves.positions.get(range.start)[2];
    let is_spatial = range.clone().any(|point| curves.positions.get(point)[2] != elevation);
    let flags = if curves.closed[curve] { CLOSED_FLAG } else { 0 } + if is_spatial { SPATIAL_FLAG } else { 0 };
    out.text("0\nPOLYLINE\n8\n0\n66\n1\n70\n")?;
    out.integer(flags)?;
    out.text("\n10\n0\n20\n0\n30\n")?;
    if is_spatial {
        out.text("0")?;
    } else {
        write_coordinate(&curves.positions, range.start, 2, out)?;
    }
    out.text("\n")?;
    for point in range {
        out.text("0\nVERTEX\n8\n0\n")?;
        write_position(&curves.positions, point, out)?;
        if is_spatial {
            out.text("70\n")?;
            out.integer(SPATIAL_VERTEX_FLAG)?;
            out.text("\n")?;
        }
    }
    out.text("0\nSEQEND\n8\n0\n")
}

fn write_position(positions: &Positions, point: usize, out: &mut TextWriter<'_>) -> io::Result<()> {
    for (axis, code) in ["10\n", "20\n", "30\n"].into_iter().enumerate() {
        out.text(code)?;
        write_coordinate(positions, point, axis, out)?;
        out.text("\n")?;
    }
    Ok(())
}

fn write_coordinate(positions: &Positions, point: usize, axis: usize, out: &mut TextWriter<'_>) -> io::Result<()> {
    match positions {
        Positions::F32(points) => out.single(points[point][axis]),
        Positions::F64(points) => out.double(points[point][axis]),
    }
}
