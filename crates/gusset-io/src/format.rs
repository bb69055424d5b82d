//! The formats, by the extensions of file names.

/// Content of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Meshes.
    Meshes,
    /// Polylines.
    Curves,
    /// Points without faces.
    Points,
}

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ, with an MTL library.
    Obj,
    /// Polygon File Format.
    Ply,
    /// Stereolithography.
    Stl,
    /// Geomview's Object File Format, with COFF, NOFF, STOFF and others.
    Off,
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// 3D Manufacturing Format.
    ThreeMf,
    /// List of scans and their poses.
    ScanList,
    /// Coordinates separated by white space.
    Xyz,
    /// Coordinates separated by commas.
    Csv,
    /// Scalable Vector Graphics: outlines.
    Svg,
    /// Drawing Exchange Format: outlines and faces.
    Dxf,
}

impl Format {
    /// All formats with their extensions, the usual one first.
    pub const ALL: [(Self, &'static [&'static str]); 12] = [
        (Self::Obj, &["obj"]),
        (Self::Ply, &["ply"]),
        (Self::Stl, &["stl"]),
        (Self::Off, &["off", "coff", "noff", "cnoff", "ncoff", "stoff"]),
        (Self::Gltf, &["gltf"]),
        (Self::Glb, &["glb"]),
        (Self::ThreeMf, &["3mf"]),
        (Self::ScanList, &["conf"]),
        (Self::Xyz, &["xyz", "pts", "txt"]),
        (Self::Csv, &["csv"]),
        (Self::Svg, &["svg"]),
        (Self::Dxf, &["dxf"]),
    ];

    /// Returns the format of a file name by its extension, in capitals or not.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let extension = name.rsplit_once('.')?.1.to_ascii_lowercase();
        Self::from_extension(&extension)
    }

    /// Returns the format of an extension in small letters, without the dot.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, extensions)| extensions.contains(&extension)).map(|(format, _)| *format)
    }

    /// Returns the format of a file by its first bytes, `None` if they do not tell.
    #[must_use]
    pub fn from_content(bytes: &[u8]) -> Option<Self> {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        let starts =
            |word: &str| text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes()));
        let line = &text[..text.iter().position(|&byte| byte == b'\n').unwrap_or(text.len())];
        match () {
            () if bytes.starts_with(b"glTF") => Some(Self::Glb),
            () if bytes.starts_with(b"PK\x03\x04") => Some(Self::ThreeMf),
            () if starts("ply") => Some(Self::Ply),
            () if starts("{") => Some(Self::Gltf),
            () if starts("<") => Some(Self::Svg),
            () if line.trim_ascii_end().ends_with(b"OFF") => Some(Self::Off),
            () if is_binary_stl(bytes) || starts("solid") => Some(Self::Stl),
            () if ["v ", "vn ", "vt ", "o ", "g ", "mtllib "].into_iter().any(starts) => Some(Self::Obj),
            () if starts("bmesh") || starts("camera") => Some(Self::ScanList),
            () => None,
        }
    }

    /// Returns the usual extension without the dot.
    #[must_use]
    pub fn extension(self) -> &'static str {
        Self::ALL.iter().find(|(format, _)| *format == self).map_or("", |(_, extensions)| extensions[0])
    }

    /// Returns whether a file of this format can hold the content when it is written.
    #[must_use]
    pub fn holds(self, content: Content) -> bool {
        match content {
            Content::Meshes => !matches!(self, Self::ScanList | Self::Xyz | Self::Csv | Self::Svg | Self::Dxf),
            Content::Curves => {
                matches!(self, Self::Obj | Self::Gltf | Self::Glb | Self::Svg | Self::Dxf | Self::Xyz | Self::Csv)
            }
            Content::Points => {
                matches!(self, Self::Obj | Self::Ply | Self::Gltf | Self::Glb | Self::Xyz | Self::Csv)
            }
        }
    }
}

/// Returns whether the size is the one of a binary STL file with its count of facets.
fn is_binary_stl(bytes: &[u8]) -> bool {
    let count = bytes.get(80..84).map(|count| u64::from(u32::from_le_bytes([count[0], count[1], count[2], count[3]])));
    count.is_some_and(|count| 84 + 50 * count == bytes.len() as u64)
}
