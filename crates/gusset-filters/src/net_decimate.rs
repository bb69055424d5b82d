use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{NON_NEGATIVE, Param, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::resample::decimate;

pub(super) const FILTER: Filter = Filter {
    id: "net_decimate",
    name: "Decimate a quad grid",
    category: CATEGORY,
    help: "Removes rows and columns of a quad grid as long as the surface hardly changes, always the one of least cost. The \
           remaining vertices stay where they were.",
    reference: REFERENCE,
    replaces: true,
    has_origins: true,
    params: &[
        Param::length("tolerance", "Tolerance", NON_NEGATIVE, &[1e-3])
            .with_help(
                "The largest distance of removed vertices from the segments that replace them; a thousandth of the size is \
                 suggested.",
            )
            .with_size_ratio(1e-3),
        TRIANGLES,
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let input = inputs[0].mesh()?;
    let grid = quads::grid(input, &job.part(0.0, 0.4))?;
    let net = &grid.net;
    let made = decimate(net, values.number("tolerance"), &job.part(0.4, 0.8))?;
    let text = format!(
        "{} of {} rows and {} of {} columns kept, deviation {:.3e}\n",
        made.rows.len(),
        net.shape().rows(),
        made.columns.len(),
        net.shape().columns(),
        made.deviation
    );
    let lines = [&made.rows[..], &made.columns];
    Ok(vec![quads::output(&made.net, (input, &grid), lines, values, &job.part(0.8, 1.0))?, Output::Text(text.into())])
}
