//! Texture coordinates across strips and patches.

use super::carried;
use super::fields::{job, stitched};
use crate::common::{Soup, cap, sheet};
use gusset::attributes::{Domain, Origins, Rule};
use gusset::fill::{self, LoopSelection, fill_holes};
use gusset::stitch::{Cells, Extent, Options, Rows};
use std::f64::consts::TAU;

/// Texture coordinates of each corner, an affine map of where its vertex is.
fn mapped(soup: &Soup, map: impl Fn([f64; 3]) -> [f64; 2]) -> Vec<f64> {
    soup.corners.iter().flat_map(|&v| map(soup.points[v as usize])).collect()
}

fn plain(p: [f64; 3]) -> [f64; 2] {
    [0.1 * p[0] + 0.02 * p[1], 0.1 * p[1]]
}

fn elsewhere(p: [f64; 3]) -> [f64; 2] {
    [0.9 - 0.05 * p[1], 0.3 + 0.07 * p[0]]
}

/// A sheet of triangles and one of quads, side by side with a gap.
fn sides() -> [Soup; 2] {
    let grid = sheet(7, 3);
    let mut left = Soup { points: grid.points.clone(), offsets: vec![0], ..Soup::default() };
    for face in grid.faces() {
        left.face(&[face[0], face[1], face[2]]);
        left.face(&[face[0], face[2], face[3]]);
    }
    let mut right = sheet(6, 4);
    right.points.iter_mut().for_each(|p| (p[0], p[1]) = (p[0] * 7.0 / 6.0 + 0.05, p[1] * 0.8 + 3.9));
    [left, right]
}

fn options() -> Vec<Options> {
    let arcs = Options { extent: Extent::OpenArcs, ..Options::default() };
    vec![
        arcs,
        Options { rows: Rows::Count(1), ..arcs },
        Options { rows: Rows::Count(4), ..arcs },
        Options { rows: Rows::Count(3), cells: Cells::Quads, ..arcs },
    ]
}

#[test]
fn one_chart_goes_on_across_a_strip() {
    let [a, b] = sides();
    for options in options() {
        let case = stitched("one chart", &a, Some(&b), &options);
        let found = carried(&case.origins, Domain::Corners, Rule::Texture, 2, &[mapped(&a, plain), mapped(&b, plain)]);
        for (uv, &v) in found.chunks_exact(2).zip(&case.mesh.face_corners) {
            let exact = plain(case.at(v).to_array());
            assert!((0..2).all(|k| (uv[k] - exact[k]).abs() < 1e-12), "{uv:?} {exact:?}");
        }
    }
}

/// A tube about the z axis. Its texture wraps once around from column `cut` on.
fn tube(around: u32, low: f64, cut: u32) -> (Soup, Vec<f64>) {
    let (mut soup, mut values) = (Soup { offsets: vec![0], ..Soup::default() }, Vec::new());
    for row in 0..3 {
        for k in 0..around {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(around)).sin_cos();
            soup.points.push([cos, sin, low + 0.3 * f64::from(row)]);
        }
    }
    for (row, k) in (0..2).flat_map(|row| (0..around).map(move |k| (row, k))) {
        let at = |row: u32, k: u32| row * around + k % around;
        soup.face(&[at(row, k), at(row, k + 1), at(row + 1, k + 1), at(row + 1, k)]);
        let first = (k + around - cut) % around;
        for (column, row) in [(first, row), (first + 1, row), (first + 1, row + 1), (first, row + 1)] {
            values.extend([f64::from(column) / f64::from(around), low + 0.3 * f64::from(row)]);
        }
    }
    (soup, values)
}

/// A periodic chart is cut somewhere: no face of a strip spans the whole chart backwards.
#[test]
fn faces_are_on_one_side_of_a_cut() {
    let rows = [(Rows::None, Cells::Triangles), (Rows::Count(1), Cells::Triangles), (Rows::Count(4), Cells::Quads)];
    for (cut, (rows, cells)) in [0, 5].into_iter().flat_map(|cut| rows.map(|rows| (cut, rows))) {
        // The last one's jumps are of different lengths: no texture repeats like that.
        for (below, stretch) in [(12, 1.0), (17, 1.0), (17, 0.97)] {
            // Cuts that do not face each other, too.
            let ((a, of_a), (b, mut of_b)) = (tube(below, 0.0, cut * below / 12 + below % 2), tube(12, 1.0, cut));
            of_b.iter_mut().step_by(2).for_each(|u| *u *= stretch);
            let options = Options { rows, cells, ..Options::default() };
            let case = stitched("cut", &a, Some(&b), &options);
            let found = carried(&case.origins, Domain::Corners, Rule::Texture, 2, &[of_a, of_b]);
            for range in case.mesh.face_offsets.windows(2) {
                let u = (range[0]..range[1]).map(|corner| found[2 * corner as usize]);
                let (low, high) = u.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), u| (a.min(u), b.max(u)));
                assert!(high - low < 0.3, "{rows:?} {cut} {below}: {low} to {high}");
            }
        }
    }
}

/// Values that differ by as much as a scan's do: interpolated still, and one at each vertex.
#[test]
fn charts_that_nearly_fit_are_continuous() {
    let [a, b] = sides();
    let near = |p: [f64; 3]| plain(p).map(|x| x + 0.01 * (3.0 * p[0]).sin() + 0.006);
    for options in options() {
        let case = stitched("near", &a, Some(&b), &options);
        let found = carried(&case.origins, Domain::Corners, Rule::Texture, 2, &[mapped(&a, plain), mapped(&b, near)]);
        let mut at = vec![None; case.mesh.positions.len()];
        for (uv, &v) in found.chunks_exact(2).zip(&case.mesh.face_corners) {
            assert_eq!(*at[v as usize].get_or_insert([uv[0], uv[1]]), [uv[0], uv[1]]);
        }
    }
}

