//! Borders that are apart: the hint which tolerance sews them, and tolerances wider than edges.

use super::touching::Pose;
use crate::common::{Soup, edge_counts, faces_of, is_exhaustive};
use gusset::Job;
use gusset::repair::weld::{Options, Weld, weld};

/// A sheet of quads with edges near 1, from `x` on: `columns` wide, 12 long.
fn sheet(x: f64, columns: u32, random: &mut fastrand::Rng) -> Soup {
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let mut y = 0.0;
    for _ in 0..=LENGTH {
        soup.points.extend((0..=columns).map(|i| [x + f64::from(i), y, 0.0]));
        y += 0.8 + 0.4 * random.f64();
    }
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    for j in 0..LENGTH {
        (0..columns).for_each(|i| soup.face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
    }
    soup
}

const LENGTH: u32 = 12;

/// Two sheets with equal borders, `gap` apart.
fn two_sheets(gap: f64, seed: u64) -> Soup {
    let mut random = fastrand::Rng::with_seed(seed);
    let columns = [random.u32(4..8), random.u32(4..8)];
    let borders = random.u64(..);
    let pieces = [(-f64::from(columns[0]), columns[0]), (gap, columns[1])];
    let [mut all, other] = pieces.map(|(x, columns)| sheet(x, columns, &mut fastrand::Rng::with_seed(borders)));
    let first = all.points.len() as u32;
    all.points.extend(&other.points);
    let other = if random.bool() { other.turned() } else { other };
    other.offsets.windows(2).for_each(|face| {
        let corners: Vec<u32> = other.corners[face[0] as usize..face[1] as usize].iter().map(|v| v + first).collect();
        all.face(&corners);
    });
    Pose::random(&mut random).moved(all)
}

fn welded(soup: &Soup, tolerance: Option<f64>) -> Weld {
    weld(&soup.view(), &Options { tolerance, ..Options::default() }, &Job::default()).unwrap()
}

fn mean_edge(soup: &Soup) -> f64 {
    let [p, q] = [0, 1].map(|k| glam::DVec3::from_array(soup.points[k]));
    p.distance(q)
}

fn cases() -> u64 {
    if is_exhaustive() { 5000 } else { 200 }
}

#[test]
fn the_hint_names_a_tolerance_that_sews_all() {
    for seed in 0..cases() {
        let gap = 0.07 * fastrand::Rng::with_seed(!seed).f64() + 1e-4;
        let soup = two_sheets(gap, seed);
        let before = welded(&soup, None);
        assert_eq!((before.sewn_edges, before.near.edge_pairs), (0, LENGTH), "{seed}");
        let apart = gap * mean_edge(&soup);
        let ratio = before.near.tolerance / apart;
        assert!((1.0 - 1e-9..1.12).contains(&ratio), "{seed}: {ratio}");
        assert!(before.near.hint().unwrap().contains(&format!("{:e}", before.near.tolerance)), "{seed}");
        let after = welded(&soup, Some(before.near.tolerance));
        assert_eq!((after.sewn_edges, after.near.edge_pairs), (LENGTH, 0), "{seed}");
    }
}

#[test]
fn borders_far_apart_give_no_hint() {
    for seed in 0..20 {
        let soup = two_sheets(0.2 + fastrand::Rng::with_seed(seed).f64(), seed);
        assert_eq!(welded(&soup, None).near, gusset::repair::near_borders::NearBorders::default(), "{seed}");
    }
    assert_eq!(welded(&two_sheets(0.0, 1), None).near.hint(), None);
}

/// A tolerance of up to four edges pairs the borders, vertex by vertex, and nothing else.
#[test]
fn tolerances_wider_than_edges_pair_across() {
    for seed in 0..cases() {
        let mut random = fastrand::Rng::with_seed(!seed);
        let gap = 0.3 + 2.0 * random.f64();
        let soup = two_sheets(gap, seed);
        let tolerance = gap * (1.01 + random.f64()) * mean_edge(&soup);
        let done = welded(&soup, Some(tolerance));
        assert_eq!((done.sewn_edges, done.welded_vertices), (LENGTH, LENGTH + 1), "{seed}: gap {gap}");
        assert!(edge_counts(faces_of(&done.mesh)).values().all(|&(there, back)| there + back <= 2), "{seed}");
    }
}

/// A cut through a sheet, as wide as several of its edges in the middle, and closed at both ends.
#[test]
fn a_wide_cut_is_sewn_up_to_its_ends() {
    for seed in 0..cases() {
        let mut random = fastrand::Rng::with_seed(seed);
        let width = 0.2 + 2.0 * random.f64();
        let mut soup = sheet(0.0, 12, &mut fastrand::Rng::with_seed(seed));
        // The vertices of the middle column, between its ends, become two.
        let middle = |j: u32| j * 13 + 6;
        for j in 1..LENGTH {
            let opening = width * (std::f64::consts::PI * f64::from(j) / f64::from(LENGTH)).sin();
            let old = middle(j) as usize;
            let new = soup.points.len() as u32;
            soup.points.push(soup.points[old]);
            soup.points[old][2] += 0.5 * opening;
            soup.points[new as usize][2] -= 0.5 * opening;
            let right = |h: usize| (h / 4) % 12 >= 6;
            for (_, v) in soup.corners.iter_mut().enumerate().filter(|(h, _)| right(*h)) {
                if *v as usize == old {
                    *v = new;
                }
            }
        }
        let soup = Pose::random(&mut random).moved(soup);
        let done = welded(&soup, Some(1.1 * width * mean_edge(&soup)));
        assert_eq!((done.welded_vertices, done.sewn_edges), (LENGTH - 1, LENGTH), "{seed}: width {width}");
    }
}

/// The corners of each triangle of a box are moved by themselves, as in files of single precision that
/// were turned and moved triangle by triangle.
#[test]
fn the_hint_covers_soups_whose_corners_differ() {
    for seed in 0..cases() {
        let mut random = fastrand::Rng::with_seed(seed);
        let jitter = 10f64.powf(-2.0 - 10.0 * random.f64());
        let box_of_quads = crate::weld::cube([0.0; 3]);
        let mut soup = Soup { offsets: vec![0], ..Soup::default() };
        for face in box_of_quads.faces() {
            for corners in [[face[0], face[1], face[2]], [face[0], face[2], face[3]]] {
                let first = soup.points.len() as u32;
                let moved = |v: u32| box_of_quads.points[v as usize].map(|x| x + jitter * (random.f64() - 0.5));
                soup.points.extend(corners.map(moved));
                soup.face(&[first, first + 1, first + 2]);
            }
        }
        let before = welded(&soup, None);
        assert_eq!(before.sewn_edges + before.near.edge_pairs, 18, "{seed}: {jitter}");
        let after = welded(&soup, Some(before.near.tolerance.max(before.tolerance)));
        assert_eq!((after.sewn_edges, after.near.edge_pairs), (18, 0), "{seed}: {jitter}");
    }
}
