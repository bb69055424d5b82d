use super::curve::{CATEGORY, CurvePlane, INTERPOLATION, PLANE, REFERENCE};
use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::{CURVES_ONLY, TO_TEXT};
use super::typed_param::{Param, ParamValues, PlaneValue, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::{CurveKind, CurveView};

pub(super) const FILTER: Filter = Filter {
    id: "curve_svg",
    name: "Curves as SVG paths",
    category: CATEGORY,
    help: "Writes plane curves as the data of SVG paths, one line for each curve. Numbers keep every bit. Smooth curves become \
           Bezier curves.",
    reference: REFERENCE,
    ..Filter::new(CURVES_ONLY, TO_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
    plane: PlaneValue = PLANE;
    downwards: bool = Param::flag("y downwards", "Negates the second coordinate, as y points down in SVG.");
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let flat = CurvePlane::new(values.plane);
    let curves = flat.fit_curves_in_plane(inputs[0].curves()?, values.between, &job.sub_job(0.0, 0.5))?;
    let mut text = String::new();
    for (c, curve) in curves.iter().enumerate() {
        let part = job.sub_job(0.5, 1.0).sub_job_of_item(c, curves.len());
        part.step(0.0, "writing a path")?;
        let path = match values.downwards {
            true => svg_path_with_y_down(&curve.view(), &part)?,
            false => curve.view().to_svg_path(&part)?,
        };
        let bytes = path.len() + 1;
        text.try_reserve(bytes).map_err(|_| Error::OutOfMemory { bytes: bytes as u64 })?;
        text += &path;
        text.push('\n');
    }
    Ok(vec![Output::Text(text.into())])
}

/// The path of a curve whose second coordinate grows downwards.
fn svg_path_with_y_down(curve: &CurveView<'_>, job: &Job<'_>) -> Result<String> {
    let points = alloc::collect(curve.points().iter().map(|p| DVec3::new(p.x, -p.y, p.z)))?;
    CurveView::new(&points, curve.ends(), curve.is_closed())?.to_svg_path(job)
}
