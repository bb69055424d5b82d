//! The construction of each shape. A profile is swept around the z axis along a circle or a
//! polygon, or the shape has its own topology and formula. Coordinates are written row by row in
//! double precision and rounded once. O(nodes).

use super::formula::{
    boy_surface_point, figure_eight_bottle_point, moebius_strip_point, point_on_box, point_on_bulge, square_to_sphere,
    symmetric_parameter,
};
use super::profile::{
    ProfilePoint, circle_profile, half_circle_profile, regular_polygon, subdivide_polyline, unit_circle,
};
use super::solid::Primitive;
use crate::topology::{ContractedLinks, LinkMatrix};
use crate::{Coordinates, Net, Real, Shape, Sides, Topology, closure, each};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::Scalar;

/// Returns the net of a shape with valid dimensions.
pub(super) fn construct_net(
    primitive: &Primitive<'_>,
    shape: Shape,
    scalar: Scalar,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    let (h, w) = (shape.rows(), shape.columns());
    let turn = |profile: &[ProfilePoint], section: &[ProfilePoint]| sweep_profile(shape, profile, section, scalar, job);
    match *primitive {
        Primitive::Sphere { radius } => turn(&half_circle_profile(radius, h)?, &unit_circle(w)?),
        Primitive::Torus { radius, minor_radius } => turn(&circle_profile(radius, minor_radius, h)?, &unit_circle(w)?),
        Primitive::Tube { radius, height } => {
            turn(&subdivide_polyline(&tube_profile(radius, height), h)?, &unit_circle(w)?)
        }
        Primitive::Cylinder { radius, height } => {
            turn(&subdivide_polyline(&cylinder_profile(radius, height), h)?, &unit_circle(w)?)
        }
        Primitive::Cone { radius, height } => {
            turn(&subdivide_polyline(&cone_profile(radius, height), h)?, &unit_circle(w)?)
        }
        Primitive::Prism { sides, radius, height } => {
            turn(&subdivide_polyline(&cylinder_profile(radius, height), h)?, &regular_polygon(sides as usize, w)?)
        }
        Primitive::Pyramid { sides, radius, height } => {
            turn(&subdivide_polyline(&cone_profile(radius, height), h)?, &regular_polygon(sides as usize, w)?)
        }
        Primitive::Lathe { profile } => turn(profile, &unit_circle(w)?),
        Primitive::Plane { size: [x, y] } => {
            let sheet = Topology::from_sides(shape, Sides::SHEET);
            net_from_nodes(sheet, scalar, job, |i, j| {
                [x / 2.0 * symmetric_parameter(j, w), y / 2.0 * symmetric_parameter(i, h), 0.0]
            })
        }
        Primitive::OnePoleSphere { radius } => {
            let topology = Topology::from_sides(shape, Sides::ONE_POLE);
            net_from_nodes(topology, scalar, job, |i, j| {
                square_to_sphere([symmetric_parameter(j, w), symmetric_parameter(i, h)]).map(|x| radius * x)
            })
        }
        Primitive::Cuboid { cuboid, size } => {
            net_from_nodes(cuboid.topology()?, scalar, job, |i, j| point_on_box(&cuboid, size, i, j))
        }
        Primitive::Moebius { radius, width } => net_from_nodes(closure::moebius(shape)?, scalar, job, |i, j| {
            let (i, j) = node_in_first_column(shape, i, j);
            moebius_strip_point(radius, width / 2.0 * symmetric_parameter(i, h), j, w - 1)
        }),
        Primitive::Klein { radius, minor_radius } => net_from_nodes(closure::klein(shape)?, scalar, job, |i, j| {
            let (i, j) = node_in_first_column(shape, i, j);
            figure_eight_bottle_point(radius, minor_radius, [i, h - 1], [j, w - 1])
        }),
        Primitive::ProjectivePlane { radius } => {
            net_from_nodes(closure::projective_plane(shape)?, scalar, job, |i, j| {
                let (i, j) = node_in_first_row_or_column(shape, i, j);
                boy_surface_point([symmetric_parameter(j, w), symmetric_parameter(i, h)]).map(|x| radius * x)
            })
        }
        Primitive::Pillow { size, thickness } => net_from_nodes(closure::pillow(shape)?, scalar, job, |i, j| {
            let (column, upper) = (j.min(w - 1 - j), 2 * j < w);
            point_on_bulge(
                size,
                if upper { thickness } else { -thickness },
                [symmetric_parameter(column, w.div_ceil(2)), symmetric_parameter(i, h)],
            )
        }),
    }
}

/// Returns the node in the first column of the class of a node of a Möbius strip or a Klein bottle.
fn node_in_first_column(shape: Shape, i: usize, j: usize) -> (usize, usize) {
    if j + 1 == shape.columns() { (shape.rows() - 1 - i, 0) } else { (i, j) }
}

/// Returns the node in the first row or column of the class of a node of a projective plane.
fn node_in_first_row_or_column(shape: Shape, i: usize, j: usize) -> (usize, usize) {
    let (h, w) = (shape.rows(), shape.columns());
    let second = i + 1 == h || (j + 1 == w && i > 0);
    if second { (h - 1 - i, w - 1 - j) } else { (i, j) }
}

