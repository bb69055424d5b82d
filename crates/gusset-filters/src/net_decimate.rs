use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{NON_NEGATIVE_RANGE, Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::resample::decimate;

pub(super) const FILTER: Filter = Filter {
    id: "net_decimate",
    name: "Decimate a quad grid",
    category: CATEGORY,
    help: "Removes rows and columns of a quad grid, always the one with the least deviation, up to a tolerance. The remaining \
           vertices keep their positions.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    tolerance: f64 = Param::length(
        "Tolerance",
        "The largest distance of removed vertices from the segments that replace them. A thousandth of the size is suggested.",
        NON_NEGATIVE_RANGE, &[1e-3],
    ).with_size_ratio(1e-3);
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let input = inputs[0].mesh()?;
    let grid = quads::recognise_grid(input, &job.sub_job(0.0, 0.4))?;
    let net = &grid.net;
    let made = decimate(net, values.tolerance, &job.sub_job(0.4, 0.8))?;
    let text = format!(
        "{} of {} rows and {} of {} columns kept, deviation {:.3e}\n",
        made.rows.len(),
        net.shape().rows(),
        made.columns.len(),
        net.shape().columns(),
        made.deviation
    );
    let lines = [&made.rows[..], &made.columns];
    Ok(vec![
        quads::output_of_resampled_grid(
            &made.net,
            (input, &grid),
            lines,
            (values, values.triangles),
            &job.sub_job(0.8, 1.0),
        )?,
        Output::Text(text.into()),
    ])
}
