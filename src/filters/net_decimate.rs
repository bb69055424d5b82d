use super::prelude::*;
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::net::resample::decimate;

pub(super) const FILTER: Filter = Filter {
    id: "net_decimate",
    name: "Decimate a quad grid",
    category: CATEGORY,
    help: "Removes rows and columns of a quad grid as long as the surface hardly changes, always the one of least cost. The \
           remaining vertices stay where they were.",
    reference: REFERENCE,
    replaces: true,
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
    let net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.4))?;
    let made = decimate(&net, values.number("tolerance"), &job.part(0.4, 0.8))?;
    let text = format!(
        "{} of {} rows and {} of {} columns kept, deviation {:.3e}\n",
        made.rows.len(),
        net.shape().rows(),
        made.columns.len(),
        net.shape().columns(),
        made.deviation
    );
    Ok(vec![Output::Mesh(quads::mesh(&made.net, values, &job.part(0.8, 1.0))?), Output::Text(text.into())])
}
