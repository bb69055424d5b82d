//! Outlines of SVG files.

use super::svg_numbers::{NumberReader, metres};
use super::svg_shapes::{Attributes, draw_shape};
use super::svg_transform::Transform;
use crate::document::Document;
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::foreign_files::refuse_foreign_file;
use crate::options::ReadOptions;
use crate::outline_pen::{OutlinePen, read_outlines};
use crate::scene::counted;
use crate::text_encoding::{decode_text, lossy_text, owned_text};
use gusset_base::alloc;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;
use std::collections::HashMap;

/// Most elements that repeat each other.
const MAX_USE_DEPTH: usize = 16;
/// Bytes that repeated elements may have, in sizes of the file.
const MAX_REPEATED_SIZES: u64 = 16;
/// Bytes that repeated elements may have in any file.
const MIN_REPEATED_BYTES: u64 = 1 << 20;

pub(crate) fn read_svg(bytes: &[u8], _: &ReadOptions) -> Result<Document, ReadError> {
    let decoded = decode_text(bytes)?;
    let text = lossy_text(&decoded)?;
    let names = if text.contains("use") { find_names(&text)? } else { HashMap::new() };
    let (findings, curves, mut notes) = read_outlines(text.len(), |pen| {
        let repeated_bytes = (text.len() as u64).saturating_mul(MAX_REPEATED_SIZES).max(MIN_REPEATED_BYTES);
        let mut reader = SvgReader {
            text: &text,
            names: &names,
            pen,
            view: [100.0; 2],
            repeated_bytes,
            repeated: Vec::new(),
            findings: Findings::default(),
        };
        reader.read_elements(0, Transform::UPWARDS, 0)?;
        Ok(reader.findings)
    })?;
    if !findings.has_root {
        let error = ReadError::malformed(Place::Line(1), "the file has no svg element");
        return Err(refuse_foreign_file(bytes).unwrap_or(error));
    }
    findings.add_notes(&mut notes);
    Ok(Document { curves, notes, metres_per_unit: findings.metres_per_unit, ..Document::default() })
}

/// Finds where the elements with names begin.
fn find_names(text: &str) -> Result<HashMap<String, usize>, ReadError> {
    let mut names = HashMap::new();
    let mut reader = lenient_reader(text);
    loop {
        let place = reader.buffer_position() as usize;
        match reader.read_event() {
            Ok(Event::Start(element) | Event::Empty(element)) => {
                if let Some((_, id)) = attribute_values(&element)?.into_iter().find(|(key, _)| *key == "id") {
                    names.try_reserve(1)?;
                    names.entry(owned_text(id.as_bytes())?).or_insert(place);
                    alloc::check_reserve()?;
                }
            }
            Ok(Event::Eof) | Err(_) => return Ok(names),
            Ok(_) => {}
        }
    }
}

fn lenient_reader(text: &str) -> Reader<&[u8]> {
    let mut reader = Reader::from_str(text);
    let config = reader.config_mut();
    config.check_end_names = false;
    config.allow_unmatched_ends = true;
    config.allow_dangling_amp = true;
    reader
}

/// Returns names and values. Entities in values beyond a length stay as they are.
fn attribute_values<'e>(element: &'e BytesStart<'_>) -> Result<Vec<(&'e str, Cow<'e, str>)>, ReadError> {
    const MAX_UNESCAPED_BYTES: usize = 1 << 15;
    let mut values = Vec::new();
    for attribute in element.attributes().with_checks(false).flatten() {
        let has_entities = attribute.value.len() <= MAX_UNESCAPED_BYTES && attribute.value.contains('&');
        let unescaped = has_entities.then(|| quick_xml::escape::unescape(&attribute.value).ok()).flatten();
        let unescaped = unescaped.map(|text| text.into_owned().into());
        alloc::push(&mut values, (attribute.key.local_name().into_inner(), unescaped.unwrap_or(attribute.value)))?;
        alloc::check_reserve()?;
    }
    Ok(values)
}

