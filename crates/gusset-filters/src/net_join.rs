use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{NON_NEGATIVE, Param, Values};
use super::quads::{self, CATEGORY, TRIANGLES};
use super::report::counted;
use super::report::{COLUMN, ROW};
use super::signatures::{TO_MESH_TEXT, TWO_MESHES};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_net::{BridgeMode, Direction, JoinOptions, Replication, concatenate_all};

pub(super) const FILTER: Filter = Filter {
    id: "net_join",
    name: "Join quad grids",
    category: CATEGORY,
    help: "Joins quad grids side by side to one: the rows, or columns, of each follow those of the one before, with a row of new \
           quads between them, or welded. Smaller grids have rows replicated to fit.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, concatenation",
    max_inputs: 1 << 16,
    params: &[
        Param::choice("direction", "Direction", DIRECTIONS.texts)
            .with_help("The direction from each grid to the next."),
        Param::choice("bridge", "Between them", BridgeMode::CHOICES.texts)
            .with_help("The connection between two grids."),
        Param::length("tolerance", "Welding distance", NON_NEGATIVE, &[0.0])
            .with_help("The largest distance of vertices that are welded; 0 for equal positions."),
        Param::choice("sizes", "Different sizes", REPLICATIONS.texts)
            .with_help("The treatment of sides with different numbers of vertices."),
        Param::int("twist", "Twist", [0.0, u32::MAX as f64], &[0.0]).with_help(
            "The number of vertices by which closed sides of all grids but the first are rotated before joining.",
        ),
        Param { default: &[1.0], ..Param::flag("turn", "Flip") }
            .with_help("Flips grids of opposite orientation to the first along the side; otherwise the filter fails."),
        TRIANGLES,
    ],
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, run)
};

choices! {
    DIRECTIONS: Direction =
        Direction::Down => "Below", "Its rows follow the last row; a closed row is joined to a closed row by a tube.";
        Direction::Right => "Right", "Its columns follow the last column.";
}

choices! {
    REPLICATIONS: Option<Replication> =
        Some(Replication::Uniform) => "Repeat evenly", "Rows of the smaller grid are replicated evenly.";
        Some(Replication::First) => "Repeat the first", "Its first row is replicated.";
        Some(Replication::Last) => "Repeat the last", "Its last row is replicated.";
        None => "Refuse", "The filter fails.";
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let grids = inputs.iter().enumerate();
    let nets = alloc::try_collect(
        grids.map(|(k, grid)| quads::net(grid.mesh()?, &job.part(0.0, 0.5).share(k, inputs.len()))),
    )?;
    let options = JoinOptions {
        mode: values.choice("bridge", BridgeMode::CHOICES),
        tolerance: values.number("tolerance"),
        equalise: values.choice("sizes", REPLICATIONS),
        twist: values.number("twist") as u32,
        turn: values.is_set("turn"),
        ..JoinOptions::new(values.choice("direction", DIRECTIONS))
    };
    let all = alloc::collect(nets.iter())?;
    let joined = concatenate_all(&all, &options, &job.part(0.5, 0.7))?;
    let shape = joined.shape();
    let text = format!(
        "{} joined to {} and {}\n",
        counted(nets.len(), ["grid", "grids"]),
        counted(shape.rows(), ROW),
        counted(shape.columns(), COLUMN)
    );
    Ok(vec![Output::Mesh(quads::mesh(&joined, values, &job.part(0.7, 1.0))?, None), Output::Text(text.into())])
}
