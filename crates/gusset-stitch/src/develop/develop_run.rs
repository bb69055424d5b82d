//! The steps from the mesh to its development.

use super::STAGE;
use super::chart::ChartMesh;
use super::chart_system::ChartSystem;
use super::cut_edges::{CutSurface, PathSearch, SurfaceGraph};
use super::cut_to_discs::open_charts_to_discs;
use super::dart_tip::find_dart_tip;
use super::descend::{BorderRule, Descent, DescentOutcome, minimise_by_descent};
use super::develop_request::{Chart, CutKind, Developed, Distortion, Finish, Options};
use super::energy::{Jacobian, stretch_energy};
use super::exact_unfolding::{EdgeLengths, unfold_triangles};
use super::overlap::count_border_intersections;
use super::split_surface::SurfaceSplitAtCuts;
use super::start_maps::{conformal_map, tutte_map};
use glam::{DVec2, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Component, Element, Error, Result};
use gusset_base::geom::bit_set::BitSet;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, MeshView, NONE, PositionBuffer};

/// Default limit on the steps of a descent.
const DEFAULT_MAX_ITERATIONS: u32 = 200;
/// Distance between charts, relative to the greatest width of a chart.
const RELATIVE_CHART_GAP: f64 = 0.05;

/// The largest coordinate whose square, an area, is finite.
const MAX_COORDINATE: f64 = 1e150;

/// Edges of an exact chart that cross by at most this, relative to the root of its area, only
/// touch.
const MAX_RELATIVE_TOUCH_DEPTH: f64 = 1e-8;

/// A chart in the plane.
struct FlatChart {
    /// The positions in the unit.
    positions: Vec<DVec2>,
    finish: Finish,
    iterations: u32,
    /// The stretches of each face of the chart.
    stretches: Vec<[f64; 2]>,
    energy: f64,
    overlaps: u32,
    folds: u32,
    area: f64,
    flat_area: f64,
    /// The vertex at which a dart should end, if it was searched.
    dart_tip: Option<u32>,
}

impl FlatChart {
    /// Returns true if a dart was worthwhile.
    fn is_better_than(&self, other: &FlatChart) -> bool {
        self.folds == 0 && self.overlaps == 0 && self.energy < other.energy
    }

    /// Returns the largest factor by which a length changes, above 1.
    fn largest_stretch(&self) -> f64 {
        let of = |&[most, least]: &[f64; 2]| most.max(1.0 / least.max(f64::MIN_POSITIVE));
        self.stretches.iter().map(of).fold(1.0, f64::max)
    }
}

