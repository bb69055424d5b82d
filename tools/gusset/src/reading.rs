//! Input files: names, folders and standard input.

use crate::failure::{Exit, Failure, counted};
use crate::pieces::{Piece, read_failure};
use gusset_io::{Content, Curves, Document, Format, NoResources, ReadOptions};
use std::ffi::OsString;
use std::io::Read;
use std::path::{Path, PathBuf};

/// An input, or an output, of a command.
#[derive(Clone, Debug)]
pub(crate) enum FileName {
    Path(PathBuf),
    /// `-`: standard input or output.
    Standard,
}

impl FileName {
    pub(crate) fn new(word: &OsString) -> Self {
        if word == "-" { Self::Standard } else { Self::Path(PathBuf::from(word)) }
    }

    /// Returns the name as messages show it, without control characters.
    pub(crate) fn shown(&self) -> String {
        match self {
            Self::Path(path) => gusset_io::printable(&path.to_string_lossy()),
            Self::Standard => "-".into(),
        }
    }
}

/// How files are read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reading {
    pub(crate) options: ReadOptions,
    /// Format of standard input; found from its first bytes if absent.
    pub(crate) from: Option<Format>,
}

impl Reading {
    fn document(&self, file: &FileName) -> Result<Document, Failure> {
        let shown = file.shown();
        match file {
            FileName::Path(path) => {
                gusset_io::read_file(path, &self.options).map_err(|error| read_failure(&shown, &error))
            }
            FileName::Standard => {
                let mut bytes = Vec::new();
                std::io::stdin()
                    .lock()
                    .read_to_end(&mut bytes)
                    .map_err(|error| Failure::file(format!("{shown}: {error}")))?;
                let format = self.from.or_else(|| Format::from_content(&bytes));
                let format = format.ok_or_else(|| {
                    Failure::file("-: the format is unknown; name it with --from, such as --from obj")
                })?;
                let mut document = gusset_io::read(&bytes, format, &NoResources, &self.options)
                    .map_err(|error| read_failure(&shown, &error))?;
                document.drop_image_files();
                Ok(document)
            }
        }
    }

    /// Reads a mesh. Writes the reader's notes to standard error.
    pub(crate) fn mesh(&self, file: &FileName) -> Result<Piece, Failure> {
        let shown = file.shown();
        let document = self.document(file)?;
        let only = [(document.curves.closed.len(), "polyline"), (document.points.positions.len(), "point")];
        let size =
            if let FileName::Path(path) = file { std::fs::metadata(path).map_or(0, |status| status.len()) } else { 0 };
        let piece = Piece::from_document(document, &shown, size)?;
        tell_notes(&shown, &piece.notes);
        if piece.mesh.face_count() == 0 {
            let rest = only
                .iter()
                .find(|(count, _)| *count > 0)
                .map(|(count, what)| format!(", only {}", counted(*count, what)))
                .unwrap_or_default();
            return Err(Failure::file(format!("{shown}: it has no faces{rest}")));
        }
        Ok(piece)
    }

    /// Reads meshes that stay apart: each scan of a list, or else one mesh. Writes the reader's notes to standard error.
    pub(crate) fn pieces(&self, file: &FileName) -> Result<Vec<Piece>, Failure> {
        let format = match file {
            FileName::Path(path) => Format::from_name(&path.to_string_lossy()),
            FileName::Standard => self.from,
        };
        if format != Some(Format::ScanList) {
            return Ok(vec![self.mesh(file)?]);
        }
        let shown = file.shown();
        let pieces = Piece::from_placements(self.document(file)?, &shown, u64::MAX)?;
        pieces.iter().for_each(|piece| tell_notes(&shown, &piece.notes));
        match pieces.iter().find(|piece| piece.mesh.face_count() == 0) {
            Some(piece) => Err(Failure::file(format!("{}: it has no faces", piece.path))),
            None => Ok(pieces),
        }
    }

