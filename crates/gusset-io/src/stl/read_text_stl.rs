//! Text STL files.

use super::read_binary_stl::is_long_binary_stl;
use super::stl_parts::{FACETS_START, MeshAndNotes, mesh_from_parts, number_corners};
use crate::error::{Note, Place, ReadError, ReadErrorKind, quoted};
use crate::mesh::Positions;
use crate::options::ReadOptions;
use crate::scene::counted;
use crate::text::Scanner;
use crate::vertex_merging::VertexMerger;

/// Words that may be in the place of a normal.
const MAX_NORMAL_WORDS: usize = 4;
/// Words that may follow the name of a solid, or a facet.
const WORDS_IN_SOLID: [&str; 4] = ["facet", "endsolid", "solid", "color"];

/// Returns whether a file that is not an exact binary file begins as text does: with `solid`, and with words of STL after its line.
pub(super) fn is_text_stl(text: &[u8]) -> bool {
    let mut scanner = Scanner::new(text, None);
    skip_comments(&mut scanner, text);
    if !scanner.word().is_some_and(|word| is_word(word, "solid")) {
        return false;
    }
    let is_control = |byte: &u8| matches!(byte, 0..=8 | 14..=31 | 0xff);
    if !is_long_binary_stl(text) && !text.iter().take(FACETS_START).any(is_control) {
        return true;
    }
    // The header of a binary file may begin like this.
    let mut reader = TextReader::new(scanner, text);
    let (_, has_facet) = reader.read_name();
    has_facet || reader.scanner.word().is_some_and(|word| is_any_word(word, &WORDS_IN_SOLID))
}

/// Passes empty lines, and lines that begin with `#`, `//`, `;` or `!`. Returns whether there were comments.
fn skip_comments(scanner: &mut Scanner<'_>, text: &[u8]) -> bool {
    let mut is_found = false;
    loop {
        let line = &text[scanner.place()..];
        let start = line.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(line.len());
        let is_comment = [&b"#"[..], b"//", b";", b"!"].iter().any(|mark| line[start..].starts_with(mark));
        if !is_comment {
            return is_found;
        }
        is_found = true;
        // The first word of the comment is on its line.
        scanner.word();
        if !scanner.next_line() {
            return true;
        }
    }
}

fn is_word(word: &[u8], wanted: &str) -> bool {
    word.eq_ignore_ascii_case(wanted.as_bytes())
}

fn is_any_word(word: &[u8], wanted: &[&str]) -> bool {
    wanted.iter().any(|wanted| is_word(word, wanted))
}

pub(super) fn read_text_stl(text: &[u8], options: &ReadOptions) -> Result<MeshAndNotes, ReadError> {
    let mut reader = TextReader::new(Scanner::new(text, None), text);
    if skip_comments(&mut reader.scanner, text) {
        reader.notes.push(Note::new(Place::Line(1), "comments before \"solid\" are ignored"));
    }
    let name = reader.read_solids()?;
    let TextReader { positions, offsets, notes, .. } = reader;
    let (positions, corners) = if options.merge_repeated {
        let mut merger = VertexMerger::new(positions.len() / 6)?;
        let mut corners = Vec::new();
        corners.try_reserve_exact(positions.len())?;
        merger.extend(&positions, &mut corners)?;
        (merger.into_points(), corners)
    } else {
        let corners = number_corners(positions.len())?;
        (positions, corners)
    };
    let mut mesh = mesh_from_parts(Positions::F64(positions), corners, offsets);
    mesh.name = name;
    Ok((mesh, notes))
}

struct TextReader<'a> {
    scanner: Scanner<'a>,
    text: &'a [u8],
    positions: Vec<[f64; 3]>,
    offsets: Vec<u32>,
    /// Whether words follow `endloop` or `endfacet` on its line.
    has_trailing_words: bool,
    notes: Vec<Note>,
}

impl<'a> TextReader<'a> {
    fn new(scanner: Scanner<'a>, text: &'a [u8]) -> Self {
        let (positions, offsets, notes) = (Vec::new(), vec![0], Vec::new());
        Self { scanner, text, positions, offsets, has_trailing_words: false, notes }
    }

    /// Reads all solids. Returns the name of the only one.
    fn read_solids(&mut self) -> Result<String, ReadError> {
        let mut name = String::new();
        let (mut solids, mut is_open, mut polygons) = (0, false, 0);
        let mut word = self.scanner.word();
        while let Some(found) = word {
            word = None;
            if is_word(found, "solid") {
                let (solid_name, has_facet) = self.read_name();
                solids += 1;
                is_open = true;
                name = if solids == 1 { solid_name } else { String::new() };
                if has_facet {
                    word = Some(b"facet");
                }
            } else if is_word(found, "endsolid") {
                is_open = false;
                self.scanner.rest_of_line();
            } else if is_word(found, "facet") {
                polygons += usize::from(self.read_facet()? > 3);
                word = self.skip_trailing_words(&WORDS_IN_SOLID);
            } else if is_word(found, "color") {
                self.scanner.rest_of_line();
            } else {
                return Err(self.scanner.error(format!(
                    "facet {}: {} where \"facet\" or \"endsolid\" must be",
                    self.offsets.len() - 1,
                    quoted(found)
                )));
            }
            if word.is_none() {
                word = self.scanner.word();
            }
        }
        self.add_notes(solids, is_open, polygons);
        Ok(name)
    }

