//! The filter `net_join`.

use super::Filter;
use super::data::{Input, InputKind, Output, OutputKind};
use super::param::{Choice, Param, ParamKind, Values};
use super::quads::{self, CATEGORY, TRIANGLES};
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::net::{BridgeMode, Direction, JoinOptions, Net, Replication, concatenate_all};

pub(super) const FILTER: Filter = Filter {
    id: "net_join",
    name: "Join grids of quads",
    script_name: "net_join",
    category: CATEGORY,
    help: "Joins grids of quads to one, side by side: the rows, or columns, of each follow those of the one before, and a row of new \
           quads lies between them, or they are welded. Smaller grids have rows repeated until they fit.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, concatenation",
    inputs: &[InputKind::Mesh, InputKind::Mesh],
    min_inputs: 2,
    max_inputs: 1 << 16,
    outputs: &[OutputKind::Mesh, OutputKind::Text],
    replaces: false,
    params: &[
        Param::choice(
            "direction",
            "Direction",
            "On which side of the first grid the next one lies.",
            &[
                Choice {
                    label: "Below",
                    help: "Its rows follow the last row; a closed row is joined to a closed row by a tube.",
                },
                Choice { label: "Right", help: "Its columns follow the last column." },
            ],
        ),
        Param::choice(
            "bridge",
            "Between them",
            "What lies between two grids.",
            &[
                Choice { label: "Quads", help: "A row of new quads joins them." },
                Choice { label: "Nothing", help: "They are in one mesh, but not joined." },
                Choice { label: "Weld", help: "Their sides lie on each other and become one." },
            ],
        ),
        Param::new(
            "tolerance",
            "Welding distance",
            "How far apart vertices that are welded may be; 0 for equal positions.",
            ParamKind::Length,
            [0.0, 1e15],
            &[0.0],
        ),
        Param::choice(
            "sizes",
            "Different sizes",
            "What becomes of sides with different numbers of vertices.",
            &[
                Choice {
                    label: "Repeat evenly",
                    help: "Rows of the smaller grid are repeated, spread over all of it.",
                },
                Choice { label: "Repeat the first", help: "Its first row is repeated." },
                Choice { label: "Repeat the last", help: "Its last row is repeated." },
                Choice { label: "Refuse", help: "The filter fails." },
            ],
        ),
        Param::new(
            "twist",
            "Twist",
            "By how many vertices closed sides of the grids but the first are turned before they are joined.",
            ParamKind::Int,
            [0.0, u32::MAX as f64],
            &[0.0],
        ),
        Param::new(
            "turn",
            "Turn over",
            "Grids whose faces run the other way round than those of the first are flipped along the side; else the filter fails.",
            ParamKind::Bool,
            [0.0, 1.0],
            &[1.0],
        ),
        TRIANGLES,
    ],
    suggest: None,
    run,
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mut nets: Vec<Net<'static>> = alloc::with_capacity(inputs.len())?;
    for (k, input) in inputs.iter().enumerate() {
        let part = job.part(0.5 * k as f64 / inputs.len() as f64, 0.5 * (k + 1) as f64 / inputs.len() as f64);
        nets.push(quads::net(input.mesh()?, &part)?);
    }
    let options = JoinOptions {
        mode: [BridgeMode::Keep, BridgeMode::Hide, BridgeMode::Weld][values.chosen("bridge")],
        tolerance: values.number("tolerance"),
        equalise: [Some(Replication::Uniform), Some(Replication::First), Some(Replication::Last), None]
            [values.chosen("sizes")],
        twist: values.number("twist") as u32,
        turn: values.is_set("turn"),
        ..JoinOptions::new([Direction::Down, Direction::Right][values.chosen("direction")])
    };
    let all = alloc::collect(nets.iter())?;
    let joined = concatenate_all(&all, &options, &job.part(0.5, 0.7))?;
    let shape = joined.shape();
    let text = format!("{} grids joined to {} rows and {} columns\n", nets.len(), shape.rows(), shape.columns());
    Ok(vec![Output::Mesh(quads::mesh(&joined, values, &job.part(0.7, 1.0))?), Output::Text(text)])
}
