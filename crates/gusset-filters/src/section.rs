use super::data::{Curves, Input, Output};
use super::filter::{Filter, FilterBody};
use super::report::{CURVE, POINT, Report, ReportValue, count_with_noun, format_short, push_line, push_unlisted_count};
use super::section_planes::{self, DIRECTION, DISTANCE, NUMBER, OFFSET};
use super::signatures::{ONE_MESH, TO_CURVES_TEXT};
use super::smooth::{self, CHORD_ERROR, SCHEME};
use super::smooth_sections::extent_along;
use super::typed_param::{NON_NEGATIVE_RANGE, Param, ParamValues, params};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::{Error, Result};
use gusset_base::geom::aabb;
use gusset_base::job::Job;
use gusset_mesh::MeshView;
use gusset_mesh::section::{
    InPlane, Options, Plane, PlaneStack, SectionPath, cut_by_planes, cut_by_stack, planes_about_axis,
};
use gusset_surface::contour::Planes;
use gusset_surface::{Scheme, Surface};
use std::f64::consts::PI;

/// The largest number of planes that the report lists.
const MAX_LISTED_PLANES: usize = 20;

pub(super) const FILTER: Filter = Filter {
    id: "section",
    name: "Plane sections",
    category: "Measures",
    help: "Cuts a mesh by parallel planes or by planes about an axis, and returns the curves in order. A closed mesh gives \
           closed curves only: each vertex is on a side of each plane exactly. Around a solid, outer curves run \
           counter-clockwise seen against the normal, curves around holes clockwise. A grid of quads is cut as the smooth \
           surface through its vertices, unless its faces are chosen.",
    reference: "J. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997; \
                V. A. Leus, Carcasses on smooth surfaces, 1976",
    ..Filter::new(ONE_MESH, TO_CURVES_TEXT, &FilterBody(run))
};

params! {
    cut: Cut = Param::choice("Cut", "The surface that the planes cut.", CUTS);
    placement: Placement = Param::choice("Planes", "The placement of the planes.", PLACEMENTS);
    direction: DVec3 = DIRECTION.with_help("The normal of parallel planes, or the direction of the axis.");
    number: u32 = NUMBER;
    offset: f64 = OFFSET;
    distance: f64 = DISTANCE;
    point: DVec3 = Param::point("Point", "A point of the axis, for planes about an axis.", &[0.0; 3])
        .suggested(|_, extent| Some(extent.centre()));
    tolerance: f64 = Param::length(
        "Tolerance",
        "Leaves out points of curves on faces while no left-out point is farther than this from its curve; 0 keeps all points.",
        NON_NEGATIVE_RANGE, &[0.0],
    );
    in_plane: InPlane = Param::choice("Vertices in a plane", "The side of vertices in a plane, for faces.", InPlane::CHOICES);
    scheme: Scheme = SCHEME.with_label("Scheme");
    chord_error: f64 = CHORD_ERROR;
}

/// The surface to cut.
#[derive(Clone, Copy, PartialEq)]
enum Cut {
    ByKind,
    Faces,
    SmoothSurface,
}

/// The placement of the planes.
#[derive(Clone, Copy, PartialEq)]
enum Placement {
    Even,
    Given,
    AboutAxis,
}

choices! {
    CUTS: Cut =
        Cut::ByKind => "Automatic", "The smooth surface of a grid of quads; the faces of any other mesh.";
        Cut::Faces => "Faces", "The faces themselves.";
        Cut::SmoothSurface => "Smooth surface", "The smooth surface through the vertices of a grid of quads.";
}

choices! {
    PLACEMENTS: Placement =
        Placement::Even => "Even", "Parallel, evenly over the extent of the surface.";
        Placement::Given => "Given", "Parallel, from the offset on, at the given spacing.";
        Placement::AboutAxis => "About an axis", "Through an axis, evenly over half a turn.";
}

/// Planes as the filter places them.
enum PlacedPlanes {
    /// Parallel planes at these offsets from the origin.
    Parallel {
        normal: DVec3,
        offsets: Vec<f64>,
    },
    Each(Vec<Plane>),
}

