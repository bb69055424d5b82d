use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY};
use super::report::{Report, ReportValue, count_with_noun, format_short};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::planarise::{PlanariseOptions, Planarised, planarise};

pub(super) const FILTER: Filter = Filter {
    id: "net_planarise",
    name: "Make the faces of a quad grid planar",
    category: CATEGORY,
    help: "Moves the vertices of a quad grid as little as possible until all faces are planar, as panels of glass or sheet \
           metal are. Failure to converge is not an error; the report tells it.",
    reference: "A. A. Deryagin, Modelling of 3D objects and scenes by tetragonal regular networks, closures; Y. Liu et al., \
                Geometric modeling with conical meshes and developable surfaces (2006)",
    replaces: true,
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    tolerance: f64 = Param::real(
        "Tolerance",
        "The largest distance of the corners of a face from their mean plane, relative to the diagonal of the bounding box. 0 \
         takes 1e-10, or 4e-7 for positions in single precision.",
        [0.0, 1.0], &[0.0],
    );
    keep_boundary: bool = Param::flag("Keep the boundary", "Vertices on the boundary keep their positions.");
    max_steps: u32 = Param::int("Most steps", "The largest number of steps.", [1.0, 1e6], &[100.0]);
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let input = inputs[0].mesh()?;
    let mut grid = quads::recognise_grid(input, &job.sub_job(0.0, 0.3))?;
    let options = PlanariseOptions {
        tolerance: values.tolerance,
        max_iterations: values.max_steps,
        keep_boundary: values.keep_boundary,
        fixed: &[],
    };
    let done = planarise(&mut grid.net, &options, &job.sub_job(0.3, 0.8))?;
    let [rows, columns] = [grid.net.shape().rows(), grid.net.shape().columns()].map(|count| alloc::collect(0..count));
    let made = quads::output_of_resampled_grid(
        &grid.net,
        (input, &grid),
        [&rows?, &columns?],
        (values, false),
        &job.sub_job(0.8, 1.0),
    )?;
    Ok(vec![made, Output::Text(report(&done))])
}

fn report(done: &Planarised) -> Report {
    let text = format!(
        "largest distance from a plane {} before, {} now{}\nlargest displacement {}, root mean square {}; {}\n",
        format_short(done.deviation_before),
        format_short(done.deviation_after),
        if done.converged { "" } else { ", more than the tolerance" },
        format_short(done.max_displacement),
        format_short(done.rms_displacement),
        count_with_noun(done.iterations, ["step", "steps"])
    );
    let values = [
        ("deviation_before", ReportValue::length(done.deviation_before)),
        ("deviation", ReportValue::length(done.deviation_after)),
        ("tolerance", ReportValue::length(done.tolerance)),
        ("largest_displacement", ReportValue::length(done.max_displacement)),
        ("root_mean_square_displacement", ReportValue::length(done.rms_displacement)),
        ("steps", ReportValue::count(done.iterations)),
        ("converged", ReportValue::flag(done.converged)),
    ];
    Report::new(text, &values)
}
