//! The filter `net_resample`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::extent::put;
use super::param::{Choice, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use crate::error::Result;
use crate::job::Job;
use crate::net::resample::{Interpolation, resample};

pub(super) const FILTER: Filter = Filter {
    id: "net_resample",
    name: "Resample a grid of quads",
    script_name: "net_resample",
    category: CATEGORY,
    help: "Gives a grid of quads other numbers of rows and columns, spread evenly over the old ones. It stays closed where it is \
           closed, and poles stay poles.",
    reference: REFERENCE,
    inputs: &[InputKind::Mesh],
    min_inputs: 1,
    max_inputs: 1,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: true,
    params: PARAMS,
    suggest: Some(suggest),
    run,
};

const PARAMS: &[Param] = &[
    count("rows", "Rows", "The number of rows of vertices; suggested are about as many as there are.", &[33.0]),
    count(
        "columns",
        "Columns",
        "The number of columns of vertices; of closed rows the last vertex is the first again.",
        &[65.0],
    ),
    Param::choice(
        "interpolation",
        "Between the vertices",
        "How positions between the old vertices are found.",
        &[
            Choice {
                label: "Cubic",
                help: "On cubic splines along rows and columns, which pass through all vertices.",
            },
            Choice { label: "Bilinear", help: "On the bilinear patches of the quads." },
        ],
    ),
    TRIANGLES,
];

const fn count(id: &'static str, label: &'static str, help: &'static str, default: &'static [f64]) -> Param {
    Param::new(id, label, help, ParamKind::Int, [2.0, 100_001.0], default)
}

/// As many nodes as there are vertices, as many each way: which way rows run is known to the run
/// only.
fn suggest(inputs: &[Input<'_>], values: &mut [f64]) {
    if let Some(Input::Mesh(mesh)) = inputs.first() {
        let side = (mesh.positions().len() as f64).sqrt().round().clamp(5.0, 100_001.0);
        put(PARAMS, values, "rows", &[side]);
        put(PARAMS, values, "columns", &[side]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.4))?;
    let [rows, columns] = ["rows", "columns"].map(|id| values.number(id) as usize);
    let interpolation = [Interpolation::Bicubic, Interpolation::Bilinear][values.chosen("interpolation")];
    let made = resample(&net, rows, columns, interpolation, &job.part(0.4, 0.7))?;
    let shape = net.shape();
    let text = format!("{} rows and {} columns made {rows} and {columns}\n", shape.rows(), shape.columns());
    Ok(vec![Output::Mesh(quads::mesh(&made, values, &job.part(0.7, 1.0))?), Output::Text(text)])
}
