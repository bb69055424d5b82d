//! The filter `curve_nearest`.

use super::Filter;
use super::curve::{self, BETWEEN, CATEGORY, REFERENCE};
use super::data::{Curves, Input, InputKind, Output, OutputKind};
use super::distances;
use super::param::Values;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::outline::Curve;
use crate::outline::ops::nearest_of_any;
use glam::DVec3;

/// Points between two progress reports.
const STEP: usize = 1 << 16;

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
    let views = alloc::collect(curves.iter().map(Curve::view))?;
    let found = nearest_of_any(&views, &queries, &job.part(0.2, 0.9))?;
    let mut ways = Curves::none();
    for (k, (&query, (_, nearest))) in queries.iter().zip(&found).enumerate() {
        if k % STEP == 0 {
            job.step(0.9 + 0.1 * k as f64 / queries.len() as f64, "segments")?;
        }
        ways.add([query, nearest.point].into_iter(), false)?;
    }
    let text = distances::account("points", found.iter().map(|(_, nearest)| nearest.distance));
    Ok(vec![Output::Curves(ways), Output::Text(text)])
}