/// Content of the file beside outlines.
#[derive(Default)]
struct Findings {
    has_root: bool,
    metres_per_unit: Option<f64>,
    texts: usize,
    images: usize,
    wrong_shapes: usize,
    missing_names: usize,
}

impl Findings {
    fn add_notes(&self, notes: &mut Vec<Note>) {
        for (count, one, several, text) in [
            (self.texts, "text", "texts", "left out"),
            (self.images, "image", "images", "left out"),
            (self.wrong_shapes, "shape", "shapes", "with malformed numbers, read up to the mistake"),
            (self.missing_names, "use", "uses", "of elements that the file lacks or that hold the use, left out"),
        ] {
            if count > 0 {
                notes.push(Note::new(Place::Whole, format!("{} {text}", counted(count, one, several))));
            }
        }
    }
}

struct SvgReader<'a, 'b> {
    text: &'a str,
    names: &'a HashMap<String, usize>,
    pen: &'b mut OutlinePen,
    /// Width and height of the view that percentages refer to.
    view: [f64; 2],
    /// Bytes that repeated elements may still have.
    repeated_bytes: u64,
    /// Places of the elements that are being repeated, from the outermost on.
    repeated: Vec<usize>,
    findings: Findings,
}

impl SvgReader<'_, '_> {
    /// Reads elements from a place: all of the file, or one and its content if `use_depth` is not 0.
    fn read_elements(&mut self, place: usize, transform: Transform, use_depth: usize) -> Result<(), ReadError> {
        let mut reader = lenient_reader(&self.text[place..]);
        // Transforms of the open elements; none for those whose content is not drawn.
        let mut open: Vec<Option<Transform>> = Vec::new();
        while !self.pen.is_full() {
            let event = reader.read_event().map_err(|error| self.xml_error(place, &reader, &error))?;
            match event {
                Event::Start(element) => {
                    let outer = open.last().copied().unwrap_or(Some(transform));
                    let inner = self.read_element(&element, outer, use_depth, open.is_empty())?;
                    open.try_reserve(1)?;
                    open.push(inner);
                }
                Event::Empty(element) => {
                    let outer = open.last().copied().unwrap_or(Some(transform));
                    self.read_element(&element, outer, use_depth, open.is_empty())?;
                    if use_depth > 0 && open.is_empty() {
                        break;
                    }
                }
                Event::End(_) => {
                    open.pop();
                    if use_depth > 0 && open.is_empty() {
                        break;
                    }
                }
                Event::Eof => break,
                _ => {}
            }
            if use_depth > 0 && reader.buffer_position() > self.repeated_bytes {
                let message = "elements that repeat each other hold more than 16 times the file";
                return Err(ReadError::new(ReadErrorKind::TooLarge, message));
            }
        }
        if use_depth > 0 {
            self.repeated_bytes = self.repeated_bytes.saturating_sub(reader.buffer_position());
        }
        Ok(())
    }

    fn xml_error(&self, place: usize, reader: &Reader<&[u8]>, error: &quick_xml::Error) -> ReadError {
        let end = (place + reader.error_position() as usize).min(self.text.len());
        let line = 1 + self.text.as_bytes()[..end].iter().filter(|&&byte| byte == b'\n').count();
        ReadError::malformed(Place::Line(line as u64), format!("the XML is malformed: {error}"))
    }

