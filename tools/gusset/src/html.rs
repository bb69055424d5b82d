//! A page that shows a result in 3-D beside its inputs. It needs nothing but a browser.
//!
//! `examples/page` has the page and its script, which documents the form of the arrays: each as differences to the element before,
//! lowest bytes of all elements first.

use crate::failure::Failure;
use crate::pieces::Piece;
use base64::Engine;
use flate2::{Compression, GzBuilder};
use gusset_io::Mesh;
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;

const PAGE: &str = include_str!("../../../examples/page/page.html");
const STYLE: &str = include_str!("../../../examples/page/page.css");
const SCRIPTS: [&str; 3] = [
    include_str!("../../../examples/page/decode.js"),
    include_str!("../../../examples/page/view.js"),
    include_str!("../../../examples/page/page.js"),
];
const THREE: &str = include_str!("../../../examples/page/three/three.min.js");
const THREE_LICENCE: &str = include_str!("../../../examples/page/three/LICENSE.three");

/// Colours of inputs in turn, then the colour of new faces.
const INPUT_COLOURS: [&str; 4] = ["#dbcbad", "#96aaba", "#b7c4a1", "#c9a9a6"];
const NEW_COLOUR: &str = "#d99a1c";

/// A mesh of the page.
pub(crate) struct Body<'a> {
    pub(crate) mesh: &'a Mesh,
    /// For each face the input that it comes from; `None` for new faces.
    pub(crate) inputs: Vec<Option<u32>>,
}

/// Writes the page that compares inputs and result.
pub(crate) fn write_page(
    path: &Path,
    title: &str,
    text: &str,
    inputs: &[&Piece],
    result: &Body<'_>,
) -> Result<(), Failure> {
    let mut arrays = Arrays::default();
    let mut bodies: Vec<Value> = Vec::new();
    let before = joined(inputs);
    let inputs_of_faces =
        inputs.iter().zip(0..).flat_map(|(piece, input)| vec![Some(input); piece.mesh.face_count()]).collect();
    bodies.push(arrays.body(&Body { mesh: &before, inputs: inputs_of_faces }, inputs.len()));
    bodies.push(arrays.body(result, inputs.len()));
    let paint = |name: &str, colour: &str, is_new: bool| json!({ "name": name, "colour": colour, "metalness": if is_new { 0.4 } else { 0.0 }, "roughness": 0.42, "joint": is_new });
    let mut paints: Vec<Value> = (0..inputs.len())
        .map(|input| paint(&inputs[input].path, INPUT_COLOURS[input % INPUT_COLOURS.len()], false))
        .collect();
    paints.push(paint("new", NEW_COLOUR, true));
    let described = json!([{
        "id": "result",
        "title": title,
        "text": text,
        "paints": paints,
        "states": [{ "name": "Before", "body": 0, "hidden": [] }, { "name": "After", "body": 1, "hidden": [] }],
        "pairs": [[0, 1]],
        "eye": [0.5, 0.4, 1.0],
        "up": [0.0, 1.0, 0.0],
        "bodies": bodies,
    }]);
    let page = filled(title, &described, &arrays.bytes)?;
    std::fs::write(path, page).map_err(|error| Failure::file(format!("{}: {error}", path.display())))
}

