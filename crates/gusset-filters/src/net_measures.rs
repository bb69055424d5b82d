use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY};
use super::report::{
    BOUNDARY_LOOP, COLUMN, QUAD, ROW, Report, ReportValue, count_with_noun, format_short, format_short_point,
};
use super::signatures::{ONE_MESH, TO_TEXT};
use super::typed_param::{Param, ParamValues, params};
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::complex::Complex;
use gusset_net::measure::{measure, moments, planarity};

pub(super) const FILTER: Filter = Filter {
    id: "net_measures",
    name: "Measure a quad grid",
    category: CATEGORY,
    help: "Measures a quad grid as a surface of bilinear patches: area, bounding box, planarity of the quads and topology. A \
           closed grid also has volume, centroid and inertia tensor.",
    reference: "The divergence theorem on bilinear patches, with Gauss points",
    ..Filter::new(ONE_MESH, TO_TEXT, &FilterBody(run))
};

params! {
    planarity: f64 = Param::real(
        "Planarity limit",
        "Counts the quads whose corners are farther than this from their mean plane, relative to the longer diagonal.",
        [0.0, 1.0], &[0.01],
    );
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::recognise_net(inputs[0].mesh()?, &job.sub_job(0.0, 0.4))?;
    let measures = measure(&net, &job.sub_job(0.4, 0.5))?;
    let plane = planarity(&net, values.planarity, &job.sub_job(0.5, 0.6))?;
    let complex = Complex::from_topology(net.topology(), &job.sub_job(0.6, 0.8))?;
    let sided = if complex.orientable { "two-sided" } else { "one-sided" };
    let mut text = format!(
        "{}, {} of vertices\n{sided}, Euler characteristic {}, {}\narea {}, box {} to {}\n\
         {} off the plane by more than the limit, mean {:.3e}, most {:.3e} (face {})\n",
        count_with_noun(net.shape().rows(), ROW),
        count_with_noun(net.shape().columns(), COLUMN),
        complex.euler_characteristic(),
        count_with_noun(complex.boundary.len(), BOUNDARY_LOOP),
        format_short(measures.area),
        format_short_point(measures.low),
        format_short_point(measures.high),
        count_with_noun(plane.above, QUAD),
        plane.mean,
        plane.worst.map_or(0.0, |worst| worst.0),
        plane.worst.map_or(0, |worst| worst.1)
    );
    let mut values = vec![
        ("rows", ReportValue::count(net.shape().rows())),
        ("columns", ReportValue::count(net.shape().columns())),
        ("euler_characteristic", ReportValue::count(complex.euler_characteristic())),
        ("boundary_loops", ReportValue::count(complex.boundary.len())),
        ("area", ReportValue::area(measures.area)),
    ];
    if complex.is_closed() && complex.orientable {
        let body = moments(&net, &job.sub_job(0.8, 1.0))?;
        let [x, y, z] = [0, 1, 2].map(|k| format_short_point(body.inertia.col(k)));
        let (volume, centre) = (format_short(body.volume), format_short_point(body.centroid));
        text += &format!("volume {volume}, centre {centre}\ninertia {x} {y} {z}\n");
        values.push(("volume", ReportValue::volume(body.volume)));
    }
    Ok(vec![Output::Text(Report::new(text, &values))])
}
