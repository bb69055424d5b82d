//! The filter `orient`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, Values};
use crate::error::Result;
use crate::job::Job;
use crate::repair::orient::{Options, Oriented, Outward, orient};
use std::fmt::Write;

/// Components that the report lists one by one.
const LISTED: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "orient",
    name: "Orient faces",
    script_name: "orient",
    category: "Repair",
    help: "Turns faces over until neighbours agree which side is out, as few as possible in each piece. What has one side \
           only, such as a Moebius strip, stays as it is.",
    reference: "Breadth-first search across edges of two faces",
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: true,
    params: &[Param::choice(
        "outward",
        "Closed pieces",
        "Which way closed pieces face.",
        &[
            Choice { label: "As most faces", help: "The way that most of their faces have." },
            Choice { label: "Outwards", help: "Outwards, each by its own volume, also inside others." },
        ],
    )],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let outward = [Outward::Keep, Outward::Closed][values.chosen("outward")];
    let done = orient(inputs[0].mesh()?, &Options { outward }, job)?;
    let text = report(&done);
    Ok(vec![Output::Mesh(done.mesh), Output::Text(text)])
}

fn report(done: &Oriented) -> String {
    let mut text =
        format!("{} of {} faces turned over, {} pieces\n", done.turned_faces, done.turned.len(), done.components);
    for found in done.one_sided.iter().take(LISTED) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "the piece of face {} has one side only (half-edge {})", found.face, found.half_edge);
    }
    if done.one_sided.len() > LISTED {
        let _ = writeln!(text, "and {} more", done.one_sided.len() - LISTED);
    }
    text
}
