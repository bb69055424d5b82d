//! The filter `displace`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put, rounded};
use super::param::{PLACES, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::error::Result;
use crate::job::Job;
use crate::net::field::displace;

pub(super) const FILTER: Filter = Filter {
    id: "displace",
    name: "Move along the normals",
    script_name: "displace",
    category: CATEGORY,
    help: "Moves every vertex of a grid of quads along the normal of the surface there, also at poles and across seams; vertices that \
           are one stay one.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh],
    replaces: true,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    Param::new(
        "distance",
        "Distance",
        "How far vertices are moved: outwards, or inwards if it is negative; suggested is a hundredth of the size.",
        ParamKind::Length,
        PLACES,
        &[0.01],
    ),
    TRIANGLES,
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "distance", &[rounded(0.01 * extent.diagonal())]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mut net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.5))?;
    displace(&mut net, values.number("distance"), &job.part(0.5, 0.7))?;
    Ok(vec![Output::Mesh(quads::mesh(&net, values, &job.part(0.7, 1.0))?)])
}
