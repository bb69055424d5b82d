use super::prelude::*;
use super::report::{BOUNDARY_LOOP, FACE};
use crate::fill::{Fairing, Filled, HoleStatus, Keep, Limits, Options, Refinement, Weight, fill_holes};
use crate::repair::orient::Outward;
use crate::stitch::Intersections;

pub(super) const FILTER: Filter = Filter {
    id: "fill_holes",
    name: "Fill holes",
    category: "Boundary",
    help: "Closes boundary loops of a mesh by new triangles: the triangulation of least weight, refined to the density of the \
           surrounding mesh and faired. Vertices stay where they are and no face is lost.",
    reference: "P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron (1995)",
    replaces: true,
    params: &[
        Param::choice("inside", "Inside the holes", INTERIORS).with_help("The interior of the patches."),
        Param::choice("weight", "Best triangulation", Weight::CHOICES.texts)
            .with_help("The weight that the triangulation of a rim minimises."),
        Param::int("max_edges", "Most edges", [0.0, u32::MAX as f64], &[0.0])
            .with_help("Loops of more edges are left open; 0 sets no limit."),
        Param::length("max_length", "Greatest length", NON_NEGATIVE, &[0.0])
            .with_help("Longer loops are left open; 0 sets no limit."),
        Param::choice("keep", "Keep open", Keep::CHOICES.texts).with_help("The loops that are no holes."),
        Param::flag("outward", "Turn outwards").with_help(OUTWARD_HELP),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

pub(super) const OUTWARD_HELP: &str = "Reverses the faces of closed components of the result that are inside out, each by its own volume, also inside \
     others.";

const INTERIORS: &[Choice] = &[
    Choice::new("Rim only", "Triangles between the vertices of the rim."),
    Choice::new("Refined", "New vertices, as dense as those round the hole."),
    Choice::new("Refined and fair", "New vertices, placed so that the patch continues the surface smoothly."),
];

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (edges, length) = (values.number("max_edges"), values.number("max_length"));
    let inside = values.place("inside");
    let options = Options {
        weight: values.choice("weight", Weight::CHOICES),
        refinement: if inside > 0 { Refinement::RimDensity(0) } else { Refinement::None },
        fairing: if inside > 1 { Fairing::ThinPlate } else { Fairing::None },
        limits: Limits {
            edges: (edges > 0.0).then_some(edges as u32),
            length: (length > 0.0).then_some(length),
            diameter: None,
            area: None,
        },
        keep: values.choice("keep", Keep::CHOICES),
        intersections: Intersections::Auto,
        plan_only: false,
        outward: if values.is_set("outward") { Outward::Closed } else { Outward::Keep },
    };
    let done = fill_holes(inputs[0].mesh()?, None, &options, job)?;
    let report = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(report)])
}

/// The line of a report on faces that were turned outwards, if there are any.
pub(super) fn turned_outwards(faces: &[u32]) -> String {
    match faces.len() {
        0 => String::new(),
        n => format!("{} turned over, to face outwards\n", counted(n, FACE)),
    }
}

fn report(done: &Filled) -> Report {
    let filled = done.holes.iter().filter(|hole| hole.status == HoleStatus::Filled);
    let count = filled.clone().count();
    let faces: usize = filled.clone().map(|hole| hole.faces.len()).sum();
    let vertices: usize = filled.map(|hole| hole.vertices.len()).sum();
    let (area, angle) = (done.quality.area, done.quality.min_angle.to_degrees());
    let measures = match count {
        0 => String::new(),
        _ => format!("area {}, smallest angle {angle:.2} degrees\n", short(area)),
    };
    let turned = turned_outwards(&done.turned_outwards);
    let text = format!(
        "filled {count} of {} by {} and {}\n{measures}{turned}{} left\n",
        counted(done.holes.len(), BOUNDARY_LOOP),
        counted(faces, FACE),
        counted(vertices, ["new vertex", "new vertices"]),
        counted(done.quality.loops_left, BOUNDARY_LOOP)
    );
    let values = [
        ("filled_loops", count as f64),
        ("boundary_loops_before", done.holes.len() as f64),
        ("new_faces", faces as f64),
        ("new_vertices", vertices as f64),
        ("area", area),
        ("smallest_angle", done.quality.min_angle),
        ("turned_outwards", done.turned_outwards.len() as f64),
        ("boundary_loops", f64::from(done.quality.loops_left)),
    ];
    Report::new(text, &values)
}
