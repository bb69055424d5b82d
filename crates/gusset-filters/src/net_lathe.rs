use super::curve::{self, INTERPOLATION};
use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::{QUAD, ROW, count_with_noun};
use super::signatures::{CURVES_ONLY, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_curve::ops::SampleSpacing;
use gusset_curve::{CurveKind, CurveView};
use gusset_net::primitive::{Primitive, Request};
use gusset_net::transform::{Affine, transform};

pub(super) const FILTER: Filter = Filter {
    id: "net_lathe",
    name: "Surface of revolution",
    category: CATEGORY,
    help: "Revolves a curve about an axis. The result is a quad grid whose rows are circles, with a pole where the curve meets \
           the axis. Only the height of each point along the axis and its distance from the axis count.",
    reference: REFERENCE,
    ..Filter::new(CURVES_ONLY, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    point: DVec3 = Param::point("Point of the axis", "A point on the axis of revolution.", &[0.0; 3])
        .suggested(|_, extent| Some(suggested_axis(extent).0));
    direction: DVec3 = Param::direction(
        "Direction of the axis",
        "The direction of the axis. The surface runs counter-clockwise about it.",
    ).suggested(|_, extent| Some(suggested_axis(extent).1));
    columns: u32 = Param::int("Columns", "The number of quads around the axis.", [3.0, 100_000.0], &[64.0]);
    rows: u32 = Param::int(
        "Rows",
        "The number of rows at equal arc lengths of the curve; 0 takes the given points.",
        [0.0, 100_000.0], &[0.0],
    );
    between: Option<CurveKind> = INTERPOLATION;
    triangles: bool = TRIANGLES;
}

/// The coordinate axis along the longest side of the curve's box: its point nearest to the box, and
/// its direction.
fn suggested_axis(extent: &Aabb) -> (DVec3, DVec3) {
    let size = extent.size();
    let axis = if size.z >= size.x && size.z >= size.y { 2 } else { usize::from(size.y >= size.x) };
    let mut point = DVec3::ZERO;
    point[axis] = DVec3::ZERO.clamp(extent.low, extent.high)[axis];
    (point, DVec3::AXES[axis])
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let (origin, axis) = (values.point, values.direction);
    let curves = curve::fit_curves(inputs[0].curves()?, values.between, &job.sub_job(0.0, 0.1))?;
    let [curve] = curves.as_slice() else {
        return Err(Error::CurveCount { input: 0, given: curves.len() as u64, needed: "one" });
    };
    let curve = curve.view();
    if curve.is_empty() {
        return Err(Error::EmptyCurve);
    }
    let mut points = match values.rows as usize {
        0 => curve_joints(&curve)?,
        rows => {
            let count = rows.max(if curve.is_closed() { 3 } else { 2 });
            curve.sample_points(SampleSpacing::Count(count), &job.sub_job(0.1, 0.2))?.points
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
    let request =
        Request { columns: values.columns as usize + 1, ..Request::new(Primitive::Lathe { profile: &profile }) };
    let mut net = request.build_net(&job.sub_job(0.2, 0.5))?;
    let (u, v) = axis.any_orthonormal_pair();
    let rows = [0, 1, 2].map(|k| [u[k], v[k], axis[k], origin[k]]);
    transform(&mut net, &Affine::new(rows)?, &job.sub_job(0.5, 0.6))?;
    let text = format!(
        "{} of {}\n",
        count_with_noun(net.shape().rows() - 1, ROW),
        count_with_noun(net.shape().columns() - 1, QUAD)
    );
    Ok(vec![
        Output::Mesh(quads::mesh_of_net(&net, values.triangles, &job.sub_job(0.6, 1.0))?, None),
        Output::Text(text.into()),
    ])
}

/// The joints between segments, and both ends of an open curve.
fn curve_joints(curve: &CurveView<'_>) -> Result<Vec<DVec3>> {
    let ends = &curve.ends()[..curve.ends().len() - usize::from(curve.is_closed())];
    alloc::collect(ends.iter().map(|&end| curve.points()[end as usize]))
}