    fn add_notes(&mut self, solids: usize, is_open: bool, polygons: usize) {
        if solids > 1 {
            self.notes.push(Note::new(Place::Whole, format!("the {solids} solids of the file become one mesh")));
        }
        if self.has_trailing_words {
            self.notes.push(Note::new(Place::Whole, "words after \"endloop\" or \"endfacet\" are ignored"));
        }
        if is_open {
            self.notes.push(Note::new(Place::Line(self.scanner.line()), "the file ends without \"endsolid\""));
        }
        if polygons > 0 {
            let facets = counted(polygons, "facet has", "facets have");
            self.notes.push(Note::new(Place::Whole, format!("{facets} more than 3 corners")));
        }
    }

    /// Reads the name of a solid to the end of its line, or to `facet normal`. Returns whether `facet` was read.
    fn read_name(&mut self) -> (String, bool) {
        let start = self.scanner.place();
        let mut end = start;
        let mut has_facet = false;
        while let Some(word) = self.scanner.word_in_line() {
            let is_facet = is_word(word, "facet");
            if has_facet && is_word(word, "normal") {
                return (self.text_between(start, end), true);
            }
            if is_facet {
                end = self.scanner.place() - word.len();
            }
            has_facet = is_facet;
        }
        (self.text_between(start, self.scanner.place()), false)
    }

    fn text_between(&self, start: usize, end: usize) -> String {
        crate::error::printable_bytes(self.text[start..end].trim_ascii())
    }

    /// Reads a facet after its first word. Returns the number of its corners.
    fn read_facet(&mut self) -> Result<usize, ReadError> {
        let facet = self.offsets.len() - 1;
        for _ in 0..=MAX_NORMAL_WORDS {
            // The normal follows from the corners, and may be anything.
            let Some(word) = self.scanner.word() else { return Err(self.early_end(facet)) };
            if is_word(word, "outer") {
                return self.read_loop(facet);
            }
        }
        Err(self.scanner.error(format!("facet {facet}: \"outer loop\" does not follow the normal")))
    }

    fn read_loop(&mut self, facet: usize) -> Result<usize, ReadError> {
        self.expect(facet, "loop")?;
        let mut count = 0;
        loop {
            let Some(word) = self.scanner.word() else { return Err(self.early_end(facet)) };
            if is_word(word, "vertex") {
                let mut point = [0.0; 3];
                for coordinate in &mut point {
                    *coordinate = self.scanner.number(|| format!("facet {facet}, corner {count}"))?;
                }
                self.positions.try_reserve(1)?;
                self.positions.push(point);
                count += 1;
            } else if count >= 3 && is_word(word, "endloop") {
                break;
            } else {
                let wanted = if count < 3 { "vertex" } else { "endloop" };
                return Err(self.scanner.error(format!("facet {facet}: {} where \"{wanted}\" must be", quoted(word))));
            }
        }
        let word = self.skip_trailing_words(&["endfacet", "facet", "endsolid"]).or_else(|| self.scanner.word());
        self.check_word(facet, word, "endfacet")?;
        let end = u32::try_from(self.positions.len())
            .map_err(|_| ReadError::new(ReadErrorKind::TooLarge, "the file has more than 2^32 corners; split it"))?;
        self.offsets.try_reserve(1)?;
        self.offsets.push(end);
        Ok(count)
    }

    /// Skips the rest of the line up to one of the keywords, which it returns. Some programs repeat names at the end of facets.
    fn skip_trailing_words(&mut self, keywords: &[&str]) -> Option<&'a [u8]> {
        while let Some(word) = self.scanner.word_in_line() {
            if is_any_word(word, keywords) {
                return Some(word);
            }
            self.has_trailing_words = true;
        }
        None
    }

    fn expect(&mut self, facet: usize, wanted: &str) -> Result<(), ReadError> {
        let word = self.scanner.word();
        self.check_word(facet, word, wanted)
    }

    fn check_word(&self, facet: usize, word: Option<&[u8]>, wanted: &str) -> Result<(), ReadError> {
        match word {
            Some(word) if is_word(word, wanted) => Ok(()),
            Some(word) => {
                Err(self.scanner.error(format!("facet {facet}: {} where \"{wanted}\" must be", quoted(word))))
            }
            None => Err(self.early_end(facet)),
        }
    }

    fn early_end(&self, facet: usize) -> ReadError {
        self.scanner.error(format!("facet {facet}: the file ends"))
    }
}