/// Puts the parts into the page.
fn filled(title: &str, described: &Value, arrays: &[u8]) -> Result<String, Failure> {
    let title = escaped(title);
    let parts = [
        ("@TITLE@", title.clone()),
        ("@SHOWCASES@", format!("<a id=\"show=result\" href=\"#show=result\">{title}</a>")),
        ("@STYLE@", STYLE.to_owned()),
        ("@LICENCE@", THREE_LICENCE.trim().to_owned()),
        ("@THREE@", packed(THREE.as_bytes())?),
        // In a script, only this character could end it.
        ("@DESCRIBED@", described.to_string().replace('<', "\\u003c")),
        ("@ARRAYS@", packed(arrays)?),
        ("@SCRIPT@", SCRIPTS.concat()),
    ];
    // One pass, so that no part is searched for marks.
    let mut page = String::new();
    let mut rest = PAGE;
    while let Some((start, mark, part)) =
        parts.iter().filter_map(|(mark, part)| Some((rest.find(mark)?, mark, part))).min_by_key(|found| found.0)
    {
        page += &rest[..start];
        page += part;
        rest = &rest[start + mark.len()..];
    }
    Ok(page + rest)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Returns base64 of a gzip stream without a time, so that equal data give equal text.
fn packed(data: &[u8]) -> Result<String, Failure> {
    let mut gzip = GzBuilder::new().mtime(0).write(Vec::new(), Compression::best());
    let bytes = gzip.write_all(data).and_then(|()| gzip.finish()).map_err(|error| Failure::file(error.to_string()))?;
    Ok(base64::engine::general_purpose::STANDARD.encode(bytes))
}

/// Joins the meshes of inputs, for display.
fn joined(inputs: &[&Piece]) -> Mesh {
    let mut all = Mesh::default();
    let mut points: Vec<[f64; 3]> = Vec::new();
    let is_coloured = inputs.iter().any(|piece| !piece.mesh.vertex_colours.is_empty());
    for piece in inputs {
        let mesh = &piece.mesh;
        let (vertices, corners) = (points.len() as u32, all.corners.len() as u32);
        points.extend(mesh.positions.iter());
        all.corners.extend(mesh.corners.iter().map(|vertex| vertex + vertices));
        all.face_offsets.extend(mesh.face_offsets[1..].iter().map(|offset| offset + corners));
        if is_coloured {
            all.vertex_colours.extend_from_slice(&mesh.vertex_colours);
            all.vertex_colours.resize(points.len(), [1.0; 4]);
        }
    }
    all.positions = gusset_io::Positions::F64(points);
    all
}

/// The arrays of all bodies.
#[derive(Default)]
struct Arrays {
    bytes: Vec<u8>,
}

impl Arrays {
    /// Adds an array of elements of `WIDTH` bytes. Returns its description.
    fn add<const WIDTH: usize>(&mut self, values: &[u32]) -> Value {
        let at = self.bytes.len();
        self.bytes.resize(at + WIDTH * values.len(), 0);
        let mut before = 0_u32;
        for (place, &value) in values.iter().enumerate() {
            let difference = value.wrapping_sub(before).to_le_bytes();
            before = value;
            for (plane, &byte) in difference[..WIDTH].iter().enumerate() {
                self.bytes[at + plane * values.len() + place] = byte;
            }
        }
        json!({ "at": at, "count": values.len(), "bytes": WIDTH })
    }

    fn body(&mut self, body: &Body<'_>, input_count: usize) -> Value {
        /// Steps of the longest side of the box.
        const STEPS: f64 = 65535.0;
        let mesh = body.mesh;
        let used: Vec<[f64; 3]> = mesh.corners.iter().map(|&vertex| mesh.positions.get(vertex as usize)).collect();
        let bound = |axis: usize, choose: fn(f64, f64) -> f64| {
            used.iter().map(|point| point[axis]).filter(|x| x.is_finite()).reduce(choose).unwrap_or(0.0)
        };
        let low: [f64; 3] = std::array::from_fn(|axis| bound(axis, f64::min));
        let size = (0..3).map(|axis| bound(axis, f64::max) - low[axis]).fold(0.0, f64::max);
        let step = |x: f64| if size > 0.0 { (((x / size).clamp(0.0, 1.0)) * STEPS).round() as u32 } else { 0 };
        let points: Vec<Value> = (0..3)
            .map(|axis| {
                let places: Vec<u32> = mesh.positions.iter().map(|point| step(point[axis] - low[axis])).collect();
                self.add::<2>(&places)
            })
            .collect();
        let sizes: Vec<u32> = mesh.face_offsets.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let paint: Vec<u32> = body.inputs.iter().map(|input| input.unwrap_or(input_count as u32).min(255)).collect();
        let mut described = json!({ "low": low, "size": size, "points": points, "corners": self.add::<4>(&mesh.corners), "paint": self.add::<1>(&paint), "curves": [] });
        if sizes.iter().any(|&size| size != 3) {
            described["sizes"] = self.add::<4>(&sizes);
        }
        if !mesh.vertex_colours.is_empty() {
            let channel = |axis: usize| {
                mesh.vertex_colours
                    .iter()
                    .map(|colour| (255.0 * colour[axis].clamp(0.0, 1.0)).round() as u32)
                    .collect::<Vec<_>>()
            };
            described["vertexColours"] = (0..3).map(|axis| self.add::<1>(&channel(axis))).collect();
        }
        described
    }
}
