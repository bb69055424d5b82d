use super::data::{Curves, Input, Output};
use super::extent::extent_of;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, Param, ParamKind, Values};
use super::report::HIT;
use super::report::{counted, push_line, short, short_point};
use super::signatures::{MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, REFERENCE, SCHEME};
use gusset_base::choice::Choice;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_surface::line_intersection::{HitSelection, Line};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_line",
    name: "Intersections of a line with a smooth surface",
    category: CATEGORY,
    help: "Finds where a line or a ray intersects the smooth surface through the vertices of a quad grid: a curve of one point for \
           each intersection, with its distance from the given point and the normal. None is missed.",
    reference: REFERENCE,
    params: &[
        SCHEME,
        Param::new(ParamKind::Point, "point", "Point", COORDINATES, &[0.0, 0.0, -1e3])
            .with_help("A point on the line, the origin of a ray; a point below the centre of the mesh is suggested."),
        Param::direction("direction", "Direction").with_help("The direction of the line."),
        Param::choice("which", "Hits", HITS).with_help("The intersections that are returned."),
    ],
    suggest: Some(suggest),
    ..Filter::new(MESH, TO_CURVES_TEXT, run)
};

const HITS: &[Choice] = &[
    Choice::new("All of the line", "On both sides of the point."),
    Choice::new("All of the ray", "From the point on."),
    Choice::new("First of the ray", "The one nearest to the point."),
];

fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(extent) = extent_of(inputs) {
        let point = extent.centre().with_z(extent.low.z - 0.1 * extent.diagonal());
        defaults.set("point", &point.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (point, direction) = (values.vector("point"), values.direction("direction")?);
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.9))?;
    job.step(0.9, "line")?;
    let (line, which) = match values.place("which") {
        0 => (Line::new(point, direction), HitSelection::All),
        1 => (Line::ray(point, direction), HitSelection::All),
        _ => (Line::ray(point, direction), HitSelection::First),
    };
    let hits = surface.line(&line, which)?;
    let (mut points, mut text) = (Curves::none(), format!("{}\n", counted(hits.len(), HIT)));
    for hit in &hits {
        points.add([hit.point].into_iter(), false)?;
        let touches = if hit.tangent { ", touches" } else { "" };
        let (point, normal) = (short_point(hit.point), short_point(hit.normal));
        push_line!(text, "at {}: {point}, normal {normal}{touches}", short(hit.at));
    }
    Ok(vec![Output::Curves(points), Output::Text(text.into())])
}
