//! The filter `smooth_nearest`.

use super::prelude::*;
use super::report::distances;
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use crate::error::Element;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_nearest",
    name: "Nearest points on a smooth surface",
    category: CATEGORY,
    help: "Finds for each point of curves the nearest point on the smooth surface through the vertices of a quad grid, with proof, \
           draws the segments between them, and reports their lengths.",
    reference: REFERENCE,
    params: &[SCHEME],
    ..Filter::new(&[InputKind::Mesh, InputKind::Curves], TO_CURVES_TEXT, run)
};

/// Points that are looked at between two chances to cancel, at most.
const ROUND: usize = 1 << 12;

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[1].curves()?;
    given.each()?;
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let queries = alloc::collect(given.points.iter().map(|&point| DVec3::from(point)))?;
    let (mut ways, mut all) = (Curves::none(), alloc::with_capacity(queries.len())?);
    let mut unproven = 0;
    let job = job.part(0.4, 1.0);
    for (k, round) in queries.chunks(ROUND).enumerate() {
        let end = |k: usize| (k * ROUND).min(queries.len()) as f64 / queries.len() as f64;
        let found = surface.closest_all(round, f64::INFINITY, &job.part(end(k), end(k + 1)))?;
        for (n, (&query, found)) in round.iter().zip(found).enumerate() {
            let bad =
                Error::NotFinite { element: Element::Query, index: (k * ROUND + n) as u64, value: query.element_sum() };
            let found = found.ok_or(bad)?;
            ways.add([query, found.point].into_iter(), false)?;
            all.push(found.distance);
            unproven += usize::from(!found.proven);
        }
    }
    let mut text = distances("points", all.into_iter());
    text += &format!("{unproven} without proof\n");
    Ok(vec![Output::Curves(ways), Output::Text(text)])
}
