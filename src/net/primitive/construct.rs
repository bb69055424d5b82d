//! The construction of each shape: its profile and section, or its topology and formula. O(nodes).

use super::formula::{across, boy, bulge, figure_eight, on_box, one_pole, strip};
use super::profile::{Point, circle, half_circle, polygon, polyline, unit_circle};
use super::solid::Primitive;
use super::{coordinates, revolve};
use crate::error::Result;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::{Net, Shape, Sides, Topology, closure};

/// The net of a shape whose dimensions are checked.
pub(super) fn net(primitive: &Primitive<'_>, shape: Shape, scalar: Scalar, job: &Job<'_>) -> Result<Net<'static>> {
    let (h, w) = (shape.rows(), shape.columns());
    let turn = |profile: &[Point], section: &[Point]| revolve::net(shape, profile, section, scalar, job);
    match *primitive {
        Primitive::Sphere { radius } => turn(&half_circle(radius, h)?, &unit_circle(w)?),
        Primitive::Torus { radius, minor_radius } => turn(&circle(radius, minor_radius, h)?, &unit_circle(w)?),
        Primitive::Tube { radius, height } => turn(&polyline(&wall(radius, height), h)?, &unit_circle(w)?),
        Primitive::Cylinder { radius, height } => turn(&polyline(&capped(radius, height), h)?, &unit_circle(w)?),
        Primitive::Cone { radius, height } => turn(&polyline(&pointed(radius, height), h)?, &unit_circle(w)?),
        Primitive::Prism { sides, radius, height } => {
            turn(&polyline(&capped(radius, height), h)?, &polygon(sides as usize, w)?)
        }
        Primitive::Pyramid { sides, radius, height } => {
            turn(&polyline(&pointed(radius, height), h)?, &polygon(sides as usize, w)?)
        }
        Primitive::Lathe { profile } => turn(profile, &unit_circle(w)?),
        Primitive::Plane { size: [x, y] } => {
            let sheet = Topology::of_sides(shape, Sides::SHEET);
            coordinates::nodes(sheet, scalar, job, |i, j| [x / 2.0 * across(j, w), y / 2.0 * across(i, h), 0.0])
        }
        Primitive::OnePoleSphere { radius } => {
            let topology = Topology::of_sides(shape, Sides::ONE_POLE);
            coordinates::nodes(topology, scalar, job, |i, j| one_pole([across(j, w), across(i, h)]).map(|x| radius * x))
        }
        Primitive::Cuboid { cuboid, size } => {
            coordinates::nodes(cuboid.topology()?, scalar, job, |i, j| on_box(&cuboid, size, i, j))
        }
        Primitive::Moebius { radius, width } => coordinates::nodes(closure::moebius(shape)?, scalar, job, |i, j| {
            let (i, j) = first_column(shape, i, j);
            strip(radius, width / 2.0 * across(i, h), j, w - 1)
        }),
        Primitive::Klein { radius, minor_radius } => coordinates::nodes(closure::klein(shape)?, scalar, job, |i, j| {
            let (i, j) = first_column(shape, i, j);
            figure_eight(radius, minor_radius, [i, h - 1], [j, w - 1])
        }),
        Primitive::ProjectivePlane { radius } => {
            coordinates::nodes(closure::projective_plane(shape)?, scalar, job, |i, j| {
                let (i, j) = half_rim(shape, i, j);
                boy([across(j, w), across(i, h)]).map(|x| radius * x)
            })
        }
        Primitive::Pillow { size, thickness } => coordinates::nodes(closure::pillow(shape)?, scalar, job, |i, j| {
            let (column, upper) = (j.min(w - 1 - j), 2 * j < w);
            bulge(size, if upper { thickness } else { -thickness }, [across(column, w.div_ceil(2)), across(i, h)])
        }),
    }
}

/// The node in the first column of the class of a node of a Möbius strip or a Klein bottle.
fn first_column(shape: Shape, i: usize, j: usize) -> (usize, usize) {
    if j + 1 == shape.columns() { (shape.rows() - 1 - i, 0) } else { (i, j) }
}

/// The node in the first row or column of the class of a node of a projective plane.
fn half_rim(shape: Shape, i: usize, j: usize) -> (usize, usize) {
    let (h, w) = (shape.rows(), shape.columns());
    let second = i + 1 == h || (j + 1 == w && i > 0);
    if second { (h - 1 - i, w - 1 - j) } else { (i, j) }
}

/// The profile of a tube.
fn wall(radius: f64, height: f64) -> [Point; 2] {
    [[radius, -height / 2.0], [radius, height / 2.0]]
}

/// The profile of a cylinder.
fn capped(radius: f64, height: f64) -> [Point; 4] {
    let [low, high] = wall(radius, height);
    [[0.0, low[1]], low, high, [0.0, high[1]]]
}

/// The profile of a cone.
fn pointed(radius: f64, height: f64) -> [Point; 3] {
    let [low, high] = wall(radius, height);
    [[0.0, low[1]], low, [0.0, high[1]]]
}
