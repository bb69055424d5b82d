use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{
    BOUNDARY_EDGE, BOUNDARY_LOOP, EDGE, FACE, Report, ReportValue, count_with_noun, format_short, push_line,
};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_RANGE, Param, ParamValues, TypedParam, params};
use gusset_attributes::{KeepSplitVertices, Origins};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_stitch::assemble::{self, Assembly, MaxGap, assemble};
use gusset_stitch::fill::{
    Continuity, Fairing, Filled, Hole, HoleStatus, HoleSurvey, Keep, Limits, LoopSelection, Options, Refinement,
    Together, Weight,
};
use gusset_stitch::repair::orient::Outward;
use gusset_stitch::repair::weld;
use gusset_stitch::stitch::Intersections;
use std::ops::Range;

params! {
    finish: (Refinement, Fairing) = Param::choice("Finish", "The interior of the patches.", FINISHES);
    weight: Weight = Param::choice(
        "Best triangulation",
        "The weight that the triangulation of a rim minimises.",
        Weight::CHOICES,
    );
    max_edges: Option<u32> = MAX_EDGES;
    max_length: Option<f64> = MAX_LENGTH;
    keep: Keep = KEEP_OPEN;
    together: Together = Param::choice("Patches", "The loops that share a patch.", Together::CHOICES);
    max_diameter: Option<f64> = MAX_DIAMETER;
    max_area: Option<f64> = MAX_AREA;
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
    sew: bool = Param::choice("Coincident borders", "Borders that coincide with others.", SEWING);
}

