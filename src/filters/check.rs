//! The filter `check`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Param, ParamKind, Values};
use crate::check::{Check, check};
use crate::error::Result;
use crate::job::Job;
use std::fmt::Write;

pub(super) const FILTER: Filter = Filter {
    id: "check",
    name: "Check the mesh",
    script_name: "check",
    category: "Repair",
    help: "Says everything that is wrong or unusual in a mesh, with the numbers of the elements: borders, edges of three or more faces, \
           vertices whose faces fall apart, faces against their neighbours, doubled, degenerate and flat ones, unused vertices; and \
           pieces, Euler characteristic and genus.",
    reference: "Counts on half-edges; genus by Euler's formula",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Text],
    replaces: false,
    params: &[Param::new(
        "listed",
        "Elements listed",
        "How many elements of each kind of fault are named, at most.",
        ParamKind::Int,
        [0.0, 1e6],
        &[20.0],
    )],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let found = check(mesh, job)?;
    let mut text = summary(&found);
    let most = values.number("listed") as usize;
    let faces = mesh.faces();
    let edge = |h: u32| format!("{}-{}", faces.corner(h), faces.corner(faces.next(h)));
    // Edges are named by their ends, vertices and faces by their numbers.
    let edges: [(&str, &[u32]); 3] = [
        ("edges of one face", &found.boundary_edges),
        ("edges of three or more faces", &found.non_manifold_edges),
        ("edges that both faces run the same way", &found.orientation_conflicts),
    ];
    let others: [(&str, &[u32]); 6] = [
        ("vertices that are not manifold", &found.non_manifold_vertices),
        ("vertices whose faces fall apart", &found.bow_ties),
        ("faces that are there already", &found.duplicate_faces),
        ("faces that pass a vertex twice", &found.degenerate_faces),
        ("faces without area", &found.zero_area_faces),
        ("vertices without faces", &found.unused_vertices),
    ];
    edges.iter().for_each(|(what, list)| enter(&mut text, what, list, most, edge));
    others.iter().for_each(|(what, list)| enter(&mut text, what, list, most, |element| element.to_string()));
    Ok(vec![Output::Text(text)])
}

/// A line of the report for a kind of fault that there is.
fn enter(text: &mut String, what: &str, elements: &[u32], most: usize, name: impl Fn(u32) -> String) {
    if !elements.is_empty() {
        // Writing to a string cannot fail.
        let _ = write!(text, "{} {what}:", elements.len());
        elements.iter().take(most).for_each(|&element| *text += &format!(" {}", name(element)));
        *text += if elements.len() > most { " ...\n" } else { "\n" };
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
