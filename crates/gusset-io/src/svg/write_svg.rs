//! Outlines as SVG files.

use crate::document::Document;
use crate::error::{Loss, WriteError};
use crate::mesh::Positions;
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::scene::list_lost_beside_curves;
use crate::text::TextWriter;

/// Width of lines relative to the larger side of the drawing.
const RELATIVE_LINE_WIDTH: f64 = 2e-3;

pub(crate) fn write_svg(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let mut losses = list_lost_beside_curves(document, "SVG")?;
    let curves = &document.curves;
    if curves.positions.iter().any(|point| point[2] != 0.0) {
        losses.push(Loss("z coordinates, which SVG files do not hold".into()));
    }
    let mut out = TextWriter::new(target.main_file)?;
    write_head(document, &mut out)?;
    for (curve, &is_closed) in curves.closed.iter().enumerate() {
        out.text(if is_closed { "<polygon points=\"" } else { "<polyline points=\"" })?;
        for point in curves.offsets[curve] as usize..curves.offsets[curve + 1] as usize {
            if point > curves.offsets[curve] as usize {
                out.text(" ")?;
            }
            write_point(&curves.positions, point, &mut out)?;
        }
        out.text("\"/>\n")?;
    }
    out.text("</g>\n</svg>\n")?;
    out.finish()?;
    Ok(losses)
}

fn write_head(document: &Document, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    let points = || document.curves.positions.iter().filter(|point| point.iter().all(|part| part.is_finite()));
    let low = [0, 1].map(|axis| points().fold(f64::INFINITY, |least, point| least.min(point[axis])));
    let high = [0, 1].map(|axis| points().fold(f64::NEG_INFINITY, |most, point| most.max(point[axis])));
    let (low, high) = if low[0] <= high[0] { (low, high) } else { ([0.0; 2], [1.0; 2]) };
    let line = RELATIVE_LINE_WIDTH * (high[0] - low[0]).max(high[1] - low[1]);
    let line = if line > 0.0 { line } else { 1.0 };
    let size = [0, 1].map(|axis| high[axis] - low[axis] + 2.0 * line);
    out.text("<svg xmlns=\"http://www.w3.org/2000/svg\"")?;
    if let Some(unit) = document.metres_per_unit {
        for (name, length) in [(" width=\"", size[0]), (" height=\"", size[1])] {
            out.text(name)?;
            out.double(length * unit * 1000.0)?;
            out.text("mm\"")?;
        }
    }
    out.text(" viewBox=\"")?;
    for (place, number) in [low[0] - line, -high[1] - line, size[0], size[1]].into_iter().enumerate() {
        if place > 0 {
            out.text(" ")?;
        }
        out.double(number)?;
    }
    out.text("\">\n<g fill=\"none\" stroke=\"black\" stroke-width=\"")?;
    out.double(line)?;
    out.text("\">\n")
}

/// Writes x and -y, because the y axis of SVG points down.
fn write_point(positions: &Positions, point: usize, out: &mut TextWriter<'_>) -> std::io::Result<()> {
    match positions {
        Positions::F32(points) => {
            let [x, y, _] = points[point];
            out.single(x)?;
            out.text(",")?;
            out.single(0.0 - y)
        }
        Positions::F64(points) => {
            let [x, y, _] = points[point];
            out.double(x)?;
            out.text(",")?;
            out.double(0.0 - y)
        }
    }
}
