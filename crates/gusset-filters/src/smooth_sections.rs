use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed_param::{COORDINATE_RANGE, LENGTH_RANGE, Param, ParamValues, params};
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
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    scheme: Scheme = SCHEME;
    direction: DVec3 = Param::direction("Direction", "The normal of the planes.");
    placement: bool = Param::choice("Planes", "The placement of the planes.", PLACEMENTS);
    number: u32 = Param::int("Number", "The number of planes.", [1.0, 10_000.0], &[10.0]);
    offset: f64 = Param::length(
        "Offset",
        "The distance of the first plane from the origin along the direction, for given planes.",
        COORDINATE_RANGE, &[0.0],
    ).suggested(|_, extent| Some(extent.low.z + 0.05 * extent_in_z(extent)));
    distance: f64 = Param::length("Distance", "The spacing of the planes, for given planes.", LENGTH_RANGE, &[1.0])
        .suggested(|_, extent| Some(0.1 * extent_in_z(extent)));
    chord_error: f64 = CHORD_ERROR;
}

choices! {
    /// True if offset and distance are given.
    PLACEMENTS: bool =
        false => "Even", "Evenly over the extent of the surface.";
        true => "Given", "From the offset on, at the given spacing.";
}

/// The extent along the z axis, the default direction, which ten planes divide by default.
fn extent_in_z(extent: &Aabb) -> f64 {
    Some(extent.size().z).filter(|&height| height > 0.0).unwrap_or(extent.diagonal())
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let paths = cut_by_planes(&surface, values, &job.sub_job(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::paths_to_curves(&paths)?), Output::Text(smooth::paths_summary(&paths).into())])
}

fn cut_by_planes(surface: &Surface<'_>, values: &Params, job: &Job<'_>) -> Result<Paths> {
    let (normal, number) = (values.direction, values.number as usize);
    let [first, distance] = if values.placement {
        [values.offset, values.distance]
    } else {
        first_offset_and_spacing(surface, normal, number)
    };
    let mut offsets: Vec<f64> = (0..number).map(|k| first + k as f64 * distance).collect();
    // Where the surface has no extent, rounding makes planes equal.
    offsets.dedup();
    let planes = Planes { point: DVec3::ZERO, normal, levels: &offsets };
    surface.section(&planes, smooth::chord_spacing(surface, values.chord_error), job)
}

/// The offset of the first plane and the spacing of planes. Half a spacing remains at each end.
fn first_offset_and_spacing(surface: &Surface<'_>, normal: DVec3, number: usize) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    let [from, to] = aabb::range_of_values((0..8).map(|k| corner(k).dot(normal)));
    let distance = (to - from) / number as f64;
    [from + 0.5 * distance, distance]
}
