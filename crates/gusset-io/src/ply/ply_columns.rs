//! Which columns of a PLY file hold which attributes.

use super::ply_header::Element;
use crate::mesh::{Domain, Property};
use std::collections::BTreeMap;

/// Columns of a colour.
#[derive(Clone, Copy)]
pub(super) struct ColourColumns {
    pub(super) parts: [usize; 3],
    pub(super) opacity: Option<usize>,
}

impl ColourColumns {
    fn find(element: &Element<'_>) -> Option<Self> {
        let names = [["red", "green", "blue"], ["diffuse_red", "diffuse_green", "diffuse_blue"], ["r", "g", "b"]];
        let parts = element.find_group(&names)?;
        Some(Self { parts, opacity: element.find(&["alpha", "opacity", "diffuse_alpha", "a"], false) })
    }

    fn all(&self) -> impl Iterator<Item = usize> {
        self.parts.into_iter().chain(self.opacity)
    }
}

/// Columns of a vertex element.
pub(super) struct VertexColumns {
    pub(super) position: [usize; 3],
    pub(super) normal: Option<[usize; 3]>,
    pub(super) texcoord: Option<[usize; 2]>,
    pub(super) colour: Option<ColourColumns>,
    /// Columns that become properties.
    pub(super) rest: Vec<usize>,
}

impl VertexColumns {
    /// Returns `None` if x, y or z is missing.
    pub(super) fn find(element: &Element<'_>) -> Option<Self> {
        let position = element.find_group(&[["x", "y", "z"]])?;
        let normal = element.find_group(&[["nx", "ny", "nz"], ["normal_x", "normal_y", "normal_z"]]);
        let texcoord = element.find_group(&[["s", "t"], ["u", "v"], ["texture_u", "texture_v"]]);
        let colour = ColourColumns::find(element);
        let used = position.into_iter().chain(normal.into_iter().flatten()).chain(texcoord.into_iter().flatten());
        let rest = other_columns(element, used.chain(colour.iter().flat_map(ColourColumns::all)));
        Some(Self { position, normal, texcoord, colour, rest })
    }
}

/// Columns of a face element.
pub(super) struct FaceColumns {
    /// List of vertices.
    pub(super) vertices: usize,
    /// List of two texture coordinates for each corner.
    pub(super) texcoord: Option<usize>,
    /// Index of an image.
    pub(super) image: Option<usize>,
    pub(super) colour: Option<ColourColumns>,
    /// Columns that become properties.
    pub(super) rest: Vec<usize>,
}

impl FaceColumns {
    /// Returns `None` if no list can name vertices.
    pub(super) fn find(element: &Element<'_>) -> Option<Self> {
        let vertices = index_list(element)?;
        let texcoord = element.find(&["texcoord"], true);
        let image = element.find(&["texnumber"], false);
        let colour = ColourColumns::find(element);
        let used = [vertices].into_iter().chain(texcoord).chain(image);
        let rest = other_columns(element, used.chain(colour.iter().flat_map(ColourColumns::all)));
        Some(Self { vertices, texcoord, image, colour, rest })
    }
}

/// Returns the list of vertices: by its name, or the only list of integers.
pub(super) fn index_list(element: &Element<'_>) -> Option<usize> {
    element.find(&["vertex_indices", "vertex_index"], true).or_else(|| {
        let mut lists = (0..element.columns.len())
            .filter(|&column| element.columns[column].length.is_some() && element.columns[column].number.is_integer());
        let only = lists.next()?;
        lists.next().is_none().then_some(only)
    })
}

/// Returns the columns of single numbers that are not in `used`.
fn other_columns(element: &Element<'_>, used: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut is_free: Vec<bool> = element.columns.iter().map(|column| column.length.is_none()).collect();
    for column in used {
        is_free[column] = false;
    }
    (0..is_free.len()).filter(|&column| is_free[column]).collect()
}

/// Returns the names of the lists of an element except `used`, as `"a" and "b"`; empty if there are none.
pub(super) fn other_lists(element: &Element<'_>, used: &[usize]) -> String {
    const MAX_NAMES: usize = 8;
    let mut names: Vec<String> = Vec::new();
    for (index, column) in element.columns.iter().enumerate() {
        if column.length.is_some() && !used.contains(&index) {
            if names.len() == MAX_NAMES {
                names.push("others".into());
                break;
            }
            names.push(crate::error::quoted(column.name));
        }
    }
    match &names[..] {
        [] => String::new(),
        [name] => name.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Keeps the properties that all elements of one name have, in the order of the first element. Orders each element's columns alike.
/// Returns the properties without values, and the number of columns that were left out.
pub(super) fn share_properties(
    elements: &[&Element<'_>],
    columns: &mut [&mut Vec<usize>],
    domain: Domain,
) -> (Vec<Property>, usize) {
    let before: usize = columns.iter().map(|columns| columns.len()).sum();
    let Some((first, others)) = columns.split_first_mut() else { return (Vec::new(), 0) };
    for (element, other) in elements[1..].iter().zip(others.iter_mut()) {
        let by_name: BTreeMap<&[u8], usize> =
            other.iter().rev().map(|&column| (element.columns[column].name, column)).collect();
        first.retain(|&column| by_name.contains_key(elements[0].columns[column].name));
    }
    for (element, other) in elements[1..].iter().zip(others.iter_mut()) {
        let by_name: BTreeMap<&[u8], usize> =
            other.iter().rev().map(|&column| (element.columns[column].name, column)).collect();
        **other = first.iter().map(|&column| by_name[elements[0].columns[column].name]).collect();
    }
    let properties = first.iter().enumerate().map(|(index, &column)| {
        let kind = elements[0].columns[column].number.kind();
        let mut all = elements[1..].iter().zip(&*others).map(|(element, other)| element.columns[other[index]].number);
        Property {
            name: String::from_utf8_lossy(elements[0].columns[column].name).into_owned(),
            kind: if all.all(|number| number.kind() == kind) { kind } else { crate::NumberKind::F64 },
            domain,
            values: Vec::new(),
        }
    });
    let properties: Vec<Property> = properties.collect();
    (properties, before - elements.len() * first.len())
}
