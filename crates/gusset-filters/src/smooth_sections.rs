use super::data::{Input, Output};
use super::extent::extent_of;
use super::filter::{Defaults, Filter};
use super::param::{COORDINATES, LENGTHS, Param, Values};
use super::signatures::{MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use glam::DVec3;
use gusset_base::choice::Choice;
use gusset_base::error::Result;
use gusset_base::geom::aabb;
use gusset_base::job::Job;
use gusset_surface::contour::Planes;
use gusset_surface::{Paths, Surface};

pub(super) const FILTER: Filter = Filter {
    id: "smooth_sections",
    name: "Plane sections of a smooth surface",
    category: CATEGORY,
    help: "Cuts the smooth surface through the vertices of a quad grid by parallel planes, and returns the curves in order. No curve \
           is missed, and points lie on the surface, not on the quads.",
    reference: REFERENCE,
    params: &[
        SCHEME,
        Param::direction("direction", "Direction").with_help("The normal of the planes."),
        Param::choice("placement", "Planes", PLACEMENTS).with_help("The placement of the planes."),
        Param::int("number", "Number", [1.0, 10_000.0], &[10.0]).with_help("The number of planes."),
        Param::length("offset", "Offset", COORDINATES, &[0.0])
            .with_help("The distance of the first plane from the origin along the direction; for given planes."),
        Param::length("distance", "Distance", LENGTHS, &[1.0])
            .with_help("The spacing of the planes; for given planes."),
        CHORD_ERROR,
    ],
    suggest: Some(suggest),
    ..Filter::new(MESH, TO_CURVES_TEXT, run)
};

const PLACEMENTS: &[Choice] = &[
    Choice::new("Even", "Evenly over the extent of the surface."),
    Choice::new("Given", "From the offset on, at the given spacing."),
];

/// Ten planes across the z axis, in accordance with the other defaults.
fn suggest(inputs: &[Input<'_>], defaults: &mut Defaults<'_>) {
    if let Some(extent) = extent_of(inputs) {
        let height = Some(extent.size().z).filter(|&height| height > 0.0).unwrap_or(extent.diagonal());
        defaults.set("offset", &[extent.low.z + 0.05 * height]);
        defaults.set("distance", &[0.1 * height]);
    }
}

fn run(inputs: &[Input<'_>], values: &Values<'_>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface(inputs[0].mesh()?, values, &job.part(0.0, 0.4))?;
    let paths = cut(&surface, values, &job.part(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::polylines(&paths)?), Output::Text(smooth::summary(&paths).into())])
}

fn cut(surface: &Surface<'_>, values: &Values<'_>, job: &Job<'_>) -> Result<Paths> {
    let normal = values.direction("direction")?;
    let number = values.number("number") as usize;
    let [first, distance] = match values.place("placement") {
        0 => evenly(surface, normal, number),
        _ => [values.number("offset"), values.number("distance")],
    };
    let mut offsets: Vec<f64> = (0..number).map(|k| first + k as f64 * distance).collect();
    // Where the surface has no extent, rounding makes planes equal.
    offsets.dedup();
    let planes = Planes { point: DVec3::ZERO, normal, levels: &offsets };
    surface.section(&planes, smooth::chord(surface, values), job)
}

/// The offset of the first plane and the distance of planes: half a distance is left at either end.
fn evenly(surface: &Surface<'_>, normal: DVec3, number: usize) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    let [from, to] = aabb::range((0..8).map(|k| corner(k).dot(normal)));
    let distance = (to - from) / number as f64;
    [from + 0.5 * distance, distance]
}
