//! File names in lines of material libraries.

use crate::error::ReadError;
use crate::text_encoding::owned_text;
use std::ops::Range;

/// Longest line that can name a file: systems limit names to 4096 bytes.
const MAX_LINE_BYTES: usize = 1 << 14;

/// Returns where the file name in a line is, behind its options: `an image.png` in `map_Kd -s 1 1 1 an image.png`.
pub(super) fn file_range(line: &str) -> Option<Range<usize>> {
    if line.len() > MAX_LINE_BYTES {
        return None;
    }
    let mut words = words(line).peekable();
    let keyword = &line[words.next()?];
    if !names_file(keyword) {
        return None;
    }
    let mut last = words.peek()?.clone();
    while let Some(option) = words.next_if(|word| line[word.clone()].starts_with('-')) {
        last = option.clone();
        let Some((least, most)) = argument_counts(&line[option]) else {
            // The last word is the name, whatever the arguments of an unknown option are.
            return words.last().map(|name| name.start..line.trim_end().len());
        };
        for place in 0..most {
            let is_argument = |word: &Range<usize>| place < least || line[word.clone()].parse::<f64>().is_ok();
            let Some(argument) = words.next_if(is_argument) else { break };
            last = argument;
        }
    }
    // A name that looks like an argument is still a name if nothing follows it.
    let start = words.next().unwrap_or(last).start;
    Some(start..line.trim_end().len())
}

fn names_file(keyword: &str) -> bool {
    let keyword = keyword.to_ascii_lowercase();
    keyword != "map_aat"
        && (keyword.starts_with("map_") || matches!(&*keyword, "bump" | "disp" | "decal" | "refl" | "norm"))
}

/// Returns the least and largest numbers of arguments of an option.
fn argument_counts(option: &str) -> Option<(usize, usize)> {
    Some(match option {
        "-blendu" | "-blendv" | "-bm" | "-boost" | "-cc" | "-clamp" | "-imfchan" | "-texres" | "-type" => (1, 1),
        "-mm" => (2, 2),
        "-o" | "-s" | "-t" => (1, 3),
        _ => return None,
    })
}

fn words(line: &str) -> impl Iterator<Item = Range<usize>> + '_ {
    let mut place = 0;
    std::iter::from_fn(move || {
        let start = place + line[place..].find(|c: char| !c.is_ascii_whitespace())?;
        let length = line[start..].find(|c: char| c.is_ascii_whitespace()).unwrap_or(line.len() - start);
        place = start + length;
        Some(start..place)
    })
}

/// Returns the line with the file that it names, if any, under another name.
pub(crate) fn with_renamed_file(line: &str, rename: impl FnOnce(&str) -> String) -> Result<String, ReadError> {
    Ok(match file_range(line) {
        Some(range) => {
            format!("{}{}{}", &line[..range.start], rename(&line[range.clone()]), &line[range.end..])
        }
        None => owned_text(line.as_bytes())?,
    })
}
