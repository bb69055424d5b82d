//! The filter `curve_measures`.

use super::Filter;
use super::curve::{self, BETWEEN, CATEGORY, REFERENCE};
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::Values;
use crate::error::Result;
use crate::job::Job;
use crate::outline::CurveView;
use glam::DVec3;
use std::fmt::Write;

/// Curves that the report lists one by one.
const LISTED: usize = 1000;

pub(super) const FILTER: Filter = Filter {
    id: "curve_measures",
    name: "Measure curves",
    script_name: "curve_measures",
    category: CATEGORY,
    help: "Measures curves: their lengths, their boxes, and what area they enclose, which for a curve that is not plane is that of \
           its largest shadow. An open curve is closed by its chord for that.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Text],
    replaces: false,
    params: &[BETWEEN],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let curves = curve::curves(inputs[0].curves()?, values, &job.part(0.0, 0.5))?;
    let (mut text, mut total) = (String::new(), 0.0);
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(0.5, 1.0).share(c, curves.len());
        part.step(0.0, "measuring curves")?;
        let curve = curve.view();
        let length = if curve.is_empty() { 0.0 } else { curve.lengths_cancellable(&part)?.total() };
        total += length;
        if c < LISTED {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "curve {c}: {}", line(&curve, length)?);
        }
    }
    if curves.len() > LISTED {
        let _ = writeln!(text, "and {} more", curves.len() - LISTED);
    }
    let _ = writeln!(text, "{} curves, length {total}", curves.len());
    Ok(vec![Output::Text(text)])
}

fn line(curve: &CurveView<'_>, length: f64) -> Result<String> {
    let kind = if curve.is_closed() { "closed" } else { "open" };
    if curve.points().is_empty() {
        return Ok(format!("{kind}, without points"));
    }
    let (area, bounds) = (curve.area_vector(), curve.bounding_box()?);
    let show = |p: DVec3| format!("({} {} {})", p.x, p.y, p.z);
    Ok(format!(
        "{kind}, length {length}, area {}, seen along {}, box {} to {}",
        area.length(),
        show(area.normalize_or_zero()),
        show(bounds.low),
        show(bounds.high)
    ))
}
