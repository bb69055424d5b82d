//! Brings the attributes of inputs over to an output: old elements keep them, new ones get them from their sources.

use crate::failure::{Exit, Failure};
use crate::pieces::{Piece, attribute_names};
use crate::plugin::{Channel, Domain, Origins, Rule};
use gusset_io::{Image, ImageData, Material, Mesh, NO_MATERIAL, NativeMaterial, Property, Values};
use std::collections::{HashMap, HashSet};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;

/// Brings attributes over to `result`, whose elements come from the pieces as `origins` tells. Returns what was lost.
pub(crate) fn carry(
    pieces: &[&Piece],
    origins: Option<&Origins<'_>>,
    result: &mut Piece,
) -> Result<Vec<String>, Failure> {
    let mut names: Vec<String> = Vec::new();
    for name in pieces.iter().flat_map(|piece| attribute_names(&piece.mesh)) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.is_empty() {
        return Ok(names);
    }
    if let Some(origins) = origins {
        let carrier = Carrier { pieces, origins, result, lost: Vec::new() };
        return carrier.run().ok_or_else(|| Failure::new(Exit::Plugin, "the plugin refused to carry attributes over"));
    }
    let first = pieces[0];
    if first.mesh.positions.len() == result.mesh.positions.len()
        && first.mesh.face_offsets == result.mesh.face_offsets
        && first.mesh.corners == result.mesh.corners
    {
        return Ok(keep_all(first, result));
    }
    Ok(names.into_iter().map(|name| format!("{name}: the filter does not tell the origins of its result")).collect())
}

const MOVED_NORMALS: &str = "normals, as vertices were moved";

/// Keeps everything of a piece with these vertices and faces, whose vertices may have moved.
fn keep_all(from: &Piece, result: &mut Piece) -> Vec<String> {
    let positions = std::mem::take(&mut result.mesh.positions);
    let is_moved = (0..positions.len()).any(|vertex| positions.get(vertex) != from.mesh.positions.get(vertex));
    let mut lost = Vec::new();
    let mut mesh = Mesh { positions, ..from.mesh.clone() };
    if is_moved && !mesh.normals.is_absent() {
        mesh.normals = Values::Absent;
        lost.push(MOVED_NORMALS.to_owned());
    }
    *result = Piece { path: std::mem::take(&mut result.path), mesh, ..from.clone() };
    lost
}

struct Carrier<'a, 'b> {
    pieces: &'a [&'a Piece],
    origins: &'a Origins<'b>,
    result: &'a mut Piece,
    lost: Vec<String>,
}

impl Carrier<'_, '_> {
    /// Returns what was lost; `None` if the plugin fails.
    fn run(mut self) -> Option<Vec<String>> {
        self.result.mesh.vertex_colours =
            self.carried_colours(|mesh| &mesh.vertex_colours, Domain::Vertices, "colours of vertices")?;
        self.result.mesh.face_colours =
            self.carried_colours(|mesh| &mesh.face_colours, Domain::Faces, "colours of faces")?;
        self.carry_texcoords()?;
        self.carry_normals()?;
        self.carry_materials()?;
        self.carry_properties()?;
        let mesh = &mut self.result.mesh;
        mesh.normals = std::mem::take(&mut mesh.normals).simplified(&mesh.corners, mesh.positions.len()).ok()?;
        mesh.texcoords = std::mem::take(&mut mesh.texcoords).simplified(&mesh.corners, mesh.positions.len()).ok()?;
        Some(self.lost)
    }

    /// Returns whether any piece has it. Notes the pieces that lack it, with what stands in, if anything does.
    fn is_present(&mut self, has: impl Fn(&Mesh) -> bool, what: &str, instead: Option<&str>) -> bool {
        let lacking: Vec<&str> =
            self.pieces.iter().filter(|piece| !has(&piece.mesh)).map(|piece| piece.path.as_str()).collect();
        if lacking.len() == self.pieces.len() {
            return false;
        }
        if let Some(instead) = instead {
            self.lost.extend(lacking.into_iter().map(|path| format!("no {what} in {path}: {instead}")));
        }
        true
    }

