//! Meaning of the columns of a table.

use crate::error::ReadError;
use gusset_base::alloc;

/// Most columns that separate polylines.
const MAX_GROUP_COLUMNS: usize = 7;

/// Places of columns in a row.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct TableColumns {
    /// Columns of x, y and z. A missing coordinate is 0.
    pub(super) coordinates: [Option<usize>; 3],
    /// Columns whose new value begins a polyline.
    pub(super) groups: Vec<usize>,
    /// Columns of red, green and blue.
    pub(super) colours: Option<[usize; 3]>,
    /// Column of opacity.
    pub(super) opacity: Option<usize>,
    /// Columns of a normal.
    pub(super) normals: Option<[usize; 3]>,
    /// The numbers decide whether `colours` and `normals` are what their columns hold.
    pub(super) is_guessed: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Role {
    Coordinate(usize),
    Normal(usize),
    Colour(usize),
    Opacity,
    Other,
}

impl TableColumns {
    /// Takes roles from the names in a header. Returns `None` if it does not name two coordinates.
    pub(super) fn from_names(names: &[&[u8]]) -> Result<Option<Self>, ReadError> {
        let roles = alloc::collect(names.iter().map(|name| role_of_name(name)))?;
        let place = |role| roles.iter().position(|&found| found == role);
        let triple = |role: fn(usize) -> Role| Some([place(role(0))?, place(role(1))?, place(role(2))?]);
        let coordinates = [0, 1, 2].map(|axis| place(Role::Coordinate(axis)));
        let Some(first) = coordinates.iter().flatten().min() else { return Ok(None) };
        Ok((coordinates.iter().flatten().count() >= 2).then(|| Self {
            coordinates,
            groups: (0..*first).filter(|&column| roles[column] == Role::Other).take(MAX_GROUP_COLUMNS).collect(),
            colours: triple(Role::Colour),
            opacity: place(Role::Opacity),
            normals: triple(Role::Normal),
            is_guessed: false,
        }))
    }

    /// Guesses roles of columns without names.
    pub(super) fn from_count(count: usize) -> Self {
        // CloudCompare writes colours before normals, and PTS files have an intensity before colours.
        let first = if count == 7 { 4 } else { 3 };
        Self {
            coordinates: [Some(0), Some(1), (count > 2).then_some(2)],
            colours: (count >= first + 3).then_some([first, first + 1, first + 2]),
            normals: (count >= 9).then_some([6, 7, 8]),
            is_guessed: true,
            ..Self::default()
        }
    }
}

fn role_of_name(name: &[u8]) -> Role {
    let name = String::from_utf8_lossy(name).to_lowercase();
    let name = name.trim_start_matches("//").trim();
    match name {
        "red" | "r" | "diffuse_red" => return Role::Colour(0),
        "green" | "g" | "diffuse_green" => return Role::Colour(1),
        "blue" | "b" | "diffuse_blue" => return Role::Colour(2),
        "alpha" | "a" | "opacity" => return Role::Opacity,
        "nx" | "normal_x" | "normalx" => return Role::Normal(0),
        "ny" | "normal_y" | "normaly" => return Role::Normal(1),
        "nz" | "normal_z" | "normalz" => return Role::Normal(2),
        _ => {}
    }
    // A unit or another word may follow: `x_m`, `y (mm)`, `z half`.
    let first = name.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or("");
    match first {
        "x" | "lon" | "long" | "longitude" | "east" | "easting" => Role::Coordinate(0),
        "y" | "lat" | "latitude" | "north" | "northing" => Role::Coordinate(1),
        "z" | "alt" | "altitude" | "height" | "elevation" => Role::Coordinate(2),
        _ => Role::Other,
    }
}
