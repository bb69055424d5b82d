use super::curve::{self, INTERPOLATION};
use super::data::{Input, InputKind, Output};
use super::filter::Filter;
use super::param::{LENGTHS, Param, Values};
use super::signatures::TO_MESH_TEXT;
use super::smooth::{self, CATEGORY, FINENESS};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_curve::Curve;
use gusset_surface::construct::CurveNet;
use gusset_surface::{Sheet, Surface};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_net",
    name: "Smooth surface through a curve network",
    category: CATEGORY,
    help: "Draws the smooth surface that contains all curves of a network: curves across, and in a second input curves along, each of \
           which meets all of the first in their order. Curves across alone are skinned. The result is a mesh.",
    reference: "W. J. Gordon, Spline-blended surface interpolation through curve networks, 1969",
    min_inputs: 1,
    params: &[
        INTERPOLATION,
        Param::flag("ring", "Ring").with_help(
            "The last curve across is followed by the first; ignored with curves along, which determine it.",
        ),
        // The rounding of points may keep curves apart.
        Param::length("tolerance", "Tolerance", LENGTHS, &[1e-6])
            .with_help("The largest distance of curves where they meet; both are then moved to the middle.")
            .with_size_ratio(1e-4),
        FINENESS[0],
        FINENESS[1],
        FINENESS[2],
    ],
    ..Filter::new(&[InputKind::Curves; 2], TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let across = curve::curves(inputs[0].curves()?, values, &job.part(0.0, 0.1))?;
    let along = match inputs.get(1) {
        Some(given) => curve::curves(given.curves()?, values, &job.part(0.1, 0.2))?,
        None => Vec::new(),
    };
    let closed = [&across, &along].map(|curves| all_closed(curves));
    let unfit = |input: u32| Error::InputUnfit { input, why: "all curves must be closed, or all open" };
    let [closed_across, closed_along] = [closed[0].ok_or(unfit(0))?, closed[1].ok_or(unfit(1))?];
    let ring = if along.is_empty() { values.is_set("ring") } else { closed_along };
    let rows = alloc::collect(across.iter().map(Curve::view))?;
    let columns = alloc::collect(along.iter().map(Curve::view))?;
    let net = CurveNet {
        rows: &rows,
        columns: &columns,
        closed: [ring, closed_across],
        tolerance: Some(values.number("tolerance")),
    };
    let sheet = Sheet::from_curves(&net, &job.part(0.2, 0.5))?;
    let surface = Surface::new(vec![sheet], None, &job.part(0.5, 0.6))?;
    let (mesh, report) = smooth::meshed(&surface, values, &job.part(0.6, 1.0))?;
    Ok(vec![Output::Mesh(mesh, None), Output::Text(report)])
}

/// True if all curves are closed, false if all are open, `None` for both kinds.
fn all_closed(curves: &[Curve]) -> Option<bool> {
    let closed = curves.iter().filter(|curve| curve.view().is_closed()).count();
    // A point is a pole, closed or not.
    let open = curves.iter().filter(|curve| !curve.view().is_closed() && !curve.view().is_empty()).count();
    (closed == 0 || open == 0).then_some(closed > 0)
}
