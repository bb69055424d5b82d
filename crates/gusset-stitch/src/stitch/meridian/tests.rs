//! Checks every choice of meridians that has a measure by brute force, and the coarse-to-fine
//! search by the exact one.

use super::index_rule::meridians_by_index_rule;
use super::step_metric::strip_area;
use super::*;
use glam::DVec3;
use gusset_base::testing::case_count;
use proptest::prelude::*;

/// Returns the edges that a path uses. The end of a closed polyline is identified with its start.
fn edges_of_path(rims: &RimPair<'_>, path: &[MeridianEnds]) -> Vec<[usize; 2]> {
    let (n, m) = (rims.a.len(), rims.b.len());
    let (n, m) = if rims.closed { (n - 1, m - 1) } else { (n, m) };
    let mut edges: Vec<_> = path.iter().map(|&[i, j]| [i as usize % n, j as usize % m]).collect();
    if rims.closed {
        // The last meridian repeats the first by definition.
        edges.pop();
    }
    edges.sort_unstable();
    edges
}

fn is_allowed_path(rims: &RimPair<'_>, path: &[MeridianEnds]) -> bool {
    edges_of_path(rims, path).windows(2).all(|pair| pair[0] != pair[1])
        && !path.iter().any(|pair| rims.forbidden.contains(pair))
}

/// Visits every good path by enumeration.
fn visit_all_paths(rims: &RimPair<'_>, steps: &[[u32; 2]], mut visit: impl FnMut(&[MeridianEnds])) {
    let end = [rims.a.len() as u32 - 1, rims.b.len() as u32 - 1];
    let mut paths = vec![vec![[0, 0]]];
    while let Some(path) = paths.pop() {
        let [i, j] = *path.last().unwrap();
        if [i, j] == end {
            if is_allowed_path(rims, &path) {
                visit(&path);
            }
            continue;
        }
        for [di, dj] in steps {
            if i + di <= end[0] && j + dj <= end[1] {
                paths.push([path.as_slice(), &[[i + di, j + dj]]].concat());
            }
        }
    }
}

/// Returns the bends of a strip, triangle by triangle.
fn total_bends(rims: &RimPair<'_>, path: &[MeridianEnds]) -> f64 {
    let (a, b) = (|i: u32| rims.a[i as usize], |j: u32| rims.b[j as usize]);
    let mut sum = 0.0;
    let mut normals = Vec::new();
    for step in path.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        let third = if i2 > i { a(i) } else { b(j) };
        let normal = (third - a(i2)).cross(b(j2) - a(i2)).normalize_or_zero();
        if let Some([along_a, along_b]) = rims.face_normals_along_rims {
            let (edge, side) =
                if i2 > i { (a(i2) - a(i), along_a[i as usize]) } else { (b(j2) - b(j), along_b[j as usize]) };
            sum += edge.length() * (1.0 - normal.dot(side));
        }
        normals.push(normal);
    }
    for (k, pair) in normals.windows(2).enumerate() {
        let [i, j] = path[k + 1];
        sum += a(i).distance(b(j)) * (1.0 - pair[0].dot(pair[1]));
    }
    if rims.closed {
        sum += a(0).distance(b(0)) * (1.0 - normals[0].dot(normals[normals.len() - 1]));
    }
    sum
}

