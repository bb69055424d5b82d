use super::data::{Curves, Input, InputKind, Output};
use super::filter::{Filter, FilterBody};
use super::report::{POINT, Report, ReportValue, distance_report};
use super::signatures::TO_CURVES_TEXT;
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use super::typed_param::{ParamValues, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Result};
use gusset_base::job::Job;
use gusset_surface::Scheme;

pub(super) const FILTER: Filter = Filter {
    id: "smooth_nearest",
    name: "Nearest points on a smooth surface",
    category: CATEGORY,
    help: "Finds the nearest point on the smooth surface through the vertices of a quad grid for each point of some curves. It \
           draws the segments between them and reports their lengths, and how many nearest points are not proven.",
    reference: REFERENCE,
    ..Filter::new(&[InputKind::Mesh, InputKind::Curves], TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let given = inputs[1].curves()?;
    given.polylines()?;
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let queries = alloc::collect(given.points.iter().map(|&point| DVec3::from(point)))?;
    let nearest = smooth::nearest_surface_points(&surface, &queries, Element::Query, &job.sub_job(0.4, 1.0))?;
    let mut ways = Curves::without_curves();
    for (&query, nearest) in queries.iter().zip(&nearest) {
        ways.add_curve([query, nearest.point].into_iter(), false)?;
    }
    let unproven = nearest.iter().filter(|nearest| !nearest.proven).count();
    let found = distance_report(POINT, nearest.iter().map(|nearest| nearest.distance));
    let text = format!("{found}{unproven} without proof\n");
    let values = [found.values(), &[("unproven", ReportValue::count(unproven))]].concat();
    Ok(vec![Output::Curves(ways), Output::Text(Report::new(text, &values))])
}
