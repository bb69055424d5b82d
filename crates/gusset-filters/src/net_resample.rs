use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::{COLUMN, ROW, count_with_noun};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::job::Job;
use gusset_net::resample::{Interpolation, resample};

/// The range of the numbers of rows and columns.
const LINE_COUNT_RANGE: [f64; 2] = [2.0, 100_001.0];

pub(super) const FILTER: Filter = Filter {
    id: "net_resample",
    name: "Resample a quad grid",
    category: CATEGORY,
    help: "Resamples a quad grid to other numbers of rows and columns, evenly spaced over the old ones. Closed sides and poles \
           are kept.",
    reference: REFERENCE,
    replaces: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    rows: u32 = Param::int(
        "Rows",
        "The number of rows of vertices. The suggestion keeps about the same number of vertices.",
        LINE_COUNT_RANGE, &[33.0],
    ).suggested(suggested_count);
    columns: u32 = Param::int(
        "Columns",
        "The number of columns of vertices. In closed rows the last vertex repeats the first.",
        LINE_COUNT_RANGE, &[65.0],
    ).suggested(suggested_count);
    interpolation: Interpolation =
        Param::choice("Interpolation", "The interpolation between the old vertices.", Interpolation::CHOICES);
    triangles: bool = TRIANGLES;
}

/// The square root of the number of vertices: the direction of rows is known only once the grid is
/// recognised.
fn suggested_count(inputs: &[Input<'_>], _: &Aabb) -> Option<f64> {
    match inputs.first() {
        Some(Input::Mesh(mesh)) => Some((mesh.positions().len() as f64).sqrt().round().max(5.0)),
        _ => None,
    }
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::recognise_net(inputs[0].mesh()?, &job.sub_job(0.0, 0.4))?;
    let [rows, columns] = [values.rows, values.columns].map(|count| count as usize);
    let made = resample(&net, rows, columns, values.interpolation, &job.sub_job(0.4, 0.7))?;
    let shape = net.shape();
    let text = format!(
        "{} and {} made {rows} and {columns}\n",
        count_with_noun(shape.rows(), ROW),
        count_with_noun(shape.columns(), COLUMN)
    );
    Ok(vec![
        Output::Mesh(quads::mesh_of_net(&made, values.triangles, &job.sub_job(0.7, 1.0))?, None),
        Output::Text(text.into()),
    ])
}
