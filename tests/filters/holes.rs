//! The filter `fill` with its defaults on random sheets, bowls, bodies with loose faces and torn
//! bodies. The construction of each shape says which loops are holes.

use crate::common::{Soup, cap, edge_counts, euler, sheet, some_of};
use crate::editor;
use fastrand::Rng;
use glam::{DQuat, DVec3};
use gusset::Job;
use gusset::filters::Filter;
use gusset::filters::data::{Input, Output};
use std::collections::{HashMap, HashSet};
use std::f64::consts::TAU;

/// A shape, and the number of its boundary loops by their right treatment.
struct Case {
    soup: Soup,
    holes: usize,
    outlines: usize,
    loose: usize,
    /// The Euler characteristic of the right result.
    euler: i64,
}

/// Removes interior faces that share no vertex with each other or with the boundary.
fn with_holes(soup: &Soup, count: usize, random: &mut Rng) -> Soup {
    let counts = edge_counts(soup.faces());
    let border = counts.iter().filter(|&(_, &uses)| uses != (1, 1));
    let mut taken: HashSet<u32> = border.flat_map(|(&(u, v), _)| [u, v]).collect();
    let faces: Vec<&[u32]> = soup.faces().collect();
    let mut removed = HashSet::new();
    for _ in 0..1000 {
        let f = random.usize(0..faces.len());
        if removed.len() < count && faces[f].iter().all(|v| !taken.contains(v)) {
            removed.insert(faces[f]);
            taken.extend(faces[f]);
        }
    }
    assert_eq!(removed.len(), count);
    soup.part(|face| !removed.contains(face))
}

/// Another place, unit and order of corners.
fn moved(mut soup: Soup, random: &mut Rng) -> Soup {
    let axis = DVec3::from_array([0; 3].map(|_| random.f64() - 0.5)).normalize();
    let turn = DQuat::from_axis_angle(axis, TAU * random.f64());
    let shift = DVec3::from_array([0; 3].map(|_| 10.0 * (random.f64() - 0.5)));
    let unit = 10f64.powf(12.0 * random.f64() - 6.0);
    soup.points.iter_mut().for_each(|p| *p = ((turn * DVec3::from_array(*p) + shift) * unit).to_array());
    if random.bool() { soup.turned() } else { soup }
}

/// A rectangle, an L or a disc; wavy terrain, or rolled up to a third of a tube.
fn random_sheet(random: &mut Rng) -> Soup {
    let (w, h) = (random.u32(8..24), random.u32(8..24));
    let mut soup = sheet(w, h);
    let middle = |soup: &Soup, face: &[u32]| soup.middle(face) / DVec3::new(f64::from(w), f64::from(h), 1.0);
    soup = match random.u8(0..3) {
        0 => soup,
        1 => soup.part(|face| middle(&soup, face).truncate().min_element() < 0.6),
        _ => soup.part(|face| (middle(&soup, face).truncate() - 0.5).length() < 0.5),
    };
    let roll = TAU / 3.0 * random.f64() / f64::from(w);
    let (height, phase) = (0.8 * random.f64(), TAU * random.f64());
    for p in &mut soup.points {
        p[2] = height * (0.9 * p[0] + phase).sin() * (0.8 * p[1]).cos();
        if roll > 0.05 {
            let (r, angle) = (1.0 / roll + p[2], roll * p[0]);
            *p = [r * angle.sin(), p[1], r * angle.cos()];
        }
    }
    soup
}

fn sheet_case(random: &mut Rng) -> Case {
    let holes = random.usize(0..4);
    let soup = moved(with_holes(&random_sheet(random), holes, random), random);
    Case { soup, holes, outlines: 1, loose: 0, euler: 1 }
}

/// A ball with one wide opening, a cup, or an open box: stretched by up to two.
fn random_bowl(random: &mut Rng) -> Soup {
    let n = random.u32(10..30);
    let mut soup = match random.u8(0..2) {
        0 => cap(n, n / 2 + 3, (TAU * (0.2 + 0.25 * random.f64())).cos(), 1.0),
        _ => {
            // A square or a disc, whose outer part is folded down as the wall.
            let (mut soup, rings) = (cap(if random.bool() { 4 } else { n }, 8, -0.9, 1.0), 8.0);
            let depth = 0.6 + 2.0 * random.f64();
            for p in &mut soup.points {
                let ring = rings * p[2].clamp(-1.0, 1.0).acos() / (-0.9f64).acos();
                let along = (p[0] * p[0] + p[1] * p[1]).sqrt().max(1e-9);
                let r = (ring / 4.0).min(1.0);
                *p = [p[0] / along * r, p[1] / along * r, -depth * (ring / 4.0 - 1.0).max(0.0)];
            }
            soup
        }
    };
    let stretch = [0; 3].map(|_| 1.0 + 0.3 * random.f64());
    soup.points.iter_mut().for_each(|p| (0..3).for_each(|k| p[k] *= stretch[k]));
    soup
}

