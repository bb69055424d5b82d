use super::data::{Input, Output};
use super::fill::KEEP_OPEN;
use super::filter::{Filter, FilterBody};
use super::report::{EDGE, FACE, Noun, Report, ReportValue, count_with_noun, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use super::weld::TOLERANCE;
use gusset_attributes::Origins;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::fill::{self, Keep};
use gusset_stitch::solid::{DropReason, Options, Repaired, repair};

pub(super) const FILTER: Filter = Filter {
    id: "repair",
    name: "Repair",
    category: "Repair",
    help: "Removes the defects of a mesh, to get a valid solid where possible. Changes only faces at defects. Sews borders, drops faces without area and \
           duplicate faces, fills holes, separates sheets that share edges or vertices, drops walls within the solid, and turns \
           closed components outwards. Replaces closed components that intersect by their union. Lists what was dropped.",
    reference: "Zhou, Grinspun, Zorin and Jacobson 2016, for cells; Attene 2010",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    tolerance: Option<f64> = TOLERANCE;
    keep: Keep = KEEP_OPEN;
    leave_borders: bool = Param::flag("Leave borders", "Keeps borders that coincide apart.");
    leave_flat_faces: bool = Param::flag("Leave flat faces", "Keeps faces whose area is 0 up to rounding.");
    leave_duplicates: bool = Param::flag("Leave duplicates", "Keeps faces that have the vertices of another.");
    leave_holes: bool = Param::flag("Leave holes", "Keeps all holes open.");
    leave_non_manifold: bool = Param::flag(
        "Leave shared edges",
        "Keeps edges with three or more faces, vertices with several fans of faces, and faces within the solid.",
    );
    leave_fins: bool = Param::flag("Leave fins", "Keeps open sheets that were attached to a closed component.");
    leave_intersections: bool = Param::flag("Leave intersections", "Keeps faces that intersect.");
    leave_orientation: bool = Param::flag("Leave orientation", "Keeps the orientation of all faces.");
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options {
        tolerance: values.tolerance,
        leave_borders: values.leave_borders,
        leave_flat_faces: values.leave_flat_faces,
        leave_duplicates: values.leave_duplicates,
        leave_non_manifold: values.leave_non_manifold,
        leave_holes: values.leave_holes,
        leave_orientation: values.leave_orientation,
        leave_intersections: values.leave_intersections,
        leave_fins: values.leave_fins,
        fill: fill::Options { keep: values.keep, ..fill::Options::default() },
    };
    let done = repair(inputs[0].mesh()?, &options, job)?;
    let origins = values.trace_origins(|| Origins::from_repaired(&done, &job.sub_job(1.0, 1.0)))?;
    let report = solid_report(&done, "nothing to repair");
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

/// The nouns of dropped faces.
const DROPPED: [(DropReason, Noun, &str); 6] = [
    (DropReason::Degenerate, ["degenerate face", "degenerate faces"], "degenerate_faces"),
    (DropReason::ZeroArea, ["face without area", "faces without area"], "zero_area_faces"),
    (DropReason::Duplicate, ["duplicate face", "duplicate faces"], "duplicate_faces"),
    (DropReason::Inside, ["face within the solid", "faces within the solid"], "inner_faces"),
    (DropReason::Fin, ["face of a fin", "faces of fins"], "fin_faces"),
    (DropReason::Overlap, ["overlapping face", "overlapping faces"], "overlapping_faces"),
];

/// Reports the changes and the remaining defects. `unchanged` is said if nothing was changed.
pub(super) fn solid_report(done: &Repaired, unchanged: &str) -> Report {
    let mut text = String::new();
    let turned = done.turned.iter().filter(|&&turned| turned).count();
    let counts = [
        (done.sewn_edges, EDGE, "sewn"),
        (done.split_faces, FACE, "split at borders"),
        (done.filled_holes, ["hole", "holes"], "filled"),
        (done.split_vertices, ["copy of a vertex", "copies of vertices"], "made to separate sheets"),
        (turned as u32, FACE, "turned over"),
    ];
    for (count, noun, what) in counts.into_iter().filter(|&(count, ..)| count > 0) {
        push_line!(text, "{} {what}", count_with_noun(count, noun));
    }
    let dropped = |reason| done.dropped.iter().filter(|dropped| dropped.reason == reason).count();
    for (reason, noun, _) in DROPPED.into_iter().filter(|&(reason, ..)| dropped(reason) > 0) {
        push_line!(text, "{} dropped", count_with_noun(dropped(reason), noun));
    }
    if text.is_empty() {
        push_line!(text, "{unchanged}");
    }
    let after = &done.after;
    let left = [
        (after.boundary_edges.len(), ["boundary edge", "boundary edges"]),
        (after.non_manifold_edges.len(), ["edge with three or more faces", "edges with three or more faces"]),
        (after.bow_ties.len(), ["vertex with several fans", "vertices with several fans"]),
        (after.orientation_conflicts.len(), ["edge where orientations conflict", "edges where orientations conflict"]),
        (after.degenerate_faces.len(), ["degenerate face", "degenerate faces"]),
        (after.zero_area_faces.len(), ["face without area", "faces without area"]),
        (after.duplicate_faces.len(), ["duplicate face", "duplicate faces"]),
        (done.intersections.len(), ["pair of intersecting faces", "pairs of intersecting faces"]),
    ];
    if done.is_valid() {
        push_line!(text, "valid: closed, manifold, oriented, without intersecting faces");
    } else {
        let left: Vec<_> = left.into_iter().filter(|&(n, _)| n > 0).map(|(n, noun)| count_with_noun(n, noun)).collect();
        push_line!(text, "not a valid solid: {} left", left.join(", "));
    }
    let mut values = vec![
        ("valid", ReportValue::flag(done.is_valid())),
        ("welded_vertices", ReportValue::count(done.welded_vertices)),
        ("tolerance", ReportValue::length(done.tolerance)),
        ("sewn_edges", ReportValue::count(done.sewn_edges)),
        ("split_faces", ReportValue::count(done.split_faces)),
        ("filled_holes", ReportValue::count(done.filled_holes)),
        ("split_vertices", ReportValue::count(done.split_vertices)),
        ("turned_faces", ReportValue::count(turned)),
    ];
    values.extend(DROPPED.map(|(reason, _, name)| (name, ReportValue::count(dropped(reason)))));
    values.push(("boundary_edges_left", ReportValue::count(after.boundary_edges.len())));
    values.push(("non_manifold_edges_left", ReportValue::count(after.non_manifold_edges.len())));
    values.push(("intersecting_pairs_left", ReportValue::count(done.intersections.len())));
    Report::new(text, &values)
}