/// Returns the measure of continuation, triangle by triangle, in mean edges of the rims.
fn continuation_measure(rims: &RimPair<'_>, path: &[MeridianEnds]) -> f64 {
    let length = |line: &[DVec3]| line.windows(2).map(|edge| (edge[1] - edge[0]).length()).sum::<f64>();
    let mean = (length(rims.a) + length(rims.b)) / (rims.a.len() + rims.b.len() - 2) as f64;
    let [along_a, along_b] = rims.face_normals_along_rims.unwrap();
    let vertex = |sides: &[DVec3], k: u32| {
        let (k, n) = (k as usize, sides.len());
        let before = if k > 0 {
            sides[k - 1]
        } else if rims.closed {
            sides[n - 1]
        } else {
            DVec3::ZERO
        };
        let after = if k < n {
            sides[k]
        } else if rims.closed {
            sides[0]
        } else {
            DVec3::ZERO
        };
        (before + after).normalize_or_zero()
    };
    let (a, b) = (|i: u32| rims.a[i as usize], |j: u32| rims.b[j as usize]);
    let bulge = |[i, j]: MeridianEnds| {
        let heights = [vertex(along_a, i), vertex(along_b, j)].map(|normal| normal.dot(b(j) - a(i)) / mean);
        ((heights[0].powi(2) + heights[1].powi(2)) / 32.0).sqrt()
    };
    // A bend of more than 150 degrees is a fold.
    let cost = |bend: f64| bend + 50.0 * f64::max(bend - 2.0 * 75f64.to_radians().sin(), 0.0);
    let (mut sum, mut normals) = (0.0, Vec::new());
    for step in path.windows(2) {
        let ([i, j], [i2, j2]) = (step[0], step[1]);
        let third = if i2 > i { a(i) } else { b(j) };
        let vector = (third - a(i2)).cross(b(j2) - a(i2));
        let side = if i2 > i { along_a[i as usize] } else { along_b[j as usize] };
        let (first, second) = (bulge(step[0]), bulge(step[1]));
        let area = vector.length() / 2.0 / mean.powi(2);
        sum += area * (first.powi(2) + first * second + second.powi(2)) / 3.0;
        sum += 4.0 * cost((vector.normalize_or_zero() - side).length());
        normals.push(vector.normalize_or_zero());
    }
    if rims.closed {
        normals.push(normals[0]);
    }
    sum + normals.windows(2).map(|pair| cost((pair[0] - pair[1]).length())).sum::<f64>()
}

