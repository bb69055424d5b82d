//! Where one surface meets itself: against places that triangles of it show, found by Newton's
//! method from there. Each is on a path, no path is there twice, and chords are as near as asked.

use crate::pairs::{distance, length, summary};
use crate::self_intersection::{lattice, meet};
use crate::shapes::Random;
use glam::{DVec3, DVec4};
use gusset::surface::{Paths, Place, Surface};
use gusset_oracles::crossings::crossing_pairs;
use std::f64::consts::TAU;

/// Parameters of two points on a surface of one sheet, in cells.
struct Sampled<'a> {
    surface: &'a Surface<'a>,
    closed: [bool; 2],
}

impl Sampled<'_> {
    fn counts(&self) -> [f64; 2] {
        self.surface.sheet(0).cells().map(|n| n as f64)
    }

    fn place(&self, at: [f64; 2]) -> Place {
        let counts = self.counts();
        let at = [0, 1].map(|k| if self.closed[k] { at[k].rem_euclid(counts[k]) } else { at[k] });
        let cell = [0, 1].map(|k| at[k].floor().clamp(0.0, counts[k] - 1.0));
        Place { sheet: 0, cell: cell.map(|k| k as u32), u: at[0] - cell[0], v: at[1] - cell[1] }
    }

    fn point(&self, at: [f64; 2]) -> DVec3 {
        self.surface.jet(self.place(at)).point
    }

    /// The way from one to the other, the short one across seams.
    fn between(&self, from: DVec4, to: DVec4) -> DVec4 {
        let mut way = to - from;
        for k in 0..4 {
            let count = self.counts()[k % 2];
            if self.closed[k % 2] {
                way[k] -= count * (way[k] / count).round();
            }
        }
        way
    }

    /// S(p) = S(q) near two places, by Newton's steps of least length.
    fn solution(&self, start: DVec4) -> Option<(DVec3, DVec4)> {
        let (mut x, counts) = (start, self.counts());
        for _ in 0..20 {
            let [one, other] = [[x.x, x.y], [x.z, x.w]].map(|at| self.surface.jet(self.place(at)));
            let miss = one.point - other.point;
            let columns = [one.u, one.v, -other.u, -other.v];
            let square = columns
                .iter()
                .fold(glam::DMat3::ZERO, |sum, c| sum + glam::DMat3::from_cols(*c * c.x, *c * c.y, *c * c.z));
            let dual = square.inverse() * miss;
            let outside = |x: f64, k: usize, by: f64| !self.closed[k % 2] && !(-by..=counts[k % 2] + by).contains(&x);
            for k in 0..4 {
                x[k] -= columns[k].dot(dual);
                if !x[k].is_finite() || outside(x[k], k, 0.01) {
                    return None;
                }
            }
            if miss.length() < 1e-12 {
                let inside = (0..4).all(|k| !outside(x[k], k, -1e-6));
                return inside.then_some((one.point, x));
            }
        }
        None
    }

    /// How far apart both points of a solution are by parameters.
    fn apart(&self, x: DVec4) -> f64 {
        let way = self.between(x, DVec4::new(x.z, x.w, x.x, x.y));
        way.x.abs().max(way.y.abs())
    }

    /// The places where triangles intersect, `dense` to a cell along each parameter, without
    /// neighbours, and without solutions that are one point.
    fn places(&self, dense: usize) -> Vec<(DVec3, DVec4)> {
        let [h, w] = self.surface.sheet(0).cells().map(|n| n * dense);
        let wrap =
            |[i, j]: [usize; 2]| [if self.closed[0] { i % h } else { i }, if self.closed[1] { j % w } else { j }];
        let at = |[i, j]: [usize; 2]| [i as f64 / dense as f64, j as f64 / dense as f64];
        let points: Vec<DVec3> = (0..(h + 1) * (w + 1)).map(|k| self.point(at([k / (w + 1), k % (w + 1)]))).collect();
        let triangles: Vec<[[usize; 2]; 3]> = (0..h * w)
            .flat_map(|k| {
                let (i, j) = (k / w, k % w);
                [[[i, j], [i + 1, j], [i + 1, j + 1]], [[i, j], [i + 1, j + 1], [i, j + 1]]]
            })
            .collect();
        let corners: Vec<[DVec3; 3]> = triangles.iter().map(|t| t.map(|[i, j]| points[i * (w + 1) + j])).collect();
        let middle = |t: &[[usize; 2]; 3]| [0, 1].map(|k| t.iter().map(|&p| at(p)[k]).sum::<f64>() / 3.0);
        let shares_corner = |one: &[[usize; 2]; 3], other: &[[usize; 2]; 3]| {
            one.iter().any(|&p| other.iter().any(|&q| wrap(p) == wrap(q)))
        };
        crossing_pairs(&corners)
            .into_iter()
            .map(|pair| pair.map(|n| &triangles[n]))
            .filter(|[one, other]| !shares_corner(one, other))
            .filter_map(|[one, other]| {
                let ([a, b], [c, d]) = (middle(one), middle(other));
                self.solution(DVec4::new(a, b, c, d)).filter(|&(_, x)| self.apart(x) >= 1e-3)
            })
            .collect()
    }

    /// The chords of paths by the parameters of both pieces, with their ends in space.
    fn chords(&self, paths: &Paths) -> Vec<([DVec4; 2], [DVec3; 2])> {
        let at = |k: usize| {
            let [p, q] = [paths.places[k], paths.others[k]];
            let of = |p: Place| [f64::from(p.cell[0]) + p.u, f64::from(p.cell[1]) + p.v];
            let ([a, b], [c, d]) = (of(p), of(q));
            DVec4::new(a, b, c, d)
        };
        let mut chords = Vec::new();
        for k in 0..paths.len() {
            let (from, to) = (paths.ends[k] as usize, paths.ends[k + 1] as usize);
            for n in from..to - usize::from(!paths.closed[k]) {
                let next = if n + 1 < to { n + 1 } else { from };
                // Where both pieces change places on the way round.
                let (first, last) = (at(n), at(next));
                let swapped = DVec4::new(last.z, last.w, last.x, last.y);
                let ways = [last, swapped].map(|last| self.between(first, last));
                let way = if next == from && ways[1].length() < ways[0].length() { ways[1] } else { ways[0] };
                chords.push(([first, first + way], [paths.points[n], paths.points[next]]));
            }
        }
        chords
    }

    /// Asserts all that holds of paths with chords of the given height, and returns how many places
    /// there were.
    fn check(&self, name: &str, paths: &Paths, dense: usize, chord: f64) -> usize {
        let chords = self.chords(paths);
        // Points of long paths may be left out that are near others: that adds to the height.
        let limit = 1.5 * chord;
        for (of, [a, b]) in &chords {
            for part in [0.25, 0.5, 0.75] {
                let Some((point, x)) = self.solution(of[0].lerp(of[1], part)) else { continue };
                let t = ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
                let far = point.distance(a.lerp(*b, t));
                assert!(self.apart(x) < 1e-3 || far <= limit, "{name}: {point} is {far} from its chord");
            }
        }
        assert_eq!(self.repeated(&chords), None, "{name}: {}", summary(paths));
        let places = self.places(dense);
        for (point, x) in &places {
            let far = distance(paths, *point);
            assert!(far <= limit, "{name}: {point} {x} is {far} away: {}", summary(paths));
        }
        places.len()
    }

    /// A point of one chord through which another one leads, too.
    fn repeated(&self, chords: &[([DVec4; 2], [DVec3; 2])]) -> Option<(DVec4, DVec3)> {
        chords.iter().enumerate().find_map(|(k, (of, _))| {
            let (point, x) = self.solution(of[0].lerp(of[1], 0.5))?;
            let turned = DVec4::new(x.z, x.w, x.x, x.y);
            // Next to a pinch both ways round are one.
            let own = self.apart(x) < 0.05 || point.is_nan();
            let through = |n: usize, x: DVec4| {
                let [from, to] = chords[n].0;
                let (way, here) = (to - from, self.between(from, x));
                let t = here.dot(way) / way.length_squared();
                let near = from + t * way;
                let miss = self.between(near, x).length();
                // Near a chord of the same curve, the solution is the point itself, except at
                // bends.
                (0.0..=1.0).contains(&t)
                    && miss < 0.05
                    && (miss < 1e-6
                        || self.solution(near).is_some_and(|(_, y)| self.between(y, x).length() < 0.1 * miss))
            };
            let again = !own && (0..chords.len()).any(|n| n.abs_diff(k) > 2 && (through(n, x) || through(n, turned)));
            again.then_some((x, point))
        })
    }
}