    /// Returns the values of the result's elements; missing where a source lacks them.
    fn carried<const N: usize>(&self, domain: Domain, rule: Rule, given: &[Vec<[f64; N]>]) -> Option<Vec<[f64; N]>> {
        let is_finite = |value: &[f64; N]| value.iter().all(|part| part.is_finite());
        let flat: Vec<Vec<f64>> = given
            .iter()
            .map(|values| values.iter().flat_map(|value| if is_finite(value) { *value } else { [0.0; N] }).collect())
            .collect();
        let values = self.origins.apply(Channel { domain, rule, width: N }, &flat)?;
        let (made, _) = values.as_chunks::<N>();
        let mut made = made.to_vec();
        if !given.iter().flatten().all(is_finite) {
            let present: Vec<Vec<f64>> = given
                .iter()
                .map(|values| values.iter().map(|value| f64::from(u8::from(is_finite(value)))).collect())
                .collect();
            let parts = self.origins.apply(Channel { domain, rule: Rule::Linear, width: 1 }, &present)?;
            // Weights sum to 1 up to rounding.
            const FULL_WEIGHT: f64 = 1.0 - 1e-9;
            for (value, part) in made.iter_mut().zip(parts) {
                if part < FULL_WEIGHT {
                    *value = Values::<N>::MISSING;
                }
            }
        }
        Some(made)
    }

    fn carried_colours(
        &mut self,
        colours_of: impl Fn(&Mesh) -> &Vec<[f32; 4]>,
        domain: Domain,
        what: &str,
    ) -> Option<Vec<[f32; 4]>> {
        if !self.is_present(|mesh| !colours_of(mesh).is_empty(), what, Some("white is taken")) {
            return Some(Vec::new());
        }
        let count = |mesh: &Mesh| if domain == Domain::Faces { mesh.face_count() } else { mesh.positions.len() };
        let given: Vec<Vec<[f64; 4]>> = self
            .pieces
            .iter()
            .map(|piece| {
                let colours = colours_of(&piece.mesh);
                if colours.is_empty() {
                    vec![[1.0; 4]; count(&piece.mesh)]
                } else {
                    colours.iter().map(|colour| colour.map(f64::from)).collect()
                }
            })
            .collect();
        let in_steps = self.pieces.iter().all(|piece| are_colours_exact_as_bytes(colours_of(&piece.mesh)));
        let values = self.carried(domain, Rule::Linear, &given)?;
        let sources = self.origins.sources(domain)?;
        let colour = |(element, value): (usize, [f64; 4])| {
            if value[0].is_nan() {
                return [1.0; 4];
            }
            // Colours in 256 steps stay so.
            let is_stepped = in_steps && sources.single(element).is_none();
            value.map(|part| if is_stepped { f32::from(step(part as f32)) / 255.0 } else { part as f32 })
        };
        Some(values.into_iter().enumerate().map(colour).collect())
    }

    /// Values at the corners of each piece, missing where it lacks them.
    fn at_corners<const N: usize>(&self, values_of: impl Fn(&Mesh) -> &Values<N>) -> Vec<Vec<[f64; N]>> {
        let of_piece = |piece: &&Piece| {
            let values = values_of(&piece.mesh);
            let corners = piece.mesh.corners.iter().enumerate();
            corners.map(|(corner, &vertex)| values.at_corner(corner, vertex).unwrap_or(Values::<N>::MISSING)).collect()
        };
        self.pieces.iter().map(of_piece).collect()
    }

    fn carry_texcoords(&mut self) -> Option<()> {
        if self.is_present(|mesh| !mesh.texcoords.is_absent(), "texture coordinates", Some("its faces have none")) {
            let given = self.at_corners(|mesh| &mesh.texcoords);
            self.result.mesh.texcoords = Values::Corners(self.carried(Domain::Corners, Rule::Texture, &given)?);
        }
        Some(())
    }

    fn carry_normals(&mut self) -> Option<()> {
        if !self.is_present(|mesh| !mesh.normals.is_absent(), "normals", None) {
            return Some(());
        }
        if self.are_vertices_moved()? {
            self.lost.push(MOVED_NORMALS.to_owned());
            return Some(());
        }
        let computed = vertex_normals(&self.result.mesh);
        // A reversed normal has no negative zeros.
        let or_computed = |normal: [f64; 3], vertex: usize| {
            if normal[0].is_nan() { computed[vertex] } else { normal.map(|part| part + 0.0) }
        };
        let smooth: Option<Vec<Vec<[f64; 3]>>> = self
            .pieces
            .iter()
            .map(|piece| if let Values::Vertices(normals) = &piece.mesh.normals { Some(normals.clone()) } else { None })
            .collect();
        self.result.mesh.normals = if let Some(given) = smooth {
            let normals = self.carried(Domain::Vertices, Rule::Normal, &given)?;
            Values::Vertices(
                normals.into_iter().enumerate().map(|(vertex, normal)| or_computed(normal, vertex)).collect(),
            )
        } else {
            let normals = self.carried(Domain::Corners, Rule::Normal, &self.at_corners(|mesh| &mesh.normals))?;
            let corners = normals.into_iter().zip(&self.result.mesh.corners);
            Values::Corners(corners.map(|(normal, &vertex)| or_computed(normal, vertex as usize)).collect())
        };
        Some(())
    }