#[test]
fn charts_that_do_not_fit_go_on_to_a_seam() {
    let [a, b] = sides();
    for options in options() {
        let case = stitched("two charts", &a, Some(&b), &options);
        let inputs = [mapped(&a, plain), mapped(&b, elsewhere)];
        let found = carried(&case.origins, Domain::Corners, Rule::Texture, 2, &inputs);
        let old = a.faces().count() + b.faces().count();
        let (mut of_a, mut of_b) = (0, 0);
        for (f, face) in case.mesh.faces().enumerate().skip(old) {
            let first = case.mesh.face_offsets[f] as usize;
            let fits = |map: fn([f64; 3]) -> [f64; 2]| {
                face.iter().zip(found[2 * first..].chunks_exact(2)).all(|(&v, uv)| {
                    let exact = map(case.at(v).to_array());
                    (0..2).all(|k| (uv[k] - exact[k]).abs() < 1e-9)
                })
            };
            // At the ends of the arcs faces run back beside the sheets.
            let place = |v: u32| (0.1..=6.9).contains(&case.at(v).x) && (3.0..=3.9).contains(&case.at(v).y);
            let between = face.iter().all(|&v| place(v));
            assert!(!between || fits(plain) || fits(elsewhere), "face {f}");
            of_a += usize::from(fits(plain));
            of_b += usize::from(fits(elsewhere));
        }
        // The seam is in the middle.
        assert!(of_a.abs_diff(of_b) <= (of_a + of_b) / 3 + 2, "{of_a} {of_b}");
        // Other rules mix them.
        let mixed = carried(&case.origins, Domain::Corners, Rule::Linear, 2, &inputs);
        assert_eq!(
            mixed[..2 * case.mesh.face_offsets[old] as usize],
            found[..2 * case.mesh.face_offsets[old] as usize]
        );
        assert!(mixed != found);
    }
}

/// A hole in one chart, and one that two charts meet in.
#[test]
fn patches_go_on_with_the_charts_round_them() {
    let whole = sheet(12, 12);
    let mut soup = Soup { points: whole.points.clone(), offsets: vec![0], ..Soup::default() };
    for face in whole.faces() {
        let centre = [0, 1].map(|k| (whole.points[face[0] as usize][k] + 0.5 - 6.0_f64).abs());
        if centre[0] > 3.0 || centre[1] > 3.0 {
            soup.face(face);
        }
    }
    let keep = fill::Keep::OuterBorders;
    for refinement in [fill::Refinement::None, fill::Refinement::RimDensity(10_000)] {
        let options = fill::Options { refinement, keep, ..fill::Options::default() };
        let done = fill_holes(&soup.view(), LoopSelection::All, &options, &job()).unwrap();
        let origins = Origins::from_filled(&done, &job()).unwrap();
        let exact = |found: &[f64], f: usize, map: fn([f64; 3]) -> [f64; 2]| {
            let range = done.mesh.face_offsets[f] as usize..done.mesh.face_offsets[f + 1] as usize;
            range.into_iter().all(|c| {
                let exact = map(done.mesh.positions.get(done.mesh.face_corners[c]).to_array());
                (0..2).all(|k| (found[2 * c + k] - exact[k]).abs() < 1e-9)
            })
        };
        let found = carried(&origins, Domain::Corners, Rule::Texture, 2, &[mapped(&soup, plain)]);
        assert!(done.mesh.face_count() > soup.faces().count());
        assert!((0..done.mesh.face_count()).all(|f| exact(&found, f, plain)));
        // Another chart on the right half: faces, not vertices, say which.
        let two: Vec<f64> = soup
            .faces()
            .flat_map(|face| {
                let right = soup.points[face[0] as usize][0] >= 6.0;
                let own = move |p: [f64; 3]| if right { elsewhere(p) } else { plain(p) };
                face.iter().flat_map(|&v| own(soup.points[v as usize])).collect::<Vec<_>>()
            })
            .collect();
        let found = carried(&origins, Domain::Corners, Rule::Texture, 2, &[two]);
        let fits = |f: usize| [exact(&found, f, plain), exact(&found, f, elsewhere)];
        let counts = (0..done.mesh.face_count()).map(fits).fold([0, 0], |sum, fits| {
            assert!(fits[0] || fits[1]);
            [0, 1].map(|k| sum[k] + usize::from(fits[k]))
        });
        assert!(counts[0] > soup.faces().count() / 2 && counts[1] > soup.faces().count() / 2);
    }
}

/// Needles, points in one and the like give some numbers.
#[test]
fn values_stay_finite() {
    let mut thin = cap(9, 3, 0.4, 1.0);
    thin.points.iter_mut().for_each(|p| p[0] *= 1e-12);
    let mut flat = cap(8, 2, 0.4, -1.0);
    flat.points.iter_mut().for_each(|p| *p = [0.0, 0.0, -3.0]);
    for (a, b) in [(thin.clone(), cap(7, 2, 0.4, -1.0)), (cap(9, 2, 0.4, 1.0), flat)] {
        for scale in [1.0, 1e-150, 1e150] {
            let scaled = |soup: &Soup| {
                let mut soup = soup.clone();
                soup.points.iter_mut().for_each(|p| *p = p.map(|x| x * scale));
                soup
            };
            let case = stitched(
                "odd",
                &scaled(&a),
                Some(&scaled(&b)),
                &Options { rows: Rows::Count(2), ..Options::default() },
            );
            let inputs = [mapped(&a, plain), mapped(&b, elsewhere)];
            let found = carried(&case.origins, Domain::Corners, Rule::Texture, 2, &inputs);
            assert!(found.iter().all(|x| x.is_finite()));
        }
    }
}
