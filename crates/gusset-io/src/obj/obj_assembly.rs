//! The content of a whole file, from chunks that threads read.

use super::obj_chunk::{
    ABSENT, Chunk, ChunkReadFailure, Element, Lists, MAX_CHUNK_BYTES, MAX_ELEMENTS, Names, OMISSION_COUNT, ObjectStart,
    Tally, decoded, push_object,
};
use super::obj_cursor::{Cursor, Keyword, is_blank};
use crate::error::{Place, ReadError, ReadErrorKind, quoted};
use gusset_base::alloc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Size of chunks of large files, and the number of threads that read them.
const CHUNK_BYTES: usize = 1 << 20;
const MAX_THREADS: usize = 4;

/// The content of a file. All indices are valid.
#[derive(Debug, Default)]
pub(super) struct Content<'a> {
    pub(super) positions: Vec<[f64; 3]>,
    /// Empty, or one for each vertex.
    pub(super) colours: Vec<[f32; 4]>,
    pub(super) normals: Vec<[f64; 3]>,
    pub(super) texcoords: Vec<[f64; 2]>,
    pub(super) face_offsets: Vec<u32>,
    pub(super) corners: Vec<u32>,
    /// Empty, or one for each corner: an index or `ABSENT`.
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
    /// Corners that name normals and texture coordinates that do not exist, and the first such face.
    pub(super) missing_normals: Tally,
    pub(super) missing_texcoords: Tally,
    pub(super) unknown: Option<&'a [u8]>,
    pub(super) has_known: bool,
}

/// Reads a whole file.
pub(super) fn read_content(bytes: &[u8]) -> Result<Content<'_>, ReadError> {
    read_content_in_chunks(bytes, CHUNK_BYTES)
}

/// Reads a whole file in chunks of about this size. The size does not change the result.
pub(super) fn read_content_in_chunks(bytes: &[u8], chunk_bytes: usize) -> Result<Content<'_>, ReadError> {
    let ranges = whole_lines(bytes, chunk_bytes)?;
    let chunks = parse_chunks(&ranges)?;
    let counts = Counts::sum(&chunks)?;
    let mut content = Content::with_capacity(&counts)?;
    let mut before = Counts::default();
    for chunk in chunks {
        let after = before.plus(&chunk);
        content.append(&chunk, &before, &counts, bytes)?;
        before = after;
    }
    if !content.colours.is_empty() {
        fill(&mut content.colours, counts.vertices, [1.0; 4])?;
    }
    for indices in [&mut content.corner_normals, &mut content.corner_texcoords] {
        if !indices.is_empty() {
            fill(indices, counts.corners, ABSENT)?;
        }
    }
    Ok(content)
}

fn fill<T: Copy>(values: &mut Vec<T>, count: usize, value: T) -> Result<(), ReadError> {
    values.try_reserve(count.saturating_sub(values.len()))?;
    values.resize(count, value);
    Ok(())
}

/// Splits text behind line ends that no backslash precedes.
fn whole_lines(bytes: &[u8], chunk_bytes: usize) -> Result<Vec<&[u8]>, ReadError> {
    let mut chunks = Vec::new();
    let mut rest = bytes;
    while !rest.is_empty() {
        let mut length = chunk_bytes.min(rest.len());
        while length < rest.len() && !is_line_start(rest, length) {
            length += 1;
        }
        if length > MAX_CHUNK_BYTES {
            return Err(ReadError::new(ReadErrorKind::TooLarge, "a line is longer than 256 MB"));
        }
        let (chunk, others) = rest.split_at(length);
        alloc::push(&mut chunks, chunk)?;
        rest = others;
    }
    Ok(chunks)
}

fn is_line_start(bytes: &[u8], place: usize) -> bool {
    let Some((b'\n', line)) = bytes[..place].split_last() else { return false };
    line.iter().rev().find(|&&byte| !is_blank(byte)) != Some(&b'\\')
}

/// Reads chunks, in several threads if the system gives them.
fn parse_chunks<'a>(ranges: &[&'a [u8]]) -> Result<Vec<Chunk<'a>>, ReadError> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut parsed = alloc::with_capacity(ranges.len())?;
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(range) = ranges.get(place) else { return Ok::<_, ReadError>(parsed) };
            parsed.push((place, Chunk::parse(range)));
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(MAX_THREADS).min(ranges.len());
    let mut parsed = std::thread::scope(|scope| {
        let others: Vec<_> =
            (1..threads).map_while(|_| std::thread::Builder::new().spawn_scoped(scope, work).ok()).collect();
        let own = work();
        let mut parsed = own?;
        for thread in others {
            parsed.extend(thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))?);
        }
        Ok::<_, ReadError>(parsed)
    })?;
    parsed.sort_unstable_by_key(|&(place, _)| place);
    let mut chunks: Vec<Chunk<'a>> = alloc::with_capacity(parsed.len())?;
    for (_, chunk) in parsed {
        match chunk {
            Ok(chunk) => chunks.push(chunk),
            Err(flaw) => return Err(error_behind(flaw, &chunks)),
        }
    }
    Ok(chunks)
}

