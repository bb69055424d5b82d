//! Sections, blocks and entities of DXF files.

use super::dxf_curves::{PolylineVertex, draw_curve, draw_polyline};
use super::dxf_entity::{Entity, Frame};
use super::dxf_faces::FaceList;
use super::dxf_pairs::PairReader;
use super::dxf_units::metres_from_number;
use super::join_outlines::join_outlines;
use crate::document::{Document, PointCloud};
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::foreign_files::refuse_foreign_file;
use crate::mesh::Positions;
use crate::options::ReadOptions;
use crate::outline_pen::{OutlinePen, Vector, read_outlines};
use crate::scene::counted;
use crate::text::integer;
use crate::text_encoding::decode_text;
use gusset_base::alloc;
use std::collections::{BTreeMap, HashMap};

const BINARY_START: &[u8] = b"AutoCAD Binary DXF";
/// Most blocks that insert each other.
const MAX_BLOCK_DEPTH: usize = 16;
/// Bytes that inserted blocks may have, in sizes of the file.
const MAX_INSERTED_SIZES: u64 = 16;
/// Bytes that inserted blocks may have in any file.
const MIN_INSERTED_BYTES: u64 = 1 << 22;
/// Kinds of entities that notes name.
const MAX_NAMED_KINDS: usize = 12;
/// Entities that belong to others, or show nothing.
const SILENT_KINDS: [&[u8]; 5] = [b"SEQEND", b"VERTEX", b"ATTRIB", b"ATTDEF", b"VIEWPORT"];

pub(crate) fn read_dxf(bytes: &[u8], options: &ReadOptions) -> Result<Document, ReadError> {
    if bytes.starts_with(BINARY_START) {
        let message = "this is a binary DXF file; save it as text, for example by ODA File Converter or ezdxf";
        return Err(ReadError::unsupported(message));
    }
    let text = decode_text(bytes)?;
    let result = read_outlines(text.len(), |pen| {
        let mut reader = DxfReader::new(pen, text.len());
        reader.read_sections(&text)?;
        Ok(reader.findings)
    });
    let (findings, curves, mut notes) = result.map_err(|error| refuse_foreign_file(bytes).unwrap_or(error))?;
    if !findings.has_section {
        let error = ReadError::malformed(Place::Line(1), "the file has no section of DXF");
        return Err(refuse_foreign_file(bytes).unwrap_or(error));
    }
    findings.add_notes(&mut notes);
    let metres_per_unit = findings.metres_per_unit;
    let points = PointCloud { positions: Positions::F64(findings.points), ..PointCloud::default() };
    let document =
        findings.faces.into_mesh(options.merge_repeated)?.map_or_else(Document::default, Document::from_mesh);
    Ok(Document { curves: join_outlines(curves)?, points, metres_per_unit, notes, ..document })
}

/// Content of the file beside outlines.
struct Findings {
    has_section: bool,
    metres_per_unit: Option<f64>,
    points: Vec<Vector>,
    faces: FaceList,
    /// Numbers of entities that are left out, by their kinds.
    unread_kinds: BTreeMap<String, usize>,
    paper_space_entities: usize,
    missing_blocks: usize,
}

impl Findings {
    fn add_notes(&self, notes: &mut Vec<Note>) {
        for (kind, &count) in &self.unread_kinds {
            notes.push(Note::new(Place::Whole, format!("{count} {kind} left out")));
        }
        for (count, one, several, text) in [
            (self.paper_space_entities, "entity", "entities", "of the paper space left out"),
            (
                self.missing_blocks,
                "insertion",
                "insertions",
                "of blocks that the file lacks or that hold the insertion, left out",
            ),
            (self.faces.dropped_face_count, "face", "faces", "with fewer than 3 corners left out"),
            (self.faces.wrong_index_count, "face", "faces", "with vertices that do not exist, left out"),
        ] {
            if count > 0 {
                notes.push(Note::new(Place::Whole, format!("{} {text}", counted(count, one, several))));
            }
        }
    }
}

/// Where the entities of a block begin.
struct Block<'a> {
    first_entity_kind: &'a [u8],
    entities: PairReader<'a>,
    base_point: Vector,
}

struct DxfReader<'a, 'b> {
    pen: &'b mut OutlinePen,
    blocks: HashMap<Vec<u8>, Block<'a>>,
    /// Names of the blocks that are being inserted, from the outermost on.
    blocks_being_inserted: Vec<Vec<u8>>,
    /// Bytes that inserted blocks may still have.
    inserted_bytes: u64,
    point_limit: usize,
    findings: Findings,
}

