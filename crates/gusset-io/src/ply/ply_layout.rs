//! Content and types of a written PLY file.

use crate::document::{Document, PointCloud};
use crate::error::{WriteError, printable};
use crate::material::{ImageData, Material, NO_MATERIAL};
use crate::mesh::{Domain, Mesh, Positions, Property, Values};
use crate::scene::has_shades_between_steps;
use gusset_base::alloc;
use std::borrow::Cow;

/// Vectors and whether single precision holds all of them.
pub(super) struct Vectors<'a, const N: usize> {
    pub(super) values: Cow<'a, [[f64; N]]>,
    pub(super) is_single: bool,
}

impl<'a, const N: usize> Vectors<'a, N> {
    fn new(values: Cow<'a, [[f64; N]]>) -> Self {
        let is_single = values.iter().flatten().all(|&x| is_single(x));
        Self { values, is_single }
    }
}

/// Colours and whether none of them is transparent.
pub(super) struct Colours<'a> {
    pub(super) values: &'a [[f32; 4]],
    pub(super) is_opaque: bool,
}

impl<'a> Colours<'a> {
    fn new(values: &'a [[f32; 4]]) -> Self {
        Self { values, is_opaque: values.iter().all(|colour| colour[3] == 1.0) }
    }

    /// Returns whether some colour is not one of 256 steps.
    pub(super) fn is_rounded(&self) -> bool {
        has_shades_between_steps(self.values)
    }
}

fn is_single(x: f64) -> bool {
    x.is_nan() || f64::from(x as f32) == x
}

/// The vertices.
pub(super) struct VertexLayout<'a> {
    pub(super) positions: &'a Positions,
    pub(super) is_single: bool,
    pub(super) normals: Option<Vectors<'a, 3>>,
    pub(super) colours: Colours<'a>,
    pub(super) texcoords: Option<Vectors<'a, 2>>,
    pub(super) properties: Vec<&'a Property>,
}

impl<'a> VertexLayout<'a> {
    pub(super) fn from_points(points: &'a PointCloud) -> Self {
        let normals = (!points.normals.is_empty()).then(|| Vectors::new(Cow::Borrowed(&points.normals[..])));
        Self {
            positions: &points.positions,
            is_single: has_single_positions(&points.positions),
            normals,
            colours: Colours::new(&points.colours),
            texcoords: None,
            properties: Vec::new(),
        }
    }

    /// Returns whether vertices have positions and nothing else.
    pub(super) fn has_positions_only(&self) -> bool {
        self.normals.is_none()
            && self.colours.values.is_empty()
            && self.texcoords.is_none()
            && self.properties.is_empty()
    }

    pub(super) fn from_mesh(mesh: &'a Mesh) -> Result<Self, WriteError> {
        let count = mesh.positions.len();
        Ok(Self {
            positions: &mesh.positions,
            is_single: has_single_positions(&mesh.positions),
            normals: mesh.normals.at_vertices(&mesh.corners, count)?.map(Vectors::new),
            colours: Colours::new(&mesh.vertex_colours),
            texcoords: mesh.texcoords.at_vertices(&mesh.corners, count)?.map(Vectors::new),
            properties: properties_of_domain(mesh, Domain::Vertices)?,
        })
    }
}

fn has_single_positions(positions: &Positions) -> bool {
    match positions {
        Positions::F32(_) => true,
        Positions::F64(points) => points.iter().flatten().all(|&x| is_single(x)),
    }
}

fn properties_of_domain(mesh: &Mesh, domain: Domain) -> Result<Vec<&Property>, WriteError> {
    Ok(alloc::gather(mesh.properties.iter().filter(|property| property.domain == domain))?)
}

/// The faces.
pub(super) struct FaceLayout<'a> {
    pub(super) mesh: &'a Mesh,
    /// Whether all lists are short enough for a length of one byte.
    pub(super) has_short_lists: bool,
    pub(super) colours: Colours<'a>,
    /// Texture coordinates of corners that differ at some vertex.
    pub(super) texcoords: Option<Vectors<'a, 2>>,
    pub(super) properties: Vec<&'a Property>,
    pub(super) textures: Textures<'a>,
}

