//! Surfaces of real things: a ship's table of offsets, nets of sketched curves, a foot, Newell's
//! teapot. Skipped where the data is not.

use glam::DVec3;
use gusset::curve::frame::{Correspondence, FrameOptions, frame};
use gusset::curve::{Curve, CurveKind, CurveView, Options, Outlines, Points};
use gusset::surface::construct::{CurveNet, FrameSurface};
use gusset::surface::{Grid, Nodes, Patches, Scheme, Sheet, Surface};
use gusset::{Error, Job};
use serde_json::Value;

/// A file of the surface folder of the data; `None`, with a note, where there is none.
fn text(name: &str) -> Option<String> {
    crate::common::data::text(&format!("carcass/{name}"))
}

fn json(name: &str) -> Option<Value> {
    text(name).map(|text| serde_json::from_str(&text).unwrap())
}

fn vector(value: &Value) -> DVec3 {
    let x = |k: usize| value[k].as_f64().unwrap();
    DVec3::new(x(0), x(1), x(2))
}

/// Cubics through points, C2.
fn through(points: &[DVec3]) -> Curve {
    let rows: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
    let outlines = Outlines { points: Points::from(&rows[..]), offsets: None, closed: false, constraints: &[] };
    let options = Options { curve: CurveKind::CubicC2, ..Options::default() };
    gusset::curve::fit(&outlines, &options, &Job::default()).unwrap().curve(0).to_owned().unwrap()
}

/// The given points of each station of the hull, from below.
fn stations(hull: &Value) -> Vec<Vec<DVec3>> {
    let [length, beam, depth] = ["LOA", "BOA", "Depth"].map(|key| hull[key].as_f64().unwrap());
    let table = &hull["halfBreadths"];
    let at = |key: &str, k: usize| table[key][k].as_f64().unwrap();
    let (count, levels) = (table["stations"].as_array().unwrap().len(), table["waterlines"].as_array().unwrap().len());
    let point = |i: usize, j: usize| {
        let breadth = table["table"][j][i].as_f64()?;
        Some(DVec3::new(at("stations", i) * length, 0.5 * beam * breadth, at("waterlines", j) * depth))
    };
    (0..count).map(|i| (0..levels).filter_map(|j| point(i, j)).collect()).collect()
}

/// A station as `width` nodes: all given points, and between the lowest two as many more as are
/// missing.
fn filled(points: &[DVec3], width: usize) -> Vec<DVec3> {
    let missing = width - points.len();
    let lowest = points[1.min(points.len() - 1)];
    let more = (1..=missing).map(|k| points[0].lerp(lowest, k as f64 / (missing + 1) as f64));
    points[..1].iter().copied().chain(more).chain(points[1..].iter().copied()).collect()
}

#[test]
fn the_hull_passes_every_point_of_its_stations() {
    let Some(hull) = json("hull_gunnerus_offsets.json") else { return };
    let stations = stations(&hull);
    let given: usize = stations.iter().map(Vec::len).sum();
    assert_eq!(given, 64 * 16 - 260);
    // Abaft the forecastle the sides end lower: two sheets, which share a station up to there.
    let forecastle = stations.iter().position(|station| station.len() == 16).unwrap();
    let low = stations[forecastle - 1].len();
    let aft: Vec<Vec<DVec3>> = stations[..forecastle]
        .iter()
        .map(|station| filled(station, low))
        .chain([stations[forecastle][..low].to_vec()])
        .collect();
    let fore: Vec<Vec<DVec3>> = stations[forecastle..].iter().map(|station| filled(station, 16)).collect();
    let sheet = |rows: &[Vec<DVec3>]| {
        let data: Vec<f64> = rows.iter().flatten().flat_map(DVec3::to_array).collect();
        let nodes = Nodes::strided(data, rows.len(), rows[0].len(), 0, 0).unwrap();
        Sheet::Grid(Grid::new(nodes, [false, false], Scheme::SixTap).unwrap())
    };
    let grids = vec![sheet(&aft), sheet(&fore)];
    assert_eq!(grids[1].poles_at_sides(), [[false, true], [false, false]], "the stem's head is a point");
    // The same as skins of curves through all points of the stations.
    let skin = |stations: &[Vec<DVec3>]| {
        let curves: Vec<Curve> =
            stations.iter().filter(|station| station.len() > 1).map(|points| through(points)).collect();
        let views: Vec<CurveView<'_>> = curves.iter().map(Curve::view).collect();
        let net = CurveNet { rows: &views, columns: &[], closed: [false, false], tolerance: None };
        Sheet::from_curves(&net, &Job::default()).unwrap()
    };
    let mut shared: Vec<Vec<DVec3>> = stations[..forecastle].to_vec();
    shared.push(stations[forecastle][..low].to_vec());
    let skins = vec![skin(&shared), skin(&stations[forecastle..])];
    for (name, sheets, last) in [("grid", grids, 64), ("skin", skins, 63)] {
        let cells: Vec<_> = sheets.iter().map(Sheet::cells).collect();
        let surface = Surface::new(sheets, None, &Job::default()).unwrap();
        let mut worst = 0.0_f64;
        for point in stations[..last].iter().flatten() {
            worst = worst.max(surface.closest(*point, f64::INFINITY).unwrap().distance);
        }
        println!("{name}: {cells:?} cells, {given} points, farthest {worst:e} m");
        assert!(worst <= 1e-12 * 36.25, "{name}: {worst}");
    }
}