impl PlacedPlanes {
    /// Places planes on a surface of the given extent along the direction.
    fn new(values: &Params, extent: impl FnOnce() -> [f64; 2]) -> Result<Self> {
        let (normal, number) = (values.direction, values.number);
        let parallel = |first_and_spacing| PlacedPlanes::Parallel {
            normal,
            offsets: section_planes::offsets_at_spacing(first_and_spacing, number),
        };
        Ok(match values.placement {
            Placement::Even => parallel(section_planes::first_offset_and_spacing(extent(), number)),
            Placement::Given => parallel([values.offset, values.distance]),
            Placement::AboutAxis => {
                let angles = alloc::collect((0..number).map(|k| PI * f64::from(k) / f64::from(number)))?;
                let reference = coordinate_axis_across(normal);
                PlacedPlanes::Each(planes_about_axis(values.point, normal, reference, &angles)?)
            }
        })
    }

    fn len(&self) -> usize {
        match self {
            PlacedPlanes::Parallel { offsets, .. } => offsets.len(),
            PlacedPlanes::Each(planes) => planes.len(),
        }
    }

    /// The place of a plane in words.
    fn describe_plane(&self, k: usize) -> String {
        match self {
            PlacedPlanes::Parallel { offsets, .. } => format!("plane at {}", format_short(offsets[k])),
            PlacedPlanes::Each(planes) => {
                format!("plane at {} degrees", format_short(180.0 * k as f64 / planes.len() as f64))
            }
        }
    }
}

/// The coordinate axis with the largest angle to a direction, the first one of several.
fn coordinate_axis_across(direction: DVec3) -> DVec3 {
    let sizes = direction.abs();
    let axis = (0..3).fold(0, |least, k| if sizes[k] < sizes[least] { k } else { least });
    DVec3::AXES[axis]
}

fn run(inputs: &[Input<'_>], values: &ParamValues<Params>, job: &Job<'_>) -> Result<Vec<Output>> {
    let mesh = inputs[0].mesh()?;
    let (curves, report) = match smooth_surface_to_cut(mesh, values, &job.sub_job(0.0, 0.4))? {
        Some(surface) => cut_smooth_surface(&surface, values, &job.sub_job(0.4, 1.0))?,
        None => cut_faces(mesh, values, &job.sub_job(0.4, 1.0))?,
    };
    Ok(vec![Output::Curves(curves), Output::Text(report)])
}

/// The smooth surface through the vertices if it is to be cut; `None` if the faces are to be cut.
fn smooth_surface_to_cut(mesh: &MeshView<'_>, values: &Params, job: &Job<'_>) -> Result<Option<Surface<'static>>> {
    let through_mesh = || smooth::surface_through_mesh(mesh, values.scheme, job).map(Some);
    match values.cut {
        Cut::Faces => Ok(None),
        Cut::SmoothSurface => through_mesh(),
        Cut::ByKind if !may_be_grid_of_quads(mesh) => Ok(None),
        Cut::ByKind => match through_mesh() {
            Err(Error::NoGrid { .. }) => Ok(None),
            surface => surface,
        },
    }
}

/// Whether faces have the numbers of corners of a grid: quads, and triangles at poles. Spares meshes
/// of triangles the search for rows.
fn may_be_grid_of_quads(mesh: &MeshView<'_>) -> bool {
    let corner_counts = || (0..mesh.faces().len()).map(|face| mesh.faces().corner_range(face).len());
    corner_counts().all(|count| count <= 4) && corner_counts().any(|count| count == 4)
}

