use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{NON_NEGATIVE, Param, Values};
use super::report::{BOUNDARY_LOOP, FACE};
use super::report::{Report, counted, short};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_attributes::{KeepSplits, Origins};
use gusset_base::choice::Choice;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_stitch::fill::{
    Continuity, Fairing, Filled, HoleStatus, Keep, Limits, Options, Refinement, Selection, Together, Weight, fill_holes,
};
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::stitch::Intersections;

pub(super) const FILTER: Filter = Filter {
    id: "fill_holes",
    name: "Fill holes",
    category: "Boundary",
    help: "Closes boundary loops of a mesh by new triangles: the triangulation of least weight, refined to the density of the \
           surrounding mesh and faired. Vertices stay where they are and no face is lost.",
    reference: "P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron (1995)",
    replaces: true,
    has_origins: true,
    params: &[
        Param::choice("inside", "Inside the holes", INTERIORS).with_help("The interior of the patches."),
        Param::choice("weight", "Best triangulation", Weight::CHOICES.texts)
            .with_help("The weight that the triangulation of a rim minimises."),
        Param::int("max_edges", "Most edges", [0.0, u32::MAX as f64], &[0.0])
            .with_help("Loops of more edges are left open; 0 sets no limit."),
        Param::length("max_length", "Greatest length", NON_NEGATIVE, &[0.0])
            .with_help("Longer loops are left open; 0 sets no limit."),
        Param::choice("keep", "Keep open", Keep::CHOICES.texts).with_help("The loops that are no holes."),
        Param::choice("together", "Patches", Together::CHOICES.texts).with_help("The loops that get one patch."),
        Param::length("max_diameter", "Greatest diameter", NON_NEGATIVE, &[0.0])
            .with_help("Loops in a box along the axes with a longer diagonal are left open; 0 sets no limit."),
        Param::real("max_area", "Greatest area", NON_NEGATIVE, &[0.0])
            .with_help("Loops with a larger area between them and their centre, in the square of the unit, are left open; 0 sets no limit."),
        Param::choice("intersections", "Intersections", CUTS.texts).with_help("The search for faces of patches that cut."),
        Param::flag("plan_only", "Plan only").with_help("Nothing is filled: the report says what would be."),
        Param::choice("continuity", "Continuity", Continuity::CHOICES.texts).with_help("How fair patches go on the surface round them."),
        Param::flag("ignore_creases", "Ignore creases").with_help("No patch goes on with creases of the surface round it."),
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

choices! {
    CUTS: Intersections =
        Intersections::Auto => "Automatic", "They are looked for, and avoided by less fairing, other weights and no new vertices.";
        Intersections::Ignore => "Ignore", "No search.";
        Intersections::Report => "Report", "They are looked for, and nothing is done about them.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let limit = |id| Some(values.number(id)).filter(|&limit| limit > 0.0);
    let inside = values.place("inside");
    let options = Options {
        weight: values.choice("weight", Weight::CHOICES),
        refinement: if inside > 0 { Refinement::RimDensity(0) } else { Refinement::None },
        fairing: if inside > 1 { Fairing::ThinPlate } else { Fairing::None },
        continuity: values.choice("continuity", Continuity::CHOICES),
        ignore_creases: values.is_set("ignore_creases"),
        limits: Limits {
            edges: limit("max_edges").map(|limit| limit as u32),
            length: limit("max_length"),
            diameter: limit("max_diameter"),
            area: limit("max_area"),
        },
        keep: values.choice("keep", Keep::CHOICES),
        together: values.choice("together", Together::CHOICES),
        intersections: values.choice("intersections", CUTS),
        plan_only: values.is_set("plan_only"),
        outward: if values.is_set("outward") { Outward::Closed } else { Outward::Keep },
    };
    let old = inputs[0].mesh()?;
    let mut done = fill_holes(old, Selection::All, &options, job)?;
    done.keep_splits(&[old], &job.part(1.0, 1.0))?;
    let report = report(old, &done, options.plan_only);
    let origins = values.origins(|| Origins::from_filled(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The line of a report on faces that were turned outwards, if there are any.
pub(super) fn turned_outwards(faces: &[u32]) -> String {
    match faces.len() {
        0 => String::new(),
        n => format!("{} turned over, to face outwards\n", counted(n, FACE)),
    }
}

fn report(old: &MeshView<'_>, done: &Filled, plan_only: bool) -> Report {
    let filled = done.holes.iter().filter(|hole| hole.status == HoleStatus::Filled);
    let count = filled.clone().count();
    let patches = if plan_only { count } else { filled.map(|hole| hole.patch as usize + 1).max().unwrap_or(0) };
    let joined =
        if patches < count { format!(" with {}", counted(patches, ["patch", "patches"])) } else { String::new() };
    let faces = done.mesh.face_count() - old.faces().len();
    let vertices = done.parents.len();
    let (area, angle) = (done.quality.area, done.quality.min_angle.to_degrees());
    let measures = match faces {
        0 => String::new(),
        _ => format!("area {}, smallest angle {angle:.2} degrees\n", short(area)),
    };
    let turned = turned_outwards(&done.turned_outwards);
    let verb = if plan_only { "would fill" } else { "filled" };
    let cuts = cuts(done.intersections.as_deref());
    let text = format!(
        "{verb} {count} of {}{joined} by {} and {}\n{measures}{cuts}{turned}{} left\n",
        counted(done.holes.len(), BOUNDARY_LOOP),
        counted(faces, FACE),
        counted(vertices, ["new vertex", "new vertices"]),
        counted(done.quality.loops_left, BOUNDARY_LOOP)
    );
    let mut values = vec![
        ("filled_loops", count as f64),
        ("patches", patches as f64),
        ("boundary_loops_before", done.holes.len() as f64),
        ("new_faces", faces as f64),
        ("new_vertices", vertices as f64),
        ("area", area),
        ("smallest_angle", done.quality.min_angle),
        ("turned_outwards", done.turned_outwards.len() as f64),
        ("boundary_loops", f64::from(done.quality.loops_left)),
    ];
    if let Some(pairs) = &done.intersections {
        values.push(("intersections", pairs.len() as f64));
    }
    Report::new(text, &values)
}

/// The line of a report on faces that cut each other, if they were looked for.
pub(super) fn cuts(pairs: Option<&[[u32; 2]]>) -> String {
    match pairs {
        None => String::new(),
        Some([]) => "no faces cut each other\n".to_owned(),
        Some(pairs) => format!("{} cut each other\n", counted(pairs.len(), ["pair of faces", "pairs of faces"])),
    }
}
