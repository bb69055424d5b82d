use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::moving::CATEGORY;
use super::report::{FACE, Report, ReportValue, count_with_noun, push_line};
use super::signatures::{ONE_MESH, TO_MESH_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_attributes::Origins;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_stitch::develop::{Cuts, Developed, Distortion, Finish, Options, develop};

pub(super) const FILTER: Filter = Filter {
    id: "develop",
    name: "Develop into the plane",
    category: CATEGORY,
    help: "Lays a surface out in the plane, as a pattern to cut it from. A surface that is not a disc is opened along short \
           paths. A developable surface keeps every length. Any other surface gets the least distortion, without folds or \
           overlaps. Darts reduce the distortion further.",
    reference: "Rabinovich, Poranne, Panozzo, Sorkine-Hornung 2017; Ben-Chen, Gotsman, Bunin 2008 for darts",
    has_origins: true,
    ..Filter::new(ONE_MESH, TO_MESH_TEXT, &FilterBody(run))
};

params! {
    distortion: Distortion = Param::choice("Distortion", "The kind of distortion to minimise.", Distortion::CHOICES);
    darts: u32 = Param::int(
        "Darts",
        "The largest number of darts: cuts from the border to places of large curvature.",
        [0.0, 100.0], &[0.0],
    );
    stretch: f64 = Param::real(
        "Largest stretch",
        "Darts are cut until no length changes by a larger factor; 1 cuts all of them.",
        [1.0, 100.0], &[1.0],
    );
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let options = Options {
        distortion: values.distortion,
        cuts: Cuts::default(),
        max_darts: values.darts,
        max_stretch: Some(values.stretch).filter(|&stretch| stretch > 1.0),
        max_iterations: 0,
    };
    let done = develop(inputs[0].mesh()?, &options, job)?;
    let report = report(&done);
    let origins = values.trace_origins(|| Origins::from_developed(&done, &job.sub_job(1.0, 1.0)))?;
    Ok(vec![Output::Mesh(done.mesh, origins), Output::Text(report)])
}

fn report(done: &Developed) -> Report {
    let all = |of: fn(&gusset_stitch::develop::Chart) -> f64| done.charts.iter().map(of).sum::<f64>();
    let (area, flat) = (all(|chart| chart.area), all(|chart| chart.flat_area));
    let exact = done.charts.iter().filter(|chart| chart.finish == Finish::Exact).count();
    let folds: u64 = done.charts.iter().map(|chart| u64::from(chart.folds)).sum();
    let overlaps: u64 = done.charts.iter().map(|chart| u64::from(chart.overlaps)).sum();
    let energy = all(|chart| chart.energy * chart.area) / area;
    let stretch = done.stretches.iter().fold([1.0f64; 2], |all, s| [all[0].max(s[0]), all[1].min(s[1])]);
    let mut text = format!(
        "{} in {} charts, {exact} of them without distortion; {} edges cut, {} darts\n",
        count_with_noun(done.stretches.len(), FACE),
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
    if folds + overlaps > 0 {
        push_line!(text, "{folds} triangles are inverted, {overlaps} pairs of edges overlap");
    }
    let values = [
        ("charts", ReportValue::count(done.charts.len())),
        ("exact_charts", ReportValue::count(exact)),
        ("cut_edges", ReportValue::count(done.cut_edges.len())),
        ("darts", ReportValue::count(done.darts)),
        ("energy", ReportValue::number(energy)),
        ("max_stretch", ReportValue::number(stretch[0])),
        ("min_stretch", ReportValue::number(stretch[1])),
        ("area", ReportValue::area(area)),
        ("flat_area", ReportValue::area(flat)),
        ("turned_triangles", ReportValue::count(folds)),
        ("overlaps", ReportValue::count(overlaps)),
    ];
    Report::new(text, &values)
}