/// The default error of chords.
fn default_chord(surface: &Surface<'_>) -> f64 {
    1e-4 * (surface.bounds()[1] - surface.bounds()[0]).length()
}

#[test]
fn random_sheets_against_triangles() {
    random_sheets(6);
}

#[test]
#[ignore = "a minute or two"]
fn exhaustive_random_sheets_against_triangles() {
    random_sheets(100);
}

/// Sheets through nodes at random.
fn random_sheets(count: usize) {
    let mut random = Random(23);
    let (mut curves, mut closed, mut places, mut unresolved) = (0, 0, 0, 0);
    for number in 0..count {
        let cells = [5, 6];
        let shifts: Vec<DVec3> = (0..42).map(|_| random.point(0.2)).collect();
        let surface = lattice(cells, [false; 2], |u, v| {
            let (i, j) = ((5.0 * u).round() as usize, (6.0 * v).round() as usize);
            DVec3::new(u, v, 0.0) + shifts[i * 7 + j]
        });
        let paths = meet(&surface);
        curves += paths.len();
        closed += paths.closed.iter().filter(|&&closed| closed).count();
        unresolved += paths.unresolved.len();
        check_ends(number, &paths, cells);
        let sampled = Sampled { surface: &surface, closed: [false; 2] };
        places += sampled.check(&format!("sheet {number}"), &paths, 6, default_chord(&surface));
    }
    println!("{curves} curves, {closed} closed, {unresolved} unresolved; {places} places");
    assert!(curves > count && places > 50 * count);
}

