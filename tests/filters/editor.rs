//! Small and large inputs for each filter, as a mesh editor passes them.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use crate::common::{Soup, cap, torus};
use gusset::filters::Filter;
use gusset::filters::data::{Curves, Input, InputKind, Output};
use gusset::mesh::Mesh;
use gusset::{Job, Result};
use std::f64::consts::{PI, TAU};

/// An input that owns what it is made of.
pub enum Given {
    Mesh(Soup),
    Curves(Curves),
}

/// As a filter takes them.
pub fn inputs(given: &[Given]) -> Vec<Input<'_>> {
    let mut inputs = Vec::new();
    for given in given {
        inputs.push(match given {
            Given::Mesh(soup) => Input::Mesh(soup.view()),
            Given::Curves(curves) => Input::Curves(curves),
        });
    }
    inputs
}

/// Runs a filter on meshes.
pub fn run_on(id: &str, soups: &[Soup], values: &[f64]) -> Result<Vec<Output>> {
    let inputs: Vec<_> = soups.iter().map(|soup| Input::Mesh(soup.view())).collect();
    Filter::find(id).unwrap().run(&inputs, values, &Job::default())
}

/// Runs a filter on polylines.
pub fn run_on_curves(id: &str, curves: &[Curves], values: &[f64]) -> Result<Vec<Output>> {
    let inputs: Vec<_> = curves.iter().map(Input::Curves).collect();
    Filter::find(id).unwrap().run(&inputs, values, &Job::default())
}

/// The defaults for some inputs, with the parameters that are named set to other values.
pub fn values(id: &str, inputs: &[Input<'_>], set: &[(&str, &[f64])]) -> Vec<f64> {
    let filter = Filter::find(id).unwrap();
    let mut values = filter.defaults(inputs);
    for (name, given) in set {
        let place = filter.params.iter().position(|param| param.id == *name).unwrap_or_else(|| panic!("{id}: {name}"));
        let start: usize = filter.params[..place].iter().map(|param| param.kind.component_count()).sum();
        values[start..start + given.len()].copy_from_slice(given);
    }
    values
}

/// The parts of an output that must be a mesh: points and faces.
pub fn mesh(output: &Output) -> (Vec<[f64; 3]>, Vec<&[u32]>) {
    let Output::Mesh(mesh, _) = output else { panic!("no mesh: {output:?}") };
    (points(mesh), mesh.faces().collect())
}

/// The positions of a mesh.
pub fn points(mesh: &Mesh) -> Vec<[f64; 3]> {
    (0..mesh.positions.len()).map(|v| mesh.positions.get(v as u32).to_array()).collect()
}

/// An output that must be polylines.
pub fn lines(output: &Output) -> &Curves {
    let Output::Curves(curves) = output else { panic!("no curves: {output:?}") };
    curves
}

/// An output that must be text.
pub fn text(output: &Output) -> &str {
    let Output::Text(text) = output else { panic!("no text: {output:?}") };
    text
}

/// The number of this name in a report.
pub fn value(output: &Output, name: &str) -> f64 {
    let Output::Text(report) = output else { panic!("no text: {output:?}") };
    let found = report.values().iter().find(|(known, _)| *known == name);
    found.unwrap_or_else(|| panic!("{name} is not in: {report:?}")).1.number
}

/// The number behind a word of a report.
pub fn number(text: &str, behind: &str) -> f64 {
    let (_, rest) = text.split_once(behind).unwrap_or_else(|| panic!("{behind} is not in: {text}"));
    let end = |c: char| c.is_whitespace() || c == ',' || c == ';' || c == ')';
    rest.trim_start_matches([' ', ':', '(']).split(end).next().unwrap().parse().unwrap_or_else(|_| panic!("{rest}"))
}

/// The points of one polyline.
pub fn curve(curves: &Curves, c: usize) -> &[[f64; 3]] {
    &curves.points[curves.offsets[c] as usize..curves.offsets[c + 1] as usize]
}

pub fn radius(p: &[f64; 3]) -> f64 {
    p[0].hypot(p[1]).hypot(p[2])
}

/// Polylines of points and whether they are closed.
pub fn polylines(lines: &[(Vec<[f64; 3]>, bool)]) -> Curves {
    let mut curves = Curves { offsets: vec![0], ..Curves::default() };
    for (points, closed) in lines {
        curves.points.extend(points);
        curves.offsets.push(curves.points.len() as u32);
        curves.closed.push(*closed);
    }
    curves
}

/// A circle of `count` points round a centre, counter-clockwise from above.
pub fn circle(count: u32, radius: f64, [x, y, z]: [f64; 3]) -> Vec<[f64; 3]> {
    let point = |k: u32| {
        let (sin, cos) = (TAU * f64::from(k) / f64::from(count)).sin_cos();
        [x + radius * cos, y + radius * sin, z]
    };
    (0..count).map(point).collect()
}

/// A unit sphere of quads, closed round and seen from outside; `rows` cells from pole to pole.
pub fn sphere(rows: u32, columns: u32) -> Soup {
    let mut points = vec![[0.0, 0.0, 1.0]];
    for i in 1..rows {
        let (sin, cos) = (PI * f64::from(i) / f64::from(rows)).sin_cos();
        points.extend((0..columns).map(|j| {
            let (y, x) = (TAU * f64::from(j) / f64::from(columns)).sin_cos();
            [sin * x, sin * y, cos]
        }));
    }
    points.push([0.0, 0.0, -1.0]);
    let south = points.len() as u32 - 1;
    let node = |i: u32, j: u32| 1 + (i - 1) * columns + j % columns;
    let mut soup = Soup::new(points, &[]);
    for j in 0..columns {
        soup.face(&[0, node(1, j), node(1, j + 1)]);
    }
    for (i, j) in (1..rows - 1).flat_map(|i| (0..columns).map(move |j| (i, j))) {
        soup.face(&[node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)]);
    }
    for j in 0..columns {
        soup.face(&[south, node(rows - 1, j + 1), node(rows - 1, j)]);
    }
    soup
}