    /// Reads curves. Writes the reader's notes to standard error.
    pub(crate) fn curves(&self, file: &FileName) -> Result<Curves, Failure> {
        let shown = file.shown();
        let document = self.document(file)?;
        let ignored = [(document.points.positions.len(), "point"), (face_count(&document), "face")];
        let mut notes: Vec<String> = document.notes.into_iter().map(|note| note.text).collect();
        if document.curves.closed.is_empty() {
            tell_notes(&shown, &notes);
            return Err(Failure::file(format!("{shown}: it has no polylines; the filter takes curves")));
        }
        let ignored = ignored.into_iter().filter(|&(count, _)| count > 0);
        notes.extend(
            ignored.map(|(count, what)| format!("{} ignored, because polylines are needed", counted(count, what))),
        );
        tell_notes(&shown, &notes);
        Ok(document.curves)
    }
}

fn tell_notes(path: &str, notes: &[String]) {
    for note in notes {
        crate::writing::tell!("gusset: {path}: note: {note}");
    }
}

/// Replaces each folder by the mesh files in it, in the order of their names.
pub(crate) fn expand_folders(words: &[OsString]) -> Result<Vec<FileName>, Failure> {
    let mut files = Vec::new();
    for word in words {
        let path = Path::new(word);
        if word == "-" || !path.is_dir() {
            files.push(FileName::new(word));
            continue;
        }
        let entries = std::fs::read_dir(path).map_err(|error| Failure::file(format!("{}: {error}", path.display())))?;
        let mut found: Vec<PathBuf> =
            entries.filter_map(Result::ok).map(|entry| entry.path()).filter(|path| is_mesh_file(path)).collect();
        found.sort();
        if found.is_empty() {
            return Err(Failure::new(Exit::File, format!("{}: the folder has no mesh files", path.display())));
        }
        files.extend(found.into_iter().map(FileName::Path));
    }
    Ok(files)
}

fn is_mesh_file(path: &Path) -> bool {
    let format = path.file_name().and_then(|name| Format::from_name(&name.to_string_lossy()));
    path.is_file() && format.is_some_and(|format| format.holds(Content::Meshes))
}

impl Reading {
    /// Reads a document with anything in it. Writes the reader's notes to standard error.
    pub(crate) fn convertible(&self, file: &FileName) -> Result<Document, Failure> {
        let document = self.document(file)?;
        let shown = file.shown();
        let notes: Vec<String> = document.notes.iter().map(|note| note.text.clone()).collect();
        tell_notes(&shown, &notes);
        let is_empty =
            face_count(&document) == 0 && document.curves.closed.is_empty() && document.points.positions.is_empty();
        if is_empty {
            Err(Failure::file(format!("{shown}: it has no faces, polylines or points")))
        } else {
            Ok(document)
        }
    }
}

fn face_count(document: &Document) -> usize {
    document.meshes.iter().map(gusset_io::Mesh::face_count).sum()
}

/// Returns what a document mainly is: meshes if it has faces, otherwise curves or points.
pub(crate) fn main_content(document: &Document) -> Content {
    if face_count(document) > 0 {
        Content::Meshes
    } else if document.curves.closed.is_empty() {
        Content::Points
    } else {
        Content::Curves
    }
}

/// Describes a document in JSON.
pub(crate) fn describe(path: &str, document: &Document) -> serde_json::Value {
    use crate::report::{describe_curves, describe_mesh};
    match main_content(document) {
        Content::Curves => describe_curves(path, &document.curves),
        Content::Points => {
            serde_json::json!({ "file": path, "kind": "points", "points": document.points.positions.len() })
        }
        Content::Meshes => {
            if let [mesh] = &document.meshes[..] {
                return describe_mesh(path, mesh);
            }
            let vertices: usize = document.meshes.iter().map(|mesh| mesh.positions.len()).sum();
            serde_json::json!({ "file": path, "kind": "mesh", "vertices": vertices, "faces": face_count(document), "meshes": document.meshes.len() })
        }
    }
}