fn bowl_case(random: &mut Rng) -> Case {
    let holes = random.usize(0..3);
    let soup = moved(with_holes(&random_bowl(random), holes, random), random);
    Case { soup, holes: holes + 1, outlines: 0, loose: 0, euler: 2 }
}

/// A ball with holes; single faces, pairs and strips lie about it, and some in its holes.
fn debris_case(random: &mut Rng) -> Case {
    let holes = random.usize(1..4);
    let body = with_holes(&cap(12, 9, -0.95, 1.0), holes, random);
    let (mut soup, loose) = (body.clone(), random.usize(1..6));
    for _ in 0..loose {
        let mut scrap = match random.u8(0..3) {
            0 => Soup::flat(3, &[&[0, 1, 2]]),
            1 => Soup::flat(4, &[&[0, 1, 2], &[1, 3, 2]]),
            _ => sheet(random.u32(1..6), 1),
        };
        let place = DVec3::from_array([0; 3].map(|_| 3.0 * (random.f64() - 0.5)));
        let size = 0.05 + 0.1 * random.f64();
        scrap.points.iter_mut().for_each(|p| *p = (DVec3::from_array(*p) * size + place).to_array());
        soup = soup.and(&scrap);
    }
    let euler = 2 + loose as i64;
    Case { soup: moved(soup, random), holes: holes + 1, outlines: 0, loose, euler }
}

/// A ball with holes, or a sheet, whose vertices are split in some places or everywhere.
fn torn_case(random: &mut Rng) -> Case {
    let is_sheet = random.bool();
    let mut case = if is_sheet { sheet_case(random) } else { bowl_case(random) };
    let share = if random.bool() { 1.0 } else { random.f64() * 0.5 };
    let mut torn = Soup { points: case.soup.points.clone(), offsets: vec![0], ..Soup::default() };
    for face in case.soup.faces() {
        let own = |&v: &u32| {
            if random.f64() >= share {
                return v;
            }
            torn.points.push(case.soup.points[v as usize]);
            torn.points.len() as u32 - 1
        };
        let corners: Vec<u32> = face.iter().map(own).collect();
        torn.face(&corners);
    }
    case.soup = torn;
    case
}

/// The faces with equal positions as one vertex.
fn merged(points: &[[f64; 3]], faces: &[&[u32]]) -> Vec<Vec<u32>> {
    let mut names = HashMap::new();
    let mut name = |v: &u32| {
        let next = names.len() as u32;
        *names.entry(points[*v as usize].map(f64::to_bits)).or_insert(next)
    };
    faces.iter().map(|face| face.iter().map(&mut name).collect()).collect()
}

/// The number of loops of edges with one face.
fn count_open_loops(faces: &[Vec<u32>]) -> usize {
    let counts = edge_counts(faces.iter().map(Vec::as_slice));
    let mut next: HashMap<u32, Vec<u32>> = HashMap::new();
    for (&(u, v), _) in counts.iter().filter(|&(_, &(there, back))| there + back == 1) {
        next.entry(u).or_default().push(v);
        next.entry(v).or_default().push(u);
    }
    let mut loops = 0;
    while let Some(&first) = next.keys().next() {
        let mut open = vec![first];
        while let Some(v) = open.pop() {
            open.extend(next.remove(&v).unwrap_or_default());
        }
        loops += 1;
    }
    loops
}

/// Returns the fault of the default result, if any.
fn fault_of(case: &Case) -> Option<String> {
    let outputs = editor::run_on("fill", std::slice::from_ref(&case.soup), &[]).unwrap();
    let (points, faces) = editor::mesh(&outputs[0]);
    let Output::Text(report) = &outputs[1] else { panic!("no report") };
    let text: &str = report;
    let named = |name: &str| {
        let values = report.values();
        values.iter().find(|(known, _)| *known == name).map_or(0.0, |(_, value)| value.number) as usize
    };
    let left = case.outlines + case.loose;
    let named = [named("filled_loops"), named("loops_kept") + named("loops_of_loose_faces"), named("boundary_loops")];
    if named != [case.holes, left, left] {
        return Some(format!("{named:?} instead of {:?}: {text}", [case.holes, left, left]));
    }
    let faces = merged(&points, &faces);
    let slices = || faces.iter().map(Vec::as_slice);
    let counts = edge_counts(slices());
    if counts.values().any(|&(there, back)| there > 1 || back > 1) {
        return Some("an edge is used twice in one direction".to_owned());
    }
    if count_open_loops(&faces) != left || euler(slices()) != case.euler {
        return Some(format!("{} loops, characteristic {}", count_open_loops(&faces), euler(slices())));
    }
    None
}

