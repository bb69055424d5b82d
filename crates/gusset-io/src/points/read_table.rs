//! Tables of coordinates as points and polylines.

use super::table_columns::TableColumns;
use super::table_fields::FieldStyle;
use crate::colour_steps::scale_colours;
use crate::document::{Curves, Document, PointCloud};
use crate::error::{Note, Place, ReadError, quoted};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::Positions;
use crate::options::ReadOptions;
use crate::scene::counted;
use crate::text_encoding::decode_text;
use gusset_base::alloc;

/// Marks a row before which a polyline ends, beside one bit for each group column.
const BREAK_BIT: u8 = 1 << 7;

/// Most columns of a table without a header: a wider one holds something else, such as heights.
const MAX_UNNAMED_COLUMNS: usize = 16;

pub(crate) fn read_table(bytes: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    let text = decode_text(bytes)?;
    let mut reader = TableReader::default();
    for (index, line) in text.split(|&byte| byte == b'\n').enumerate() {
        reader.line = index as u64 + 1;
        reader.read_line(line.trim_ascii())?;
    }
    if let Some(layout) = &reader.layout
        && layout.columns.is_guessed
        && layout.field_count > MAX_UNNAMED_COLUMNS
    {
        let message = format!("{} columns without names; name x, y and z in a first line", layout.field_count);
        return Err(ReadError::malformed(Place::Whole, message));
    }
    if reader.layout.is_none() && !text.iter().all(u8::is_ascii_whitespace) {
        return Err(refuse_foreign_file(bytes)
            .unwrap_or_else(|| ReadError::malformed(Place::Whole, "no line has at least 2 numbers and nothing else")));
    }
    reader.finish()
}

/// How rows are split and what their columns are.
struct TableLayout {
    style: FieldStyle,
    columns: TableColumns,
    /// Number of fields of the first row.
    field_count: usize,
}

#[derive(Default)]
struct TableReader<'a> {
    line: u64,
    header: &'a [u8],
    layout: Option<TableLayout>,
    fields: Vec<&'a [u8]>,
    groups: Vec<&'a [u8]>,
    points: Vec<[f64; 3]>,
    /// For each point: which group columns changed, and whether a polyline ended before it.
    point_marks: Vec<u8>,
    is_break: bool,
    colours: Vec<[f32; 4]>,
    normals: Vec<[f64; 3]>,
    incomplete_rows: usize,
    titles: usize,
    notes: Vec<Note>,
}

impl<'a> TableReader<'a> {
    fn read_line(&mut self, line: &'a [u8]) -> Result<(), ReadError> {
        if line.is_empty() || line.iter().all(|byte| b",;\t ".contains(byte)) || line[0] == b'>' {
            self.is_break = true;
            return Ok(());
        }
        let comment = [&b"#"[..], b"//", b"%", b"!"].into_iter().find(|mark| line.starts_with(mark));
        if let Some(mark) = comment {
            if self.layout.is_none() {
                self.header = line[mark.len()..].trim_ascii();
            }
            return Ok(());
        }
        let end = line.iter().position(|&byte| byte == b'#').unwrap_or(line.len());
        let line = line[..end].trim_ascii_end();
        if self.layout.is_none() {
            self.layout = self.find_layout(line)?;
        }
        let Some(layout) = self.layout.take() else {
            self.header = line;
            return Ok(());
        };
        layout.style.split(line, &mut self.fields)?;
        let result = self.read_row(line, &layout);
        self.layout = Some(layout);
        result
    }

