//! The filter `net_decimate`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put, rounded};
use super::param::{Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::error::Result;
use crate::job::Job;
use crate::net::resample::decimate;

pub(super) const FILTER: Filter = Filter {
    id: "net_decimate",
    name: "Thin out a grid of quads",
    script_name: "net_decimate",
    category: CATEGORY,
    help: "Leaves out rows and columns of a grid of quads as long as the surface hardly changes, always the one whose loss costs \
           least. What is left are vertices of the grid, where they were.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: true,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    Param::new(
        "tolerance",
        "Tolerance",
        "How far vertices that are left out may be from the segments that replace them; suggested is a thousandth of the size.",
        ParamKind::Length,
        [0.0, 1e15],
        &[1e-3],
    ),
    TRIANGLES,
];

fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        put(PARAMS, values, "tolerance", &[rounded(1e-3 * extent.diagonal())]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.4))?;
    let made = decimate(&net, values.number("tolerance"), &job.part(0.4, 0.8))?;
    let text = format!(
        "{} of {} rows and {} of {} columns kept, deviation {:.3e}\n",
        made.rows.len(),
        net.shape().rows(),
        made.columns.len(),
        net.shape().columns(),
        made.deviation
    );
    Ok(vec![Output::Mesh(quads::mesh(&made.net, values, &job.part(0.8, 1.0))?), Output::Text(text)])
}