/// Returns the profile of a tube.
fn tube_profile(radius: f64, height: f64) -> [ProfilePoint; 2] {
    [[radius, -height / 2.0], [radius, height / 2.0]]
}

/// Returns the profile of a cylinder.
fn cylinder_profile(radius: f64, height: f64) -> [ProfilePoint; 4] {
    let [low, high] = tube_profile(radius, height);
    [[0.0, low[1]], low, high, [0.0, high[1]]]
}

/// Returns the profile of a cone.
fn cone_profile(radius: f64, height: f64) -> [ProfilePoint; 3] {
    let [low, high] = tube_profile(radius, height);
    [[0.0, low[1]], low, [0.0, high[1]]]
}

/// Row i is point i of the profile, column j in the direction of point j of the section.
fn sweep_profile(
    shape: Shape,
    profile: &[ProfilePoint],
    section: &[ProfilePoint],
    scalar: Scalar,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    net_from_rows(swept_topology(shape, profile)?, scalar, job, |i, [x, y, z]| {
        let [distance, height] = profile[i];
        for ((x, y), &[u, v]) in x.iter_mut().zip(y).zip(section) {
            (*x, *y) = (distance * u, distance * v);
        }
        z.fill(height);
    })
}

/// Rows are closed. Rows on the axis are contracted, and columns are closed if the profile is. A
/// closed surface is oriented so that its volume is positive.
fn swept_topology(shape: Shape, profile: &[ProfilePoint]) -> Result<Topology> {
    let last = profile.len() - 1;
    let ring = last >= 3 && profile[0] == profile[last];
    let on_axis = |i: usize| profile[i][0] == 0.0;
    let sides = Sides { columns_closed: ring, pole_top: on_axis(0), pole_bottom: on_axis(last), ..Sides::TUBE };
    let topology = if (1..last).any(on_axis) {
        let mut matrix = LinkMatrix::from_sides(shape, sides)?;
        for i in (1..last).filter(|&i| on_axis(i)) {
            (0..shape.columns() - 1).for_each(|j| matrix.set_contracted(shape.horizontal_link(i, j), true));
        }
        // A contracted row reduces its cells to triangles, or to wires between two such rows, so
        // none is crossed.
        Topology::assemble_unchecked(shape, ContractedLinks::Matrix(matrix), Vec::new(), false)
    } else {
        Topology::from_sides(shape, sides)
    };
    let closed = ring || (on_axis(0) && on_axis(last));
    Ok(topology.with_reversed(closed && profile_volume(profile) < 0.0))
}

/// Returns the volume that the profile encloses, up to a positive factor: truncated cones, signed
/// by their heights.
fn profile_volume(profile: &[ProfilePoint]) -> f64 {
    // Scaled, so that products stay in range.
    let scale = profile.iter().flatten().fold(f64::MIN_POSITIVE, |max, value| max.max(value.abs()));
    let cone = |ends: &[ProfilePoint]| {
        let [[a, low], [b, high]] = [ends[0], ends[1]].map(|point| point.map(|value| value / scale));
        (a * a + a * b + b * b) * (high - low)
    };
    profile.windows(2).map(cone).sum()
}

/// Nodes between two progress reports.
const NODES_PER_REPORT: usize = 1 << 16;

/// Returns the net whose row i is written by `row` to three buffers. Zeros are positive.
fn net_from_rows(
    topology: Topology,
    scalar: Scalar,
    job: &Job<'_>,
    mut row: impl FnMut(usize, [&mut [f64]; 3]),
) -> Result<Net<'static>> {
    let shape = topology.shape();
    let mut coordinates = Coordinates::zeroed(shape, scalar)?;
    let mut buffer: Vec<f64> = alloc::zeroed(3 * shape.columns())?;
    let often = (NODES_PER_REPORT / shape.columns()).max(1);
    for i in 0..shape.rows() {
        job.step_every(often, i, shape.rows(), "primitive")?;
        let (x, yz) = buffer.split_at_mut(shape.columns());
        let (y, z) = yz.split_at_mut(shape.columns());
        row(i, [x, y, z]);
        each!(&mut coordinates, planes => copy_buffer_to_row(&buffer, planes.row_mut(i)));
    }
    Ok(Net::new(coordinates, topology))
}

/// Returns the net whose nodes are given by `node`.
fn net_from_nodes(
    topology: Topology,
    scalar: Scalar,
    job: &Job<'_>,
    node: impl Fn(usize, usize) -> [f64; 3],
) -> Result<Net<'static>> {
    net_from_rows(topology, scalar, job, |i, [x, y, z]| {
        for (j, ((x, y), z)) in x.iter_mut().zip(y).zip(z).enumerate() {
            [*x, *y, *z] = node(i, j);
        }
    })
}

fn copy_buffer_to_row<T: Real>(buffer: &[f64], row: [&mut [T]; 3]) {
    let columns = row[0].len();
    for (to, from) in row.into_iter().zip(buffer.chunks_exact(columns)) {
        // Adding 0 makes negative zeros positive, including zeros that come from rounding.
        to.iter_mut().zip(from).for_each(|(to, &value)| *to = T::from_f64(value) + T::from_f64(0.0));
    }
}
