use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::net_join::{DIFFERENT_SIZES, DIRECTION, TURN, TWIST, join_grids};
use super::quads::{self, CATEGORY, TRIANGLES};
use super::report::{Report, ReportValue, count_with_noun, format_short};
use super::signatures::{TO_MESH_TEXT, TWO_MESHES};
use super::typed_param::{NON_NEGATIVE_RANGE, Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::settle::{SettleOptions, Settled, settle};
use gusset_net::{BridgeProperties, Direction, JoinOptions, Replication};

pub(super) const FILTER: Filter = Filter {
    id: "net_settle",
    name: "Join quad grids by elastic bridges",
    category: CATEGORY,
    help: "Joins quad grids side by side into one by bridges of several rows, and moves the rows of the bridges to the \
           equilibrium of their tension, elasticity and stiffness. The given grids keep their positions. A bridge between \
           closed sides is a tube, whose tension acts like a soap film. Failure to converge is not an error; the report tells \
           it.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, concatenation; H.-J. Schek, \
                The force density method for form finding (1974)",
    max_inputs: 1 << 16,
    ..Filter::new(TWO_MESHES, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    direction: Direction = DIRECTION;
    rows: u32 = Param::int("Rows", "The number of rows of new vertices in each bridge.", [1.0, 10_000.0], &[8.0]);
    tension: f64 = Param::real(
        "Tension",
        "The force in each line across a ribbon, or the force per length in a tube.",
        NON_NEGATIVE_RANGE, &[0.0],
    );
    elasticity: f64 = Param::real(
        "Elasticity",
        "The force that doubles the length of a line across a bridge.",
        NON_NEGATIVE_RANGE, &[0.0],
    );
    stiffness: f64 = Param::real(
        "Stiffness",
        "The bending stiffness of each line across a bridge, as force times squared length. Stiff lines leave the grids without \
         a kink.",
        NON_NEGATIVE_RANGE, &[1.0],
    );
    rest_ratio: f64 = Param::real(
        "Rest length",
        "The length of an unstressed bridge, as a multiple of its straight length. Only elastic bridges depend on it.",
        [1e-3, 1e3], &[1.0],
    );
    sizes: Option<Replication> = DIFFERENT_SIZES;
    twist: u32 = TWIST;
    turn: bool = TURN;
    max_steps: u32 = Param::int("Most steps", "The largest number of steps.", [1.0, 1e6], &[1000.0]);
    triangles: bool = TRIANGLES;
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let Params { tension, elasticity, stiffness, .. } = **values;
    let options = JoinOptions {
        equalise: values.sizes,
        twist: values.twist,
        turn: values.turn,
        properties: BridgeProperties { tension, elasticity, stiffness, user: 0 },
        rows: values.rows,
        ..JoinOptions::new(values.direction)
    };
    let mut net = join_grids(inputs, &options, &job.sub_job(0.0, 0.4))?;
    let options =
        SettleOptions { rest_ratio: values.rest_ratio, max_iterations: values.max_steps, ..SettleOptions::default() };
    let done = settle(&mut net, &options, &job.sub_job(0.4, 0.8))?;
    let made = quads::mesh_of_net(&net, values.triangles, &job.sub_job(0.8, 1.0))?;
    Ok(vec![Output::Mesh(made, None), Output::Text(report(&done))])
}

fn report(done: &Settled) -> Report {
    let energy = done.tension_energy + done.elastic_energy + done.bending_energy;
    let collapsed = match done.collapsed {
        0 => String::new(),
        count => format!("{} collapsed\n", count_with_noun(count, ["film", "films"])),
    };
    let text = format!(
        "{} settled, {} without forces; energy {} before, {} now\nlargest force left {}, largest displacement {}; {}{}\n{collapsed}",
        count_with_noun(done.settled, ["bridge", "bridges"]),
        done.idle,
        format_short(done.energy_before),
        format_short(energy),
        format_short(done.residual_force),
        format_short(done.max_displacement),
        count_with_noun(done.iterations, ["step", "steps"]),
        if done.converged { "" } else { ", not converged" }
    );
    let values = [
        ("settled_bridges", ReportValue::count(done.settled)),
        ("idle_bridges", ReportValue::count(done.idle)),
        ("energy_before", ReportValue::number(done.energy_before)),
        ("energy", ReportValue::number(energy)),
        ("tension_energy", ReportValue::number(done.tension_energy)),
        ("elastic_energy", ReportValue::number(done.elastic_energy)),
        ("bending_energy", ReportValue::number(done.bending_energy)),
        ("residual_force", ReportValue::number(done.residual_force)),
        ("largest_displacement", ReportValue::length(done.max_displacement)),
        ("steps", ReportValue::count(done.iterations)),
        ("converged", ReportValue::flag(done.converged)),
        ("collapsed_films", ReportValue::count(done.collapsed)),
    ];
    Report::new(text, &values)
}
