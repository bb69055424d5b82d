use super::curve::{self, CATEGORY, INTERPOLATION, REFERENCE};
use super::data::{Curves, Input, InputKind, Output};
use super::filter::{Filter, FilterBody};
use super::report::{POINT, distance_report};
use super::signatures::TO_CURVES_TEXT;
use super::typed_param::{ParamValues, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_curve::ops::nearest_of_any;
use gusset_curve::{Curve, CurveKind};

/// Points between two progress reports.
const POINTS_PER_REPORT: usize = 1 << 16;

pub(super) const FILTER: Filter = Filter {
    id: "curve_nearest",
    name: "Nearest points on curves",
    category: CATEGORY,
    help: "Finds the nearest point on any curve of the second input for each point of the first. It draws the segments between \
           them and reports their lengths.",
    reference: REFERENCE,
    ..Filter::new(&[InputKind::Curves; 2], TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let from = inputs[0].curves()?;
    from.polylines()?;
    let curves = curve::fit_curves(inputs[1].curves()?, values.between, &job.sub_job(0.0, 0.2))?;
    let queries = alloc::collect(from.points.iter().map(|&point| DVec3::from(point)))?;
    let views = alloc::collect(curves.iter().map(Curve::view))?;
    let found = nearest_of_any(&views, &queries, &job.sub_job(0.2, 0.9))?;
    let (mut ways, drawing) = (Curves::without_curves(), job.sub_job(0.9, 1.0));
    for (k, (&query, (_, nearest))) in queries.iter().zip(&found).enumerate() {
        drawing.step_every(POINTS_PER_REPORT, k, queries.len(), "segments")?;
        ways.add_curve([query, nearest.point].into_iter(), false)?;
    }
    let report = distance_report(POINT, found.iter().map(|(_, nearest)| nearest.distance));
    Ok(vec![Output::Curves(ways), Output::Text(report)])
}