/// A sketched net: where nodes are, and segments with their ends and curves.
struct Sketch {
    nodes: Vec<DVec3>,
    segments: Vec<([usize; 2], Curve)>,
}

impl Sketch {
    fn read(value: &Value) -> Sketch {
        let nodes = value["nodes"].as_array().unwrap();
        let number = |id: &Value| nodes.iter().position(|node| node["id"] == *id).unwrap();
        let segments = value["segments"].as_array().unwrap().iter().map(|segment| {
            let (mut points, mut ends) = (Vec::new(), vec![0]);
            for piece in segment["ctrl_pts"].as_array().unwrap() {
                let controls = piece.as_array().unwrap().iter().map(vector);
                points.extend(controls.skip(usize::from(!points.is_empty())));
                ends.push(points.len() as u32 - 1);
            }
            let curve = CurveView::new(&points, &ends, false).unwrap().to_owned().unwrap();
            ([number(&segment["nodes"][0]), number(&segment["nodes"][1])], curve)
        });
        let segments = segments.collect();
        Sketch { nodes: nodes.iter().map(|node| vector(&node["position"])).collect(), segments }
    }

    /// The segments at a node with their other ends.
    fn at(&self, node: usize) -> impl Iterator<Item = (usize, usize)> {
        self.segments.iter().enumerate().filter_map(move |(k, &([a, b], _))| match node {
            n if n == a => Some((k, b)),
            n if n == b => Some((k, a)),
            _ => None,
        })
    }

    /// Cycles of `length` segments through different nodes, each once, that no segment cuts short.
    fn cycles(&self, length: usize) -> Vec<Vec<(usize, usize)>> {
        let mut found = Vec::new();
        for start in 0..self.nodes.len() {
            self.extend(start, length, &mut vec![(usize::MAX, start)], &mut found);
        }
        found
    }

    fn extend(
        &self,
        start: usize,
        length: usize,
        path: &mut Vec<(usize, usize)>,
        found: &mut Vec<Vec<(usize, usize)>>,
    ) {
        let (_, here) = path[path.len() - 1];
        for (segment, next) in self.at(here) {
            if path.len() == length && next == start && segment != path[1].0 && path[1].0 < segment {
                let nodes: Vec<usize> = path.iter().map(|step| step.1).collect();
                let joined = |a: usize, b: usize| self.at(nodes[a]).any(|(_, other)| other == nodes[b]);
                if length < 4 || !(joined(0, 2) || joined(1, 3)) {
                    let mut cycle: Vec<(usize, usize)> = path[1..].iter().map(|step| (step.0, step.1)).collect();
                    cycle.push((segment, start));
                    found.push(cycle);
                }
            } else if path.len() < length && next > start && path.iter().all(|step| step.1 != next) {
                path.push((segment, next));
                self.extend(start, length, path, found);
                path.pop();
            }
        }
    }
}

