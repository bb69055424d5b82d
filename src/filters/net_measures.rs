use super::prelude::*;
use super::quads::{self, CATEGORY};
use crate::net::complex::Complex;
use crate::net::measure::{measure, moments, planarity};

pub(super) const FILTER: Filter = Filter {
    id: "net_measures",
    name: "Measure a quad grid",
    category: CATEGORY,
    help: "Measures a quad grid as a surface of bilinear patches: area, bounding box, planarity of the quads and topology; of a \
           closed one also volume, centroid and inertia tensor.",
    reference: "The divergence theorem on bilinear patches, with Gauss's points",
    params: &[Param::real("planarity", "Planarity limit", [0.0, 1.0], &[0.01])
        .help("Quads whose corners are farther from their mean plane, relative to the longer diagonal, are counted.")],
    ..Filter::new(MESH, TO_TEXT, run)
};

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let net = quads::net(inputs[0].mesh()?, &job.part(0.0, 0.4))?;
    let measures = measure(&net, &job.part(0.4, 0.5))?;
    let plane = planarity(&net, values.number("planarity"), &job.part(0.5, 0.6))?;
    let complex = Complex::of_topology(net.topology(), &job.part(0.6, 0.8))?;
    let show = |p: DVec3| format!("({} {} {})", p.x, p.y, p.z);
    let sided = if complex.orientable { "two-sided" } else { "one-sided" };
    let mut text = format!(
        "{} rows, {} columns of vertices\n{sided}, Euler characteristic {}, {} boundary loops\narea {}, box {} to {}\n\
         {} quads off their planes by more than the limit, mean {:.3e}, most {:.3e} (face {})\n",
        net.shape().rows(),
        net.shape().columns(),
        complex.euler_characteristic(),
        complex.boundary.len(),
        measures.area,
        show(measures.low),
        show(measures.high),
        plane.above,
        plane.mean,
        plane.worst.map_or(0.0, |worst| worst.0),
        plane.worst.map_or(0, |worst| worst.1)
    );
    if complex.is_closed() && complex.orientable {
        let body = moments(&net, &job.part(0.8, 1.0))?;
        let [x, y, z] = [0, 1, 2].map(|k| show(body.inertia.col(k)));
        text += &format!("volume {}, centre {}\ninertia {x} {y} {z}\n", body.volume, show(body.centroid));
    }
    Ok(vec![Output::Text(text)])
}