fn check_all_choices(rims: &RimPair<'_>) {
    check_continuation(rims);
    let (a, b) = (rims.a, rims.b);
    let paper = meridians_by_index_rule(a.len() as u32 - 1, b.len() as u32 - 1).unwrap();
    let length = |&[i, j]: &MeridianEnds| a[i as usize].distance(b[j as usize]);
    let squares = |path: &[MeridianEnds]| path[1..].iter().map(|pair| length(pair).powi(2)).sum::<f64>();
    type Measure<'a> = &'a dyn Fn(&[MeridianEnds]) -> f64;
    let triangles: &[[u32; 2]] = &[[1, 0], [0, 1]];
    let cases: [(Meridians, &[[u32; 2]], Measure<'_>); 4] = [
        (Meridians::MinArea, triangles, &|path| strip_area(a, b, path)),
        (Meridians::MinDiagonal, triangles, &|path| path[1..].iter().map(length).sum()),
        (Meridians::Smooth, triangles, &|path| total_bends(rims, path)),
        (Meridians::Quad, &[[1, 0], [0, 1], [1, 1]], &squares),
    ];
    for (choice, steps, measure) in cases {
        let mut least = f64::INFINITY;
        let mut slack = 0.0;
        visit_all_paths(rims, steps, |path| {
            if measure(path) < least {
                least = measure(path);
                // The weight of the tie break for the best path.
                slack = match choice {
                    Meridians::MinArea if strip_area(a, b, &paper) == 0.0 => f64::INFINITY,
                    Meridians::MinArea => 0.5f64.powi(32) * strip_area(a, b, &paper) / squares(&paper) * squares(path),
                    Meridians::Smooth => {
                        0.5f64.powi(20) * paper.iter().map(length).sum::<f64>()
                            / paper.iter().map(|pair| length(pair).powi(2)).sum::<f64>()
                            * squares(path)
                    }
                    _ => 0.0,
                };
            }
        });
        match choose_meridians(rims, choice, MeridianSearch::Auto, &Job::default()).unwrap() {
            None => assert_eq!(least, f64::INFINITY, "{choice:?}"),
            Some(chosen) => {
                assert!(is_allowed_path(rims, &chosen.pairs), "{choice:?} {:?}", chosen.pairs);
                assert_eq!(
                    (chosen.pairs[0], chosen.pairs.last()),
                    ([0, 0], Some(&[a.len() as u32 - 1, b.len() as u32 - 1]))
                );
                let cost = measure(&chosen.pairs);
                let round_off = 1e-12 * (1.0 + least.abs());
                assert!((least - round_off..=least + slack + round_off).contains(&cost), "{choice:?} {cost} {least}");
            }
        }
    }
    for choice in [Meridians::ArcLength, Meridians::Greedy] {
        if let Some(chosen) = choose_meridians(rims, choice, MeridianSearch::Auto, &Job::default()).unwrap() {
            assert!(is_allowed_path(rims, &chosen.pairs), "{choice:?} {:?}", chosen.pairs);
        }
    }
}

fn check_continuation(rims: &RimPair<'_>) {
    if !rims.has_faces_along_rims() || rims.a[1..].iter().chain(&rims.b[1..]).all(|&p| p == rims.a[0]) {
        return;
    }
    let mut least = f64::INFINITY;
    visit_all_paths(rims, &[[1, 0], [0, 1]], |path| least = least.min(continuation_measure(rims, path)));
    match choose_meridians(rims, Meridians::Continuation, MeridianSearch::Exact, &Job::default()).unwrap() {
        None => assert_eq!(least, f64::INFINITY),
        Some(chosen) => {
            assert!(is_allowed_path(rims, &chosen.pairs), "{:?}", chosen.pairs);
            let cost = continuation_measure(rims, &chosen.pairs);
            // The tie break is 2^-20 of the meridians' lengths, in mean edges.
            assert!((least * (1.0 - 1e-9)..=least * (1.0 + 1e-3) + 1e-3).contains(&cost), "{cost} {least}");
        }
    }
}

/// Repeats the first point at the end.
fn repeat_first_point(points: &[DVec3]) -> Vec<DVec3> {
    points.iter().chain(&points[..1]).copied().collect()
}

/// Returns a path with steps on A where `on_a` is true, as long as there are any.
fn path_with_steps(on_a: &[bool], n: usize, m: usize) -> Vec<MeridianEnds> {
    let mut path = vec![[0, 0]];
    for &on_a in on_a {
        let [i, j] = path[path.len() - 1];
        if (i as usize) < n && (on_a || j as usize == m) {
            path.push([i + 1, j]);
        } else if (j as usize) < m {
            path.push([i, j + 1]);
        }
    }
    path
}

fn polyline_of_integers(coordinates: &[(i8, i8, i8)]) -> Vec<DVec3> {
    coordinates.iter().map(|&(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)) / 128.0).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(case_count(256)))]

    #[test]
    fn meridians_equal_brute_force(
        a in prop::collection::vec(any::<(i8, i8, i8)>(), 3..6),
        b in prop::collection::vec(any::<(i8, i8, i8)>(), 3..6),
        // With a tiny second rim, the best of all paths repeats a meridian.
        shrink in prop::sample::select(vec![1.0, 1e-3, 0.0]),
        sides in prop::collection::vec(any::<(i8, i8, i8)>(), 10),
        forbidden in any::<u64>(),
        sparse in 1u32..5,
    ) {
        let a = polyline_of_integers(&a);
        let b: Vec<_> = polyline_of_integers(&b).iter().map(|&p| p * shrink).collect();
        let (n, m) = (a.len() as u32, b.len() as u32);
        let sides: Vec<_> = polyline_of_integers(&sides).iter().map(|p| p.normalize_or_zero()).collect();
        let sides = [&sides[..5], &sides[5..]];
        let some = (0..n).flat_map(|i| (0..m).map(move |j| [i, j]));
        let some: Vec<_> =
            some.filter(|&[i, j]| (i * 7 + j) % sparse == 3 && forbidden >> (i * 6 + j) & 1 == 1).collect();
        for few in [&[][..], &some] {
            let nodes = |closed| sorted_forbidden_nodes(few.iter().copied(), n, m, closed).unwrap();
            for sides in [None, Some(sides)] {
                let (closed_a, closed_b) = (repeat_first_point(&a), repeat_first_point(&b));
                let rims = RimPair { a: &closed_a, b: &closed_b, closed: true, forbidden: &nodes(true), face_normals_along_rims: sides, penalties: &[] };
                check_all_choices(&rims);
                check_all_choices(&RimPair { a: &a, b: &b, closed: false, forbidden: &nodes(false), face_normals_along_rims: sides, penalties: &[] });
            }
        }
    }

    /// Both searches find the cheapest path within any band.
    #[test]
    fn bands_are_searched_exactly(
        a in prop::collection::vec(any::<(i8, i8, i8)>(), 3..7),
        b in prop::collection::vec(any::<(i8, i8, i8)>(), 3..7),
        path in prop::collection::vec(any::<bool>(), 12),
        width in 0usize..2,
    ) {
        let (a, b) = (polyline_of_integers(&a), polyline_of_integers(&b));
        let (n, m) = (a.len() - 1, b.len() - 1);
        let middle = path_with_steps(&path, n, m);
        let band = LatticeBand::around_path(&middle, n, m, width).unwrap();
        let rims = RimPair { a: &a, b: &b, closed: false, forbidden: &[], face_normals_along_rims: None, penalties: &[] };
        let within = |path: &[MeridianEnds]| path.iter().all(|&[i, j]| band.columns_of_row(i as usize).contains(&(j as usize)));
        for (metric, steps) in [(StepMetric::Diagonal, &[[1, 0], [0, 1]][..]), (StepMetric::Quad, &[[1, 0], [0, 1], [1, 1]])] {
            let mut least = f64::INFINITY;
            visit_all_paths(&rims, steps, |path| {
                if within(path) {
                    least = least.min(metric.path_cost(&a, &b, path));
                }
            });
            let plain = lattice_path::cheapest_path(&rims, metric, &band, &Job::default()).unwrap().unwrap();
            let (_, by_states) = cheapest_path(&rims, &PathCost::StepCosts(metric), &band, false, None, &Job::default()).unwrap().unwrap();
            for path in [plain, by_states] {
                let cost = metric.path_cost(&a, &b, &path);
                prop_assert!(within(&path) && (cost - least).abs() < 1e-12, "{metric:?} {cost} {least} {path:?}");
            }
        }
    }

    /// The search by bends is exact on open and closed rims, with penalties, and for simple paths.
    #[test]
    fn bends_in_bands_are_searched_exactly(
        a in prop::collection::vec(any::<(i8, i8, i8)>(), 3..6),
        b in prop::collection::vec(any::<(i8, i8, i8)>(), 3..6),
        path in prop::collection::vec(any::<bool>(), 12),
        width in 0usize..3,
        closes in any::<bool>(),
        normals in prop::collection::vec(any::<(i8, i8, i8)>(), 12),
        penalties in prop::collection::btree_map((0u32..6, 0u32..6, any::<bool>()), 0.0..50.0, 0..6),
    ) {
        let (a, b) = (polyline_of_integers(&a), polyline_of_integers(&b));
        let (a, b) = if closes { (repeat_first_point(&a), repeat_first_point(&b)) } else { (a, b) };
        let (n, m) = (a.len() - 1, b.len() - 1);
        let middle = path_with_steps(&path, n, m);
        let band = LatticeBand::around_path(&middle, n, m, width).unwrap();
        let normals: Vec<DVec3> = polyline_of_integers(&normals).into_iter().map(DVec3::normalize_or_zero).collect();
        let sides = Some([&normals[..n], &normals[6..6 + m]]);
        let penalties: Vec<StepPenalty> = penalties
            .into_iter()
            .map(|((i, j, on_b), extra)| StepPenalty { end_node: [i, j], on_b, additional_cost: extra })
            .filter(|penalty| penalty.end_node[0] as usize <= n && penalty.end_node[1] as usize <= m)
            .collect();
        let rims = RimPair { a: &a, b: &b, closed: closes, forbidden: &[], face_normals_along_rims: sides, penalties: &penalties };
        let within = |path: &[MeridianEnds]| path.iter().all(|&[i, j]| band.columns_of_row(i as usize).contains(&(j as usize)));
        let extra = |path: &[MeridianEnds]| {
            let of = |step: &[MeridianEnds]| {
                let own = |p: &&StepPenalty| p.end_node == step[1] && p.on_b == (step[1][0] == step[0][0]);
                penalties.iter().filter(own).map(|p| p.additional_cost).sum::<f64>()
            };
            path.windows(2).map(of).sum::<f64>()
        };
        type Measure<'a> = &'a dyn Fn(&[MeridianEnds]) -> f64;
        let cases: [(StripBends<'_>, Measure<'_>); 2] = [
            (StripBends::for_least_bends(&rims, 0.0).unwrap(), &|path| total_bends(&rims, path)),
            (StripBends::for_best_continuation(&rims, 0.0).unwrap(), &|path| continuation_measure(&rims, path)),
        ];
        for (of, measure) in &cases {
            for simple in [false, true] {
                // The least cost of simple paths; other paths may be cheaper.
                let mut least = f64::INFINITY;
                visit_all_paths(&rims, &[[1, 0], [0, 1]], |path| {
                    if within(path) {
                        least = least.min(measure(path) + extra(path));
                    }
                });
                let Some((cost, path)) = cheapest_path(&rims, &PathCost::Bends(of), &band, simple, None, &Job::default()).unwrap() else {
                    prop_assert!(simple && least == f64::INFINITY);
                    continue;
                };
                let (own, slack) = (measure(&path) + extra(&path), 1e-9 * (1.0 + cost));
                prop_assert!(within(&path) && (own - cost).abs() <= slack, "{own} {cost} {path:?}");
                prop_assert!(cost <= least + slack, "{cost} {least} {path:?}");
                if is_simple_path(&rims, &path) {
                    prop_assert!(cost >= least - slack, "{cost} {least} {path:?}");
                } else {
                    prop_assert!(!simple);
                }
            }
        }
    }

    #[test]
    fn open_polylines_of_few_points_equal_brute_force(
        a in prop::collection::vec(any::<(i8, i8, i8)>(), 1..4),
        b in prop::collection::vec(any::<(i8, i8, i8)>(), 1..6),
    ) {
        // Two points span no strip.
        prop_assume!(a.len() + b.len() > 2);
        let (a, b) = (polyline_of_integers(&a), polyline_of_integers(&b));
        check_all_choices(&RimPair { a: &a, b: &b, closed: false, forbidden: &[], face_normals_along_rims: None, penalties: &[] });
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(case_count(16)))]

    /// Compares a long wavy rim from coarse to fine with the exact result.
    #[test]
    fn coarse_to_fine_is_nearly_the_best(
        n in 1500usize..2500,
        ratio in 0.3f64..1.0,
        waves in prop::collection::vec((1u32..40, -0.2f64..0.2, 0.0f64..6.3), 4),
        shift in 0.0f64..0.1,
    ) {
        let rim = |count: usize, lift: f64, shift: f64| -> Vec<DVec3> {
            (0..count).map(|i| {
                let t = shift + std::f64::consts::TAU * i as f64 / count as f64;
                let wave = waves.iter().map(|&(k, size, phase)| size * (f64::from(k) * t + phase).sin() / f64::from(k));
                DVec3::new(t.cos(), t.sin(), lift + (1.0 + lift) * wave.sum::<f64>())
            }).collect()
        };
        let (a, b) = (repeat_first_point(&rim(n, 0.0, 0.0)), repeat_first_point(&rim((ratio * n as f64) as usize, 0.3, shift)));
        let lost = coarse_search_excess(&a, &b, &[]);
        prop_assert!(lost <= 0.0005, "{lost}");
    }

    /// Rims as a cut through a mesh leaves them: teeth of a few edges each, as high as the edges
    /// are long.
    #[test]
    fn coarse_to_fine_is_nearly_the_best_on_jagged_rims(
        n in 1500usize..2500,
        ratio in 0.3f64..1.0,
        seed in any::<u64>(),
        barred in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0), 0..20),
    ) {
        let mut random = fastrand::Rng::with_seed(seed);
        let mut rim = |count: usize, lift: f64| -> Vec<DVec3> {
            let edge = std::f64::consts::TAU / count as f64;
            let (mut up, mut points) = (false, Vec::new());
            for i in 0..count {
                up ^= random.f64() < 0.6;
                let tooth = if up { 0.9 * edge } else { 0.0 };
                let (t, radius) = (edge * (i as f64 + 0.4 * random.f64()), 1.0 + 0.2 * edge * random.f64());
                points.push(DVec3::new(radius * t.cos(), radius * t.sin(), lift + tooth));
            }
            points
        };
        let (a, b) = (repeat_first_point(&rim(n, 0.0)), repeat_first_point(&rim((ratio * n as f64) as usize, 0.3)));
        let (n, m) = (a.len() as u32 - 1, b.len() as u32 - 1);
        let place = |share: f64, count: u32| 1 + (share * f64::from(count - 2)) as u32;
        let barred = barred.iter().map(|&(i, j)| [place(i, n), place(j, m)]);
        let lost = coarse_search_excess(&a, &b, &sorted_forbidden_nodes(barred, n, m, true).unwrap());
        prop_assert!(lost <= 0.0005, "{lost}");
    }
}