/// Lays a surface out in the plane with the least distortion.
///
/// The surface is cut along the given paths. Components that are not discs are opened along the
/// shortest further paths. A chart that can be unfolded about its edges keeps every length. Any
/// other chart descends to the least distortion, without folding a triangle or overlapping itself.
/// Edges with three or more faces, and edges whose faces have inconsistent orientations, are
/// borders.
///
/// O(H log H) for charts that are unfolded, and O(n^1.5) for each step of a descent with n
/// vertices. Memory is linear, except O(n log n) for the factor.
///
/// # Errors
/// * [`Error::OptionOutOfRange`] for a `max_stretch` that is not finite and above 1.
/// * [`Error::CoordinateTooLarge`] for a vertex beyond 1e150.
/// * [`Error::BadOffsets`] for the cuts.
/// * [`Error::LoopIndexOutOfRange`] for a vertex of a cut that does not exist.
/// * [`Error::CutNotConnected`], [`Error::RepeatedCorner`], [`Error::OutOfMemory`],
///   [`Error::Cancelled`].
pub fn develop(mesh: &MeshView<'_>, options: &Options<'_>, job: &Job<'_>) -> Result<Developed> {
    if let Some(stretch) = options.max_stretch {
        Error::require(stretch > 1.0 && stretch.is_finite(), "max_stretch", stretch, "finite and above 1")?;
    }
    job.step(0.0, STAGE)?;
    let unit = choose_unit(mesh, &job.sub_job(0.0, 0.0))?;
    let mut surface = CutSurface::new(mesh, &job.sub_job(0.0, 0.05))?;
    surface.cut_paths(&options.cuts, &job.sub_job(0.05, 0.05))?;
    let mut split = SurfaceSplitAtCuts::new(&surface, &job.sub_job(0.05, 0.06))?;
    if open_charts_to_discs(&mut surface, &split, &job.sub_job(0.06, 0.08))? {
        split = SurfaceSplitAtCuts::new(&surface, &job.sub_job(0.08, 0.1))?;
    }
    let count = split.vertices.len();
    let mut flats: Vec<Option<FlatChart>> = alloc::with_capacity(count)?;
    flats.resize_with(count, || None);
    let whole = job.sub_job(0.1, 0.95);
    // The number of darts is unknown in advance: each gets half of the remaining progress.
    let looks = options.max_darts > 0;
    let middle = if looks { 0.5 } else { 1.0 };
    let (first, mut rest) = (whole.sub_job(0.0, middle), whole.sub_job(middle, 1.0));
    for (chart, flat) in flats.iter_mut().enumerate() {
        *flat =
            Some(flatten_chart(&surface, &split, chart, unit, options, looks, &first.sub_job_of_item(chart, count))?);
    }
    let mut made = 0;
    while made < options.max_darts {
        let Some((chart, tip)) = choose_chart_for_dart(&flats, options) else {
            break;
        };
        let job = rest.sub_job(0.0, 0.5);
        rest = rest.sub_job(0.5, 1.0);
        let cut = cut_dart(&mut surface, &split, chart, tip, &job.sub_job(0.0, 0.1))?;
        let parts = SurfaceSplitAtCuts::new(&surface, &job.sub_job(0.1, 0.1))?;
        let flat = flatten_chart(&surface, &parts, chart, unit, options, true, &job.sub_job(0.1, 1.0))?;
        let old = flats[chart].as_mut().filter(|old| !flat.is_better_than(old));
        if let Some(old) = old {
            // Do not try further darts on this chart.
            surface.undo_cuts(&cut);
            old.dart_tip = None;
        } else {
            (split, flats[chart], made) = (parts, Some(flat), made + 1);
        }
    }
    let flats = alloc::gather(flats.into_iter().flatten())?;
    job.step(0.95, STAGE)?;
    build_result(mesh, surface, split, &flats, unit, made, &job.sub_job(0.95, 1.0))
}

/// Returns the unit in which the largest coordinate is from 1 to 2, a power of two.
fn choose_unit(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<f64> {
    let mut largest = DVec3::ZERO;
    for h in 0..mesh.faces().half_edge_count() as u32 {
        job.step_within_list(h as usize, STAGE)?;
        let v = mesh.faces().corner(h);
        let p = mesh.positions().get(v);
        if let Some((component, value)) = Component::find(p, |x| x.abs() > MAX_COORDINATE) {
            return Err(Error::CoordinateTooLarge { element: Element::Vertex, index: v.into(), component, value });
        }
        largest = largest.max(p.abs());
    }
    // A unit is at least 2^-900, so subnormal coordinates need a second one.
    let unit = common_unit([&largest]);
    Ok(unit * common_unit([&(largest / unit)]))
}

/// Returns the chart that most needs a dart, and the vertex at which the dart should end.
fn choose_chart_for_dart(flats: &[Option<FlatChart>], options: &Options<'_>) -> Option<(usize, u32)> {
    let limit = options.max_stretch.unwrap_or(1.0);
    let needs = flats.iter().enumerate().filter_map(|(k, flat)| {
        let flat = flat.as_ref()?;
        (flat.largest_stretch() > limit).then_some((flat.largest_stretch(), k, flat.dart_tip?))
    });
    needs.max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1))).map(|(_, chart, tip)| (chart, tip))
}

