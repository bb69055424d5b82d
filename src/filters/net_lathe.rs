//! The filter `net_lathe`.

use super::Filter;
use super::curve::{self, BETWEEN};
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::{extent_of, put};
use super::param::{PLACES, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::net::primitive::{Primitive, Request};
use crate::net::transform::{Affine, transform};
use crate::outline::CurveView;
use crate::outline::ops::Spacing;
use glam::DVec3;

pub(super) const FILTER: Filter = Filter {
    id: "net_lathe",
    name: "Surface of revolution",
    script_name: "net_lathe",
    category: CATEGORY,
    help: "Turns a curve round an axis: a grid of quads whose rows are circles, closed round, with a pole where the curve meets the \
           axis. Of each point its height along the axis and its distance from it are taken.",
    reference: REFERENCE,
    inputs: &[InputKind::Curves],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    Param::new("point", "Point of the axis", "The axis passes this point.", ParamKind::Point, PLACES, &[0.0; 3]),
    Param::new(
        "direction",
        "Direction of the axis",
        "The axis runs along this direction, and the surface round it counter-clockwise.",
        ParamKind::Direction,
        PLACES,
        &[0.0, 0.0, 1.0],
    ),
    Param::new("columns", "Columns", "The number of quads round the axis.", ParamKind::Int, [3.0, 100_000.0], &[64.0]),
    Param::new(
        "rows",
        "Rows",
        "The number of rows, at equal distances along the curve; 0 takes the points of the curve as they are.",
        ParamKind::Int,
        [0.0, 100_000.0],
        &[0.0],
    ),
    BETWEEN,
    TRIANGLES,
];

/// The axis is that of the curve's box: parallel to its longest side, at its edge next to the
/// origin.
fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(extent) = extent_of(inputs) {
        let size = extent.size();
        let axis = if size.z >= size.x && size.z >= size.y { 2 } else { usize::from(size.y >= size.x) };
        let near = DVec3::ZERO.clamp(extent.low, extent.high);
        put(PARAMS, values, "direction", &DVec3::AXES[axis].to_array());
        // A curve that keeps to one side of an axis of space turns round that; others round the
        // side of their box.
        let mut point = DVec3::ZERO;
        point[axis] = near[axis];
        put(PARAMS, values, "point", &point.to_array());
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
        // A profile that ends where it begins makes a ring.
        let first = points[0];
        alloc::push(&mut points, first)?;
    }
    let size = points.iter().fold(0.0f64, |size, point| size.max(point.distance(origin)));
    let profile = alloc::collect(points.iter().map(|&point| {
        let height = axis.dot(point - origin);
        let radius = (point - origin - height * axis).length();
        // What rounding leaves of a point on the axis.
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
    let text = format!("{} rows of {} quads\n", net.shape().rows() - 1, net.shape().columns() - 1);
    Ok(vec![Output::Mesh(quads::mesh(&net, values, &job.part(0.6, 1.0))?), Output::Text(text)])
}

/// The points where segments meet, and both ends of an open curve.
fn joints(curve: &CurveView<'_>) -> Result<Vec<DVec3>> {
    let ends = &curve.ends()[..curve.ends().len() - usize::from(curve.is_closed())];
    alloc::collect(ends.iter().map(|&end| curve.points()[end as usize]))
}
