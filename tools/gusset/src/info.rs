//! Measures of a mesh for the command `info`.

use crate::failure::Failure;
use crate::pieces::{Piece, attribute_names};
use crate::reading::{FileName, Reading};
use crate::report::number;
use crate::values::print_number;
use gusset_io::Mesh;
use serde_json::{Value, json};
use std::collections::HashMap;

/// Sums over the faces of a mesh.
struct Measures {
    min: [f64; 3],
    max: [f64; 3],
    area: f64,
    /// Signed volume; meaningful if the mesh is closed.
    volume: f64,
    /// Centre of the surface.
    area_centre: [f64; 3],
    boundary_edges: usize,
}

/// Measures a file. Returns the lines of the report and the JSON.
pub(crate) fn measure_file(file: &FileName, reading: &Reading) -> Result<(String, Value), Failure> {
    let piece = reading.mesh(file)?;
    let measures = Measures::new(&piece.mesh);
    Ok((lines(&piece, &measures), describe(file, &piece, &measures)))
}

impl Measures {
    fn new(mesh: &Mesh) -> Self {
        let mut made = Self {
            min: [f64::INFINITY; 3],
            max: [f64::NEG_INFINITY; 3],
            area: 0.0,
            volume: 0.0,
            area_centre: [0.0; 3],
            boundary_edges: boundary_edges(mesh),
        };
        for &vertex in &mesh.corners {
            for (axis, x) in mesh.positions.get(vertex as usize).into_iter().enumerate() {
                made.min[axis] = made.min[axis].min(x);
                made.max[axis] = made.max[axis].max(x);
            }
        }
        let origin: [f64; 3] = std::array::from_fn(|axis| 0.5 * (made.min[axis] + made.max[axis]));
        for face in 0..mesh.face_count() {
            made.add_face(mesh, face, origin);
        }
        for (axis, part) in made.area_centre.iter_mut().enumerate() {
            *part = origin[axis] + if made.area > 0.0 { *part / made.area } else { 0.0 };
        }
        made
    }

    /// Adds a polygon by its vector area, with volumes of pyramids over `origin`.
    fn add_face(&mut self, mesh: &Mesh, face: usize, origin: [f64; 3]) {
        let point = |vertex: u32| {
            let position = mesh.positions.get(vertex as usize);
            std::array::from_fn::<f64, 3, _>(|axis| position[axis] - origin[axis])
        };
        let vertices = mesh.face(face);
        let Some(&first) = vertices.first() else { return };
        let a = point(first);
        let mut vector = [0.0; 3];
        for pair in vertices[1..].windows(2) {
            let [b, c] = [point(pair[0]), point(pair[1])];
            let [u, v] = [sub(b, a), sub(c, a)];
            let normal = cross(u, v);
            vector = std::array::from_fn(|axis| vector[axis] + 0.5 * normal[axis]);
            self.volume += dot(a, normal) / 6.0;
        }
        let area = dot(vector, vector).sqrt();
        let count = vertices.len() as f64;
        for &vertex in vertices {
            for (sum, x) in self.area_centre.iter_mut().zip(point(vertex)) {
                *sum += area * x / count;
            }
        }
        self.area += area;
    }

    fn size(&self) -> [f64; 3] {
        std::array::from_fn(|axis| self.max[axis] - self.min[axis])
    }
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Counts edges that do not have one face on each side.
fn boundary_edges(mesh: &Mesh) -> usize {
    let mut balance: HashMap<(u32, u32), i32> = HashMap::new();
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        for (place, &vertex) in vertices.iter().enumerate() {
            let [from, to] = [vertex, vertices[(place + 1) % vertices.len()]].map(|vertex| mesh.representative(vertex));
            *balance.entry((from.min(to), from.max(to))).or_default() += if from < to { 1 } else { -1 };
        }
    }
    balance.values().map(|balance| balance.unsigned_abs() as usize).sum()
}

/// Units of length, with metres.
const UNITS: [(&str, f64); 5] =
    [("micrometre", 1e-6), ("millimetre", 1e-3), ("centimetre", 1e-2), ("inch", 0.0254), ("metre", 1.0)];

/// Returns the unit that the file states, or the likely one by the size of the mesh: parts of 10 or more are taken for millimetres, and
/// smaller ones for metres.
fn unit(piece: &Piece, measures: &Measures) -> (String, bool) {
    if let Some(metres) = piece.metres_per_unit {
        let named =
            UNITS.iter().find(|(_, size)| (size / metres - 1.0).abs() < 1e-9).map(|(name, _)| (*name).to_owned());
        return (named.unwrap_or_else(|| format!("{} m", print_number(metres))), true);
    }
    const MIN_MILLIMETRES: f64 = 10.0;
    let largest = measures.size().into_iter().fold(0.0, f64::max);
    (if largest >= MIN_MILLIMETRES { "millimetre" } else { "metre" }.to_owned(), false)
}

fn lines(piece: &Piece, measures: &Measures) -> String {
    let mesh = &piece.mesh;
    let short = |value: f64| print_number(format!("{value:.5e}").parse().unwrap_or(value));
    let vector = |values: [f64; 3]| values.map(short).join(" ");
    let (unit, is_stated) = unit(piece, measures);
    let mut text = format!("{} vertices, {} faces\n", mesh.positions.len(), mesh.face_count());
    text += &format!(
        "box      {} to {}\nsize     {}\n",
        vector(measures.min),
        vector(measures.max),
        vector(measures.size())
    );
    text += &format!("area     {}\n", short(measures.area));
    if measures.boundary_edges == 0 {
        text += &format!("volume   {}\n", short(measures.volume));
    } else {
        text += &format!("volume   none: {} edges lack a second face of opposite direction\n", measures.boundary_edges);
    }
    text += &format!("centre   {}\n", vector(measures.area_centre));
    text += &format!("unit     {unit}{}\n", if is_stated { ", as the file says" } else { " (a guess by the size)" });
    let names = attribute_names(mesh);
    if !names.is_empty() {
        text += &format!("carries  {}\n", names.join(", "));
    }
    text
}

fn describe(file: &FileName, piece: &Piece, measures: &Measures) -> Value {
    let mesh = &piece.mesh;
    let vector = |values: [f64; 3]| values.map(number);
    let (unit, is_stated) = unit(piece, measures);
    let is_closed = measures.boundary_edges == 0;
    json!({
        "file": file.shown(),
        "vertices": mesh.positions.len(),
        "faces": mesh.face_count(),
        "box": { "min": vector(measures.min), "max": vector(measures.max), "size": vector(measures.size()) },
        "area": number(measures.area),
        "volume": if is_closed { number(measures.volume) } else { Value::Null },
        "centre": vector(measures.area_centre),
        "closed": is_closed,
        "unit": unit,
        "unit_stated": is_stated,
        "attributes": attribute_names(mesh),
        "materials": piece.materials.len(),
    })
}
