use super::prelude::*;
use crate::check::{Check, check};
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "check",
    name: "Check the mesh",
    category: "Repair",
    help: "Reports every defect of a mesh with the numbers of the elements: boundary edges, edges of three or more faces, \
           non-manifold vertices, inconsistently oriented, duplicate, degenerate and zero-area faces, unused vertices; and the \
           number of components, the Euler characteristic and the genus.",
    reference: "Counts on half-edges; genus by Euler's formula",
    params: &[Param::int("listed", "Elements listed", [0.0, 1e6], &[20.0])
        .help("The largest number of elements that are listed for each kind of defect.")],
    ..Filter::new(MESH, TO_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let found = check(mesh, job)?;
    let mut text = summary(&found);
    let max = values.number("listed") as usize;
    let faces = mesh.faces();
    let edge = |h: u32| format!("{}-{}", faces.corner(h), faces.corner(faces.next(h)));
    // Edges are named by their ends, vertices and faces by their numbers.
    let edges: [(&str, &[u32]); 3] = [
        ("edges of one face", &found.boundary_edges),
        ("edges of three or more faces", &found.non_manifold_edges),
        ("edges with inconsistently oriented faces", &found.orientation_conflicts),
    ];
    let others: [(&str, &[u32]); 6] = [
        ("non-manifold vertices", &found.non_manifold_vertices),
        ("vertices with several fans of faces", &found.bow_ties),
        ("duplicate faces", &found.duplicate_faces),
        ("faces with a repeated vertex", &found.degenerate_faces),
        ("faces without area", &found.zero_area_faces),
        ("unused vertices", &found.unused_vertices),
    ];
    edges.iter().for_each(|(what, list)| push_defects(&mut text, what, list, max, edge));
    others.iter().for_each(|(what, list)| push_defects(&mut text, what, list, max, |element| element.to_string()));
    Ok(vec![Output::Text(text)])
}

/// Appends a line on a kind of defect, if there are any.
fn push_defects(text: &mut String, what: &str, elements: &[u32], max: usize, name: impl Fn(u32) -> String) {
    if !elements.is_empty() {
        let _ = write!(text, "{} {what}:", elements.len());
        elements.iter().take(max).for_each(|&element| *text += &format!(" {}", name(element)));
        *text += if elements.len() > max { " ...\n" } else { "\n" };
    }
}

fn summary(found: &Check) -> String {
    let yes = |is: bool, word: &'static str, other: &'static str| if is { word } else { other };
    let genus = found.genus.map_or(String::new(), |genus| format!(", genus {genus}"));
    format!(
        "{} vertices, {} edges, {} faces, {} pieces, {} boundary walks\n{}, {}, {}\nEuler characteristic {}{genus}\n",
        found.vertices,
        found.edges,
        found.faces,
        found.components,
        found.boundary_walks,
        yes(found.closed, "closed", "not closed"),
        yes(found.manifold, "manifold", "not manifold"),
        match (found.oriented, found.orientable) {
            (true, _) => "oriented",
            (false, true) => "not oriented, but faces can be turned over until it is",
            (false, false) => "one-sided",
        },
        found.euler
    )
}