#[test]
fn sketched_nets_become_coons_patches_where_their_cycles_allow() {
    for name in ["10-1-2", "computer-mouse", "vacuum", "vintage_car"] {
        let Some(value) = json(&format!("cassie_{name}.graph.json")) else { return };
        let sketch = Sketch::read(&value);
        let mut used = vec![false; sketch.segments.len()];
        let (mut sheets, mut refused) = (Vec::new(), Vec::new());
        for (length, cycle) in
            [4, 3].into_iter().flat_map(|n| sketch.cycles(n).into_iter().map(move |cycle| (n, cycle)))
        {
            let curve = |k: usize| sketch.segments[cycle[k].0].1.view();
            // A three-sided cell has a pole: the node between its last side and its first.
            let start = sketch.nodes[cycle[length - 1].1];
            let tip = CurveView::new(std::slice::from_ref(&start), &[0], false).unwrap();
            let (rows, columns) = if length == 4 {
                ([curve(0), curve(2)], [curve(3), curve(1)])
            } else {
                ([tip, curve(1)], [curve(0), curve(2)])
            };
            // Ends of segments are up to 8e-7 from their nodes.
            let net = CurveNet { rows: &rows, columns: &columns, closed: [false, false], tolerance: Some(2e-6) };
            match Sheet::from_curves(&net, &Job::default()) {
                Ok(sheet) => {
                    // Two curves may meet elsewhere too; here all four corners are nodes.
                    let [h, w] = sheet.cells();
                    let corners = [(0, 0), (0, w), (h, 0), (h, w)].map(|(i, j)| sheet.corner(i, j));
                    let whole =
                        corners.iter().all(|p| cycle.iter().any(|&(_, node)| sketch.nodes[node].distance(*p) < 1e-5));
                    if whole {
                        let surface = Surface::new(vec![sheet.clone()], None, &Job::default()).unwrap();
                        for (curve, t) in (0..length).flat_map(|k| [0.2, 0.7].map(|t| (curve(k), t))) {
                            let point = curve.point(gusset::curve::Place { segment: 0, t }).unwrap();
                            let distance = surface.closest(point, f64::INFINITY).unwrap().distance;
                            assert!(distance < 4e-6, "{name}: {cycle:?}: {distance}");
                        }
                        cycle.iter().for_each(|&(segment, _)| used[segment] = true);
                        sheets.push(sheet);
                    } else {
                        refused.push("curves that meet elsewhere too");
                    }
                }
                Err(Error::CurvesApart { .. }) => refused.push("curves apart"),
                Err(Error::CurvesOutOfOrder { .. }) => refused.push("curves out of order"),
                Err(other) => panic!("{name}: {other}"),
            }
        }
        // Segments in no cell: dangling segments, and segments of longer cycles only.
        let valence = |node: usize| sketch.at(node).count();
        let free: Vec<usize> = (0..used.len()).filter(|&k| !used[k]).collect();
        let dangling = free.iter().filter(|&&k| sketch.segments[k].0.iter().any(|&node| valence(node) == 1)).count();
        println!(
            "{name}: {} cells of three or four sides with {} of {} segments; refused {refused:?}; left over {}: {dangling} dangling, {} in longer cycles only: {free:?}",
            sheets.len(),
            used.iter().filter(|&&used| used).count(),
            used.len(),
            free.len(),
            free.len() - dangling,
        );
        assert!(sheets.len() >= 10, "{name}: {}", sheets.len());
        assert!(Surface::new(sheets, None, &Job::default()).is_ok());
    }
}

#[test]
fn a_foot_from_its_frame() {
    let Some(foot) = json("foot_stations_z.json") else { return };
    let (mut points, mut offsets) = (Vec::new(), vec![0]);
    for station in foot["stations"].as_array().unwrap() {
        let mut own: Vec<DVec3> = station["points"].as_array().unwrap().iter().map(vector).collect();
        own.dedup();
        // They begin anywhere: from the highest point.
        let top = (0..own.len()).max_by(|&a, &b| own[a].y.total_cmp(&own[b].y)).unwrap();
        own.rotate_left(top);
        points.extend(own.iter().map(DVec3::to_array));
        offsets.push(points.len() as u32);
    }
    let sections =
        Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
    let curves = Options { curve: CurveKind::CubicC2, ..Options::default() };
    let options =
        FrameOptions { across: curves, along: curves, ..FrameOptions::new(Correspondence::ArcLength { columns: 32 }) };
    let made = frame(&sections, &options, &Job::default()).unwrap();
    for kind in [FrameSurface::Nodes, FrameSurface::Curves] {
        let sheet = Sheet::from_frame(&made, [false, true], kind, &Job::default()).unwrap();
        assert_eq!(sheet.is_closed(), [false, true]);
        let surface = Surface::new(vec![sheet], None, &Job::default()).unwrap();
        let mut worst = 0.0_f64;
        for &node in &made.grid.nodes {
            worst = worst.max(surface.closest(node, f64::INFINITY).unwrap().distance);
        }
        if kind == FrameSurface::Curves {
            for fit in [&made.across, &made.along] {
                for (curve, k) in (0..fit.len()).map(|k| (fit.curve(k), k)) {
                    let segment = (7 * k % curve.len()) as u32;
                    let point = curve.point(gusset::curve::Place { segment, t: 0.37 }).unwrap();
                    worst = worst.max(surface.closest(point, f64::INFINITY).unwrap().distance);
                }
            }
        }
        println!("foot, {kind:?}: farthest {worst:e}");
        assert!(worst < 1e-11, "{kind:?}: {worst}");
    }
}

