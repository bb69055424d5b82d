//! Materials of libraries.

use super::mtl_line::{file_range, with_renamed_file};
use crate::error::ReadError;
use crate::material::{Material, NativeMaterial};
use crate::text;
use crate::text_encoding::{lossy_text, owned_text};
use gusset_base::alloc;
use std::collections::HashMap;

/// A material library: its bytes and the folder from which it names files, with a slash at its end.
pub(super) struct Library {
    pub(super) bytes: Vec<u8>,
    pub(super) folder: String,
}

/// Lines of a material behind `newmtl`, and the folder of their library.
#[derive(Clone, Copy)]
pub(super) struct Definition<'a> {
    lines: &'a [u8],
    folder: &'a str,
}

/// Adds the materials of a library by their names. A later material replaces an earlier one.
pub(super) fn add_definitions<'a>(
    library: &'a Library,
    known: &mut HashMap<&'a [u8], Definition<'a>>,
) -> Result<(), ReadError> {
    let text = &library.bytes[..];
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let mut current: Option<(&[u8], usize)> = None;
    let mut place = 0;
    let mut close = |current: Option<(&'a [u8], usize)>, end: usize| {
        if let Some((name, start)) = current {
            known.try_reserve(1)?;
            known.insert(name, Definition { lines: &text[start..end], folder: &library.folder });
        }
        Ok::<(), ReadError>(())
    };
    for line in text.split_inclusive(|&byte| byte == b'\n') {
        let start = place;
        place += line.len();
        if let Some(name) = material_name(line.trim_ascii()) {
            close(current, start)?;
            current = Some((name, place));
        }
    }
    close(current, text.len())
}

fn material_name(line: &[u8]) -> Option<&[u8]> {
    let (keyword, name) = line.split_at_checked(6)?;
    let is_named = keyword.eq_ignore_ascii_case(b"newmtl") && name.first().is_none_or(u8::is_ascii_whitespace);
    is_named.then(|| name.trim_ascii())
}

/// Makes a material of its lines. Returns also the file of its diffuse image.
pub(super) fn material_from_lines(
    name: &[u8],
    definition: Definition<'_>,
) -> Result<(Material, Option<String>), ReadError> {
    let lines = || {
        let lines = definition.lines.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
        lines.filter(|line| !line.is_empty() && line[0] != b'#')
    };
    let mut material = Material { name: owned_text(name)?, ..Material::default() };
    let mut image = None;
    let mut opacity = None;
    let mut kept = alloc::with_capacity(lines().count())?;
    for line in lines() {
        let line = with_renamed_file(&lossy_text(line)?, |file| name_from(definition.folder, file))?;
        let mut words = line.split_ascii_whitespace();
        let keyword = words.next().unwrap_or_default().to_ascii_lowercase();
        let number = |word: Option<&str>| word.and_then(|word| text::number(word.as_bytes())).map(|value| value as f32);
        match &*keyword {
            "kd" => {
                let [red, green, blue] = [(); 3].map(|()| number(words.next()).unwrap_or(1.0));
                material.colour[..3].copy_from_slice(&[red, green, blue]);
            }
            "d" => opacity = number(words.next_back()).or(opacity),
            "tr" => material.colour[3] = 1.0 - number(words.next_back()).unwrap_or(0.0),
            "map_kd" => image = file_range(&line).map(|range| line[range].to_string()),
            _ => {}
        }
        kept.push(line);
        alloc::check_reserve()?;
    }
    material.colour[3] = opacity.unwrap_or(material.colour[3]);
    material.colour = material.colour.map(|part| if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) });
    material.native = Some(NativeMaterial::Mtl(kept));
    Ok((material, image))
}

/// Returns a file of a folder as it is named from the folder's parent, with the slashes of Unix.
fn name_from(folder: &str, file: &str) -> String {
    let file = file.replace('\\', "/");
    let has_drive = matches!(file.as_bytes(), [drive, b':', ..] if drive.is_ascii_alphabetic());
    if file.starts_with('/') || has_drive { file } else { format!("{folder}{file}") }
}