/// A cube about the origin: corner k is at `-side` or `side` on axis i as bit i of k says.
pub fn box_around(side: f64) -> Soup {
    let point = |k: u32| [0, 1, 2].map(|axis| if k >> axis & 1 == 1 { side } else { -side });
    let faces: [&[u32]; 6] = [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]];
    Soup::new((0..8).map(point).collect(), &faces)
}

/// Two caps that face each other askew, of about `faces` faces together.
pub fn pieces(faces: u32) -> [Soup; 2] {
    let rings = ((f64::from(faces) / 8.0).sqrt() as u32).max(3);
    let mut second = cap(3 * rings, rings + 1, 0.3, -1.0);
    second.points.iter_mut().for_each(|p| p[0] += 0.6);
    [cap(4 * rings, rings, 0.2, 1.0), second]
}

/// Inputs that a filter takes, of about `size` faces or points in all; `size` 100 makes small ones.
pub fn given(filter: &Filter, size: u32) -> Vec<Given> {
    let side = (f64::from(size) / 2.0).sqrt() as u32 + 1;
    let grid = |scale: f64, x: f64| {
        let mut soup = sphere(side, side + side / 2);
        soup.points.iter_mut().for_each(|p| *p = [scale * p[0] + x, scale * p[1], scale * p[2]]);
        soup
    };
    let mesh = |scale, x| Given::Mesh(grid(scale, x));
    let wave = |z: f64| -> Vec<[f64; 3]> {
        let point = |k: u32| {
            let t = f64::from(k) / f64::from(size / 2 + 4);
            [2.5 * t - 1.0, (5.0 * t).sin(), z]
        };
        (0..size / 2 + 5).map(point).collect()
    };
    let rings = |count: u32| -> Vec<(Vec<[f64; 3]>, bool)> {
        let ring = |k: u32| {
            let z = f64::from(k) / f64::from(count);
            (circle(size / count + 3, 1.0 + 0.3 * (2.0 * z).sin(), [0.1 * z, 0.0, 2.0 * z]), true)
        };
        (0..count).map(ring).collect()
    };
    let both = [(circle(size / 2 + 7, 1.0, [0.0; 3]), true), (wave(0.0), false)];
    let curves = |lines: &[(Vec<[f64; 3]>, bool)]| Given::Curves(polylines(lines));
    match (filter.id, filter.inputs, filter.category) {
        (_, [], _) => Vec::new(),
        ("net_analyse" | "morph", ..) => {
            let (before, mut after) = (grid(1.0, 0.0), grid(1.0, 0.0));
            after.points.iter_mut().for_each(|p| *p = [p[0] + 0.2 * p[2] * p[2], 0.8 * p[1], p[2]]);
            vec![Given::Mesh(before), Given::Mesh(after)]
        }
        ("lattice", ..) => {
            let (rest, mut moved) = (box_around(2.0), box_around(2.0));
            moved.points[7] = [3.0, 2.5, 2.0];
            vec![mesh(1.0, 0.0), Given::Mesh(rest), Given::Mesh(moved)]
        }
        ("unite", ..) => {
            let (left, mut right) = (torus(side, side), torus(side, side));
            right.points.iter_mut().for_each(|p| *p = [p[0] + 1.37, p[2] + 0.11, 0.07 - p[1]]);
            vec![Given::Mesh(left), Given::Mesh(right)]
        }
        ("facing_arcs", ..) => vec![curves(&[
            (circle(size / 2 + 7, 1.0, [0.0; 3]), true),
            (circle(size / 2 + 9, 0.7, [0.4, 0.0, 1.0]), true),
        ])],
        ("strip", ..) => vec![curves(&rings(2))],
        ("net_lathe", ..) => {
            let profile = wave(0.0).iter().map(|p| [2.0 + p[1], 0.0, p[0]]).collect();
            vec![curves(&[(profile, false)])]
        }
        ("loft", ..) => vec![curves(&rings(f64::from(size).sqrt() as u32 / 3 + 4))],
        ("smooth_net", ..) => vec![curves(&rings(f64::from(size).sqrt() as u32 / 3 + 4))],
        (_, [InputKind::Mesh, InputKind::Mesh, ..], _) => vec![mesh(1.0, 0.0), mesh(1.1, 0.3)],
        (_, [InputKind::Mesh, InputKind::Curves], _) => vec![mesh(1.0, 0.0), curves(&[(wave(0.1), false)])],
        (_, [InputKind::Curves, InputKind::Curves], _) => vec![curves(&[(wave(0.5), false)]), curves(&both)],
        ("section", ..) => vec![mesh(1.0, 0.0)],
        (_, [InputKind::Mesh], "Quad grids" | "Smooth surfaces") => vec![mesh(1.0, 0.0)],
        (_, [InputKind::Mesh], _) => pieces(size).into_iter().take(filter.max_inputs).map(Given::Mesh).collect(),
        _ => vec![curves(&both)],
    }
}