    /// Returns the first layout in which a line is a row of numbers.
    fn find_layout(&self, line: &'a [u8]) -> Result<Option<TableLayout>, ReadError> {
        let (mut fields, mut names) = (Vec::new(), Vec::new());
        for style in FieldStyle::ALL {
            style.split(line, &mut fields)?;
            style.split(self.header, &mut names)?;
            let is_number = |field: &[u8]| style.number(field).is_some();
            let is_row = |column: usize| fields.get(column).is_none_or(|field| field.is_empty() || is_number(field));
            let count = fields.len();
            // A sentence of words is not a list of names.
            let has_names = if style.separator == b' ' { names.len() == count } else { names.len() >= count };
            if let Some(columns) = TableColumns::from_names(&names)?.filter(|_| has_names) {
                let mut places = columns.coordinates.iter().flatten();
                let has_number = places.clone().any(|&column| fields.get(column).is_some_and(|field| is_number(field)));
                if has_number && places.all(|&column| is_row(column)) {
                    return Ok(Some(TableLayout { style, columns, field_count: count }));
                }
            } else if count >= 2 && is_number(fields[0]) && is_number(fields[1]) && (2..count).all(is_row) {
                return Ok(Some(TableLayout { style, columns: TableColumns::from_count(count), field_count: count }));
            }
        }
        Ok(None)
    }

    fn read_row(&mut self, line: &'a [u8], layout: &TableLayout) -> Result<(), ReadError> {
        if self.is_title(line, layout) {
            self.is_break = true;
            self.titles += 1;
            return Ok(());
        }
        let mut point = [0.0; 3];
        for (axis, column) in layout.columns.coordinates.iter().enumerate() {
            let Some(column) = *column else { continue };
            match self.fields.get(column) {
                None if layout.style.separator == b' ' => {
                    let numbers = counted(self.fields.len(), "number", "numbers");
                    return Err(self.error(&format!("{numbers}; the first row has {}", layout.field_count)));
                }
                None | Some([]) => {
                    self.incomplete_rows += 1;
                    return Ok(());
                }
                Some(field) => {
                    point[axis] = layout.style.number(field).ok_or_else(|| {
                        self.error(&format!("column {}: {} is not a number", column + 1, quoted(field)))
                    })?;
                }
            }
        }
        if point.iter().zip(&layout.columns.coordinates).all(|(part, column)| part.is_nan() || column.is_none()) {
            self.is_break = true;
            return Ok(());
        }
        self.add_point(point, &layout.columns, layout.style)
    }

    /// Returns whether a line repeats the header, or is a title after a blank line.
    fn is_title(&self, line: &[u8], layout: &TableLayout) -> bool {
        let is_number = |field: &&[u8]| layout.style.number(field).is_some();
        line == self.header || (self.is_break && !self.points.is_empty() && !self.fields.iter().any(is_number))
    }

    fn error(&self, message: &str) -> ReadError {
        ReadError::malformed(Place::Line(self.line), format!("point {}: {message}", self.points.len()))
    }

    fn add_point(&mut self, point: [f64; 3], columns: &TableColumns, style: FieldStyle) -> Result<(), ReadError> {
        let mut mark = if self.is_break { BREAK_BIT } else { 0 };
        self.is_break = false;
        self.groups.resize(columns.groups.len(), &[]);
        for (place, &column) in columns.groups.iter().enumerate() {
            let value = self.fields.get(column).copied().unwrap_or(&[]);
            if value != self.groups[place] {
                self.groups[place] = value;
                mark |= 1 << place;
            }
        }
        self.points.try_reserve(1)?;
        self.points.push(point);
        self.point_marks.try_reserve(1)?;
        self.point_marks.push(mark);
        let number = |column: usize| self.fields.get(column).and_then(|field| style.number(field));
        if let Some(places) = columns.colours {
            let parts = places.map(|column| number(column).map_or(f32::NAN, |part| part as f32));
            let opacity = columns.opacity.and_then(number).map_or(f32::NAN, |part| part as f32);
            self.colours.try_reserve(1)?;
            self.colours.push([parts[0], parts[1], parts[2], opacity]);
        }
        if let Some(places) = columns.normals {
            self.normals.try_reserve(1)?;
            self.normals.push(places.map(|column| number(column).unwrap_or(f64::NAN)));
        }
        Ok(())
    }