fn cut_faces(mesh: &MeshView<'_>, values: &Params, job: &Job<'_>) -> Result<(Curves, Report)> {
    let planes = PlacedPlanes::new(values, || extent_of_vertices(mesh, values.direction))?;
    let options = Options { in_plane: values.in_plane, tolerance: values.tolerance };
    let sections = match &planes {
        PlacedPlanes::Parallel { normal, offsets } => {
            cut_by_stack(mesh, &PlaneStack { point: DVec3::ZERO, normal: *normal, offsets }, &options, job)?
        }
        PlacedPlanes::Each(planes) => cut_by_planes(mesh, planes, &options, job)?,
    };
    let mut curves = Curves::without_curves();
    for (k, path) in sections.paths().iter().enumerate() {
        curves.add_curve(sections.points()[sections.range(k)].iter().copied(), path.is_closed)?;
    }
    let mut text = summarise(&curves, planes.len(), "faces");
    let planes_with_paths = || sections.paths().chunk_by(|a, b| a.plane == b.plane);
    for paths in planes_with_paths().take(MAX_LISTED_PLANES) {
        let sum_over_paths = |measure: fn(&SectionPath) -> f64| format_short(paths.iter().map(measure).sum());
        push_line!(
            text,
            "{}: {}, length {}, area {}",
            planes.describe_plane(paths[0].plane as usize),
            count_with_noun(paths.len(), CURVE),
            sum_over_paths(|path| path.length),
            sum_over_paths(|path| path.area)
        );
    }
    push_unlisted_count(&mut text, planes_with_paths().count(), MAX_LISTED_PLANES);
    let length = sections.paths().iter().map(|path| path.length).sum();
    let report = report_counts(text, &curves, planes.len(), ("length", ReportValue::length(length)));
    Ok((curves, report))
}

/// The range of the vertices along a direction. Vertices that are not finite are left out.
fn extent_of_vertices(mesh: &MeshView<'_>, direction: DVec3) -> [f64; 2] {
    let positions = mesh.positions();
    let heights = (0..positions.len() as u32).map(|v| positions.get(v).dot(direction)).filter(|x| x.is_finite());
    let range = aabb::range_of_values(heights);
    if range[0] <= range[1] { range } else { [0.0; 2] }
}

fn cut_smooth_surface(surface: &Surface<'_>, values: &Params, job: &Job<'_>) -> Result<(Curves, Report)> {
    let planes = PlacedPlanes::new(values, || extent_along(surface, values.direction))?;
    let spacing = smooth::chord_spacing(surface, values.chord_error);
    let found = match &planes {
        PlacedPlanes::Parallel { normal, offsets } => {
            vec![surface.section(&Planes { point: DVec3::ZERO, normal: *normal, levels: offsets }, spacing, job)?]
        }
        PlacedPlanes::Each(planes) => alloc::try_collect(planes.iter().enumerate().map(|(k, plane)| {
            let through_axis = Planes { point: plane.point, normal: plane.normal, levels: &[0.0] };
            surface.section(&through_axis, spacing, &job.sub_job_of_item(k, planes.len()))
        }))?,
    };
    let mut curves = Curves::without_curves();
    for paths in &found {
        for (k, &is_closed) in paths.closed.iter().enumerate() {
            let range = paths.ends[k] as usize..paths.ends[k + 1] as usize;
            curves.add_curve(paths.points[range].iter().copied(), is_closed)?;
        }
    }
    let unresolved: usize = found.iter().map(|paths| paths.unresolved.len()).sum();
    let mut text = summarise(&curves, planes.len(), "the smooth surface");
    if unresolved > 0 {
        push_line!(text, "{} unresolved", count_with_noun(unresolved, ["cell", "cells"]));
    }
    let report = report_counts(text, &curves, planes.len(), ("unresolved", ReportValue::count(unresolved)));
    Ok((curves, report))
}

fn count_closed(curves: &Curves) -> usize {
    curves.closed.iter().filter(|&&closed| closed).count()
}

/// A line that names the surface and counts planes and curves.
fn summarise(curves: &Curves, plane_count: usize, surface: &str) -> String {
    format!(
        "{} of {surface} by {}, {} of them closed, {}\n",
        count_with_noun(curves.closed.len(), CURVE),
        count_with_noun(plane_count, ["plane", "planes"]),
        count_closed(curves),
        count_with_noun(curves.points.len(), POINT)
    )
}

fn report_counts(text: String, curves: &Curves, plane_count: usize, last: (&'static str, ReportValue)) -> Report {
    let values = [
        ("planes", ReportValue::count(plane_count)),
        ("curves", ReportValue::count(curves.closed.len())),
        ("closed_curves", ReportValue::count(count_closed(curves))),
        ("points", ReportValue::count(curves.points.len())),
        last,
    ];
    Report::new(text, &values)
}
