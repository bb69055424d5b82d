use super::data::{Input, Output};
use super::filter::{Filter, FilterBody};
use super::section_planes::{self, DIRECTION, DISTANCE, NUMBER, OFFSET};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CATEGORY, CHORD_ERROR, REFERENCE, SCHEME};
use super::typed_param::{Param, ParamValues, params};
use glam::DVec3;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::geom::aabb;
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
    direction: DVec3 = DIRECTION;
    placement: bool = Param::choice("Planes", "The placement of the planes.", PLACEMENTS);
    number: u32 = NUMBER;
    offset: f64 = OFFSET;
    distance: f64 = DISTANCE;
    chord_error: f64 = CHORD_ERROR;
}

choices! {
    /// True if offset and distance are given.
    PLACEMENTS: bool =
        false => "Even", "Evenly over the extent of the surface.";
        true => "Given", "From the offset on, at the given spacing.";
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let surface = smooth::surface_through_mesh(inputs[0].mesh()?, values.scheme, &job.sub_job(0.0, 0.4))?;
    let paths = cut_by_planes(&surface, values, &job.sub_job(0.4, 1.0))?;
    Ok(vec![Output::Curves(smooth::paths_to_curves(&paths)?), Output::Text(smooth::paths_summary(&paths).into())])
}

fn cut_by_planes(surface: &Surface<'_>, values: &Params, job: &Job<'_>) -> Result<Paths> {
    let (normal, number) = (values.direction, values.number);
    let first_and_spacing = if values.placement {
        [values.offset, values.distance]
    } else {
        section_planes::first_offset_and_spacing(extent_along(surface, normal), number)
    };
    let offsets = section_planes::offsets_at_spacing(first_and_spacing, number);
    let planes = Planes { point: DVec3::ZERO, normal, levels: &offsets };
    surface.section(&planes, smooth::chord_spacing(surface, values.chord_error), job)
}

/// The range of the box of a surface along a direction.
pub(super) fn extent_along(surface: &Surface<'_>, direction: DVec3) -> [f64; 2] {
    let [low, high] = surface.bounds();
    let corner = |k: usize| DVec3::new([low.x, high.x][k & 1], [low.y, high.y][k >> 1 & 1], [low.z, high.z][k >> 2]);
    aabb::range_of_values((0..8).map(|k| corner(k).dot(direction)))
}