/// Cuts from a vertex inside a chart along the shortest path to its border, and returns the path.
fn cut_dart(
    surface: &mut CutSurface<'_, '_>,
    split: &SurfaceSplitAtCuts,
    chart: usize,
    tip: u32,
    job: &Job<'_>,
) -> Result<Vec<u32>> {
    let faces = *surface.mesh.faces();
    let mut on_border = BitSet::new(split.vertex_map.len())?;
    for &f in split.faces.get(chart) {
        for h in faces.corner_range(f as usize).map(|h| h as u32) {
            if surface.mate_across(h) == NONE {
                [h, faces.next(h)].iter().for_each(|&h| on_border.insert(split.corners[h as usize]));
            }
        }
    }
    let count = split.vertex_map.len();
    let graph = SurfaceGraph::new(surface, count, |h| split.corners[h as usize], job)?;
    let mut search = PathSearch::new(count)?;
    let Some(end) = search.search_nearest_target(&graph, &[tip], |v| on_border.contains(v), job)? else {
        return Ok(Vec::new());
    };
    let path = search.path_half_edges(end)?;
    for &h in &path {
        surface.cut_edge(h, CutKind::Dart)?;
    }
    Ok(path)
}

fn flatten_chart(
    surface: &CutSurface<'_, '_>,
    split: &SurfaceSplitAtCuts,
    number: usize,
    unit: f64,
    options: &Options<'_>,
    looks_for_tip: bool,
    job: &Job<'_>,
) -> Result<FlatChart> {
    let chart = ChartMesh::new(surface, split, number, unit, &job.sub_job(0.0, 0.05))?;
    let exact = |x| measure_flat_chart(&chart, x, Finish::Exact, 0, None, &job.sub_job(0.95, 1.0));
    let lengths = EdgeLengths::new(&chart, &job.sub_job(0.05, 0.05))?;
    let turned = unfold_triangles(&chart, &job.sub_job(0.05, 0.05))?;
    if lengths.are_lengths_kept(&turned, &job.sub_job(0.05, 0.05))? {
        return exact(turned);
    }
    let mut system = ChartSystem::new(&chart, &job.sub_job(0.05, 0.1))?;
    if let Some(x) = lengths.restore_lengths(&mut system, turned, &job.sub_job(0.1, 0.12))? {
        return exact(x);
    }
    let x = conformal_map(&chart, &mut system, &job.sub_job(0.12, 0.15))?;
    if let Some(x) = lengths.restore_lengths(&mut system, alloc::copied(&x)?, &job.sub_job(0.15, 0.18))? {
        return exact(x);
    }
    let tip = match looks_for_tip {
        true => find_dart_tip(&chart, &mut system, &job.sub_job(0.18, 0.2))?.map(|v| v + split.vertices[number].start),
        false => None,
    };
    let is_conformal = options.distortion == Distortion::Conformal;
    if is_conformal && chart.count_folded_triangles(&x) == 0 && has_simple_border(&chart, &x, &job.sub_job(0.2, 0.2))? {
        return measure_flat_chart(&chart, x, Finish::Conformal, 0, tip, &job.sub_job(0.95, 1.0));
    }
    let limit = if options.max_iterations == 0 { DEFAULT_MAX_ITERATIONS } else { options.max_iterations };
    // The rigid energy does not prevent folds, so start from a map without folds.
    let end = if options.distortion == Distortion::Rigid { 0.6 } else { 0.95 };
    let mut descent =
        minimise_distortion(&chart, &mut system, Distortion::Symmetric, x, limit, &job.sub_job(0.2, end))?;
    if options.distortion == Distortion::Rigid && descent.outcome != DescentOutcome::Folded {
        let before = descent.iterations;
        descent = minimise_distortion(
            &chart,
            &mut system,
            Distortion::Rigid,
            descent.positions,
            limit,
            &job.sub_job(end, 0.95),
        )?;
        descent.iterations += before;
    }
    let finish = match descent.outcome {
        DescentOutcome::Folded => Finish::Folded,
        _ if is_conformal => Finish::NotConformal,
        DescentOutcome::Converged => Finish::Converged,
        DescentOutcome::Stalled => Finish::Stalled,
        DescentOutcome::IterationLimit => Finish::IterationLimit,
    };
    measure_flat_chart(&chart, descent.positions, finish, descent.iterations, tip, &job.sub_job(0.95, 1.0))
}