impl<'a> FaceLayout<'a> {
    /// Returns whether faces are short lists of corners and nothing else.
    pub(super) fn has_corners_only(&self) -> bool {
        self.has_short_lists
            && self.colours.values.is_empty()
            && self.texcoords.is_none()
            && !self.textures.has_numbers
            && self.properties.is_empty()
    }

    pub(super) fn new(mesh: &'a Mesh, vertices: &VertexLayout<'a>, document: &'a Document) -> Result<Self, WriteError> {
        let widest = (0..mesh.face_count()).map(|face| mesh.face_range(face).len()).max().unwrap_or(0);
        let texcoords = match &mesh.texcoords {
            Values::Corners(values) if vertices.texcoords.is_none() => Some(Vectors::new(Cow::Borrowed(&values[..]))),
            _ => None,
        };
        Ok(Self {
            mesh,
            has_short_lists: 2 * widest <= usize::from(u8::MAX),
            colours: Colours::new(&mesh.face_colours),
            texcoords,
            properties: properties_of_domain(mesh, Domain::Faces)?,
            textures: Textures::new(mesh, document)?,
        })
    }
}

/// Images of faces.
#[derive(Default)]
pub(super) struct Textures<'a> {
    /// Names of files.
    pub(super) names: Vec<&'a str>,
    /// Index of a name for each material, -1 without an image.
    pub(super) numbers: Vec<i32>,
    /// Whether some face does not have the first image.
    pub(super) has_numbers: bool,
    /// Whether some material has more than an image.
    pub(super) loses_materials: bool,
}

impl<'a> Textures<'a> {
    fn new(mesh: &Mesh, document: &'a Document) -> Result<Self, WriteError> {
        let mut textures = Self { numbers: alloc::filled(-1, document.materials.len())?, ..Self::default() };
        let mut is_used = alloc::filled(false, document.materials.len())?;
        for &material in mesh.face_materials.iter().filter(|&&material| material != NO_MATERIAL) {
            is_used[material as usize] = true;
        }
        let mut number_of_image = alloc::filled(-1, document.images.len())?;
        for (index, material) in document.materials.iter().enumerate().filter(|&(index, _)| is_used[index]) {
            let file = image_file(material, document).filter(|_| !mesh.texcoords.is_absent());
            let Some((image, name)) = file else {
                textures.loses_materials = true;
                continue;
            };
            if number_of_image[image] < 0 {
                number_of_image[image] = textures.names.len() as i32;
                alloc::push(&mut textures.names, name)?;
            }
            textures.numbers[index] = number_of_image[image];
            textures.loses_materials |= material.native.is_some() || material.colour != [1.0; 4];
        }
        textures.has_numbers =
            !textures.names.is_empty() && mesh.face_materials.iter().any(|&material| textures.number(material) != 0);
        Ok(textures)
    }

    /// Returns the index of the name of a material's image, -1 without an image.
    pub(super) fn number(&self, material: u32) -> i32 {
        self.numbers.get(material as usize).copied().unwrap_or(-1)
    }
}

/// Returns the image of a material and the name of its file, if a header can hold it.
fn image_file<'a>(material: &Material, document: &'a Document) -> Option<(usize, &'a str)> {
    let image = material.image? as usize;
    match &document.images.get(image)?.data {
        ImageData::File(name) if !name.is_empty() && printable(name) == *name && name.trim() == name => {
            Some((image, name))
        }
        _ => None,
    }
}

/// Longest name of a written property.
const MAX_NAME_CHARACTERS: usize = 1000;

/// Returns the name of a property without blanks and control characters.
pub(super) fn property_name(name: &str) -> String {
    let word: String = name
        .chars()
        .take(MAX_NAME_CHARACTERS)
        .map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c })
        .collect();
    if word.is_empty() { "property".into() } else { word }
}
