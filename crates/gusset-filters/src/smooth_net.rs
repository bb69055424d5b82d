use super::curve::{self, INTERPOLATION};
use super::data::{Input, InputKind, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::TO_MESH_TEXT;
use super::smooth::{self, CATEGORY, DEVIATION, MIN_PARTS_PER_SIDE, TRIANGLES};
use super::typed_param::{LENGTH_RANGE, Param, ParamValues, params};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::{Curve, CurveKind};
use gusset_surface::construct::CurveNet;
use gusset_surface::{Sheet, Surface};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_net",
    name: "Smooth surface through a curve network",
    category: CATEGORY,
    help: "Draws the smooth surface that contains all curves of a network, as a mesh. The first input has the curves across, \
           and a second input may have curves along. Each curve along meets all curves across. The curves may be listed in any \
           order. Curves across alone are skinned in the given order.",
    reference: "W. J. Gordon, Spline-blended surface interpolation through curve networks, 1969",
    min_inputs: 1,
    ..Filter::new(&[InputKind::Curves; 2], TO_MESH_TEXT, &FilterBody(run))
};

params! {
    between: Option<CurveKind> = INTERPOLATION;
    ring: bool = Param::flag(
        "Ring",
        "The first curve across follows the last one. Ignored if there are curves along, which determine it.",
    );
    // Curves may be apart by the rounding of their points.
    tolerance: f64 = Param::length(
        "Tolerance",
        "The largest distance of two curves where they meet. Both are moved to the middle.",
        LENGTH_RANGE, &[1e-6],
    ).with_size_ratio(1e-4);
    deviation: f64 = DEVIATION;
    parts: u32 = MIN_PARTS_PER_SIDE;
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let across = curve::fit_curves(inputs[0].curves()?, values.between, &job.sub_job(0.0, 0.1))?;
    let along = match inputs.get(1) {
        Some(given) => curve::fit_curves(given.curves()?, values.between, &job.sub_job(0.1, 0.2))?,
        None => Vec::new(),
    };
    let closed = [&across, &along].map(|curves| common_closedness(curves));
    let unfit = |input: u32| Error::InputUnfit { input, why: "all curves must be closed, or all open" };
    let [closed_across, closed_along] = [closed[0].ok_or(unfit(0))?, closed[1].ok_or(unfit(1))?];
    let ring = if along.is_empty() { values.ring } else { closed_along };
    let rows = alloc::collect(across.iter().map(Curve::view))?;
    let columns = alloc::collect(along.iter().map(Curve::view))?;
    let net =
        CurveNet { rows: &rows, columns: &columns, closed: [ring, closed_across], tolerance: Some(values.tolerance) };
    let sheet = Sheet::from_curves(&net, &job.sub_job(0.2, 0.5))?;
    let surface = Surface::new(vec![sheet], None, &job.sub_job(0.5, 0.6))?;
    let (mesh, report) =
        smooth::mesh_surface(&surface, (values.deviation, values.parts, values.triangles), &job.sub_job(0.6, 1.0))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(report)])
}

/// Returns true if all curves are closed, false if all are open, `None` if there are both.
fn common_closedness(curves: &[Curve]) -> Option<bool> {
    let closed = curves.iter().filter(|curve| curve.view().is_closed()).count();
    // A single point is a pole and counts as either.
    let open = curves.iter().filter(|curve| !curve.view().is_closed() && !curve.view().is_empty()).count();
    (closed == 0 || open == 0).then_some(closed > 0)
}