/// Returns true if the border of a map does not intersect itself.
fn has_simple_border(chart: &ChartMesh, x: &[DVec2], job: &Job<'_>) -> Result<bool> {
    Ok(count_border_intersections(&chart.border, x, 0.0, 1, job)? == 0)
}

/// Returns the injective map of least distortion by descent from `positions`. If `positions` folds, or the descent
/// fails, starts again from Tutte's map.
fn minimise_distortion(
    chart: &ChartMesh,
    system: &mut ChartSystem,
    distortion: Distortion,
    positions: Vec<DVec2>,
    limit: u32,
    job: &Job<'_>,
) -> Result<Descent> {
    let (mut start, mut iterations) = (positions, 0);
    for job in [job.sub_job(0.0, 0.5), job.sub_job(0.5, 1.0)] {
        if chart.count_folded_triangles(&start) == 0 {
            let mut last = None;
            let free = minimise_by_descent(
                chart,
                system,
                distortion,
                start,
                BorderRule::Free(&mut last),
                limit,
                &job.sub_job(0.0, 0.4),
            )?;
            iterations += free.iterations;
            if has_simple_border(chart, &free.positions, &job.sub_job(0.4, 0.4))? {
                return Ok(Descent { iterations, ..free });
            }
            if let Some(last) = last {
                let done = minimise_by_descent(
                    chart,
                    system,
                    distortion,
                    last,
                    BorderRule::Apart,
                    limit,
                    &job.sub_job(0.4, 0.9),
                )?;
                return Ok(Descent { iterations: iterations + done.iterations, ..done });
            }
        }
        start = tutte_map(chart, system, &job.sub_job(0.9, 1.0))?;
    }
    Ok(Descent { positions: start, iterations, outcome: DescentOutcome::Folded })
}

/// Measures the chart, after turning it so that it is longest along x.
fn measure_flat_chart(
    chart: &ChartMesh,
    mut x: Vec<DVec2>,
    finish: Finish,
    iterations: u32,
    tip: Option<u32>,
    job: &Job<'_>,
) -> Result<FlatChart> {
    job.step(0.0, STAGE)?;
    turn_longest_along_x(&chart.border, &mut x);
    let slack = MAX_RELATIVE_TOUCH_DEPTH * chart.total_area().sqrt();
    let faces = chart.faces.last().map_or(0, |&last| last as usize + 1);
    let mut stretches = alloc::filled([0.0f64, f64::INFINITY], faces)?;
    let mut energy = 0.0;
    for (k, ((triangle, shape), &f)) in chart.triangles.iter().zip(&chart.shapes).zip(&chart.faces).enumerate() {
        job.step_within_list(k, STAGE)?;
        // All edges of an exact chart keep their lengths, also in a triangle without area.
        let keeps_lengths = finish == Finish::Exact && shape.is_clamped;
        let own = || Jacobian::new(&shape.gradients, triangle.map(|v| x[v as usize])).stretch;
        let [most, least] = if keeps_lengths { [1.0; 2] } else { own() };
        energy += shape.area * stretch_energy(Distortion::Symmetric, [most, least]);
        let stretch = &mut stretches[f as usize];
        *stretch = [stretch[0].max(most), stretch[1].min(least)];
    }
    job.step(0.0, STAGE)?;
    Ok(FlatChart {
        finish,
        iterations,
        stretches,
        energy: energy / chart.total_area(),
        // In an exact chart, the sides of slits coincide.
        overlaps: count_border_intersections(
            &chart.border,
            &x,
            if finish == Finish::Exact { slack } else { 0.0 },
            u32::MAX,
            job,
        )?,
        folds: if finish == Finish::Exact { 0 } else { chart.count_folded_triangles(&x) },
        area: chart.total_area(),
        flat_area: (0..chart.triangles.len()).map(|t| chart.signed_double_area(t, &x) / 2.0).sum(),
        dart_tip: tip,
        positions: x,
    })
}

