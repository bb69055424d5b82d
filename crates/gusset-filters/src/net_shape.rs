use super::data::{Input, Output};
use super::filter::Filter;
use super::param::{LENGTHS, Param, Values};
use super::quads::{self, CATEGORY, REFERENCE, TRIANGLES};
use super::report::{BOUNDARY_LOOP, EDGE, QUAD, TRIANGLE, VERTEX};
use super::report::{Report, counted};
use super::signatures::TO_MESH_TEXT;
use gusset_base::choice::Choice;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_net::closure::{BoxKind, Cuboid};
use gusset_net::complex::Complex;
use gusset_net::primitive::{Primitive, Request};

/// The range of the numbers of rows and columns.
const COUNTS: [f64; 2] = [5.0, 10_001.0];

pub(super) const FILTER: Filter = Filter {
    id: "net_shape",
    name: "Standard shape as a quad grid",
    category: CATEGORY,
    help: "Makes a standard shape as a quad grid, closed by gluing: rows and columns of faces continue across its seams, and a side \
           contracted to a pole is one vertex.",
    reference: REFERENCE,
    params: &[
        Param::choice("shape", "Shape", SHAPES).with_help("The shape, round the z axis."),
        Param::int("rows", "Rows", COUNTS, &[33.0])
            .with_help("The number of rows of nodes, from one pole or rim to the other."),
        Param::int("columns", "Columns", COUNTS, &[65.0])
            .with_help("The number of columns of nodes; in closed rows the last node repeats the first."),
        Param::length("radius", "Radius", LENGTHS, &[1.0]).with_help("The radius; of a torus that of its centre line."),
        Param::length("minor_radius", "Minor radius", LENGTHS, &[0.25])
            .with_help("The radius of the tube of a torus, smaller than the radius."),
        Param::length("height", "Height", LENGTHS, &[2.0])
            .with_help("The height of tubes, cylinders, cones, prisms and pyramids."),
        TRIANGLES,
        Param::int("sides", "Sides", [3.0, 10_000.0], &[6.0])
            .with_help("The number of sides of the base of prisms and pyramids, smaller than the number of columns."),
    ],
    ..Filter::new(&[], TO_MESH_TEXT, run)
};

const SHAPES: &[Choice] = &[
    Choice::new("Sphere", "Meridians and parallels, with two poles."),
    Choice::new("One-pole sphere", "A disc whose rim is contracted to the lowest point."),
    Choice::new("Plane", "A square of twice the radius, seen from above."),
    Choice::new("Tube", "A cylinder without caps."),
    Choice::new("Cylinder", "A cylinder with caps."),
    Choice::new("Cone", "A cone with its base."),
    Choice::new("Torus", "A torus; its tube has the minor radius."),
    Choice::new("Cube", "A cube of twice the radius; each face has as many quads along a side as there are rows."),
    Choice::new("Moebius strip", "A one-sided strip, as wide as the minor radius."),
    Choice::new("Klein bottle", "A closed one-sided surface, which intersects itself."),
    Choice::new("Prism", "A right prism over a regular polygon, with caps."),
    Choice::new("Pyramid", "A right pyramid over a regular polygon, with its base."),
    Choice::new("Projective plane", "Boy's surface: closed and one-sided, intersecting itself."),
    Choice::new(
        "Pillow",
        "Two square sheets of twice the radius, joined along their rim; as thick as the minor radius, and with an odd number of \
         columns.",
    ),
];

fn run(_: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let [radius, minor_radius, height] = ["radius", "minor_radius", "height"].map(|id| values.number(id));
    let [rows, columns] = ["rows", "columns"].map(|id| values.number(id) as usize);
    let side = 2.0 * radius;
    let (cells, sides) = ([rows as u32 - 1; 3], values.number("sides") as u32);
    let shapes = [
        Primitive::Sphere { radius },
        Primitive::OnePoleSphere { radius },
        Primitive::Plane { size: [side; 2] },
        Primitive::Tube { radius, height },
        Primitive::Cylinder { radius, height },
        Primitive::Cone { radius, height },
        Primitive::Torus { radius, minor_radius },
        Primitive::Cuboid { cuboid: Cuboid { cells, kind: BoxKind::Slit }, size: [side; 3] },
        Primitive::Moebius { radius, width: minor_radius },
        Primitive::Klein { radius, minor_radius },
        Primitive::Prism { sides, radius, height },
        Primitive::Pyramid { sides, radius, height },
        Primitive::ProjectivePlane { radius },
        Primitive::Pillow { size: [side; 2], thickness: minor_radius },
    ];
    let request = Request { rows, columns, ..Request::new(shapes[values.place("shape")]) };
    let net = request.net(&job.part(0.0, 0.5)).map_err(|error| match error {
        // The other measures are in their ranges, and always fit.
        Error::OptionOutOfRange { option: "minor radius", value } => {
            Error::OptionOutOfRange { option: "minor_radius", value }
        }
        error => error,
    })?;
    let complex = Complex::from_topology(net.topology(), &job.part(0.5, 0.7))?;
    let mesh = quads::mesh(&net, values, &job.part(0.7, 1.0))?;
    let text = format!(
        "{}, {}, {}, {}\nEuler characteristic {}, {}\n",
        counted(complex.vertices, VERTEX),
        counted(complex.edges, EDGE),
        counted(complex.quads, QUAD),
        counted(complex.triangles, TRIANGLE),
        complex.euler_characteristic(),
        counted(complex.boundary.len(), BOUNDARY_LOOP)
    );
    let values = [
        ("vertices", complex.vertices as f64),
        ("edges", complex.edges as f64),
        ("quads", complex.quads as f64),
        ("triangles", complex.triangles as f64),
        ("euler_characteristic", complex.euler_characteristic() as f64),
        ("boundary_loops", complex.boundary.len() as f64),
    ];
    Ok(vec![Output::Mesh(mesh, None), Output::Text(Report::new(text, &values))])
}