impl<'a, 'b> DxfReader<'a, 'b> {
    fn new(pen: &'b mut OutlinePen, file_bytes: usize) -> Self {
        Self {
            pen,
            blocks: HashMap::new(),
            blocks_being_inserted: Vec::new(),
            inserted_bytes: (file_bytes as u64).saturating_mul(MAX_INSERTED_SIZES).max(MIN_INSERTED_BYTES),
            point_limit: file_bytes.max(MIN_INSERTED_BYTES as usize),
            findings: Findings {
                has_section: false,
                metres_per_unit: None,
                points: Vec::new(),
                faces: FaceList::new(),
                unread_kinds: BTreeMap::new(),
                paper_space_entities: 0,
                missing_blocks: 0,
            },
        }
    }

    fn read_sections(&mut self, text: &'a [u8]) -> Result<(), ReadError> {
        let mut reader = PairReader::new(text);
        while let Some(pair) = reader.next()? {
            if pair.code != 0 || pair.value != b"SECTION" {
                continue;
            }
            let Some(name) = reader.next()? else { break };
            self.findings.has_section = true;
            match name.value {
                b"HEADER" => self.read_header(&mut reader)?,
                b"BLOCKS" => self.find_blocks(&mut reader)?,
                b"ENTITIES" => {
                    let first = reader.next()?.map(|pair| pair.value);
                    self.read_entities(first, &mut reader, &Frame::IDENTITY)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn read_header(&mut self, reader: &mut PairReader<'a>) -> Result<(), ReadError> {
        let mut variable: &[u8] = &[];
        while let Some(pair) = reader.next()? {
            match (pair.code, variable) {
                (0, _) => break,
                (9, _) => variable = pair.value,
                (70, b"$INSUNITS") => {
                    self.findings.metres_per_unit = integer(pair.value).and_then(metres_from_number);
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn find_blocks(&mut self, reader: &mut PairReader<'a>) -> Result<(), ReadError> {
        let mut kind = reader.next()?.map(|pair| pair.value);
        let mut entity = Entity::default();
        while let Some(found) = kind.filter(|kind| *kind != b"ENDSEC") {
            kind = entity.read(found, reader)?;
            if found == b"BLOCK"
                && let (Some(name), Some(first)) = (entity.text_of_code(2), kind)
            {
                let block =
                    Block { first_entity_kind: first, entities: reader.clone(), base_point: entity.point_of_code(10) };
                self.blocks.try_reserve(1)?;
                self.blocks.insert(lower_case(name)?, block);
                alloc::check_reserve()?;
            }
        }
        Ok(())
    }

    /// Reads entities up to the end of the section or block.
    fn read_entities(
        &mut self,
        first: Option<&'a [u8]>,
        reader: &mut PairReader<'a>,
        frame: &Frame,
    ) -> Result<(), ReadError> {
        let mut kind = first;
        let mut entity = Entity::default();
        let start = reader.place();
        while let Some(found) = kind.filter(|kind| !matches!(*kind, b"ENDSEC" | b"ENDBLK" | b"EOF")) {
            if self.pen.is_full() {
                break;
            }
            let line = reader.line();
            kind = entity.read(found, reader)?;
            if entity.integer_of_code(67) == 1 {
                self.findings.paper_space_entities += 1;
            } else if found == b"POLYLINE" {
                kind = self.read_polyline(&entity, kind, reader, frame)?;
            } else {
                self.read_entity(&entity, frame, line)?;
            }
            if !self.blocks_being_inserted.is_empty() && (reader.place() - start) as u64 > self.inserted_bytes {
                return Err(too_large(Place::Line(line)));
            }
        }
        if !self.blocks_being_inserted.is_empty() {
            self.inserted_bytes = self.inserted_bytes.saturating_sub((reader.place() - start) as u64);
        }
        Ok(())
    }

    fn read_entity(&mut self, entity: &Entity<'a>, frame: &Frame, line: u64) -> Result<(), ReadError> {
        if self.findings.points.len() + self.findings.faces.point_count() > self.point_limit {
            return Err(too_large(Place::Line(line)));
        }
        match entity.kind {
            b"POINT" => {
                self.findings.points.try_reserve(1)?;
                self.findings.points.push(frame.map_point(entity.point_of_code(10)));
                Ok(())
            }
            b"3DFACE" => self.findings.faces.add_3dface(entity, frame),
            b"INSERT" => self.insert_block(entity, frame),
            kind => {
                if !draw_curve(entity, frame, self.pen)? && !SILENT_KINDS.contains(&kind) {
                    self.count_unread(kind);
                }
                Ok(())
            }
        }
    }

    fn count_unread(&mut self, kind: &[u8]) {
        let name = String::from_utf8_lossy(&kind[..kind.len().min(40)]).into_owned();
        let is_known = self.findings.unread_kinds.contains_key(&name);
        let name =
            if is_known || self.findings.unread_kinds.len() < MAX_NAMED_KINDS { name } else { "other entities".into() };
        *self.findings.unread_kinds.entry(name).or_insert(0) += 1;
    }

    /// Reads the vertices that follow a `POLYLINE`. Returns the kind of the entity after them.
    fn read_polyline(
        &mut self,
        polyline: &Entity<'a>,
        first: Option<&'a [u8]>,
        reader: &mut PairReader<'a>,
        frame: &Frame,
    ) -> Result<Option<&'a [u8]>, ReadError> {
        let flags = polyline.integer_of_code(70);
        let (is_closed, is_3d, is_grid, is_polyface) =
            (flags & 1 != 0, flags & 8 != 0, flags & 16 != 0, flags & 64 != 0);
        let has_own_frame = !(is_3d || is_grid || is_polyface);
        let frame = if has_own_frame { frame.compose_after(&polyline.object_frame()) } else { *frame };
        let elevation = if has_own_frame { polyline.number_of_code(30).unwrap_or(0.0) } else { 0.0 };
        let mut kind = first;
        let mut vertex = Entity::default();
        let mut vertices: Vec<PolylineVertex> = Vec::new();
        let mut points: Vec<Vector> = Vec::new();
        while kind == Some(b"VERTEX") {
            kind = vertex.read(b"VERTEX", reader)?;
            let vertex_flags = vertex.integer_of_code(70);
            if vertex_flags & 128 != 0 && vertex_flags & 64 == 0 {
                let numbers = [71, 72, 73, 74].map(|code| vertex.integer_of_code(code));
                self.findings.faces.add_polyface(&points, numbers)?;
                continue;
            }
            // Control points of a smoothed polyline are not on it.
            if vertex_flags & 16 != 0 && flags & 4 != 0 {
                continue;
            }
            let [x, y, z] = vertex.point_of_code(10);
            let z = if has_own_frame { elevation } else { z };
            if is_polyface || is_grid {
                points.try_reserve(1)?;
                points.push(frame.map_point([x, y, z]));
            } else {
                vertices.try_reserve(1)?;
                vertices.push(PolylineVertex { point: [x, y, z], bulge: vertex.number_of_code(42).unwrap_or(0.0) });
            }
        }
        if is_grid {
            let smooth = if polyline.integer_of_code(75) != 0 { [73, 74] } else { [71, 72] };
            let size = smooth.map(|code| usize::try_from(polyline.integer_of_code(code)).unwrap_or(0));
            self.findings.faces.add_grid(&points, size, [is_closed, flags & 32 != 0])?;
        } else if !is_polyface {
            draw_polyline(&vertices, is_closed, &frame, self.pen)?;
        }
        Ok(kind)
    }

    fn insert_block(&mut self, entity: &Entity<'a>, frame: &Frame) -> Result<(), ReadError> {
        let name = lower_case(entity.text_of_code(2).unwrap_or(&[]))?;
        let is_allowed =
            self.blocks_being_inserted.len() < MAX_BLOCK_DEPTH && !self.blocks_being_inserted.contains(&name);
        let Some(block) = self.blocks.get(&name).filter(|_| is_allowed) else {
            self.findings.missing_blocks += 1;
            return Ok(());
        };
        let (first, entities, base) = (block.first_entity_kind, block.entities.clone(), block.base_point);
        let scales = [41, 42, 43].map(|code| entity.number_of_code(code).unwrap_or(1.0));
        let turned = entity.object_frame().compose_after(&Frame::translation(entity.point_of_code(10)));
        let rotation = Frame::scaled_rotation([1.0; 3], entity.number_of_code(50).unwrap_or(0.0));
        let scaled = Frame::scaled_rotation(scales, 0.0).compose_after(&Frame::translation(base.map(|part| -part)));
        let [columns, rows] = [70, 71].map(|code| entity.integer_of_code(code).max(1));
        let [across, along] = [44, 45].map(|code| entity.number_of_code(code).unwrap_or(0.0));
        self.blocks_being_inserted.push(name);
        for row in 0..rows {
            for column in 0..columns {
                let shift = Frame::translation([column as f64 * across, row as f64 * along, 0.0]);
                let placed =
                    frame.compose_after(&turned).compose_after(&rotation).compose_after(&shift).compose_after(&scaled);
                self.read_entities(Some(first), &mut entities.clone(), &placed)?;
                // An empty block costs as much as a short entity.
                self.inserted_bytes = self.inserted_bytes.saturating_sub(16);
                if self.inserted_bytes == 0 || self.pen.is_full() {
                    return if self.pen.is_full() { Ok(()) } else { Err(too_large(Place::Whole)) };
                }
            }
        }
        self.blocks_being_inserted.pop();
        Ok(())
    }
}

fn lower_case(name: &[u8]) -> Result<Vec<u8>, ReadError> {
    Ok(alloc::collect(name.iter().map(u8::to_ascii_lowercase))?)
}

fn too_large(place: Place) -> ReadError {
    let error = ReadError::new(ReadErrorKind::TooLarge, "inserted blocks hold more than 16 times the file");
    ReadError { place, ..error }
}
