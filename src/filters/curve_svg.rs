//! The filter `curve_svg`.

use super::Filter;
use super::curve::{BETWEEN, CATEGORY, Flat, PLANE, REFERENCE, suggest_plane};
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Param, Values};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::CurveView;
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "curve_svg",
    name: "Curves as SVG paths",
    script_name: "curve_svg",
    category: CATEGORY,
    help: "Writes plane curves as the data of SVG paths, one line for each curve, with numbers that read back as they are. Smooth \
           curves are written as the Bezier curves that they are.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Text],
    replaces: false,
    params: PARAMS,
    suggest: Some(|inputs, values| suggest_plane(PARAMS, inputs, values)),
    run,
};

const PARAMS: &[Param] = &[
    BETWEEN,
    PLANE,
    Param::flag("downwards", "y downwards", "The second coordinate is turned over, as it grows downwards in SVG."),
];

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let flat = Flat::new(values)?;
    let curves = flat.curves(inputs[0].curves()?, values, &job.part(0.0, 0.5))?;
    let mut text = String::new();
    for (c, curve) in curves.iter().enumerate() {
        let part = job.part(0.5, 1.0).share(c, curves.len());
        part.step(0.0, "writing a path")?;
        let path = match values.is_set("downwards") {
            true => turned_over(&curve.view(), &part)?,
            false => curve.view().svg_path_cancellable(&part)?,
        };
        let bytes = path.len() + 1;
        text.try_reserve(bytes).map_err(|_| Error::OutOfMemory { bytes: bytes as u64 })?;
        text += &path;
        text.push('\n');
    }
    Ok(vec![Output::Text(text)])
}

/// The path of a curve whose second coordinate grows downwards.
fn turned_over(curve: &CurveView<'_>, job: &Job<'_>) -> Result<String> {
    let points = alloc::collect(curve.points().iter().map(|p| DVec3::new(p.x, -p.y, p.z)))?;
    CurveView::new(&points, curve.ends(), curve.is_closed())?.svg_path_cancellable(job)
}
