use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{HIT, count_with_noun, format_short, format_short_point, push_line};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::Scheme;
use gusset_surface::line_intersection::{HitSelection, Line};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_line",
    name: "Intersections of a line with a smooth surface",
    category: CATEGORY,
    help: "Finds where a line or a ray intersects the smooth surface through the vertices of a quad grid. Each intersection is \
           a curve of one point; the report has its distance from the given point and the normal. No intersection is missed.",
    reference: REFERENCE,
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    point: DVec3 = Param::point(
        "Point",
        "A point on the line, or the origin of a ray. A point below the centre of the mesh is suggested.",
        &[0.0, 0.0, -1e3],
    ).suggested(|_, extent| Some(extent.centre().with_z(extent.low.z - 0.1 * extent.diagonal())));
    direction: DVec3 = Param::direction("Direction", "The direction of the line.");
    which: (bool, HitSelection) = Param::choice("Hits", "The intersections that are returned.", HITS);
}

choices! {
    /// Whether the line is a ray, and which of its intersections are returned.
    HITS: (bool, HitSelection) =
        (false, HitSelection::All) => "All of the line", "The intersections on both sides of the point.";
        (true, HitSelection::All) => "All of the ray", "The intersections from the point on.";
        (true, HitSelection::First) => "First of the ray", "The intersection nearest to the point.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.9))?;
    job.step(0.9, "line")?;
    let (is_ray, selection) = values.which;
    let line = if is_ray { Line::ray } else { Line::new }(values.point, values.direction);
    let hits = surface.line(&line, selection)?;
    let (mut points, mut text) = (Curves::without_curves(), format!("{}\n", count_with_noun(hits.len(), HIT)));
    for hit in &hits {
        points.add_curve([hit.point].into_iter(), false)?;
        let touches = if hit.tangent { ", touches" } else { "" };
        let (point, normal) = (format_short_point(hit.point), format_short_point(hit.normal));
        push_line!(text, "at {}: {point}, normal {normal}{touches}", format_short(hit.at));
    }
    Ok(vec![Output::Curves(points), Output::Text(text.into())])
}
