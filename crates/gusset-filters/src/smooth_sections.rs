use super::data::{Input, Output};
use super::filter::{Body, Filter};
use super::signatures::{MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed::{COORDINATES, LENGTHS, Param, Values, params};
use glam::DVec3;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::geom::{Aabb, aabb};
use gusset_base::job::Job;
use gusset_surface::contour::Planes;
use gusset_surface::{Paths, Scheme, Surface};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_sections",
    name: "Plane sections of a smooth surface",
    category: CATEGORY,
    help: "Cuts the smooth surface through the vertices of a quad grid by parallel planes, and returns the curves in order. No \
           curve is missed. Points lie on the surface, not on the quads.",
    reference: REFERENCE,
    ..Filter::new(MESH, TO_CURVES_TEXT, &Body(run))
};

params! {
    scheme: Scheme = SCHEME;
    direction: DVec3 = Param::direction("Direction", "The normal of the planes.");
    placement: bool = Param::choice("Planes", "The placement of the planes.", PLACEMENTS);
    number: u32 = Param::int("Number", "The number of planes.", [1.0, 10_000.0], &[10.0]);
    offset: f64 = Param::length(
        "Offset",
        "The distance of the first plane from the origin along the direction, for given planes.",
        COORDINATES, &[0.0],
    ).suggested(|_, extent| Some(extent.low.z + 0.05 * height(extent)));
    distance: f64 = Param::length("Distance", "The spacing of the planes, for given planes.", LENGTHS, &[1.0])
        .suggested(|_, extent| Some(0.1 * height(extent)));
    chord_error: f64 = CHORD_ERROR;
}

choices! {
    /// True if offset and distance are given.
    PLACEMENTS: bool =
        false => "Even", "Evenly over the extent of the surface.";
        true => "Given", "From the offset on, at the given spacing.";
}

/// The extent along the z axis, the default direction, which ten planes divide by default.
fn height(extent: &Aabb) -> f64 {
    Some(extent.size().z).filter(|&height| height > 0.0).unwrap_or(extent.diagonal())
}

fn run(inputs: &[Input<'_>], values: &Values<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values.scheme, &job.part(0.0, 0.4))?;
    let paths = cut(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::summary(&paths).into())])
}

fn cut(surface: &Surface<'_>, values: &Params, job: &Job<'_>) -> Result<Paths> {
    let (normal, number) = (values.direction, values.number as usize);
    let [first, distance] =
        if values.placement { [values.offset, values.distance] } else { evenly(surface, normal, number) };
    let mut offsets: Vec<f64> = (0..number).map(|k| first + k as f64 * distance).collect();
    // Where the surface has no extent, rounding makes planes equal.
    offsets.dedup();
    let planes = Planes { point: DVec3::ZERO, normal, levels: &offsets };
    surface.section(&planes, smooth::chord(surface, values.chord_error), job)
}

/// The offset of the first plane and the spacing of planes. Half a spacing remains at each end.
fn evenly(surface: &Surface<'_>, normal: DVec3, number: usize) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    let [from, to] = aabb::range((0..8).map(|k| corner(k).dot(normal)));
    let distance = (to - from) / number as f64;
    [from + 0.5 * distance, distance]
}
