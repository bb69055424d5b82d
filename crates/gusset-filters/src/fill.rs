use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{BOUNDARY_LOOP, FACE, Report, ReportValue, count_with_noun, format_short};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_RANGE, Param, ParamValues, TypedParam, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_stitch::fill::{
    Continuity, Fairing, Filled, HoleStatus, Keep, Limits, LoopSelection, Options, Refinement, Together, Weight,
    fill_holes,
};

params! {
    inside: (Refinement, Fairing) = Param::choice("Inside the holes", "The interior of the patches.", INTERIORS);
    weight: Weight = Param::choice(
        "Best triangulation",
        "The weight that the triangulation of a rim minimises.",
        Weight::CHOICES,
    );
    max_edges: Option<u32> = Param::int(
        "Most edges",
        "Loops of more edges stay open; 0 sets no limit.",
        [0.0, MAX_COUNT], &[0.0],
    ).none_unless_positive();
    max_length: Option<f64> =
        Param::length("Greatest length", "Longer loops stay open; 0 sets no limit.", NON_NEGATIVE_RANGE, &[0.0]).none_unless_positive();
    keep: Keep = KEEP_OPEN;
    together: Together = Param::choice("Patches", "The loops that share a patch.", Together::CHOICES);
    max_diameter: Option<f64> = Param::length(
        "Greatest diameter",
        "Loops whose bounding box has a longer diagonal stay open; 0 sets no limit.",
        NON_NEGATIVE_RANGE, &[0.0],
    ).none_unless_positive();
    max_area: Option<f64> = Param::real(
        "Greatest area",
        "Loops with a larger area between them and their centre stay open; 0 sets no limit. The unit is the square of the \
         positions' unit.",
        NON_NEGATIVE_RANGE, &[0.0],
    ).none_unless_positive();
    intersections: Intersections =
        Param::choice("Intersections", "The search for faces of patches that intersect others.", CUTS);
    plan_only: bool = Param::flag("Plan only", "Fills nothing. The report says what would be filled.");
    continuity: Continuity = Param::choice(
        "Continuity",
        "The continuity between fair patches and the surface around them.",
        Continuity::CHOICES,
    );
    ignore_creases: bool = Param::flag("Ignore creases", "Ends creases of the surface at the rims of patches.");
    outward: bool = OUTWARD;
}
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::stitch::Intersections;

pub(super) const FILTER: Filter = Filter {
    id: "fill",
    name: "Fill holes",
    category: "Boundary",
    help: "Closes boundary loops of a mesh by new triangles: the triangulation of least weight, on request refined to the \
           density of the surrounding mesh and faired. All vertices keep their positions, and all faces stay.",
    reference: "P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron \
                (1995)",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

/// The loops that stay open.
pub(super) const KEEP_OPEN: TypedParam<Keep> =
    Param::choice("Keep open", "The loops that are not holes.", Keep::CHOICES);

/// Turns closed components of a result outwards.
pub(super) const OUTWARD: TypedParam<bool> = Param::flag(
    "Turn outwards",
    "Reverses the faces of closed components that are inside out. Each component is judged by its own volume, even inside \
     another one.",
);

choices! {
    INTERIORS: (Refinement, Fairing) =
        (Refinement::None, Fairing::None) => "Rim only", "Triangles between the vertices of the rim.";
        (Refinement::RimDensity(0), Fairing::None) => "Refined", "New vertices, as dense as those around the hole.";
        (Refinement::RimDensity(0), Fairing::ThinPlate) => "Refined and fair",
            "New vertices, so that the patch continues the surface smoothly.";
}

choices! {
    CUTS: Intersections =
        Intersections::Auto => "Automatic", "They are found, and avoided by less fairing, other weights, or no new vertices.";
        Intersections::Ignore => "Ignore", "No search.";
        Intersections::Report => "Report", "They are found and counted, but not avoided.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (refinement, fairing) = values.inside;
    let options = Options {
        weight: values.weight,
        refinement,
        fairing,
        continuity: values.continuity,
        ignore_creases: values.ignore_creases,
        limits: Limits {
            edges: values.max_edges,
            length: values.max_length,
            diameter: values.max_diameter,
            area: values.max_area,
        },
        keep: values.keep,
        together: values.together,
        intersections: values.intersections,
        plan_only: values.plan_only,
        outward: if values.outward { Outward::Closed } else { Outward::Keep },
    };
    let old = inputs[0].mesh()?;
    let mut done = fill_holes(old, LoopSelection::All, &options, job)?;
    done.keep_split_vertices(&[old], &job.part(1.0, 1.0))?;
    let report = report(old, &done, options.plan_only);
    let origins = values.trace_origins(|| Origins::from_filled(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The line of a report on faces that were turned outwards; empty if there are none.
pub(super) fn turned_outwards_line(faces: &[u32]) -> String {
    match faces.len() {
        0 => String::new(),
        n => format!("{} reversed, to face outwards\n", count_with_noun(n, FACE)),
    }
}

fn report(old: &MeshView<'_>, done: &Filled, plan_only: bool) -> Report {
    let filled = done.holes.iter().filter(|hole| hole.status == HoleStatus::Filled);
    let count = filled.clone().count();
    let patches = if plan_only { count } else { filled.map(|hole| hole.patch as usize + 1).max().unwrap_or(0) };
    let joined = if patches < count {
        format!(" with {}", count_with_noun(patches, ["patch", "patches"]))
    } else {
        String::new()
    };
    let faces = done.mesh.face_count() - old.faces().len();
    let vertices = done.parents.len();
    let (area, angle) = (done.quality.area, done.quality.min_angle.to_degrees());
    let measures = match faces {
        0 => String::new(),
        _ => format!("area {}, smallest angle {angle:.2} degrees\n", format_short(area)),
    };
    let turned = turned_outwards_line(&done.turned_outwards);
    let verb = if plan_only { "would fill" } else { "filled" };
    let cuts = intersections_line(done.intersections.as_deref());
    let text = format!(
        "{verb} {count} of {}{joined} by {} and {}\n{measures}{cuts}{turned}{} left\n",
        count_with_noun(done.holes.len(), BOUNDARY_LOOP),
        count_with_noun(faces, FACE),
        count_with_noun(vertices, ["new vertex", "new vertices"]),
        count_with_noun(done.quality.loops_left, BOUNDARY_LOOP)
    );
    let mut values = vec![
        ("filled_loops", ReportValue::count(count)),
        ("patches", ReportValue::count(patches)),
        ("boundary_loops_before", ReportValue::count(done.holes.len())),
        ("new_faces", ReportValue::count(faces)),
        ("new_vertices", ReportValue::count(vertices)),
        ("area", ReportValue::area(area)),
        ("smallest_angle", ReportValue::angle(done.quality.min_angle)),
        ("turned_outwards", ReportValue::count(done.turned_outwards.len())),
        ("boundary_loops", ReportValue::count(done.quality.loops_left)),
    ];
    if let Some(pairs) = &done.intersections {
        values.push(("intersections", ReportValue::count(pairs.len())));
    }
    Report::new(text, &values)
}

/// The line of a report on faces that intersect each other; empty without a search.
pub(super) fn intersections_line(pairs: Option<&[[u32; 2]]>) -> String {
    match pairs {
        None => String::new(),
        Some([]) => "no faces intersect\n".to_owned(),
        Some(pairs) => {
            format!("{}\n", count_with_noun(pairs.len(), ["pair of faces intersects", "pairs of faces intersect"]))
        }
    }
}
