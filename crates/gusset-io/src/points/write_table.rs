//! Points and polylines as tables.

use crate::colour_steps::{are_colours_exact_as_bytes, has_transparency, nearest_step};
use crate::document::Document;
use crate::error::{Loss, WriteError, WriteErrorKind};
use crate::mesh::Positions;
use crate::options::WriteOptions;
use crate::resources::Target;
use crate::scene::are_points_of_curves;
use crate::text::TextWriter;

pub(crate) fn write_xyz(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    write_table(document, target, b' ')
}

pub(crate) fn write_csv(
    document: &Document,
    target: &mut Target<'_>,
    _: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    write_table(document, target, b',')
}

fn write_table(document: &Document, target: &mut Target<'_>, separator: u8) -> Result<Vec<Loss>, WriteError> {
    let files = if separator == b',' { "CSV" } else { "XYZ" };
    let has_curves = !document.curves.closed.is_empty();
    let has_points = !document.points.positions.is_empty();
    let has_meshes = document.meshes.iter().any(|mesh| !mesh.positions.is_empty());
    if has_meshes && !has_curves && !has_points {
        return Err(WriteError::new(
            WriteErrorKind::Unsupported,
            format!("{files} files hold points and curves, not meshes"),
        ));
    }
    let mut losses = Vec::new();
    if has_meshes {
        losses.push(Loss(format!("meshes, which {files} files do not hold")));
    }
    let are_points_of_curves = has_curves && are_points_of_curves(document);
    let mut table = Table { document, separator, columns: Columns::default(), out: TextWriter::new(target.main_file)? };
    if are_points_of_curves || !has_curves {
        table.columns = Columns::from_document(document, separator, &mut losses);
    } else if has_points {
        losses.push(Loss(format!("points beside curves, which {files} files do not hold")));
    }
    table.columns.has_groups = separator == b',' && document.curves.closed.len() > 1;
    table.write_header()?;
    if has_curves {
        table.write_curves(are_points_of_curves)?;
    } else {
        (0..document.points.positions.len())
            .try_for_each(|point| table.write_row(0, &document.points.positions, point))?;
    }
    table.out.finish()?;
    Ok(losses)
}

/// Columns beside coordinates.
#[derive(Default)]
struct Columns {
    has_groups: bool,
    has_normals: bool,
    has_colours: bool,
    has_opacity: bool,
    are_colours_bytes: bool,
}

impl Columns {
    fn from_document(document: &Document, separator: u8, losses: &mut Vec<Loss>) -> Self {
        let colours = &document.points.colours;
        let is_table = separator == b',';
        let is_transparent = has_transparency(colours);
        let are_exact = are_colours_exact_as_bytes(colours, is_table && is_transparent);
        if !is_table && is_transparent {
            losses.push(Loss("the opacity of points, which XYZ files do not hold".into()));
        }
        if !is_table && !are_exact && !colours.is_empty() {
            losses.push(Loss("shades of colours between 256 steps".into()));
        }
        Self {
            has_groups: false,
            has_normals: !document.points.normals.is_empty(),
            has_colours: !colours.is_empty(),
            has_opacity: is_table && is_transparent,
            are_colours_bytes: are_exact || !is_table,
        }
    }
}

struct Table<'a, 'b> {
    document: &'a Document,
    separator: u8,
    columns: Columns,
    out: TextWriter<'b>,
}

impl Table<'_, '_> {
    fn write_header(&mut self) -> std::io::Result<()> {
        if self.separator != b',' {
            return Ok(());
        }
        let columns = &self.columns;
        for (is_present, names) in [
            (columns.has_groups, "curve,"),
            (true, "x,y,z"),
            (columns.has_colours, ",red,green,blue"),
            (columns.has_opacity, ",alpha"),
            (columns.has_normals, ",nx,ny,nz"),
            (true, "\n"),
        ] {
            if is_present {
                self.out.text(names)?;
            }
        }
        Ok(())
    }

    /// Writes the curves. Takes their points with colours and normals from the document's points if they are the same.
    fn write_curves(&mut self, are_points_of_curves: bool) -> std::io::Result<()> {
        let document = self.document;
        let curves = &document.curves;
        let mut row = 0;
        for (curve, &is_closed) in curves.closed.iter().enumerate() {
            let (start, end) = (curves.offsets[curve] as usize, curves.offsets[curve + 1] as usize);
            if curve > 0 && self.separator != b',' {
                self.out.text("\n")?;
            }
            for point in (start..end).chain((is_closed && start < end).then_some(start)) {
                if are_points_of_curves {
                    self.write_row(curve, &document.points.positions, row)?;
                } else {
                    self.write_row(curve, &curves.positions, point)?;
                }
                row += 1;
            }
        }
        Ok(())
    }

    fn write_row(&mut self, group: usize, positions: &Positions, point: usize) -> std::io::Result<()> {
        if self.columns.has_groups {
            self.out.integer(group as u64)?;
            self.separate()?;
        }
        for axis in 0..3 {
            if axis > 0 {
                self.separate()?;
            }
            match positions {
                Positions::F32(points) => self.out.single(points[point][axis])?,
                Positions::F64(points) => self.out.double(points[point][axis])?,
            }
        }
        if self.columns.has_colours {
            let colour = self.document.points.colours[point];
            for &part in &colour[..if self.columns.has_opacity { 4 } else { 3 }] {
                self.separate()?;
                if self.columns.are_colours_bytes {
                    self.out.integer(u64::from(nearest_step(part)))?;
                } else {
                    self.out.single(part)?;
                }
            }
        }
        if self.columns.has_normals {
            for part in self.document.points.normals[point] {
                self.separate()?;
                self.out.attribute(part)?;
            }
        }
        self.out.text("\n")
    }

    fn separate(&mut self) -> std::io::Result<()> {
        self.out.bytes(&[self.separator])
    }
}