/// Returns the largest relative excess of the coarse-to-fine cost over the exact cost, over all
/// step metrics.
fn coarse_search_excess(a: &[DVec3], b: &[DVec3], forbidden: &[MeridianEnds]) -> f64 {
    let rims = RimPair { a, b, closed: true, forbidden, face_normals_along_rims: None, penalties: &[] };
    let paper = meridians_by_index_rule(a.len() as u32 - 1, b.len() as u32 - 1).unwrap();
    let mut most = 0.0f64;
    for metric in [StepMetric::area_with_tie_break(a, b, &paper), StepMetric::Diagonal, StepMetric::Quad] {
        let job = Job::default();
        let find = |rims: &RimPair<'_>, band: &LatticeBand, job: &Job<'_>| {
            lattice_path::cheapest_path(rims, metric, band, job)
        };
        let coarse = coarse_to_fine::search_coarse_to_fine(&rims, &find, &job).unwrap().unwrap();
        let exact = find(&rims, &LatticeBand::whole_lattice(a.len() - 1, b.len() - 1).unwrap(), &job).unwrap().unwrap();
        assert!(coarse.iter().all(|node| !forbidden.contains(node)));
        let (coarse, exact) = (metric.path_cost(a, b, &coarse), metric.path_cost(a, b, &exact));
        assert!(coarse >= exact * (1.0 - 1e-12), "{metric:?} {coarse} {exact}");
        most = most.max(coarse / exact - 1.0);
    }
    most
}