/// Open ends are at the border, or in a pinch.
fn check_ends(number: usize, paths: &Paths, cells: [usize; 2]) {
    for k in (0..paths.len()).filter(|&k| !paths.closed[k]) {
        for end in [paths.ends[k] as usize, paths.ends[k + 1] as usize - 1] {
            let at_border = |place: &Place| {
                [(place.cell[0], place.u, cells[0]), (place.cell[1], place.v, cells[1])].iter().any(|&(cell, t, n)| {
                    let at = f64::from(cell) + t;
                    at < 1e-9 || at > n as f64 - 1e-9
                })
            };
            let own = [paths.places[end], paths.others[end]];
            let in_pinch = paths.unresolved.iter().any(|place| own.iter().any(|own| own.cell == place.cell));
            assert!(own.iter().any(at_border) || in_pinch, "{number}: {} {}", paths.points[end], summary(paths));
        }
    }
}

/// A tube of circles about a closed curve: each in the plane of the vertical and of the horizontal
/// across the curve.
fn tube(cells: [usize; 2], radius: f64, shift: [f64; 2], curve: impl Fn(f64) -> DVec3) -> Surface<'static> {
    lattice(cells, [true; 2], |u, v| {
        let (t, a) = (TAU * u + shift[0], TAU * v + shift[1]);
        let along = curve(t + 1e-4) - curve(t - 1e-4);
        let across = DVec3::new(-along.y, along.x, 0.0).normalize();
        curve(t) + radius * (a.cos() * across + a.sin() * DVec3::Z)
    })
}

/// Two pipes of one radius cross at right angles. If their axes are less than two radii apart, they
/// meet in one closed curve, because the four branches of x^2 + (z - d)^2 = y^2 + z^2 = r^2 form a
/// ring. Farther apart they do not meet.
#[test]
fn a_tube_along_a_lemniscate() {
    for (lift, loops) in [(0.05, 1), (0.1, 1), (0.13, 1), (0.17, 0), (0.3, 0)] {
        for (cells, shift) in [([40, 12], [0.01, 0.02]), ([37, 11], [0.2, 0.1])] {
            let curve = |t: f64| DVec3::new(2.0 * t.sin(), 2.0 * t.sin() * t.cos(), lift * t.cos());
            let surface = tube(cells, 0.15, shift, curve);
            let paths = meet(&surface);
            let name = format!("lemniscate {lift} {cells:?}");
            println!("{name}: {} {}", summary(&paths), length(&paths));
            assert!(paths.unresolved.is_empty(), "{name}: {}", summary(&paths));
            assert_eq!((paths.len(), paths.closed.iter().all(|&closed| closed)), (loops, true), "{name}");
            let sampled = Sampled { surface: &surface, closed: [true; 2] };
            let places = sampled.check(&name, &paths, 2, default_chord(&surface));
            assert_eq!(places > 0, loops > 0, "{name}");
        }
    }
}

/// A trefoil knot, thick enough to meet itself: alike at all three of its crossings.
#[test]
fn a_thick_trefoil() {
    let knot = |t: f64| DVec3::new(t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin());
    for (radius, loops) in [(0.3, 0), (0.5, 0), (0.8, 3), (0.9, 3)] {
        let surface = tube([60, 12], radius, [0.03, 0.02], knot);
        let paths = meet(&surface);
        let lengths: Vec<f64> = (0..paths.len())
            .map(|k| {
                let points = paths.points_of(k);
                (0..points.len()).map(|n| points[n].distance(points[(n + 1) % points.len()])).sum()
            })
            .collect();
        let name = format!("trefoil {radius}");
        println!("{name}: {} {lengths:?}", summary(&paths));
        let sampled = Sampled { surface: &surface, closed: [true; 2] };
        let places = sampled.check(&name, &paths, 2, default_chord(&surface));
        assert_eq!(places > 0, loops > 0, "{name}");
        assert!(paths.unresolved.is_empty(), "{name}: {}", summary(&paths));
        assert!(paths.len() == loops && paths.closed.iter().all(|&closed| closed), "{name}: {}", summary(&paths));
        assert!(lengths.iter().all(|length| (length / lengths[0] - 1.0).abs() < 1e-3), "{name}: {lengths:?}");
    }
}
