//! Binary or text: the size, or what follows the first line, decides.

use super::read_binary_stl::{is_whole_binary_stl, read_binary_stl};
use super::read_text_stl::{is_text_stl, read_text_stl};
use crate::document::Document;
use crate::error::ReadError;
use crate::foreign_files::refuse_foreign_file;
use crate::options::ReadOptions;
use crate::text_encoding::decode_text;

pub(crate) fn read_stl(bytes: &[u8], options: &ReadOptions) -> Result<Document, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::new(crate::ReadErrorKind::Malformed, "the file is empty"));
    }
    let (mesh, notes) = if is_whole_binary_stl(bytes) {
        read_binary_stl(bytes, options)?
    } else {
        let text = decode_text(bytes)?;
        if is_text_stl(&text) {
            read_text_stl(&text, options)?
        } else if let Some(error) = refuse_foreign_file(bytes) {
            return Err(error);
        } else {
            read_binary_stl(bytes, options)?
        }
    };
    Ok(Document { notes, ..Document::from_mesh(mesh) })
}
