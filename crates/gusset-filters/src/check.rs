use super::data::{Input, Output};
use super::fill::intersections_line;
use super::filter::{Filter, FilterBody};
use super::report::{BOUNDARY_EDGE, EDGE, FACE, Noun, PIECE, Report, ReportValue, VERTEX, count_with_noun};
use super::signatures::{ONE_MESH, TO_TEXT};
use super::typed_param::{LISTED_COUNT_RANGE, Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::check::{Check, check, find_intersecting_faces};

pub(super) const FILTER: Filter = Filter {
    id: "check",
    name: "Check the mesh",
    category: "Repair",
    help: "Reports every defect of a mesh with the numbers of the elements: boundary edges, edges of three or more faces, \
           non-manifold vertices, inconsistently oriented, duplicate, degenerate and zero-area faces, unused vertices; and the \
           number of components, the Euler characteristic and the genus. On request it reports faces that intersect each other.",
    reference: "Counts on half-edges; genus by Euler's formula; J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast \
                robust geometric predicates (1997), for intersections",
    ..Filter::new(ONE_MESH, TO_TEXT, &FilterBody(run))
};

params! {
    listed: u32 =
        Param::int("Elements listed", "The largest number of elements listed for each kind of defect.", LISTED_COUNT_RANGE, &[20.0]);
    intersections: bool = Param::flag(
        "Intersections",
        "Also finds the pairs of faces that intersect or touch each other elsewhere than in common vertices and edges.",
    );
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let found = check(mesh, &job.sub_job(0.0, if values.intersections { 0.5 } else { 1.0 }))?;
    let mut text = check_summary(&found);
    let max = values.listed as usize;
    let faces = mesh.faces();
    let name = |kind: usize, element: u32| match kind {
        // Edges are named by their ends, vertices and faces by their numbers.
        0..EDGE_DEFECT_KIND_COUNT => format!("{}-{}", faces.corner(element), faces.corner(faces.next(element))),
        _ => element.to_string(),
    };
    for (kind, (noun, _, elements)) in
        defect_kinds(&found).into_iter().enumerate().filter(|(_, defect)| !defect.2.is_empty())
    {
        text += &format!("{}:", count_with_noun(elements.len(), noun));
        elements.iter().take(max).for_each(|&element| text += &format!(" {}", name(kind, element)));
        text += if elements.len() > max { " ...\n" } else { "\n" };
    }
    let mut numbers = report_values(&found);
    if values.intersections {
        let pairs = find_intersecting_faces(mesh, &job.sub_job(0.5, 1.0))?;
        text += &intersecting_pairs_line(&pairs, max);
        numbers.push(("intersections", ReportValue::count(pairs.len())));
    }
    Ok(vec![Output::Text(Report::new(text, &numbers))])
}

/// The line on faces that intersect each other, with the first `max` pairs.
fn intersecting_pairs_line(pairs: &[[u32; 2]], max: usize) -> String {
    let line = intersections_line(Some(pairs));
    if pairs.is_empty() {
        return line;
    }
    let mut line = format!("{}:", line.trim_end());
    pairs.iter().take(max).for_each(|[f, g]| line += &format!(" {f}-{g}"));
    line + if pairs.len() > max { " ...\n" } else { "\n" }
}

/// The kinds of defects that are edges, the first ones.
const EDGE_DEFECT_KIND_COUNT: usize = 3;

/// Each kind of defect: its noun, its name for programs, and its elements.
fn defect_kinds(found: &Check) -> [(Noun, &'static str, &[u32]); 9] {
    [
        (BOUNDARY_EDGE, "boundary_edges", &found.boundary_edges),
        (
            ["edge of three or more faces", "edges of three or more faces"],
            "non_manifold_edges",
            &found.non_manifold_edges,
        ),
        (
            ["edge with inconsistently oriented faces", "edges with inconsistently oriented faces"],
            "orientation_conflicts",
            &found.orientation_conflicts,
        ),
        (["non-manifold vertex", "non-manifold vertices"], "non_manifold_vertices", &found.non_manifold_vertices),
        (["vertex with several fans of faces", "vertices with several fans of faces"], "bow_ties", &found.bow_ties),
        (["duplicate face", "duplicate faces"], "duplicate_faces", &found.duplicate_faces),
        (["face with a repeated vertex", "faces with a repeated vertex"], "degenerate_faces", &found.degenerate_faces),
        (["face without area", "faces without area"], "zero_area_faces", &found.zero_area_faces),
        (["unused vertex", "unused vertices"], "unused_vertices", &found.unused_vertices),
    ]
}

fn check_summary(found: &Check) -> String {
    let yes = |is: bool, word: &'static str, other: &'static str| if is { word } else { other };
    let genus = found.genus.map_or(String::new(), |genus| format!(", genus {genus}"));
    format!(
        "{}, {}, {}, {}, {}\n{}, {}, {}\nEuler characteristic {}{genus}\n",
        count_with_noun(found.vertices, VERTEX),
        count_with_noun(found.edges, EDGE),
        count_with_noun(found.faces, FACE),
        count_with_noun(found.components, PIECE),
        count_with_noun(found.boundary_walks, ["walk round the boundary", "walks round the boundary"]),
        yes(found.closed, "closed", "not closed"),
        yes(found.manifold, "manifold", "not manifold"),
        match (found.oriented, found.orientable) {
            (true, _) => "oriented",
            (false, true) => "not oriented, but orientable by reversing faces",
            (false, false) => "one-sided",
        },
        found.euler
    )
}

fn report_values(found: &Check) -> Vec<(&'static str, ReportValue)> {
    let mut values = vec![
        ("vertices", ReportValue::count(found.vertices)),
        ("edges", ReportValue::count(found.edges)),
        ("faces", ReportValue::count(found.faces)),
        ("pieces", ReportValue::count(found.components)),
        ("boundary_walks", ReportValue::count(found.boundary_walks)),
        ("closed", ReportValue::flag(found.closed)),
        ("manifold", ReportValue::flag(found.manifold)),
        ("oriented", ReportValue::flag(found.oriented)),
        ("orientable", ReportValue::flag(found.orientable)),
        ("euler_characteristic", ReportValue::count(found.euler)),
    ];
    values.extend(found.genus.map(|genus| ("genus", ReportValue::count(genus))));
    values.extend(defect_kinds(found).map(|(_, name, elements)| (name, ReportValue::count(elements.len()))));
    values
}