/// Makes an error of a flaw in the chunk that follows these.
fn error_behind(flaw: ChunkReadFailure, chunks: &[Chunk<'_>]) -> ReadError {
    let ChunkReadFailure::Malformed { line, element, index, text } = flaw else { return ReadError::out_of_memory() };
    let count = |chunk: &Chunk<'_>| match element {
        Element::Vertex => chunk.positions.len(),
        Element::Normal => chunk.normals.len(),
        Element::Texcoord => chunk.texcoords.len(),
        Element::Face => chunk.face_ends.len(),
        Element::Polyline => chunk.polylines.list_ends.len(),
        Element::PointList => chunk.points.list_ends.len(),
    };
    let index = index + chunks.iter().map(count).sum::<usize>();
    let line = line + chunks.iter().map(|chunk| chunk.line_count).sum::<u64>() + 1;
    ReadError::malformed(Place::Line(line), format!("{} {index}: {text}", element.name()))
}

/// Numbers of elements.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    vertices: usize,
    normals: usize,
    texcoords: usize,
    faces: usize,
    corners: usize,
    lines: u64,
}

impl Counts {
    fn plus(self, chunk: &Chunk<'_>) -> Self {
        Self {
            vertices: self.vertices + chunk.positions.len(),
            normals: self.normals + chunk.normals.len(),
            texcoords: self.texcoords + chunk.texcoords.len(),
            faces: self.faces + chunk.face_ends.len(),
            corners: self.corners + chunk.corners.len(),
            lines: self.lines + chunk.line_count,
        }
    }

    fn sum(chunks: &[Chunk<'_>]) -> Result<Self, ReadError> {
        let all = chunks.iter().fold(Self::default(), Self::plus);
        let limits = [
            (all.vertices, MAX_ELEMENTS, "vertices"),
            (all.normals, MAX_ELEMENTS, "normals"),
            (all.texcoords, MAX_ELEMENTS, "texture coordinates"),
            (all.corners, u32::MAX as usize - 1, "corners of faces"),
        ];
        match limits.iter().find(|(count, limit, _)| count > limit) {
            Some((count, limit, name)) => Err(ReadError::new(
                ReadErrorKind::TooLarge,
                format!("the file has {count} {name}; the limit is {limit}"),
            )),
            None => Ok(all),
        }
    }
}

impl<'a> Content<'a> {
    fn with_capacity(counts: &Counts) -> Result<Self, ReadError> {
        let mut content = Self::default();
        content.positions.try_reserve_exact(counts.vertices)?;
        content.normals.try_reserve_exact(counts.normals)?;
        content.texcoords.try_reserve_exact(counts.texcoords)?;
        content.face_offsets.try_reserve_exact(counts.faces + 1)?;
        content.face_offsets.push(0);
        content.corners.try_reserve_exact(counts.corners)?;
        Ok(content)
    }

    fn append(&mut self, chunk: &Chunk<'a>, before: &Counts, all: &Counts, bytes: &'a [u8]) -> Result<(), ReadError> {
        let corner_start = self.corners.len() as u32;
        let face_start = before.faces as u32;
        self.append_corners(chunk, before, all, bytes)?;
        self.face_offsets.extend(chunk.face_ends.iter().map(|end| end + corner_start));
        self.positions.extend_from_slice(&chunk.positions);
        self.normals.extend_from_slice(&chunk.normals);
        self.texcoords.extend_from_slice(&chunk.texcoords);
        if !chunk.colours.is_empty() {
            fill(&mut self.colours, before.vertices, [1.0; 4])?;
            self.colours.try_reserve(chunk.colours.len())?;
            self.colours.extend_from_slice(&chunk.colours);
        }
        self.polylines.append(&chunk.polylines, Element::Polyline, before, all, bytes)?;
        self.points.append(&chunk.points, Element::PointList, before, all, bytes)?;
        self.materials.try_reserve(chunk.materials.len())?;
        self.materials.extend(chunk.materials.iter().map(|&(face, name)| (face + face_start, name)));
        self.libraries.extend_from_slice(&chunk.libraries);
        for start in &chunk.objects {
            let [vertex, face] = [start.vertex + before.vertices as u32, start.face + face_start];
            push_object(&mut self.objects, ObjectStart { vertex, face, ..*start })?;
        }
        self.groups.append(chunk.groups);
        for (tally, later) in self.omissions.iter_mut().zip(chunk.omissions) {
            tally.append(later, before.lines);
        }
        self.unknown = self.unknown.or(chunk.unknown);
        self.has_known |= chunk.has_known;
        Ok(())
    }

