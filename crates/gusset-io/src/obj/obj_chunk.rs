//! The content of a range of whole lines, whose indices are resolved once the lines before it are known.

use super::obj_cursor::{CornerIndices, Cursor, Keyword};
use crate::error::quoted;
use std::collections::TryReserveError;

/// The entry of a corner without a normal or texture coordinate.
pub(super) const ABSENT: u32 = u32::MAX;

/// The entry of the index 0, which names nothing because indices of OBJ start at 1.
const ZERO_INDEX: u32 = RELATIVE - 1;

/// Marks indices relative to the chunk's start, which follow as a distance from `-RELATIVE_BIAS`.
const RELATIVE: u32 = 1 << 31;

const RELATIVE_BIAS: i64 = 1 << 30;

/// Largest number of vertices, normals or texture coordinates of a file, and largest number of bytes of a chunk.
pub(super) const MAX_ELEMENTS: usize = (RELATIVE - 2) as usize;
pub(super) const MAX_CHUNK_BYTES: usize = 1 << 28;

/// Elements that messages name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Element {
    Vertex,
    Normal,
    Texcoord,
    Face,
    Polyline,
    PointList,
}

impl Element {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::Normal => "normal",
            Self::Texcoord => "texture coordinate",
            Self::Face => "face",
            Self::Polyline => "polyline",
            Self::PointList => "statement p",
        }
    }
}

/// Says why a chunk of the file was not read: memory ran out, or an element is malformed.
#[derive(Debug)]
pub(super) enum ChunkReadFailure {
    OutOfMemory,
    /// Line and element count from the chunk's start.
    Malformed {
        line: u64,
        element: Element,
        index: usize,
        text: String,
    },
}

impl From<TryReserveError> for ChunkReadFailure {
    fn from(_: TryReserveError) -> Self {
        Self::OutOfMemory
    }
}

/// Number of occurrences, and the line of the first.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    pub(super) count: u64,
    pub(super) first_line: u64,
}

impl Tally {
    pub(super) fn count_occurrence(&mut self, line: u64) {
        self.append(Self { count: 1, first_line: line }, 0);
    }

    /// Adds a tally whose lines count from `line_start`.
    pub(super) fn append(&mut self, later: Self, line_start: u64) {
        if self.count == 0 {
            self.first_line = later.first_line + line_start;
        }
        self.count += later.count;
    }
}

/// Content that the reader leaves out or changes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Omission {
    SmallFaces,
    ShortPolylines,
    FreeForms,
    Calls,
    Unknown,
    Weights,
}

pub(super) const OMISSION_COUNT: usize = Omission::Weights as usize + 1;

/// Start of an object: numbers of vertices and faces before its `o` statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ObjectStart<'a> {
    pub(super) vertex: u32,
    pub(super) face: u32,
    pub(super) name: &'a [u8],
}

/// Appends the start of an object. An object without vertices and faces before it is forgotten.
pub(super) fn push_object<'a>(
    objects: &mut Vec<ObjectStart<'a>>,
    start: ObjectStart<'a>,
) -> Result<(), TryReserveError> {
    match objects.last_mut() {
        Some(last) if (last.vertex, last.face) == (start.vertex, start.face) => *last = start,
        _ => push(objects, start)?,
    }
    Ok(())
}

/// One name, or the fact that there are several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Names<'a> {
    #[default]
    None,
    One(&'a [u8]),
    Several,
}

impl Names<'_> {
    pub(super) fn append(&mut self, later: Self) {
        *self = match (*self, later) {
            (old, Self::None) => old,
            (Self::None, new) => new,
            (old, new) if old == new => old,
            _ => Self::Several,
        };
    }
}

/// Indices of polylines or points, each list up to its end.
#[derive(Debug, Default)]
pub(super) struct Lists {
    pub(super) vertices: Vec<u32>,
    pub(super) list_ends: Vec<u32>,
}

/// The content of a range of lines.
#[derive(Debug, Default)]
pub(super) struct Chunk<'a> {
    pub(super) positions: Vec<[f64; 3]>,
    /// Colours of the first vertices; later vertices are white.
    pub(super) colours: Vec<[f32; 4]>,
    pub(super) normals: Vec<[f64; 3]>,
    pub(super) texcoords: Vec<[f64; 2]>,
    /// End of each face's corners.
    pub(super) face_ends: Vec<u32>,
    /// Encoded indices of corners; lists of normals and texture coordinates may end early.
    pub(super) corners: Vec<u32>,
    pub(super) corner_normals: Vec<u32>,
    pub(super) corner_texcoords: Vec<u32>,
    pub(super) polylines: Lists,
    pub(super) points: Lists,
    /// Number of faces before each `usemtl`, and its name.
    pub(super) materials: Vec<(u32, &'a [u8])>,
    pub(super) libraries: Vec<&'a [u8]>,
    pub(super) objects: Vec<ObjectStart<'a>>,
    pub(super) groups: Names<'a>,
    pub(super) omissions: [Tally; OMISSION_COUNT],
    pub(super) unknown: Option<&'a [u8]>,
    pub(super) has_known: bool,
    pub(super) line_count: u64,
}