    fn finish(mut self) -> Result<Document, ReadError> {
        if let Some(layout) = self.layout.take() {
            if layout.columns.is_guessed {
                self.judge_guesses(&layout)?;
            }
            self.note_unread_columns(&layout);
        }
        if self.incomplete_rows > 0 {
            let rows = counted(self.incomplete_rows, "row lacks", "rows lack");
            self.notes.push(Note::new(Place::Whole, format!("{rows} a coordinate, left out")));
        }
        if self.titles > 0 {
            let lines = counted(self.titles, "line of text begins", "lines of text begin");
            self.notes.push(Note::new(Place::Whole, format!("{lines} a polyline each")));
        }
        scale_colours(&mut self.colours);
        let curves = self.curves()?;
        let points =
            PointCloud { positions: Positions::F64(self.points), normals: self.normals, colours: self.colours };
        Ok(Document { points, curves, notes: self.notes, ..Document::default() })
    }

    fn note_unread_columns(&mut self, layout: &TableLayout) {
        let columns = &layout.columns;
        let colours = if self.colours.is_empty() { 0 } else { 3 + usize::from(columns.opacity.is_some()) };
        let normals = if self.normals.is_empty() { 0 } else { 3 };
        let read = columns.coordinates.iter().flatten().count() + columns.groups.len() + colours + normals;
        if layout.field_count > read {
            let unread = counted(layout.field_count - read, "column", "columns");
            self.notes
                .push(Note::new(Place::Whole, format!("{unread} beside coordinates, colours and normals left out")));
        }
    }

    /// Keeps columns without names as colours or normals only if all numbers fit.
    fn judge_guesses(&mut self, layout: &TableLayout) -> Result<(), ReadError> {
        let is_step = |part: f32| (0.0..=255.0).contains(&part) && part.fract() == 0.0;
        let are_colours = self.colours.iter().all(|colour| colour[..3].iter().all(|&part| is_step(part)))
            && self.colours.iter().flatten().any(|&part| part > 1.0);
        if !are_colours {
            if self.normals.is_empty() && layout.columns.colours == Some([3, 4, 5]) {
                let parts = |colour: &[f32; 4]| [0, 1, 2].map(|part| f64::from(colour[part]));
                self.normals = alloc::collect(self.colours.iter().map(parts))?;
            }
            self.colours = Vec::new();
        }
        let is_unit = |normal: &[f64; 3]| {
            let square = normal.iter().map(|part| part * part).sum::<f64>();
            square == 0.0 || (square - 1.0).abs() < 1e-2
        };
        if !self.normals.iter().all(is_unit) || self.normals.iter().flatten().all(|&part| part == 0.0) {
            self.normals = Vec::new();
        }
        Ok(())
    }

    /// Makes polylines of the points.
    fn curves(&self) -> Result<Curves, ReadError> {
        // A column that changes in each row numbers points.
        let groups = (0..BREAK_BIT.trailing_zeros())
            .map(|place| 1_u8 << place)
            .filter(|bit| self.point_marks.iter().skip(1).any(|mark| mark & bit == 0))
            .fold(0, |all, bit| all | bit);
        let blanks = if self.point_marks.iter().skip(1).any(|mark| mark & BREAK_BIT == 0) { BREAK_BIT } else { 0 };
        let count = u32::try_from(self.points.len()).map_err(|_| {
            ReadError::new(crate::ReadErrorKind::TooLarge, "the file has more than 2^32 - 1 points; split it")
        })?;
        let mut positions: Vec<[f64; 3]> = Vec::new();
        positions.try_reserve_exact(self.points.len())?;
        let mut curves = Curves::default();
        let mut start = 0;
        for end in 1..=count as usize {
            if end < count as usize && self.point_marks[end] & (groups | blanks) == 0 {
                continue;
            }
            let block = &self.points[start..end];
            let is_closed = block.len() > 3 && block[0] == block[block.len() - 1];
            positions.extend_from_slice(&block[..block.len() - usize::from(is_closed)]);
            curves.offsets.try_reserve(1)?;
            curves.offsets.push(positions.len() as u32);
            curves.closed.try_reserve(1)?;
            curves.closed.push(is_closed);
            start = end;
        }
        curves.positions = Positions::F64(positions);
        Ok(curves)
    }
}
