//! Regions of genus 0 with two to six loops cut out of real closed meshes, and closed again by one
//! patch. Skipped where the data are not.

use crate::common::{Soup, data, edge_counts, euler, faces_of, is_exhaustive, some_of};
use glam::DVec3;
use gusset::Job;
use gusset::fill::{Fairing, Filled, Keep, LoopSelection, Options, Refinement, Together, fill_holes};
use gusset::mesh::Mesh;
use gusset_oracles::distances::distances;
use std::collections::{BTreeMap, HashMap};

const NAMES: [&str; 6] = [
    "elephant-with-holes.off",
    "nefertiti.off",
    "head.off",
    "lion.off",
    "mech-holes-shark.off",
    "double-torus-3-holes.off",
];

fn soup_of(mesh: &Mesh) -> Soup {
    let points = (0..mesh.positions.len() as u32).map(|v| mesh.positions.get(v).to_array()).collect();
    Soup { points, offsets: mesh.face_offsets.clone(), corners: mesh.face_corners.clone() }
}

/// The closed meshes: those whose holes could be filled.
fn closed_meshes() -> Vec<(&'static str, Soup)> {
    let mut found = Vec::new();
    for name in NAMES {
        let Some(soup) = data::off(&format!("meshes/{name}")) else {
            continue;
        };
        let filled = fill_holes(&soup.view(), LoopSelection::All, &Options::default(), &Job::default()).unwrap();
        assert_eq!(filled.intersections.as_deref(), Some(&[][..]), "{name}: its own holes by default");
        let whole = soup_of(&filled.mesh);
        if edge_counts(whole.faces()).values().all(|&counts| counts == (1, 1)) && has_single_fans(&whole) {
            found.push((name, whole));
        } else {
            println!("{name} is no closed manifold: not used");
        }
    }
    found
}

/// True if the faces at each vertex of a closed mesh are one cycle.
fn has_single_fans(soup: &Soup) -> bool {
    let mut after = HashMap::new();
    let mut corners = HashMap::new();
    for face in soup.faces() {
        for (k, &v) in face.iter().enumerate() {
            after.insert((v, face[(k + 1) % face.len()]), face[(k + face.len() - 1) % face.len()]);
            corners.entry(v).or_insert((0, face[(k + 1) % face.len()])).0 += 1;
        }
    }
    corners.iter().all(|(&v, &(count, first))| {
        let mut at = first;
        let steps = (1..=count).find(|_| {
            at = after[&(v, at)];
            at == first
        });
        steps == Some(count)
    })
}

/// A part of a mesh, and the rest.
struct Region {
    removed: Vec<Vec<u32>>,
    rest: Soup,
    loops: usize,
}

fn centre(soup: &Soup, face: &[u32]) -> DVec3 {
    face.iter().map(|&v| DVec3::from_array(soup.points[v as usize])).sum::<DVec3>() / face.len() as f64
}

/// The connected parts of the faces that are chosen, those that are of genus 0 with two to six
/// simple loops.
fn regions(soup: &Soup, chosen: impl Fn(DVec3) -> bool) -> Vec<Region> {
    let faces: Vec<&[u32]> = soup.faces().collect();
    let is_in: Vec<bool> = faces.iter().map(|face| chosen(centre(soup, face))).collect();
    let sides = |f: usize| faces[f].iter().zip(faces[f].iter().cycle().skip(1)).map(|(&u, &v)| (u, v));
    let at: HashMap<(u32, u32), usize> = (0..faces.len()).flat_map(|f| sides(f).map(move |side| (side, f))).collect();
    let mut part = vec![usize::MAX; faces.len()];
    let mut found = Vec::new();
    for seed in 0..faces.len() {
        if !is_in[seed] || part[seed] != usize::MAX {
            continue;
        }
        let (mut open, mut own) = (vec![seed], Vec::new());
        part[seed] = seed;
        while let Some(f) = open.pop() {
            own.push(f);
            for g in sides(f).map(|(u, v)| at[&(v, u)]) {
                if is_in[g] && part[g] == usize::MAX {
                    part[g] = seed;
                    open.push(g);
                }
            }
        }
        own.sort_unstable();
        let border = own.iter().flat_map(|&f| sides(f)).filter(|&(u, v)| part[at[&(v, u)]] != seed);
        let border: Vec<_> = border.collect();
        let next: BTreeMap<u32, u32> = border.iter().copied().collect();
        if own.len() < 20 || own.len() * 2 > faces.len() || next.len() != border.len() {
            continue;
        }
        let removed: Vec<Vec<u32>> = own.iter().map(|&f| faces[f].to_vec()).collect();
        let loops = count_loops(&next);
        let is_planar = euler(removed.iter().map(Vec::as_slice)) == 2 - loops as i64;
        if is_planar && (2..=6).contains(&loops) {
            let mut rest = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
            faces.iter().zip(&part).filter(|&(_, &part)| part != seed).for_each(|(face, _)| rest.face(face));
            found.push(Region { removed, rest, loops });
        }
    }
    found
}

fn count_loops(next: &BTreeMap<u32, u32>) -> usize {
    let mut left = next.clone();
    let mut loops = 0;
    while let Some((_, mut v)) = left.pop_first() {
        while let Some(w) = left.remove(&v) {
            v = w;
        }
        loops += 1;
    }
    loops
}