/// Appends a value. Unlike `Vec::push` it returns an error if memory runs out.
#[inline]
fn push<T>(values: &mut Vec<T>, value: T) -> Result<(), TryReserveError> {
    if values.len() == values.capacity() {
        values.try_reserve(1)?;
    }
    values.push(value);
    Ok(())
}

/// Encodes an index of the file, before which the chunk has `count` elements.
#[inline]
fn encoded(index: i64, count: usize) -> u32 {
    if index > 0 {
        (index - 1).min(i64::from(ZERO_INDEX)) as u32
    } else if index == 0 {
        ZERO_INDEX
    } else {
        let distance = (count as i64 + index).max(-RELATIVE_BIAS) + RELATIVE_BIAS;
        RELATIVE | distance as u32
    }
}

/// Decodes an index. Returns `None` if the element does not exist. `start` counts the elements before the chunk, and `count` the elements
/// of the file.
#[inline]
pub(super) fn decoded(index: u32, start: usize, count: usize) -> Option<u32> {
    let meant = if index < RELATIVE {
        i64::from(index)
    } else {
        i64::from(index & (RELATIVE - 1)) - RELATIVE_BIAS + start as i64
    };
    (meant >= 0 && meant < count as i64).then_some(meant as u32)
}

impl<'a> Chunk<'a> {
    /// Reads all statements of whole lines.
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Self, ChunkReadFailure> {
        let mut chunk = Self::default();
        let mut cursor = Cursor::new(bytes);
        while let Some(keyword) = cursor.read_keyword() {
            match keyword {
                Keyword::Vertex => chunk.parse_vertex(&mut cursor)?,
                Keyword::Face => chunk.parse_face(&mut cursor)?,
                Keyword::Normal => {
                    let value = attribute(&mut cursor, Element::Normal, chunk.normals.len())?;
                    push(&mut chunk.normals, value)?;
                }
                Keyword::Texcoord => {
                    let value = attribute(&mut cursor, Element::Texcoord, chunk.texcoords.len())?;
                    push(&mut chunk.texcoords, value)?;
                }
                _ => {
                    chunk.parse_rare_statement(keyword, &mut cursor)?;
                    continue;
                }
            }
            chunk.has_known = true;
            cursor.next_statement();
        }
        chunk.line_count = cursor.line;
        Ok(chunk)
    }

    #[inline]
    fn parse_vertex(&mut self, cursor: &mut Cursor<'a>) -> Result<(), ChunkReadFailure> {
        let mut position = [0.0; 3];
        for (axis, coordinate) in position.iter_mut().enumerate() {
            let Some(number) = cursor.read_number() else {
                return Err(self.missing_coordinate(cursor, axis));
            };
            *coordinate = number;
        }
        push(&mut self.positions, position)?;
        if !cursor.is_at_end() {
            self.parse_vertex_extras(cursor)?;
        }
        Ok(())
    }

    #[cold]
    fn missing_coordinate(&self, cursor: &mut Cursor<'a>, axis: usize) -> ChunkReadFailure {
        let index = self.positions.len();
        if cursor.is_at_end() {
            let text = format!("it has {axis} coordinate{} instead of 3", if axis == 1 { "" } else { "s" });
            return ChunkReadFailure::Malformed { line: cursor.line, element: Element::Vertex, index, text };
        }
        not_a_number(cursor, Element::Vertex, index)
    }

    /// Reads a weight, or red, green, blue and perhaps opacity.
    fn parse_vertex_extras(&mut self, cursor: &mut Cursor<'a>) -> Result<(), ChunkReadFailure> {
        let index = self.positions.len() - 1;
        let mut numbers = [1.0; 4];
        let mut count = 0;
        while !cursor.is_at_end() {
            let number = cursor.read_number().ok_or_else(|| not_a_number(cursor, Element::Vertex, index))?;
            if let Some(place) = numbers.get_mut(count) {
                *place = number;
            }
            count += 1;
        }
        if count < 3 {
            if numbers[0] != 1.0 || count == 2 {
                self.omit(Omission::Weights, cursor.line);
            }
            return Ok(());
        }
        if self.colours.len() < index {
            self.colours.try_reserve(index + 1 - self.colours.len())?;
            self.colours.resize(index, [1.0; 4]);
        }
        push(&mut self.colours, numbers.map(|number| number as f32))?;
        Ok(())
    }

    #[inline]
    fn parse_face(&mut self, cursor: &mut Cursor<'a>) -> Result<(), ChunkReadFailure> {
        let start = self.corners.len();
        let line = cursor.line;
        while !cursor.is_at_end() {
            let Some(corner) = cursor.read_corner() else {
                return Err(not_an_index(cursor, Element::Face, self.face_ends.len(), self.corners.len() - start));
            };
            self.parse_corner(corner)?;
        }
        if self.corners.len() < start + 3 {
            self.omit(Omission::SmallFaces, line);
            self.corners.truncate(start);
            self.corner_texcoords.truncate(start);
            self.corner_normals.truncate(start);
            return Ok(());
        }
        push(&mut self.face_ends, self.corners.len() as u32)?;
        Ok(())
    }