    /// Draws an element. Returns the transform of its content, or `None` if the content is not drawn.
    fn read_element(
        &mut self,
        element: &BytesStart<'_>,
        outer: Option<Transform>,
        use_depth: usize,
        is_first: bool,
    ) -> Result<Option<Transform>, ReadError> {
        let Some(outer) = outer else { return Ok(None) };
        let name = element.local_name();
        let name: &str = name.as_ref();
        let attributes = Attributes::new(attribute_values(element)?, self.view);
        match name {
            "defs" | "clipPath" | "mask" | "pattern" | "marker" | "metadata" => return Ok(None),
            // Drawn where it is used.
            "symbol" if !(use_depth > 0 && is_first) => return Ok(None),
            _ if attributes.is_hidden() => return Ok(None),
            "text" => self.findings.texts += 1,
            "image" => self.findings.images += 1,
            _ => {}
        }
        let own = attributes.text("transform").map_or(Some(Transform::translation(0.0, 0.0)), Transform::from_list);
        let transform = outer.after(&own.unwrap_or(Transform::translation(0.0, 0.0)));
        self.findings.wrong_shapes += usize::from(own.is_none());
        if name == "svg" {
            return Ok(Some(self.enter_view(&attributes, transform)));
        }
        if name == "use" {
            self.repeat_element(&attributes, transform, use_depth)?;
        } else if let Some(is_wrong) = draw_shape(name, &attributes, &transform, self.pen)? {
            self.findings.wrong_shapes += usize::from(is_wrong);
        }
        Ok(Some(transform))
    }

    /// Returns the transform of an `svg` element's content. The outermost element tells the unit, and changes nothing.
    fn enter_view(&mut self, attributes: &Attributes<'_>, transform: Transform) -> Transform {
        let view_box = attributes.text("viewBox").and_then(|text| {
            let mut reader = NumberReader::new(text);
            Some([reader.number()?, reader.number()?, reader.number()?, reader.number()?])
        });
        let size = ["width", "height"].map(|name| attributes.length(name));
        if !self.findings.has_root {
            self.findings.has_root = true;
            self.view =
                view_box.map_or(size.map(|length| length.unwrap_or(100.0)), |[_, _, width, height]| [width, height]);
            self.findings.metres_per_unit = unit_of_view(attributes, self.view, view_box.is_some());
            return transform;
        }
        let [x, y] = ["x", "y"].map(|name| attributes.length(name).unwrap_or(0.0));
        let moved = transform.after(&Transform::translation(x, y));
        let Some([left, top, width, height]) = view_box else { return moved };
        let full = [size[0].unwrap_or(self.view[0]), size[1].unwrap_or(self.view[1])];
        let scale = (full[0] / width).min(full[1] / height);
        if !(scale > 0.0 && scale.is_finite()) {
            return moved;
        }
        let margin = [(full[0] - scale * width) / 2.0, (full[1] - scale * height) / 2.0];
        moved
            .after(&Transform::translation(margin[0], margin[1]))
            .after(&Transform::scaling(scale, scale))
            .after(&Transform::translation(-left, -top))
    }

    fn repeat_element(
        &mut self,
        attributes: &Attributes<'_>,
        transform: Transform,
        depth: usize,
    ) -> Result<(), ReadError> {
        let name = attributes.text("href").and_then(|name| name.trim().strip_prefix('#'));
        let is_allowed = |place: &&usize| depth < MAX_USE_DEPTH && !self.repeated.contains(place);
        let Some(&place) = name.and_then(|name| self.names.get(name)).filter(is_allowed) else {
            self.findings.missing_names += 1;
            return Ok(());
        };
        let [x, y] = ["x", "y"].map(|name| attributes.length(name).unwrap_or(0.0));
        self.repeated.push(place);
        self.read_elements(place, transform.after(&Transform::translation(x, y)), depth + 1)?;
        self.repeated.pop();
        Ok(())
    }
}

/// Returns the metres of a user unit if the width or the height has a unit of length.
fn unit_of_view(attributes: &Attributes<'_>, view: [f64; 2], has_view_box: bool) -> Option<f64> {
    let sizes = ["width", "height"].map(|name| attributes.text(name).and_then(metres));
    let units =
        [0, 1].map(|axis| sizes[axis].map(|size| size / view[axis]).filter(|unit| *unit > 0.0 && unit.is_finite()));
    if !has_view_box {
        return units[0].or(units[1]).map(|_| 1.0 / super::svg_numbers::UNITS_PER_METRE);
    }
    match units {
        [Some(x), Some(y)] => Some(x.min(y)),
        [x, y] => x.or(y),
    }
}