/// De Casteljau's scheme on a bicubic net.
fn casteljau(net: &[DVec3], u: f64, v: f64) -> DVec3 {
    let along = |points: [DVec3; 4], t: f64| {
        let mut work = points;
        for count in [3, 2, 1] {
            for k in 0..count {
                work[k] = work[k].lerp(work[k + 1], t);
            }
        }
        work[0]
    };
    along(std::array::from_fn(|a| along(std::array::from_fn(|b| net[4 * a + b]), v)), u)
}

#[test]
fn the_teapot_is_its_patches() {
    let (Some(teapot), Some(newell)) = (json("teapot_bezier.json"), text("teapot_newell_bezier.txt")) else { return };
    let vertices: Vec<DVec3> = teapot["vertices"].as_array().unwrap().iter().map(vector).collect();
    let numbers = |patch: &Value| patch.as_array().unwrap().iter().map(|k| k.as_u64().unwrap() as usize).collect();
    let patches: Vec<Vec<usize>> = teapot["patches"].as_array().unwrap().iter().map(numbers).collect();
    // The original file says the same.
    let lines: Vec<Vec<f64>> = newell
        .lines()
        .skip(2)
        .map(|line| line.split_whitespace().map(|word| word.parse().unwrap()).collect())
        .collect();
    for line in lines.iter().filter(|line| line.len() == 4) {
        assert_eq!(vertices[line[0] as usize - 1], DVec3::new(line[1], line[2], line[3]));
    }
    let original = lines.iter().filter(|line| line.len() == 16);
    for (line, patch) in original.zip(&patches) {
        assert!(line.iter().zip(patch).all(|(&a, &b)| a.abs() as usize == b + 1));
    }
    assert_eq!(patches.len(), 28);
    let (mut exact, mut sampled, mut stated) = (0.0_f64, 0.0_f64, 0.0_f64);
    let mut sheets = Vec::new();
    for patch in &patches {
        let net: Vec<DVec3> = patch.iter().map(|&k| vertices[k]).collect();
        let sheet = Sheet::Cubic(Patches::new(&net, [3, 3], 1, 1).unwrap());
        let nodes: Vec<f64> = (0..17 * 17)
            .flat_map(|k| casteljau(&net, f64::from(k / 17) / 16.0, f64::from(k % 17) / 16.0).to_array())
            .collect();
        let nodes = Nodes::strided(nodes, 17, 17, 0, 0).unwrap();
        let grid = Sheet::Grid(Grid::new(nodes, [false, false], Scheme::SixTap).unwrap());
        let bounds = grid.interpolation_errors(&Job::default()).unwrap();
        for k in 0..400 {
            let (u, v) = (f64::from(k / 20) / 19.0, f64::from(k % 20) / 19.0);
            let truth = casteljau(&net, u, v);
            exact = exact.max(sheet.jet(0, 0, u, v).point.distance(truth));
            let ([i, j], [s, t]) = grid.locate(16.0 * u, 16.0 * v).unwrap();
            let distance = grid.jet(i, j, s, t).point.distance(truth);
            assert!(distance <= 2.0 * bounds[16 * i + j] + 1e-14, "{distance}");
            sampled = sampled.max(distance);
            stated = stated.max(bounds[16 * i + j]);
        }
        // A normal everywhere but where the patch itself is edged.
        assert!(sheet.normal(0, 0, 0.5, 0.5).length() > 0.999);
        sheets.push(sheet);
    }
    println!("teapot: patches within {exact:e}, grids within {sampled:e}, stated {stated:e}");
    assert!(exact < 4e-15 && sampled < 1e-14);
    let surface = Surface::new(sheets, None, &Job::default()).unwrap();
    assert_eq!(surface.len(), 28);
}