#[test]
fn a_plane_ring_gets_short_meridians() {
    // All strips of a planar ring have equal area and no bends; the tie break must not leave a fan.
    let circle = |n: usize, r: f64| -> Vec<DVec3> {
        let angle = |i| std::f64::consts::TAU * i as f64 / n as f64;
        (0..n).map(|i| DVec3::new(r * angle(i).cos(), r * angle(i).sin(), 0.0)).collect()
    };
    let (a, b) = (circle(48, 2.0), circle(32, 1.7));
    let rims = RimPair {
        a: &repeat_first_point(&a),
        b: &repeat_first_point(&b),
        closed: true,
        forbidden: &[],
        face_normals_along_rims: None,
        penalties: &[],
    };
    let up = [vec![DVec3::NEG_Z; 48], vec![DVec3::NEG_Z; 32]];
    let known = RimPair { face_normals_along_rims: Some([&up[0], &up[1]]), ..rims };
    for (choice, rims) in [(Meridians::MinArea, &rims), (Meridians::Smooth, &rims), (Meridians::Continuation, &known)] {
        let chosen = choose_meridians(rims, choice, MeridianSearch::Auto, &Job::default()).unwrap().unwrap();
        let length = |&[i, j]: &MeridianEnds| a[i as usize % 48].distance(b[j as usize % 32]);
        let longest = chosen.pairs.iter().map(length).fold(0.0, f64::max);
        // No meridian leans sideways by more than one edge: the gap is 0.3 wide, and the longer
        // edge 0.334 long.
        assert!(longest < 0.3f64.hypot(0.334), "{choice:?} {longest}");
    }
}
