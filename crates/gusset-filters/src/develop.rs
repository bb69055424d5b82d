use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{Param, Values};
use super::report::FACE;
use super::report::{Report, counted, push_line};
use super::signatures::{MESH, TO_MESH_TEXT};
use gusset_attributes::Origins;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::develop::{Cuts, Developed, Distortion, Finish, Options, develop};

pub(super) const FILTER: Filter = Filter {
    id: "develop",
    name: "Develop into the plane",
    category: "Deformation",
    help: "Lays a surface out in the plane: the pattern to cut it from. What is no disc is opened along short paths. A surface that can \
           be unfolded keeps every length; any other one has the least distortion, without folds or overlaps. Darts lower it further.",
    reference: "Rabinovich, Poranne, Panozzo, Sorkine-Hornung 2017; Ben-Chen, Gotsman, Bunin 2008 for darts",
    has_origins: true,
    params: &[
        Param::choice("distortion", "Distortion", Distortion::CHOICES.texts)
            .with_help("The kind of distortion that is least."),
        Param::int("darts", "Darts", [0.0, 100.0], &[0.0])
            .with_help("The largest number of cuts from the border to where the curvature is."),
        Param::real("stretch", "Largest stretch", [1.0, 100.0], &[1.0])
            .with_help("Darts are made until no length changes by a larger factor; 1: all of them."),
    ],
    ..Filter::new(MESH, TO_MESH_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let stretch = values.number("stretch");
    let options = Options {
        distortion: values.choice("distortion", Distortion::CHOICES),
        cuts: Cuts::default(),
        max_darts: values.number("darts") as u32,
        max_stretch: (stretch > 1.0).then_some(stretch),
        max_iterations: 0,
    };
    let done = develop(inputs[0].mesh()?, &options, job)?;
    let report = report(&done);
    let origins = values.origins(|| Origins::from_developed(&done, &job.part(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Developed) -> Report {
    let all = |of: fn(&gusset_stitch::develop::Chart) -> f64| done.charts.iter().map(of).sum::<f64>();
    let (area, flat) = (all(|chart| chart.area), all(|chart| chart.flat_area));
    let exact = done.charts.iter().filter(|chart| chart.finish == Finish::Exact).count();
    let folds = all(|chart| f64::from(chart.folds));
    let overlaps = all(|chart| f64::from(chart.overlaps));
    let energy = all(|chart| chart.energy * chart.area) / area;
    let stretch = done.stretches.iter().fold([1.0f64; 2], |all, s| [all[0].max(s[0]), all[1].min(s[1])]);
    let mut text = format!(
        "{} in {} charts, {exact} of them exact; {} edges cut, {} darts\n",
        counted(done.stretches.len(), FACE),
        done.charts.len(),
        done.cut_edges.len(),
        done.darts
    );
    push_line!(
        text,
        "lengths change by factors from {:.4} to {:.4}, the area by {:.4}",
        stretch[1],
        stretch[0],
        flat / area
    );
    if folds + overlaps > 0.0 {
        push_line!(text, "{folds} triangles are turned over, {overlaps} pairs of edges overlap");
    }
    let values = [
        ("charts", done.charts.len() as f64),
        ("exact_charts", exact as f64),
        ("cut_edges", done.cut_edges.len() as f64),
        ("darts", f64::from(done.darts)),
        ("energy", energy),
        ("max_stretch", stretch[0]),
        ("min_stretch", stretch[1]),
        ("area", area),
        ("flat_area", flat),
        ("turned_triangles", folds),
        ("overlaps", overlaps),
    ];
    Report::new(text, &values)
}