    /// Returns whether an old vertex has another position.
    fn are_vertices_moved(&self) -> Option<bool> {
        let sources = self.origins.sources(Domain::Vertices)?;
        let positions = &self.result.mesh.positions;
        Some((0..positions.len()).any(|vertex| {
            sources
                .single(vertex)
                .is_some_and(|(input, source)| self.pieces[input].mesh.positions.get(source) != positions.get(vertex))
        }))
    }

    fn carry_materials(&mut self) -> Option<()> {
        if !self.is_present(|mesh| !mesh.face_materials.is_empty(), "materials", Some("its faces have none")) {
            return Some(());
        }
        // Numbers from 1 among all materials; 0 for none.
        let mut given: Vec<Vec<[f64; 1]>> = Vec::new();
        let (mut materials, mut images) = (Unique::new(), Unique::new());
        for piece in self.pieces {
            let numbers = append_materials(&mut materials, &mut images, piece);
            let mut of_piece: Vec<[f64; 1]> = piece
                .mesh
                .face_materials
                .iter()
                .map(|&material| {
                    [if material == NO_MATERIAL { 0.0 } else { f64::from(numbers[material as usize]) + 1.0 }]
                })
                .collect();
            of_piece.resize(piece.mesh.face_count(), [0.0]);
            given.push(of_piece);
        }
        make_names_unique(&mut materials.items);
        (self.result.materials, self.result.images) = (materials.items, images.items);
        let numbers = self.carried(Domain::Faces, Rule::Nearest, &given)?;
        self.result.mesh.face_materials =
            numbers.into_iter().map(|[number]| if number == 0.0 { NO_MATERIAL } else { number as u32 - 1 }).collect();
        Some(())
    }

    fn carry_properties(&mut self) -> Option<()> {
        for piece in self.pieces {
            for property in &piece.mesh.properties {
                if find_property(&self.result.mesh, property).is_none() {
                    self.carry_property(property)?;
                }
            }
        }
        Some(())
    }

    fn carry_property(&mut self, property: &Property) -> Option<()> {
        self.is_present(|mesh| find_property(mesh, property).is_some(), &property.name, Some("0 is taken"));
        let is_at_faces = property.domain == gusset_io::Domain::Faces;
        let given: Vec<Vec<[f64; 1]>> = self
            .pieces
            .iter()
            .map(|piece| {
                let count = if is_at_faces { piece.mesh.face_count() } else { piece.mesh.positions.len() };
                find_property(&piece.mesh, property)
                    .map_or_else(|| vec![[0.0]; count], |own| own.values.iter().map(|&value| [value]).collect())
            })
            .collect();
        let domain = if is_at_faces { Domain::Faces } else { Domain::Vertices };
        let rule = if property.kind.is_integer() { Rule::Nearest } else { Rule::Linear };
        let values = self.carried(domain, rule, &given)?;
        let sources = self.origins.sources(domain)?;
        // Old elements keep their values, finite or not.
        let value = |(element, [value]): (usize, [f64; 1])| {
            sources.single(element).map_or(value, |(input, source)| given[input][source][0])
        };
        let values = values.into_iter().enumerate().map(value).collect();
        self.result.mesh.properties.push(Property { values, ..property.clone() });
        Some(())
    }
}

fn find_property<'a>(mesh: &'a Mesh, like: &Property) -> Option<&'a Property> {
    mesh.properties.iter().find(|one| one.name == like.name && one.domain == like.domain && one.kind == like.kind)
}

/// Items without repeats, found by a hash.
struct Unique<T> {
    items: Vec<T>,
    by_hash: HashMap<u64, Vec<u32>>,
}

impl<T: PartialEq> Unique<T> {
    fn new() -> Self {
        Self { items: Vec::new(), by_hash: HashMap::new() }
    }