    #[inline]
    fn parse_corner(&mut self, corner: CornerIndices) -> Result<(), TryReserveError> {
        let place = self.corners.len();
        push(&mut self.corners, encoded(corner.vertex, self.positions.len()))?;
        if let Some(index) = corner.texcoord {
            push_at(&mut self.corner_texcoords, place, encoded(index, self.texcoords.len()))?;
        }
        if let Some(index) = corner.normal {
            push_at(&mut self.corner_normals, place, encoded(index, self.normals.len()))?;
        }
        Ok(())
    }

    fn omit(&mut self, omission: Omission, line: u64) {
        self.omissions[omission as usize].count_occurrence(line);
    }

    /// Reads a statement that is neither a vertex, nor an attribute, nor a face, and passes its end.
    #[cold]
    fn parse_rare_statement(&mut self, keyword: Keyword, cursor: &mut Cursor<'a>) -> Result<(), ChunkReadFailure> {
        let line = cursor.line;
        match keyword {
            Keyword::Polyline => {
                let vertex_count = self.positions.len();
                self.polylines.append_statement(cursor, Element::Polyline, vertex_count)?;
                if self.polylines.drop_short_list(2) {
                    self.omit(Omission::ShortPolylines, line);
                }
            }
            Keyword::Points => {
                let vertex_count = self.positions.len();
                self.points.append_statement(cursor, Element::PointList, vertex_count)?;
            }
            Keyword::UseMaterial => push(&mut self.materials, (self.face_ends.len() as u32, cursor.read_name()))?,
            Keyword::Library => push(&mut self.libraries, cursor.read_name())?,
            Keyword::Object => {
                let [vertex, face] = [self.positions.len() as u32, self.face_ends.len() as u32];
                push_object(&mut self.objects, ObjectStart { vertex, face, name: cursor.read_name() })?;
            }
            Keyword::Group => self.groups.append(Names::One(cursor.read_name())),
            Keyword::FreeForm => self.omit(Omission::FreeForms, line),
            Keyword::Call => self.omit(Omission::Calls, line),
            Keyword::Unknown => {
                self.omit(Omission::Unknown, line);
                let word = cursor.read_word();
                self.unknown.get_or_insert(word);
            }
            _ => {}
        }
        self.has_known |= keyword != Keyword::Unknown;
        cursor.next_statement();
        Ok(())
    }
}

impl Lists {
    fn append_statement(
        &mut self,
        cursor: &mut Cursor<'_>,
        element: Element,
        count: usize,
    ) -> Result<(), ChunkReadFailure> {
        let start = self.list_ends.last().map_or(0, |&end| end as usize);
        while !cursor.is_at_end() {
            let Some(corner) = cursor.read_corner() else {
                return Err(not_an_index(cursor, element, self.list_ends.len(), self.vertices.len() - start));
            };
            push(&mut self.vertices, encoded(corner.vertex, count))?;
        }
        push(&mut self.list_ends, self.vertices.len() as u32)?;
        Ok(())
    }

    /// Drops the last list if it has fewer than `least` vertices.
    fn drop_short_list(&mut self, least: usize) -> bool {
        let start = self.list_ends.len().checked_sub(2).map_or(0, |place| self.list_ends[place] as usize);
        let is_short = self.vertices.len() < start + least;
        if is_short {
            self.vertices.truncate(start);
            self.list_ends.pop();
        }
        is_short
    }
}

/// Sets the value at a place behind the end, and fills the gap.
#[inline]
fn push_at(values: &mut Vec<u32>, place: usize, value: u32) -> Result<(), TryReserveError> {
    if values.len() < place {
        values.try_reserve(place + 1 - values.len())?;
        values.resize(place, ABSENT);
    }
    push(values, value)
}

/// Reads up to `N` numbers. Missing numbers are 0, and further ones are ignored.
#[inline]
fn attribute<const N: usize>(
    cursor: &mut Cursor<'_>,
    element: Element,
    index: usize,
) -> Result<[f64; N], ChunkReadFailure> {
    let mut value = [0.0; N];
    for part in &mut value {
        match cursor.read_number() {
            Some(number) => *part = number,
            None if cursor.is_at_end() => break,
            None => return Err(not_a_number(cursor, element, index)),
        }
    }
    Ok(value)
}

#[cold]
fn not_a_number(cursor: &mut Cursor<'_>, element: Element, index: usize) -> ChunkReadFailure {
    let line = cursor.line;
    ChunkReadFailure::Malformed {
        line,
        element,
        index,
        text: format!("{} is not a number", quoted(cursor.read_word())),
    }
}

#[cold]
fn not_an_index(cursor: &mut Cursor<'_>, element: Element, index: usize, corner: usize) -> ChunkReadFailure {
    let line = cursor.line;
    let text = format!("corner {corner}: {} is not an index", quoted(cursor.read_word()));
    ChunkReadFailure::Malformed { line, element, index, text }
}
