use super::curve::{self, INTERPOLATION};
use super::data::{Input, Output};
use super::extent::extent_of;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::counted;
use super::report::{QUAD, ROW};
use super::signatures::{CURVES, TO_MESH_TEXT};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::CurveView;
use gusset_curve::ops::Spacing;
use gusset_net::primitive::{Primitive, Request};
use gusset_net::transform::{Affine, transform};

pub(super) const FILTER: Filter = Filter {
    id: "net_lathe",
    name: "Surface of revolution",
    category: CATEGORY,
    help: "Revolves a curve about an axis: a quad grid whose rows are closed circles, with a pole where the curve meets the axis. Of \
           each point of the curve its height along the axis and its distance from it are used.",
    reference: REFERENCE,
    params: &[
        Param::new(ParamKind::Point, "point", "Point of the axis", COORDINATES, &[0.0; 3])
            .with_help("A point on the axis of revolution."),
        Param::direction("direction", "Direction of the axis")
            .with_help("The direction of the axis; the surface runs counter-clockwise round it."),
        Param::int("columns", "Columns", [3.0, 100_000.0], &[64.0]).with_help("The number of quads round the axis."),
        Param::int("rows", "Rows", [0.0, 100_000.0], &[0.0])
            .with_help("The number of rows at equal arc lengths of the curve; 0 takes the given points."),
        INTERPOLATION,
        TRIANGLES,
    ],
    suggest: Some(suggest),
    ..Filter::new(CURVES, TO_MESH_TEXT, run)
};

/// The axis along the longest side of the curve's box, at its edge nearest to the origin.
fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(extent) = extent_of(inputs) {
        let size = extent.size();
        let axis = if size.z >= size.x && size.z >= size.y { 2 } else { usize::from(size.y >= size.x) };
        let near = DVec3::ZERO.clamp(extent.low, extent.high);
        defaults.set("direction", &DVec3::AXES[axis].to_array());
        // A coordinate axis if the curve lies on one side of it; else the edge of the box.
        let mut point = DVec3::ZERO;
        point[axis] = near[axis];
        defaults.set("point", &point.to_array());
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (origin, axis) = (values.vector("point"), values.direction("direction")?);
    let curves = curve::curves(inputs[0].curves()?, values, &job.part(0.0, 0.1))?;
    let [curve] = curves.as_slice() else {
        return Err(Error::InputUnfit { input: 0, why: "one curve is needed" });
    };
    let curve = curve.view();
    if curve.is_empty() {
        return Err(Error::EmptyCurve);
    }
    let mut points = match values.number("rows") as usize {
        0 => joints(&curve)?,
        rows => {
            let count = rows.max(if curve.is_closed() { 3 } else { 2 });
            curve.sampled(Spacing::Count(count), &job.part(0.1, 0.2))?.points
        }
    };
    if curve.is_closed() {
        // A closed profile repeats its first point.
        let first = points[0];
        alloc::push(&mut points, first)?;
    }
    let size = points.iter().fold(0.0f64, |size, point| size.max(point.distance(origin)));
    let profile = alloc::collect(points.iter().map(|&point| {
        let height = axis.dot(point - origin);
        let radius = (point - origin - height * axis).length();
        // Within rounding a point lies on the axis.
        [if radius <= 1e-12 * size { 0.0 } else { radius }, height]
    }))?;
    let request = Request {
        columns: values.number("columns") as usize + 1,
        ..Request::new(Primitive::Lathe { profile: &profile })
    };
    let mut net = request.net(&job.part(0.2, 0.5))?;
    let (u, v) = axis.any_orthonormal_pair();
    let rows = [0, 1, 2].map(|k| [u[k], v[k], axis[k], origin[k]]);
    transform(&mut net, &Affine::new(rows)?, &job.part(0.5, 0.6))?;
    let text = format!("{} of {}\n", counted(net.shape().rows() - 1, ROW), counted(net.shape().columns() - 1, QUAD));
    Ok(vec![Output::Mesh(quads::mesh(&net, values, &job.part(0.6, 1.0))?, None), Output::Text(text.into())])
}

/// The joints of segments, and both ends of an open curve.
fn joints(curve: &CurveView<'_>) -> Result<Vec<DVec3>> {
    let ends = &curve.ends()[..curve.ends().len() - usize::from(curve.is_closed())];
    alloc::collect(ends.iter().map(|&end| curve.points()[end as usize]))
}