pub(super) const FILTER: Filter = Filter {
    id: "fill",
    name: "Fill holes",
    category: "Boundary",
    help: "Closes boundary loops of a mesh by new triangles: the triangulation of least weight, on request refined to the \
           density of the surrounding mesh and faired. All vertices keep their positions, and all faces stay. Before that, \
           borders that coincide with others are sewn, as the filter join does.",
    reference: "P. Liepa, Filling holes in meshes (2003); G. Barequet, M. Sharir, Filling gaps in the boundary of a polyhedron \
                (1995)",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

/// Chooses the loops that stay open.
pub(super) const KEEP_OPEN: TypedParam<Keep> =
    Param::choice("Keep open", "The loops that are not holes.", Keep::CHOICES);

/// Limits the number of edges of the loops to fill.
pub(super) const MAX_EDGES: TypedParam<Option<u32>> =
    Param::int("Most edges", "Loops of more edges stay open; 0 sets no limit.", [0.0, MAX_COUNT], &[0.0])
        .none_unless_positive();

/// Limits the perimeter of the loops to fill.
pub(super) const MAX_LENGTH: TypedParam<Option<f64>> =
    Param::length("Greatest length", "Longer loops stay open; 0 sets no limit.", NON_NEGATIVE_RANGE, &[0.0])
        .none_unless_positive();

/// Limits the bounding-box diagonal of the loops to fill.
pub(super) const MAX_DIAMETER: TypedParam<Option<f64>> = Param::length(
    "Greatest diameter",
    "Loops whose bounding box has a longer diagonal stay open; 0 sets no limit.",
    NON_NEGATIVE_RANGE,
    &[0.0],
)
.none_unless_positive();

/// Limits the area of the loops to fill.
pub(super) const MAX_AREA: TypedParam<Option<f64>> = Param::real(
    "Greatest area",
    "Loops with a larger area between them and their centre stay open; 0 sets no limit. The unit is the square of the \
     positions' unit.",
    NON_NEGATIVE_RANGE,
    &[0.0],
)
.none_unless_positive();

/// Turns closed components of a result outwards.
pub(super) const OUTWARD: TypedParam<bool> = Param::flag(
    "Turn outwards",
    "Reverses the faces of closed components that face the wrong side. Components face outwards; the walls of cavities face \
     into the cavities.",
);

choices! {
    FINISHES: (Refinement, Fairing) =
        (Refinement::None, Fairing::None) => "Rim only", "Triangles between the vertices of the rim.";
        (Refinement::RimDensity(0), Fairing::None) => "Refined", "New vertices, as dense as those around the hole.";
        (Refinement::RimDensity(0), Fairing::ThinPlate) => "Blend",
            "New vertices, so that the patch continues the surface smoothly: the best-looking result.";
}

choices! {
    CUTS: Intersections =
        Intersections::Auto => "Automatic", "They are found, and avoided by less fairing, other weights, or no new vertices.";
        Intersections::Ignore => "Ignore", "No search.";
        Intersections::Report => "Report", "They are found and counted, but not avoided.";
}

choices! {
    /// True if coincident borders are sewn before holes are filled.
    SEWING: bool =
        true => "Sew", "They are sewn and oriented consistently before holes are filled.";
        false => "Leave", "The loops along them stay open.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (refinement, fairing) = values.finish;
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
        ..Options::default()
    };
    let old = inputs[0].mesh()?;
    let survey = HoleSurvey::new(old, LoopSelection::All, &job.sub_job(0.0, 0.2))?;
    let coincident = survey.coincident_edges();
    if values.sew && !options.plan_only && coincident > 0 {
        return sew_and_fill(old, coincident, &options, values, &job.sub_job(0.2, 1.0));
    }
    let mut done = survey.fill(&options, &job.sub_job(0.2, 1.0))?;
    done.keep_split_vertices(&[old], &job.sub_job(1.0, 1.0))?;
    let report = report(old, &done, &options);
    let origins = values.trace_origins(|| Origins::from_filled(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// Sews borders, of which `coincident` edges coincide with others, then fills holes.
fn sew_and_fill(
    old: &MeshView<'_>,
    coincident: u32,
    options: &Options,
    values: &ParamValues<Params>,
    job: &Job<'_>,
) -> Result<Vec<Output>> {
    let how = assemble::Options {
        weld: Some(weld::Options::default()),
        max_gap: MaxGap::Given(0.0),
        fill: Some(*options),
        outward: options.outward,
        ..assemble::Options::default()
    };
    let mut done = assemble(&[*old], &how, job)?;
    done.keep_split_vertices(&[old], &job.sub_job(1.0, 1.0))?;
    let report = report_after_sewing(&done, coincident);
    let origins = values.trace_origins(|| Origins::from_assembly(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The line of a report on faces that were turned outwards; empty if there are none.
pub(super) fn turned_outwards_line(faces: &[u32]) -> String {
    match faces.len() {
        0 => String::new(),
        n => format!("{} reversed, to face outwards\n", count_with_noun(n, FACE)),
    }
}

/// The reasons why loops stay open: the name of their number in a report, and a line for people.
const OPEN_LOOPS: [(HoleStatus, &str, &str); 10] = [
    (HoleStatus::Kept, "loops_kept", "an outline is no hole"),
    (HoleStatus::Loose, "loops_of_loose_faces", "loose faces: nothing lies behind the loop"),
    (HoleStatus::Unsewn, "loops_unsewn", "an edge coincides with another border, so sewing comes first"),
    (HoleStatus::TooLarge, "loops_too_large", "larger than the limits"),
    (HoleStatus::Open, "loops_not_closed", "a chain that does not close"),
    (HoleStatus::NonManifold, "loops_non_manifold", "an edge has three or more faces"),
    (HoleStatus::NotOriented, "loops_not_oriented", "the faces along the loop disagree in orientation"),
    (HoleStatus::NotSimple, "loops_not_simple", "fewer than three vertices, or one of them twice"),
    (HoleStatus::NotFree, "loops_not_free", "an edge is not a boundary edge, or is used twice"),
    (
        HoleStatus::NoTriangulation,
        "loops_without_triangulation",
        "every triangulation would use an edge of the mesh again",
    ),
];

/// Largest number of loops whose lengths a line lists.
const MAX_LISTED_LOOPS: usize = 8;

/// Appends a line for each reason why loops stay open, and the number of loops under its name.
pub(super) fn push_open_loops(holes: &[Hole], text: &mut String, values: &mut Vec<(&'static str, ReportValue)>) {
    for (status, name, why) in OPEN_LOOPS {
        let left = holes.iter().filter(|hole| hole.status == status);
        let count = left.clone().count();
        if count == 0 {
            continue;
        }
        let lengths = left.take(MAX_LISTED_LOOPS).map(|hole| hole.rim.len().to_string());
        let lengths = lengths.collect::<Vec<_>>().join(", ");
        let more = if count > MAX_LISTED_LOOPS { ", ..." } else { "" };
        push_line!(text, "{} left open, of {lengths}{more} edges: {why}", count_with_noun(count, BOUNDARY_LOOP));
        values.push((name, ReportValue::count(count)));
    }
}

/// The numbers of filled loops, patches, and the patches' faces and vertices.
fn count_filled(holes: &[Hole]) -> [usize; 4] {
    let filled = || holes.iter().filter(|hole| hole.status == HoleStatus::Filled);
    let patches = filled().map(|hole| hole.patch as usize + 1).max().unwrap_or(0);
    let end = |of: fn(&Hole) -> &Range<u32>| {
        let starts = filled().map(|hole| of(hole).start).min().unwrap_or(0);
        filled().map(|hole| of(hole).end).max().unwrap_or(0).saturating_sub(starts) as usize
    };
    [filled().count(), patches, end(|hole| &hole.faces), end(|hole| &hole.vertices)]
}

/// The first line of a report, and its numbers.
fn filled_line(verb: &str, holes: &[Hole], patches: usize) -> (String, Vec<(&'static str, ReportValue)>) {
    let [count, _, faces, vertices] = count_filled(holes);
    let joined = match patches < count {
        true => format!(" with {}", count_with_noun(patches, ["patch", "patches"])),
        false => String::new(),
    };
    let text = format!(
        "{verb} {count} of {}{joined} by {} and {}\n",
        count_with_noun(holes.len(), BOUNDARY_LOOP),
        count_with_noun(faces, FACE),
        count_with_noun(vertices, ["new vertex", "new vertices"]),
    );
    let values = vec![
        ("filled_loops", ReportValue::count(count)),
        ("patches", ReportValue::count(patches)),
        ("boundary_loops_before", ReportValue::count(holes.len())),
        ("new_faces", ReportValue::count(faces)),
        ("new_vertices", ReportValue::count(vertices)),
    ];
    (text, values)
}

fn report(old: &MeshView<'_>, done: &Filled, options: &Options) -> Report {
    let [count, patches, ..] = count_filled(&done.holes);
    let verb = if options.plan_only { "would fill" } else { "filled" };
    let (mut text, mut values) = filled_line(verb, &done.holes, if options.plan_only { count } else { patches });
    let (area, angle) = (done.quality.area, done.quality.min_angle.to_degrees());
    if done.mesh.face_count() > old.faces().len() {
        push_line!(text, "area {}, smallest angle {angle:.2} degrees", format_short(area));
    }
    text += &intersections_line(done.intersections.as_deref());
    text += &turned_outwards_line(&done.turned_outwards);
    push_line!(text, "{} left", count_with_noun(done.quality.loops_left, BOUNDARY_LOOP));
    values.extend([
        ("area", ReportValue::area(area)),
        ("smallest_angle", ReportValue::angle(done.quality.min_angle)),
        ("turned_outwards", ReportValue::count(done.turned_outwards.len())),
        ("boundary_loops", ReportValue::count(done.quality.loops_left)),
    ]);
    push_open_loops(&done.holes, &mut text, &mut values);
    if done.coincident_edges > 0 {
        push_line!(text, "{} coincide with others", count_with_noun(done.coincident_edges, BOUNDARY_EDGE));
        values.push(("coincident_edges", ReportValue::count(done.coincident_edges)));
    }
    if let Some(pairs) = &done.intersections {
        values.push(("intersections", ReportValue::count(pairs.len())));
    }
    Report::new(text, &values)
}

/// The report if coincident borders were sewn first.
fn report_after_sewing(done: &Assembly, coincident: u32) -> Report {
    let verb = if coincident == 1 { "coincides" } else { "coincide" };
    let mut text = format!(
        "{} {verb} with others: {} sewn before holes are filled\n",
        count_with_noun(coincident, BOUNDARY_EDGE),
        count_with_noun(done.sewn_edges, EDGE)
    );
    let (line, mut values) = filled_line("filled", &done.holes, count_filled(&done.holes)[1]);
    text += &line;
    let turned = done.turned.iter().filter(|&&turned| turned).count();
    if turned > 0 {
        push_line!(text, "{} reversed", count_with_noun(turned, FACE));
    }
    text += &intersections_line(done.hole_intersections.as_deref());
    push_line!(text, "{} left", count_with_noun(done.loops_left, BOUNDARY_LOOP));
    values.extend([
        ("coincident_edges", ReportValue::count(coincident)),
        ("sewn_edges", ReportValue::count(done.sewn_edges)),
        ("turned_faces", ReportValue::count(turned)),
        ("boundary_loops", ReportValue::count(done.loops_left)),
    ]);
    push_open_loops(&done.holes, &mut text, &mut values);
    if let Some(pairs) = &done.hole_intersections {
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
