//! The word with which OFF files begin.

/// Meaning of the letters before `OFF`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct OffHeader {
    pub(super) has_texcoords: bool,
    pub(super) has_colours: bool,
    pub(super) has_normals: bool,
    /// Normals are named before colours, as MeshLab does.
    pub(super) names_normals_first: bool,
    /// Positions have a fourth coordinate, by which the others are divided.
    pub(super) is_homogeneous: bool,
    /// The file tells the number of coordinates.
    pub(super) has_dimension: bool,
}

impl OffHeader {
    /// Returns the number of values of a vertex without position and colour.
    pub(super) fn plain_width(&self) -> usize {
        3 * usize::from(self.has_normals) + 2 * usize::from(self.has_texcoords)
    }
}

/// Reads the word. Returns also the digits that follow it without a blank, which are the count of vertices.
pub(super) fn parse_header(word: &[u8]) -> Option<(OffHeader, &[u8])> {
    let capitals = word.to_ascii_uppercase();
    let is_small = !word.iter().any(u8::is_ascii_uppercase);
    let known = if is_small { &capitals[..] } else { word };
    let end = known.windows(3).position(|letters| letters == b"OFF")?;
    let digits = &word[end + 3..];
    if !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let mut letters = &known[..end];
    let mut header = OffHeader::default();
    while let [letter, rest @ ..] = letters {
        letters = rest;
        match letter {
            b'S' if letters.first() == Some(&b'T') => {
                header.has_texcoords = true;
                letters = &letters[1..];
            }
            b'C' => header.has_colours = true,
            b'N' => {
                header.has_normals = true;
                header.names_normals_first = !header.has_colours;
            }
            b'4' => header.is_homogeneous = true,
            b'n' => header.has_dimension = true,
            _ => return None,
        }
    }
    Some((header, digits))
}
