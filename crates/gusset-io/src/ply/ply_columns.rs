//! Which columns of a PLY file hold which attributes.

use super::ply_header::Element;
use crate::error::ReadError;
use crate::mesh::{Domain, Property};
use crate::text_encoding::owned_text;
use gusset_base::alloc;
use std::collections::HashMap;

/// Columns of a colour.
#[derive(Clone, Copy)]
pub(super) struct ColourColumns {
    pub(super) colour_part_columns: [usize; 3],
    pub(super) opacity: Option<usize>,
}

impl ColourColumns {
    fn find(element: &Element<'_>) -> Option<Self> {
        let names = [["red", "green", "blue"], ["diffuse_red", "diffuse_green", "diffuse_blue"], ["r", "g", "b"]];
        let parts = element.find_group(&names)?;
        Some(Self {
            colour_part_columns: parts,
            opacity: element.find(&["alpha", "opacity", "diffuse_alpha", "a"], false),
        })
    }

    fn all(&self) -> impl Iterator<Item = usize> {
        self.colour_part_columns.into_iter().chain(self.opacity)
    }
}

/// Columns of a vertex element.
pub(super) struct VertexColumns {
    pub(super) position: [usize; 3],
    pub(super) normal: Option<[usize; 3]>,
    pub(super) texcoord: Option<[usize; 2]>,
    pub(super) colour: Option<ColourColumns>,
    /// Columns that become properties.
    pub(super) property_columns: Vec<usize>,
}

impl VertexColumns {
    /// Returns `None` if x, y or z is missing.
    pub(super) fn find(element: &Element<'_>) -> Result<Option<Self>, ReadError> {
        let Some(position) = element.find_group(&[["x", "y", "z"]]) else { return Ok(None) };
        let normal = element.find_group(&[["nx", "ny", "nz"], ["normal_x", "normal_y", "normal_z"]]);
        let texcoord = element.find_group(&[["s", "t"], ["u", "v"], ["texture_u", "texture_v"]]);
        let colour = ColourColumns::find(element);
        let used = position.into_iter().chain(normal.into_iter().flatten()).chain(texcoord.into_iter().flatten());
        let rest = other_columns(element, used.chain(colour.iter().flat_map(ColourColumns::all)))?;
        Ok(Some(Self { position, normal, texcoord, colour, property_columns: rest }))
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
    pub(super) property_columns: Vec<usize>,
}

impl FaceColumns {
    /// Returns `None` if no list can name vertices.
    pub(super) fn find(element: &Element<'_>) -> Result<Option<Self>, ReadError> {
        let Some(vertices) = index_list(element) else { return Ok(None) };
        let texcoord = element.find(&["texcoord"], true);
        let image = element.find(&["texnumber"], false);
        let colour = ColourColumns::find(element);
        let used = [vertices].into_iter().chain(texcoord).chain(image);
        let rest = other_columns(element, used.chain(colour.iter().flat_map(ColourColumns::all)))?;
        Ok(Some(Self { vertices, texcoord, image, colour, property_columns: rest }))
    }
}

/// Returns the list of vertices: by its name, or the only list of integers.
pub(super) fn index_list(element: &Element<'_>) -> Option<usize> {
    element.find(&["vertex_indices", "vertex_index"], true).or_else(|| {
        let mut lists = (0..element.columns.len()).filter(|&column| {
            element.columns[column].list_length_type.is_some() && element.columns[column].number_type.is_integer()
        });
        let only = lists.next()?;
        lists.next().is_none().then_some(only)
    })
}

/// Returns the columns of single numbers that are not in `used`.
fn other_columns(element: &Element<'_>, used: impl Iterator<Item = usize>) -> Result<Vec<usize>, ReadError> {
    let mut is_free = alloc::collect(element.columns.iter().map(|column| column.list_length_type.is_none()))?;
    for column in used {
        is_free[column] = false;
    }
    Ok(alloc::gather((0..is_free.len()).filter(|&column| is_free[column]))?)
}

/// Returns the names of the lists of an element except `used`, as `"a" and "b"`; empty if there are none.
pub(super) fn other_lists(element: &Element<'_>, used: &[usize]) -> String {
    const MAX_NAMES: usize = 8;
    let mut names: Vec<String> = Vec::new();
    for (index, column) in element.columns.iter().enumerate() {
        if column.list_length_type.is_some() && !used.contains(&index) {
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

/// Keeps the properties that all `elements`, sections of one name, have in common, in the order of the first one. Keeps only the first of
/// equal names. Orders each element's columns alike. Returns the properties without values, and the number of columns that were left out.
pub(super) fn keep_common_properties(
    elements: &[&Element<'_>],
    columns: &mut [&mut Vec<usize>],
    domain: Domain,
) -> Result<(Vec<Property>, usize), ReadError> {
    let before: usize = columns.iter().map(|columns| columns.len()).sum();
    let Some((first, others)) = columns.split_first_mut() else { return Ok((Vec::new(), 0)) };
    if !others.is_empty() {
        // A name that the first section has twice matches one column of another section.
        let by_name = columns_by_name(elements[0], first)?;
        first.retain(|&column| by_name[elements[0].columns[column].name] == column);
    }
    for (element, other) in elements[1..].iter().zip(others.iter_mut()) {
        let by_name = columns_by_name(element, other)?;
        first.retain(|&column| by_name.contains_key(elements[0].columns[column].name));
    }
    for (element, other) in elements[1..].iter().zip(others.iter_mut()) {
        let by_name = columns_by_name(element, other)?;
        **other = alloc::collect(first.iter().map(|&column| by_name[elements[0].columns[column].name]))?;
    }
    let properties = first.iter().enumerate().map(|(index, &column)| -> Result<Property, ReadError> {
        let kind = elements[0].columns[column].number_type.kind();
        let mut all =
            elements[1..].iter().zip(&*others).map(|(element, other)| element.columns[other[index]].number_type);
        Ok(Property {
            name: owned_text(elements[0].columns[column].name)?,
            kind: if all.all(|number| number.kind() == kind) { kind } else { crate::NumberKind::F64 },
            domain,
            values: Vec::new(),
        })
    });
    let properties = alloc::try_collect(properties)?;
    alloc::check_reserve()?;
    Ok((properties, before - elements.len() * first.len()))
}

/// Finds columns by their names; the first of equal names.
fn columns_by_name<'a>(element: &Element<'a>, columns: &[usize]) -> Result<HashMap<&'a [u8], usize>, ReadError> {
    let mut by_name = HashMap::new();
    by_name.try_reserve(columns.len())?;
    by_name.extend(columns.iter().rev().map(|&column| (element.columns[column].name, column)));
    Ok(by_name)
}