/// Turns a map so that its border is longest along x, and moves its lower left corner to the
/// origin.
fn turn_longest_along_x(border: &[[u32; 2]], x: &mut [DVec2]) {
    let count = border.len() as f64;
    let mean = border.iter().map(|&[v, _]| x[v as usize]).sum::<DVec2>() / count;
    let (mut difference, mut mixed) = (0.0, 0.0);
    for &[v, _] in border {
        let p = x[v as usize] - mean;
        difference += p.x * p.x - p.y * p.y;
        mixed += 2.0 * p.x * p.y;
    }
    // The axis is at half the angle of (difference, mixed).
    let length = f64::sqrt(difference * difference + mixed * mixed);
    let cosine = if length > 0.0 { difference / length } else { 1.0 };
    let axis =
        DVec2::new(((1.0 + cosine) / 2.0).max(0.0).sqrt(), mixed.signum() * ((1.0 - cosine) / 2.0).max(0.0).sqrt());
    x.iter_mut().for_each(|p| *p = DVec2::new(axis.dot(*p), axis.perp_dot(*p)));
    let low = x.iter().fold(DVec2::INFINITY, |low, &p| low.min(p));
    x.iter_mut().for_each(|p| *p -= low);
}

fn build_result(
    mesh: &MeshView<'_>,
    surface: CutSurface<'_, '_>,
    split: SurfaceSplitAtCuts,
    flats: &[FlatChart],
    unit: f64,
    darts: u32,
    job: &Job<'_>,
) -> Result<Developed> {
    job.step(0.0, STAGE)?;
    let width = |flat: &FlatChart| flat.positions.iter().fold(0.0, |most: f64, p| most.max(p.x));
    let gap = RELATIVE_CHART_GAP * flats.iter().map(width).fold(0.0, f64::max);
    job.step(0.0, STAGE)?;
    let mut points = alloc::with_capacity(split.vertex_map.len())?;
    let mut stretches = alloc::filled([1.0; 2], mesh.faces().len())?;
    let (mut charts, mut left) = (alloc::with_capacity(flats.len())?, 0.0);
    for (k, flat) in flats.iter().enumerate() {
        job.sub_job(0.0, 0.5).step_every(1 << 15, k, flats.len(), STAGE)?;
        points.extend(flat.positions.iter().map(|&p| unit * (p + DVec2::new(left, 0.0))));
        left += width(flat) + gap;
        for (&f, &stretch) in split.faces.get(k).iter().zip(&flat.stretches) {
            stretches[f as usize] = stretch;
        }
        let all = flat.stretches.iter().fold([0.0f64, f64::INFINITY], |all, s| [all[0].max(s[0]), all[1].min(s[1])]);
        charts.push(Chart {
            vertices: split.vertices[k].clone(),
            faces: split.faces.get(k).len() as u32,
            finish: flat.finish,
            iterations: flat.iterations,
            overlaps: flat.overlaps,
            folds: flat.folds,
            energy: flat.energy,
            stretch: all,
            area: unit * flat.area * unit,
            flat_area: unit * flat.flat_area * unit,
        });
    }
    job.step(0.5, STAGE)?;
    let mut positions = PositionBuffer::with_capacity(mesh.positions().scalar(), points.len())?;
    positions.extend(points.iter().map(|p: &DVec2| p.extend(0.0)))?;
    job.step(0.7, STAGE)?;
    let mut offsets = alloc::with_capacity(mesh.faces().len() + 1)?;
    offsets.push(0);
    offsets.extend((0..mesh.faces().len()).map(|f| mesh.faces().corner_range(f).end as u32));
    job.step(0.9, STAGE)?;
    Ok(Developed {
        mesh: Mesh::new(positions, offsets, split.corners),
        points,
        vertex_map: split.vertex_map,
        old_vertices: mesh.positions().len(),
        face_charts: split.face_charts,
        stretches,
        charts,
        cut_edges: surface.cut_edges,
        darts,
    })
}