fn check(kind: &str, make: fn(&mut Rng) -> Case) {
    let mut count = 0;
    let mut faults = Vec::new();
    for seed in some_of(10, 0..400) {
        count += 1;
        faults.extend(fault_of(&make(&mut Rng::with_seed(seed))).map(|fault| format!("{kind} {seed}: {fault}")));
    }
    println!("{kind}: {} of {count} right", count - faults.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn outlines_of_sheets_stay_open() {
    check("sheets", sheet_case);
}

#[test]
fn openings_of_bowls_are_filled() {
    check("bowls", bowl_case);
}

#[test]
fn loose_faces_stay_as_they_are() {
    check("debris", debris_case);
}

#[test]
fn torn_meshes_are_sewn_first() {
    check("torn", torn_case);
}

/// Twice the area of a face.
fn double_area(points: &[[f64; 3]], face: &[u32]) -> f64 {
    let at = |v: u32| DVec3::from_array(points[v as usize]);
    let corners = face.windows(2).skip(1).map(|pair| (at(pair[0]) - at(face[0])).cross(at(pair[1]) - at(face[0])));
    corners.sum::<DVec3>().length()
}

#[test]
fn borders_that_are_left_unsewn_get_no_faces_without_area() {
    for seed in some_of(10, 0..400) {
        let case = torn_case(&mut Rng::with_seed(seed));
        let inputs = [Input::Mesh(case.soup.view())];
        let values = editor::values("fill", &inputs, &[("sew", &[1.0])]);
        let outputs = Filter::find("fill").unwrap().run(&inputs, &values, &Job::default()).unwrap();
        let (points, faces) = editor::mesh(&outputs[0]);
        let smallest = case.soup.faces().map(|face| double_area(&case.soup.points, face)).fold(f64::MAX, f64::min);
        let new = &faces[case.soup.faces().count()..];
        assert!(new.iter().all(|face| double_area(&points, face) > 1e-9 * smallest), "{seed}");
        assert!(editor::value(&outputs[1], "coincident_edges") > 0.0, "{seed}");
    }
}

#[test]
fn coincident_borders_are_sewn_before_holes_are_filled() {
    for seed in some_of(20, 0..400) {
        let case = torn_case(&mut Rng::with_seed(seed));
        let inputs = [Input::Mesh(case.soup.view())];
        let values = editor::values("fill", &inputs, &[]);
        let outputs = Filter::find("fill").unwrap().run(&inputs, &values, &Job::default()).unwrap();
        let [coincident, sewn] = ["coincident_edges", "sewn_edges"].map(|name| editor::value(&outputs[1], name));
        assert!(sewn > 0.0 && coincident >= sewn, "{seed}");
        let said = editor::text(&outputs[1]).lines().filter(|line| line.contains("coincide")).count();
        let first = editor::text(&outputs[1]).lines().next().unwrap_or_default();
        assert!(said == 1 && first.starts_with(&format!("{coincident} boundary edge")), "{seed}: {first}");
        assert!(first.ends_with(" sewn before holes are filled"), "{seed}: {first}");
    }
}

#[test]
fn a_join_lists_no_loops_that_filling_closed() {
    for seed in some_of(10, 0..400) {
        let case = bowl_case(&mut Rng::with_seed(seed));
        let inputs = [Input::Mesh(case.soup.view())];
        let values = editor::values("join", &inputs, &[("holes", &[1.0])]);
        let outputs = Filter::find("join").unwrap().run(&inputs, &values, &Job::default()).unwrap();
        let report = &outputs[1];
        let numbers = ["filled_holes", "boundary_loops", "near_loops_left"].map(|name| editor::value(report, name));
        let text = editor::text(report);
        let joined = editor::value(report, "joins") as usize;
        assert!(numbers[0] as usize + 2 * joined >= case.holes && numbers[1..] == [0.0, 0.0], "{seed}: {text}");
        assert!(!text.contains("not joined:") && !text.contains("left open"), "{seed}: {text}");
    }
}
