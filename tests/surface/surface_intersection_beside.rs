//! Neighbouring branches, with a tolerance as large as their distance: each is found once and
//! whole.

use crate::pairs::check;
use glam::DVec3;
use gusset::Job;
use gusset::surface::surface_intersection::Options;
use gusset::surface::{Grid, Nodes, Patches, Paths, Scheme, Sheet, Surface};

/// A tolerance, and lengths in it.
const TOLERANCES: [f64; 2] = [1e-2, 1e-3];

fn plane() -> Surface<'static> {
    let corners = [[-1.0, -1.0], [-1.0, 2.0], [2.0, -1.0], [2.0, 2.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let patches = Patches::new(&corners, [1, 1], 1, 1).unwrap();
    Surface::new(vec![Sheet::Cubic(patches)], None, &Job::default()).unwrap()
}

fn meet(a: &Surface<'_>, tolerance: f64) -> Paths {
    let (plane, options) = (plane(), Options { tolerance: Some(tolerance), ..Options::default() });
    let paths = a.meet(&plane, &options, &Job::default()).unwrap();
    check(&paths, a, &plane);
    paths
}

/// Asserts the number of open paths, and the length of each.
fn check_lines(paths: &Paths, count: usize, each: f64, what: &str) {
    let length = |k: usize| paths.points_of(k).windows(2).map(|pair| pair[0].distance(pair[1])).sum();
    let lengths: Vec<f64> = (0..paths.len()).map(length).collect();
    let right = lengths.iter().all(|length| (length - each).abs() <= 1e-9 * each);
    assert!(lengths.len() == count && right && !paths.closed.contains(&true), "{what}: {lengths:?}");
    assert!(paths.unresolved.is_empty() && paths.contacts.is_empty(), "{what}");
}

/// z = depth ((x / half)^2 - 1): two lines. They lie on subdivision lines if the patch is four
/// halves wide to each side (3/8 and 5/8), and elsewhere otherwise.
#[test]
fn two_lines_of_a_valley() {
    for tolerance in TOLERANCES {
        for wide in [4.0, 4.3, 3.71] {
            for (apart, deep) in [3.0, 6.0, 12.0, 30.0].iter().flat_map(|&apart| [(apart, 4.0), (apart, 20.0)]) {
                let (half, depth) = (0.5 * apart * tolerance, deep * tolerance);
                let w = wide * half;
                let blossom =
                    |[a, b]: [f64; 2], y: f64| DVec3::new(0.5 * (a + b), y, depth * (a * b / half / half - 1.0));
                let points: Vec<DVec3> =
                    [[-w, -w], [-w, w], [w, w]].iter().flat_map(|&ab| [0.0, 0.5].map(|y| blossom(ab, y))).collect();
                let valley = Sheet::Cubic(Patches::new(&points, [2, 1], 1, 1).unwrap());
                let valley = Surface::new(vec![valley], None, &Job::default()).unwrap();
                let what = format!("tolerance {tolerance}, {apart} of it apart, {deep} deep, {wide} wide");
                check_lines(&meet(&valley, tolerance), 2, 0.5, &what);
            }
        }
    }
}

/// Corrugations, each side of which is a line, from less than one to four tolerances wide.
#[test]
fn lines_of_corrugations() {
    const WAVES: usize = 10;
    const STEPS: usize = 6;
    for tolerance in TOLERANCES {
        for (width, height) in
            [0.6, 1.0, 1.5, 2.0, 2.3, 3.2, 4.0].iter().flat_map(|&width| [(width, 4.0), (width, 10.0)])
        {
            let rows = 2 * WAVES * STEPS + 1;
            let nodes = (0..rows).flat_map(|i| (0..8).map(move |j| (i as f64 / STEPS as f64, 0.05 * f64::from(j))));
            let wave = |(x, y): (f64, f64)| {
                [x * width * tolerance, y, height * tolerance * (std::f64::consts::PI * x + 0.5).sin()]
            };
            let data: Vec<f64> = nodes.flat_map(wave).collect();
            let nodes = Nodes::strided(data, rows, 8, 0, 0).unwrap();
            let sheet = Sheet::Grid(Grid::new(nodes, [false, false], Scheme::SixTap).unwrap());
            let sheet = Surface::new(vec![sheet], None, &Job::default()).unwrap();
            let what = format!("tolerance {tolerance}, {width} wide, {height} high");
            check_lines(&meet(&sheet, tolerance), 2 * WAVES, 0.35, &what);
        }
    }
}
