use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::{BOUNDARY_LOOP, EDGE, QUAD, Report, ReportValue, TRIANGLE, VERTEX, count_with_noun};
use super::signatures::TO_MESH_TEXT;
use super::typed_param::{LENGTH_RANGE, Param, ParamValues, params};
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_net::closure::{BoxKind, Cuboid};
use gusset_net::complex::Complex;
use gusset_net::primitive::{Primitive, Request};

/// The range of the numbers of rows and columns.
const LINE_COUNT_RANGE: [f64; 2] = [5.0, 10_001.0];

pub(super) const FILTER: Filter = Filter {
    id: "net_shape",
    name: "Standard shape as a quad grid",
    category: CATEGORY,
    help: "Makes a standard shape as a quad grid. Rows and columns of faces continue across its seams, and a side contracted to \
           a pole is one vertex.",
    reference: REFERENCE,
    ..Filter::new(&[], TO_MESH_TEXT, &FilterBody(run))
};

params! {
    shape: MakeShape = Param::choice("Shape", "The shape, about the z axis.", SHAPES);
    rows: u32 = Param::int("Rows", "The number of rows of nodes, from one pole or rim to the other.", LINE_COUNT_RANGE, &[33.0]);
    columns: u32 = Param::int(
        "Columns",
        "The number of columns of nodes. In closed rows the last node repeats the first.",
        LINE_COUNT_RANGE, &[65.0],
    );
    radius: f64 = Param::length("Radius", "The radius; for a torus, the radius of its centre line.", LENGTH_RANGE, &[1.0]);
    minor_radius: f64 =
        Param::length("Minor radius", "The radius of the tube of a torus, less than the radius.", LENGTH_RANGE, &[0.25]);
    height: f64 =
        Param::length("Height", "The height of tubes, cylinders, cones, prisms and pyramids.", LENGTH_RANGE, &[2.0]);
    triangles: bool = TRIANGLES;
    sides: u32 = Param::int(
        "Sides",
        "The number of sides of the base of prisms and pyramids, less than the number of columns.",
        [3.0, 10_000.0], &[6.0],
    );
}

/// The shape that the parameters give.
type MakeShape = fn(&Params) -> Primitive<'static>;

choices! {
    SHAPES: MakeShape =
        |values| Primitive::Sphere { radius: values.radius } => "Sphere", "Meridians and parallels, with two poles.";
        |values| Primitive::OnePoleSphere { radius: values.radius } => "One-pole sphere",
            "A disc whose rim is contracted to the lowest point.";
        |values| Primitive::Plane { size: [2.0 * values.radius; 2] } => "Plane",
            "A square with sides of twice the radius, seen from above.";
        |values| Primitive::Tube { radius: values.radius, height: values.height } => "Tube", "A cylinder without caps.";
        |values| Primitive::Cylinder { radius: values.radius, height: values.height } => "Cylinder",
            "A cylinder with caps.";
        |values| Primitive::Cone { radius: values.radius, height: values.height } => "Cone", "A cone with its base.";
        |values| Primitive::Torus { radius: values.radius, minor_radius: values.minor_radius } => "Torus",
            "A torus; its tube has the minor radius.";
        |values| {
            let cuboid = Cuboid { cells: [values.rows - 1; 3], kind: BoxKind::Slit };
            Primitive::Cuboid { cuboid, size: [2.0 * values.radius; 3] }
        } => "Cube", "A cube with sides of twice the radius. Each face has one row of quads fewer than the number of rows.";
        |values| Primitive::Moebius { radius: values.radius, width: values.minor_radius } => "Moebius strip",
            "A one-sided strip, as wide as the minor radius.";
        |values| Primitive::Klein { radius: values.radius, minor_radius: values.minor_radius } => "Klein bottle",
            "A closed one-sided surface, which intersects itself.";
        |values| Primitive::Prism { sides: values.sides, radius: values.radius, height: values.height } => "Prism",
            "A right prism over a regular polygon, with caps.";
        |values| Primitive::Pyramid { sides: values.sides, radius: values.radius, height: values.height } => "Pyramid",
            "A right pyramid over a regular polygon, with its base.";
        |values| Primitive::ProjectivePlane { radius: values.radius } => "Projective plane",
            "Boy's surface: closed, one-sided, and intersecting itself.";
        |values| Primitive::Pillow { size: [2.0 * values.radius; 2], thickness: values.minor_radius } => "Pillow",
            "Two square sheets with sides of twice the radius, joined along their rims and as thick as the minor radius. The \
             number of columns must be odd.";
}

fn run(_: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let [rows, columns] = [values.rows, values.columns].map(|count| count as usize);
    let request = Request { rows, columns, ..Request::new((values.shape)(values)) };
    let net = request.build_net(&job.sub_job(0.0, 0.5))?;
    let complex = Complex::from_topology(net.topology(), &job.sub_job(0.5, 0.7))?;
    let mesh = quads::mesh_of_net(&net, values.triangles, &job.sub_job(0.7, 1.0))?;
    let text = format!(
        "{}, {}, {}, {}\nEuler characteristic {}, {}\n",
        count_with_noun(complex.vertices, VERTEX),
        count_with_noun(complex.edges, EDGE),
        count_with_noun(complex.quads, QUAD),
        count_with_noun(complex.triangles, TRIANGLE),
        complex.euler_characteristic(),
        count_with_noun(complex.boundary.len(), BOUNDARY_LOOP)
    );
    let values = [
        ("vertices", ReportValue::count(complex.vertices)),
        ("edges", ReportValue::count(complex.edges)),
        ("quads", ReportValue::count(complex.quads)),
        ("triangles", ReportValue::count(complex.triangles)),
        ("euler_characteristic", ReportValue::count(complex.euler_characteristic())),
        ("boundary_loops", ReportValue::count(complex.boundary.len())),
    ];
    Ok(vec![Output::Mesh(mesh, None), Output::Text(Report::new(text, &values))])
}