    fn append_corners(
        &mut self,
        chunk: &Chunk<'a>,
        before: &Counts,
        all: &Counts,
        bytes: &'a [u8],
    ) -> Result<(), ReadError> {
        for (corner, &index) in chunk.corners.iter().enumerate() {
            let Some(vertex) = decoded(index, before.vertices, all.vertices) else {
                let face = chunk.face_ends.partition_point(|&end| end as usize <= corner);
                let start = face.checked_sub(1).map_or(0, |last| chunk.face_ends[last] as usize);
                return Err(missing_vertex(bytes, Element::Face, before.faces + face, corner - start, all.vertices));
            };
            self.corners.push(vertex);
        }
        let attributes = [
            (&chunk.corner_normals, &mut self.corner_normals, &mut self.missing_normals, before.normals, all.normals),
            (
                &chunk.corner_texcoords,
                &mut self.corner_texcoords,
                &mut self.missing_texcoords,
                before.texcoords,
                all.texcoords,
            ),
        ];
        for (encoded, indices, missing, start, count) in attributes {
            if encoded.is_empty() {
                continue;
            }
            if indices.is_empty() {
                indices.try_reserve_exact(all.corners)?;
            }
            fill(indices, before.corners, ABSENT)?;
            let mut first = None;
            let missing_before = missing.count;
            for (corner, &index) in encoded.iter().enumerate() {
                let meant = if index == ABSENT { None } else { decoded(index, start, count) };
                if meant.is_none() && index != ABSENT {
                    missing.count += 1;
                    first.get_or_insert(corner);
                }
                indices.push(meant.unwrap_or(ABSENT));
            }
            if let Some(corner) = first
                && missing_before == 0
            {
                let face = before.faces + chunk.face_ends.partition_point(|&end| end as usize <= corner);
                missing.first_line = find_element(bytes, Element::Face, face, 0).0;
            }
        }
        Ok(())
    }
}

impl Lists {
    fn append(
        &mut self,
        chunk: &Self,
        element: Element,
        before: &Counts,
        all: &Counts,
        bytes: &[u8],
    ) -> Result<(), ReadError> {
        let (vertex_start, list_start) = (self.vertices.len(), self.list_ends.len());
        self.vertices.try_reserve(chunk.vertices.len())?;
        self.list_ends.try_reserve(chunk.list_ends.len())?;
        for (corner, &index) in chunk.vertices.iter().enumerate() {
            let Some(vertex) = decoded(index, before.vertices, all.vertices) else {
                let list = chunk.list_ends.partition_point(|&end| end as usize <= corner);
                let start = list.checked_sub(1).map_or(0, |last| chunk.list_ends[last] as usize);
                return Err(missing_vertex(bytes, element, list_start + list, corner - start, all.vertices));
            };
            self.vertices.push(vertex);
        }
        let start = u32::try_from(vertex_start).map_err(|_| ReadError::out_of_memory())?;
        for &end in &chunk.list_ends {
            self.list_ends.push(end.checked_add(start).ok_or_else(ReadError::out_of_memory)?);
        }
        Ok(())
    }
}

#[cold]
fn missing_vertex(bytes: &[u8], element: Element, index: usize, corner: usize, count: usize) -> ReadError {
    let (line, word) = find_element(bytes, element, index, corner);
    let vertex = word.split(|&byte| byte == b'/').next().unwrap_or_default();
    let shown = quoted(vertex);
    let shown = shown.trim_matches('"');
    let remedy = match vertex {
        [b'0', ..] => "vertices count from 1".to_string(),
        [b'-', ..] => "it counts back from this line".to_string(),
        _ => format!("the mesh has {count}"),
    };
    ReadError::malformed(
        Place::Line(line),
        format!("{} {index}, corner {corner}: vertex {shown} does not exist ({remedy})", element.name()),
    )
}

/// Returns the line of an element and the word of its corner, by reading the file again.
#[cold]
fn find_element(bytes: &[u8], element: Element, index: usize, corner: usize) -> (u64, &[u8]) {
    let (wanted, least) = match element {
        Element::Polyline => (Keyword::Polyline, 2),
        Element::PointList => (Keyword::Points, 0),
        _ => (Keyword::Face, 3),
    };
    let mut cursor = Cursor::new(bytes);
    let mut count = 0;
    while let Some(keyword) = cursor.read_keyword() {
        if keyword == wanted {
            let line = cursor.line + 1;
            let (mut words, mut found) = (0, &[][..]);
            while !cursor.is_at_end() {
                let word = cursor.read_word();
                if words == corner {
                    found = word;
                }
                words += 1;
            }
            if words >= least {
                if count == index {
                    return (line, found);
                }
                count += 1;
            }
        } else if matches!(keyword, Keyword::UseMaterial | Keyword::Library | Keyword::Object | Keyword::Group) {
            cursor.read_name();
        }
        cursor.next_statement();
    }
    (cursor.line, &[])
}