/// Slices along the axes, and balls with smaller ones inside them left out.
fn cut_out(soup: &Soup) -> Vec<Region> {
    let points = soup.points.iter().map(|&p| DVec3::from_array(p));
    let low = points.clone().fold(DVec3::INFINITY, DVec3::min);
    let size = points.fold(DVec3::NEG_INFINITY, DVec3::max) - low;
    let mut found = Vec::new();
    for (axis, width) in [(0, 0.06), (1, 0.06), (2, 0.06), (0, 0.15), (1, 0.15), (2, 0.15)] {
        for k in 1..8 {
            let middle = low[axis] + size[axis] * f64::from(k) / 8.0;
            found.extend(regions(soup, |p| (p[axis] - middle).abs() < width / 2.0 * size[axis]));
        }
    }
    let count = soup.offsets.len() - 1;
    for (islands, seed) in (1..=5).flat_map(|islands| [1, 2].map(|k| (islands, count * (5 * k + islands) / 17))) {
        let middle = centre(soup, soup.faces().nth(seed).unwrap());
        let radius = 0.12 * size.length();
        let inner: Vec<DVec3> = (0..islands)
            .map(|i| {
                let t = std::f64::consts::TAU * i as f64 / islands as f64;
                let p = middle + DVec3::new(t.cos(), t.sin(), (2.0 * t).cos()) * 0.6 * radius;
                let centres = soup.faces().map(|face| centre(soup, face));
                centres.min_by(|a, b| a.distance(p).total_cmp(&b.distance(p))).unwrap()
            })
            .collect();
        let is_island = |p: DVec3| inner.iter().any(|q| q.distance(p) < 0.22 * radius);
        found.extend(regions(soup, |p| p.distance(middle) < radius && !is_island(p)));
    }
    found.sort_by_key(|region| std::cmp::Reverse(region.loops));
    assert!(!found.is_empty());
    // More of one mesh take long and say nothing more.
    let most = if is_exhaustive() { 16 } else { 5 };
    let step = found.len().div_ceil(most);
    found.into_iter().step_by(step).collect()
}

/// The mean distance of the corners of one part of a surface from another, as a part of the size
/// of the box round it.
fn mean_distance(from: &[[DVec3; 3]], to: &[[DVec3; 3]]) -> f64 {
    let points = || from.as_flattened().iter().copied();
    let size = points().fold(DVec3::NEG_INFINITY, DVec3::max) - points().fold(DVec3::INFINITY, DVec3::min);
    // The centroid of corners, so that small triangles have more weight.
    let all: Vec<_> = points().step_by(points().count().div_ceil(500)).collect();
    distances(&all, to).into_iter().sum::<f64>() / all.len() as f64 / size.length()
}

fn triangles<'a>(point: impl Fn(u32) -> DVec3, faces: impl Iterator<Item = &'a [u32]>) -> Vec<[DVec3; 3]> {
    let fan = |face: &'a [u32]| (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]);
    faces.flat_map(fan).map(|corners| corners.map(&point)).collect()
}

fn fill(region: &Region, options: &Options) -> Filled {
    fill_holes(&region.rest.view(), LoopSelection::All, options, &Job::default()).unwrap()
}

#[test]
fn regions_of_several_loops_are_closed_as_they_were() {
    // Islands of few faces count as loose by default.
    let plain = Options { together: Together::One, keep: Keep::None, ..Options::default() };
    let fair = Options { refinement: Refinement::RimDensity(0), fairing: Fairing::ThinPlate, ..plain };
    for (name, soup) in closed_meshes() {
        let characteristic = euler(soup.faces());
        let mut off = [Vec::new(), Vec::new()];
        for region in some_of(2, cut_out(&soup).into_iter()) {
            for (options, off) in [plain, fair].iter().zip(&mut off) {
                let filled = fill(&region, options);
                assert_eq!(filled.holes.len(), region.loops);
                assert!(filled.holes.iter().all(|hole| hole.patch == 0), "{name}: {:?}", filled.holes);
                assert!(edge_counts(faces_of(&filled.mesh)).values().all(|&counts| counts == (1, 1)), "{name}");
                assert_eq!(euler(faces_of(&filled.mesh)), characteristic, "{name}");
                assert_eq!(filled.intersections.as_deref(), Some(&[][..]), "{name}");
                let old = region.rest.offsets.len() - 1;
                let new = triangles(|v| filled.mesh.positions.get(v), faces_of(&filled.mesh).skip(old));
                let point = |v: u32| DVec3::from_array(soup.points[v as usize]);
                let removed = triangles(point, region.removed.iter().map(Vec::as_slice));
                off.push(mean_distance(&removed, &new).max(mean_distance(&new, &removed)));
            }
        }
        for (off, way) in off.iter_mut().zip(["plain", "faired"]) {
            off.sort_by(f64::total_cmp);
            let (median, most) = (off[off.len() / 2], off[off.len() - 1]);
            println!(
                "{name}: {} regions, {way} ones off by {median:.4} in the median, {most:.4} at the most",
                off.len()
            );
            assert!(median < 0.02 && most < 0.06, "{name}");
        }
    }
}
