//! The filter `curve_nearest`.

use super::Filter;
use super::curve::{self, BETWEEN, CATEGORY, REFERENCE};
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::distances;
use super::param::Values;
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "curve_nearest",
    name: "Nearest points on curves",
    script_name: "curve_nearest",
    category: CATEGORY,
    help: "Finds for each point of the first curves the nearest point on any of the second ones, draws the ways there as segments, and \
           says how far the points are.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves, InputKind::Curves],
    min_inputs: 2,
    max_inputs: 2,
    outputs: &[OutputKind::Curves, OutputKind::Text],
    replaces: false,
    params: &[BETWEEN],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let from = inputs[0].curves()?;
    from.each()?;
    let curves = curve::curves(inputs[1].curves()?, values, &job.part(0.0, 0.2))?;
    let queries = alloc::collect(from.points.iter().map(|&point| DVec3::from(point)))?;
    let mut best = alloc::filled((f64::INFINITY, DVec3::ZERO), queries.len())?;
    let job = job.part(0.2, 1.0);
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(c as f64 / curves.len() as f64, (c + 1) as f64 / curves.len() as f64);
        let curve = curve.view();
        match curve.points() {
            [] => {}
            &[point] => {
                part.step(0.0, "nearest points")?;
                take(&mut best, queries.iter().map(|query| (query.distance(point), point)));
            }
            _ => take(&mut best, curve.nearest(&queries, &part)?.iter().map(|near| (near.distance, near.point))),
        }
    }
    if best.iter().any(|best| best.0 == f64::INFINITY) {
        return Err(Error::EmptyCurve);
    }
    let mut ways = Curves::none();
    for (&query, &(_, point)) in queries.iter().zip(&best) {
        ways.add([query, point].into_iter(), false)?;
    }
    let text = distances::account("points", best.iter().map(|best| best.0));
    Ok(vec![Output::Curves(ways), Output::Text(text)])
}

/// Keeps the nearer points.
fn take(best: &mut [(f64, DVec3)], found: impl Iterator<Item = (f64, DVec3)>) {
    for (best, found) in best.iter_mut().zip(found) {
        if found.0 < best.0 {
            *best = found;
        }
    }
}