    /// Returns the index of an equal item, which is added if there is none.
    fn index(&mut self, item: T, hash: u64) -> u32 {
        let places = self.by_hash.entry(hash).or_default();
        if let Some(&place) = places.iter().find(|&&place| self.items[place as usize] == item) {
            return place;
        }
        let place = self.items.len() as u32;
        places.push(place);
        self.items.push(item);
        place
    }
}

/// Appends the images and materials of a piece. Equal ones become one. Returns the new indices of the piece's materials.
fn append_materials(materials: &mut Unique<Material>, images: &mut Unique<Image>, piece: &Piece) -> Vec<u32> {
    let numbers: Vec<u32> = piece.images.iter().map(|image| images.index(image.clone(), image_hash(image))).collect();
    let renumbered = |image: Option<u32>| image.and_then(|image| numbers.get(image as usize).copied());
    let appended = |material: &Material| {
        let mut material = material.clone();
        material.image = renumbered(material.image);
        if let Some(NativeMaterial::Gltf { textures, .. }) = &mut material.native {
            let moved = textures.iter().map(|(sampler, image)| (sampler.clone(), renumbered(*image)));
            *textures = Arc::new(moved.collect());
        }
        let hash = material_hash(&material);
        materials.index(material, hash)
    };
    piece.materials.iter().map(appended).collect()
}

/// Numbers materials that have the name of an earlier one: the second `name` becomes `name_2`.
fn make_names_unique(materials: &mut [Material]) {
    let mut taken: HashSet<String> = materials.iter().map(|material| material.name.clone()).collect();
    let mut counts: HashMap<String, u32> = HashMap::new();
    for material in materials.iter_mut().filter(|material| !material.name.is_empty()) {
        let count = counts.entry(material.name.clone()).or_insert(0);
        *count += 1;
        if *count == 1 {
            continue;
        }
        let mut name = format!("{}_{count}", material.name);
        while !taken.insert(name.clone()) {
            *count += 1;
            name = format!("{}_{count}", material.name);
        }
        material.name = name;
    }
}

fn image_hash(image: &Image) -> u64 {
    let mut hasher = DefaultHasher::new();
    image.name.hash(&mut hasher);
    match &image.data {
        ImageData::File(name) => name.hash(&mut hasher),
        ImageData::Bytes(bytes) => bytes.hash(&mut hasher),
    }
    hasher.finish()
}

fn material_hash(material: &Material) -> u64 {
    let mut hasher = DefaultHasher::new();
    (&material.name, material.colour.map(f32::to_bits), material.image).hash(&mut hasher);
    match &material.native {
        None => {}
        Some(NativeMaterial::Mtl(lines)) => lines.hash(&mut hasher),
        Some(NativeMaterial::Gltf { material, textures }) => (material, textures).hash(&mut hasher),
    }
    hasher.finish()
}

/// Returns a part of a colour as one of 256 steps; NaN gives 0.
fn step(part: f32) -> u8 {
    (255.0 * part.clamp(0.0, 1.0)).round() as u8
}

/// Returns whether bytes hold these colours exactly.
fn are_colours_exact_as_bytes(colours: &[[f32; 4]]) -> bool {
    // Six digits of a text suffice to find the step.
    const TOLERANCE: f32 = 1e-3;
    colours.iter().flatten().all(|&part| (255.0 * part - f32::from(step(part))).abs() <= TOLERANCE)
}

/// Means of the normals of the faces at each vertex, weighted by area.
fn vertex_normals(mesh: &Mesh) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 3]; mesh.positions.len()];
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        let Some(&first) = vertices.first() else { continue };
        let origin = mesh.positions.get(first as usize);
        let mut area = [0.0; 3];
        for pair in vertices[1..].windows(2) {
            let [p, q] = [pair[0], pair[1]].map(|vertex| mesh.positions.get(vertex as usize));
            for (axis, part) in area.iter_mut().enumerate() {
                let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
                *part += (p[a] - origin[a]) * (q[b] - origin[b]) - (p[b] - origin[b]) * (q[a] - origin[a]);
            }
        }
        for &vertex in vertices {
            for (sum, part) in sums[vertex as usize].iter_mut().zip(area) {
                *sum += part;
            }
        }
    }
    for sum in &mut sums {
        let length = sum.iter().map(|part| part * part).sum::<f64>().sqrt();
        *sum = sum.map(|part| if length > 0.0 { part / length } else { 0.0 });
    }
    sums
}
