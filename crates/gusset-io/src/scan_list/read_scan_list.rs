//! Reader of lists of scans.

use super::pose::{Pose, from_numbers};
use super::scans::{ReadScan, Scene};
use crate::document::Document;
use crate::error::{Place, ReadError, ReadErrorKind};
use crate::options::ReadOptions;
use crate::resources::Resources;
use crate::text::{Scanner, number};
use crate::text_encoding::owned_text;

/// Reads all scans of a list by `read_scan`.
pub(crate) fn read_scan_list(
    bytes: &[u8],
    resources: &dyn Resources,
    options: &ReadOptions,
    read_scan: ReadScan,
) -> Result<Document, ReadError> {
    let mut scanner = Scanner::new(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), Some(b'#'));
    let mut scene = Scene::new(resources, options, read_scan);
    loop {
        let line = scanner.rest_of_line();
        if let Some(rest) = line.strip_prefix(b"bmesh").filter(|rest| rest.first().is_none_or(u8::is_ascii_whitespace))
        {
            let place = Place::Line(scanner.line());
            let (name, pose) = name_and_pose(rest, place)?;
            scene.add(&name, &pose, place)?;
        }
        if !scanner.next_line() {
            break;
        }
    }
    if scene.is_empty() {
        let text = "the list names no scans: each line is \"bmesh FILE\", a translation and a quaternion";
        return Err(ReadError::new(ReadErrorKind::Malformed, text));
    }
    Ok(scene.document)
}

/// Splits a line behind its first word into the name of a file and the last seven words.
fn name_and_pose(line: &[u8], place: Place) -> Result<(String, Pose), ReadError> {
    let incomplete = || {
        let text = "\"bmesh\" needs a file, three numbers of a translation and four numbers of a quaternion";
        ReadError::malformed(place, text)
    };
    let mut rest = line.trim_ascii();
    let mut numbers = [0.0; 7];
    for value in numbers.iter_mut().rev() {
        let start = rest.iter().rposition(u8::is_ascii_whitespace).ok_or_else(incomplete)? + 1;
        *value = number(&rest[start..]).filter(|number| number.is_finite()).ok_or_else(incomplete)?;
        rest = rest[..start].trim_ascii_end();
    }
    let name = rest.strip_prefix(b"\"").and_then(|inner| inner.strip_suffix(b"\"")).unwrap_or(rest);
    if name.is_empty() {
        return Err(incomplete());
    }
    let pose = from_numbers(numbers).ok_or_else(|| ReadError::malformed(place, "the quaternion has length 0"))?;
    Ok((owned_text(name)?, pose))
}
