use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, TRIANGLES};
use super::report::{COLUMN, ROW, count_with_noun};
use super::signatures::{TO_MESH_TEXT, TWO_MESHES};
use super::typed_param::{MAX_COUNT, NON_NEGATIVE_RANGE, Param, ParamValues, TypedParam, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::{alloc, choices};
use gusset_net::{BridgeMode, Direction, JoinOptions, Net, Replication, concatenate_all};

pub(super) const FILTER: Filter = Filter {
    id: "net_join",
    name: "Join quad grids",
    category: CATEGORY,
    help: "Joins quad grids side by side into one. The rows or columns of each grid follow the grid before it, after a row of \
           new quads or welded. Rows of smaller grids are replicated to fit.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, concatenation",
    max_inputs: 1 << 16,
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    direction: Direction = DIRECTION;
    bridge: BridgeMode = Param::choice("Between them", "The connection between two grids.", BridgeMode::CHOICES);
    tolerance: f64 = Param::length(
        "Welding distance",
        "The largest distance of vertices that are welded; 0 for equal positions.",
        NON_NEGATIVE_RANGE, &[0.0],
    );
    sizes: Option<Replication> = DIFFERENT_SIZES;
    twist: u32 = TWIST;
    turn: bool = TURN;
    triangles: bool = TRIANGLES;
}

/// Chooses the direction from each grid to the next.
pub(super) const DIRECTION: TypedParam<Direction> =
    Param::choice("Direction", "The direction from each grid to the next.", DIRECTIONS);

/// Chooses how smaller grids are enlarged; `None` refuses them.
pub(super) const DIFFERENT_SIZES: TypedParam<Option<Replication>> =
    Param::choice("Different sizes", "The treatment of sides with different numbers of vertices.", REPLICATIONS);

/// Rotates closed sides against each other.
pub(super) const TWIST: TypedParam<u32> = Param::int(
    "Twist",
    "The number of vertices by which closed sides of all grids except the first are rotated before joining.",
    [0.0, MAX_COUNT],
    &[0.0],
);

/// Turns grids of opposite orientation.
pub(super) const TURN: TypedParam<bool> = Param::flag(
    "Flip",
    "Flips grids of opposite orientation to the first along the side. Without it, the filter fails for such grids.",
)
.on_by_default();

choices! {
    DIRECTIONS: Direction =
        Direction::Down => "Below", "Its rows follow the last row. A tube joins two closed rows.";
        Direction::Right => "Right", "Its columns follow the last column.";
}

choices! {
    REPLICATIONS: Option<Replication> =
        Some(Replication::Uniform) => "Repeat evenly", "Rows of the smaller grid are replicated evenly.";
        Some(Replication::First) => "Repeat the first", "Its first row is replicated.";
        Some(Replication::Last) => "Repeat the last", "Its last row is replicated.";
        None => "Refuse", "The filter fails.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = JoinOptions {
        mode: values.bridge,
        tolerance: values.tolerance,
        equalise: values.sizes,
        twist: values.twist,
        turn: values.turn,
        ..JoinOptions::new(values.direction)
    };
    let joined = join_grids(inputs, &options, &job.sub_job(0.0, 0.7))?;
    let shape = joined.shape();
    let text = format!(
        "{} joined to {} and {}\n",
        count_with_noun(inputs.len(), ["grid", "grids"]),
        count_with_noun(shape.rows(), ROW),
        count_with_noun(shape.columns(), COLUMN)
    );
    Ok(vec![
        Output::Mesh(quads::mesh_of_net(&joined, values.triangles, &job.sub_job(0.7, 1.0))?, None),
        Output::Text(text.into()),
    ])
}

/// The quad grids joined to one net.
///
/// # Errors
/// The errors of [`concatenate_all`], and [`Error::NoGrid`](gusset_base::error::Error::NoGrid).
pub(super) fn join_grids(inputs: &[Input<'_>], options: &JoinOptions, job: &Job<'_>) -> Result<Net<'static>> {
    let grids = inputs.iter().enumerate();
    let nets =
        alloc::try_collect(grids.map(|(k, grid)| {
            quads::recognise_net(grid.mesh()?, &job.sub_job(0.0, 0.7).sub_job_of_item(k, inputs.len()))
        }))?;
    let all = alloc::collect(nets.iter())?;
    concatenate_all(&all, options, &job.sub_job(0.7, 1.0))
}
