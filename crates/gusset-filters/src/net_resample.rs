use super::data::{Input, Output};
use super::filter::{Defaults, Filter};
use super::param::{Param, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::counted;
use super::report::{COLUMN, ROW};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::resample::{Interpolation, resample};

/// The range of the numbers of rows and columns.
const COUNTS: [f64; 2] = [2.0, 100_001.0];

pub(super) const FILTER: Filter = Filter {
    id: "net_resample",
    name: "Resample a quad grid",
    category: CATEGORY,
    help: "Resamples a quad grid to other numbers of rows and columns, evenly spaced over the old ones. Closed sides stay closed, \
           and poles stay poles.",
    reference: REFERENCE,
    replaces: true,
    params: &[
        Param::int("rows", "Rows", COUNTS, &[33.0])
            .with_help("The number of rows of vertices; about as many as now are suggested."),
        Param::int("columns", "Columns", COUNTS, &[65.0])
            .with_help("The number of columns of vertices; in closed rows the last vertex repeats the first."),
        Param::choice("interpolation", "Interpolation", Interpolation::CHOICES.texts)
            .with_help("The interpolation between the old vertices."),
        TRIANGLES,
    ],
    suggest: Some(suggest),
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

/// As many nodes as vertices, equally many each way: the direction of rows is known only once the
/// grid is recognised.
fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(Input::Mesh(mesh)) = inputs.first() {
        let side = (mesh.positions().len() as f64).sqrt().round().clamp(5.0, 100_001.0);
        defaults.set("rows", &[side]);
        defaults.set("columns", &[side]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.4))?;
    let [rows, columns] = ["rows", "columns"].map(|id| values.number(id) as usize);
    let interpolation = values.choice("interpolation", Interpolation::CHOICES);
    let made = resample(&net, rows, columns, interpolation, &job.part(0.4, 0.7))?;
    let shape = net.shape();
    let text =
        format!("{} and {} made {rows} and {columns}\n", counted(shape.rows(), ROW), counted(shape.columns(), COLUMN));
    Ok(vec![Output::Mesh(quads::mesh(&made, values, &job.part(0.7, 1.0))?, None), Output::Text(text.into())])
}
