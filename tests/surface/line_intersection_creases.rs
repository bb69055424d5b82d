//! Lines through poles, seams, nodes and creases: hits are counted as the surface is passed or
//! touched, wherever it lies.

use crate::shapes::{Random, SHAPES};
use glam::DVec3;
use gusset::Job;
use gusset::curve::CurveView;
use gusset::surface::line_intersection::{Hit, HitSelection, Line};
use gusset::surface::{Grid, Nodes, Place, Scheme, Sheet, Surface};
use std::f64::consts::TAU;

/// A sheet through points, closed lines of which are repeated to the bit.
fn sheet_of(
    [h, w]: [usize; 2],
    closed: [bool; 2],
    scheme: Scheme,
    point: impl Fn(f64, f64) -> DVec3,
) -> Surface<'static> {
    let at = |k: usize, n: usize, closed: bool| (if closed { k % n } else { k }) as f64 / n as f64;
    let nodes = (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j)));
    let data: Vec<f64> = nodes.flat_map(|(i, j)| point(at(i, h, closed[0]), at(j, w, closed[1])).to_array()).collect();
    let grid = Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap();
    Surface::new(vec![Sheet::Grid(grid)], None, &Job::default()).unwrap()
}

fn multiplicities(hits: &[Hit]) -> u32 {
    hits.iter().map(|hit| hit.multiplicity).sum()
}

/// A line through a node, or through any point of a line of nodes.
fn through_a_node_or_side(surface: &Surface<'_>, random: &mut Random, k: usize) -> Line {
    let [h, w] = surface.sheet(0).cells();
    let cell = [(random.next() * h as f64) as u32, (random.next() * w as f64) as u32];
    let v = if k.is_multiple_of(2) { 0.0 } else { random.next() };
    let point = surface.jet(Place { sheet: 0, cell, u: 0.0, v }).point;
    let direction = random.point(1.0);
    Line::new(point - direction, direction)
}

#[test]
fn poles_have_normals_and_count_by_their_cells() {
    // Rows at the poles are one point each. The surface is not quite smooth there: some lines touch
    // the tip.
    let sphere = sheet_of([10, 20], [false, true], Scheme::SixTap, |u, v| {
        let (polar, turn) = (std::f64::consts::PI * u, std::f64::consts::TAU * v);
        let ring = if u == 0.0 || u == 1.0 { 0.0 } else { polar.sin() };
        DVec3::new(ring * turn.cos(), ring * turn.sin(), polar.cos())
    });
    let mut random = Random(1);
    let mut lines: Vec<Line> = (0..1000)
        .map(|k| {
            let (pole, direction) = (DVec3::new(0.0, 0.0, if k % 2 == 0 { 1.0 } else { -1.0 }), random.point(1.0));
            Line::new(pole - direction, direction)
        })
        .collect();
    lines.push(Line::new(DVec3::new(0.0, 0.0, 3.0), DVec3::Z));
    lines.push(Line::new(DVec3::new(0.0, 2.6313462855769325, 1.0), DVec3::Y));
    let mut touches = 0;
    for line in &lines {
        let hits = sphere.line(line, HitSelection::All).unwrap();
        let here: Vec<_> = hits.iter().filter(|hit| (hit.point.z.abs() - 1.0).abs() < 1e-12).collect();
        assert!(!here.is_empty(), "{line:?}");
        for hit in here {
            assert!(hit.normal.dot(hit.point).abs() > 0.999, "{line:?} {hit:?}");
            assert_eq!(hit.normal, sphere.normal(hit.place));
            touches += u32::from(hit.tangent);
            let found = sphere.closest(hit.point, f64::INFINITY).unwrap();
            assert!(found.normal.dot(hit.point).abs() > 0.999, "{found:?}");
        }
        assert!(multiplicities(&hits).is_multiple_of(2), "{line:?} {hits:?}");
    }
    assert!(touches < 20, "{touches}");
    assert!(sphere.line(&lines[1001], HitSelection::All).unwrap()[1].tangent);
}

#[test]
fn one_crossing_is_one_hit_far_from_the_origin() {
    for (far, count) in [(1e5, 1500), (1e6, 500), (1e7, 500)] {
        let shift = far * DVec3::new(1.0, -2.0, 0.5);
        let torus = sheet_of([20, 37], [true, true], Scheme::SixTap, |u, v| (SHAPES[0].point)(u, v) + shift);
        let mut random = Random(2);
        let mut lines: Vec<Line> = (0..count).map(|k| through_a_node_or_side(&torus, &mut random, k)).collect();
        if far == 1e5 {
            lines.push(Line::new(
                DVec3::new(99999.86540072673, -199998.63329539832, 50000.399954971566),
                DVec3::new(-0.4379682910236875, -0.5468478601505982, 4.502843727727246e-5),
            ));
        }
        for line in &lines {
            let hits = torus.line(line, HitSelection::All).unwrap();
            let in_doubt = hits.iter().any(|hit| hit.tangent);
            assert!(in_doubt || multiplicities(&hits).is_multiple_of(2), "{far} {line:?} {hits:?}");
        }
        let in_doubt = |line: &&Line| torus.line(line, HitSelection::All).unwrap().iter().any(|hit| hit.tangent);
        assert!(lines.iter().filter(in_doubt).count() <= 2);
    }
}

#[test]
fn creases_are_touched_or_passed() {
    let bumpy = sheet_of([31, 53], [true, true], Scheme::FourPoint, SHAPES[1].point);
    let rough = crate::shapes::rough([12, 17], [true, true], Scheme::FourPoint, 5);
    let rough = Surface::new(vec![Sheet::Grid(rough)], None, &Job::default()).unwrap();
    for surface in [&bumpy, &rough] {
        let mut random = Random(2);
        let mut touches = 0;
        for k in 0..1500 {
            let line = through_a_node_or_side(surface, &mut random, k);
            let hits = surface.line(&line, HitSelection::All).unwrap();
            assert!(multiplicities(&hits).is_multiple_of(2), "{line:?} {hits:?}");
            let touch = hits.iter().find(|hit| hit.tangent);
            touches += u32::from(touch.is_some());
            assert!(touch.is_none_or(|hit| hit.multiplicity == 2), "{hits:?}");
            assert_eq!(surface.line(&line, HitSelection::First).unwrap().first(), hits.first());
            // As a curve of one segment, straight and raised.
            if k % 10 == 0 || touch.is_some() {
                let [a, b] = [-10.0, 10.0].map(|t| line.origin + t * line.direction);
                let cubic: Vec<DVec3> = (0..4).map(|k| a.lerp(b, f64::from(k) / 3.0)).collect();
                for points in [vec![a, b], cubic] {
                    let starts = [0, points.len() as u32 - 1];
                    let curve = CurveView::new(&points, &starts, false).unwrap();
                    let found = surface.curve(&curve, HitSelection::All, &Job::default()).unwrap();
                    assert!(
                        found.iter().map(|hit| hit.multiplicity).sum::<u32>().is_multiple_of(2),
                        "{line:?} {found:?}"
                    );
                }
            }
        }
        assert!(touches > 10, "{touches}");
    }
    let line = Line::new(DVec3::new(0.9826822705510558, 8.016941675008606, -0.34147652693884484), DVec3::Y);
    let hits = bumpy.line(&line, HitSelection::All).unwrap();
    assert_eq!(
        hits.iter().map(|hit| (hit.multiplicity, hit.tangent)).collect::<Vec<_>>(),
        [(1, false), (2, true), (1, false)]
    );
}

#[test]
fn what_is_simple_is_on_the_line() {
    // Cells of sizes from 1e-8 to 1, and of 1e4 to 1.
    let far = |t: f64| 10_f64.powf(-8.0 + 8.0 * t);
    let uneven = sheet_of([20, 20], [false; 2], Scheme::SixTap, |u, v| {
        let (x, y) = (far(u), far(v));
        DVec3::new(x, y, 0.1 * (3.0 * x).sin() * (2.0 * y).cos())
    });
    let long = sheet_of([30, 30], [false; 2], Scheme::SixTap, |u, v| {
        DVec3::new(3e5 * u, 30.0 * v, (21.0 * u).sin() + 0.1 * (30.0 * v).cos())
    });
    let bumpy = sheet_of([31, 53], [true, true], Scheme::SixTap, SHAPES[1].point);
    for surface in [&uneven, &long, &bumpy] {
        let [low, high] = surface.bounds();
        let size = low.distance(high);
        let [h, w] = surface.sheet(0).cells();
        let mut random = Random(3);
        for _ in 0..1500 {
            let cell = [(random.next() * h as f64) as u32, (random.next() * w as f64) as u32];
            let v = if random.next() < 0.5 { 0.0 } else { random.next() };
            let jet = surface.jet(Place { sheet: 0, cell, u: 0.0, v });
            // Along the surface, nearly.
            let direction = size * (random.next() * jet.u + random.next() * jet.v).normalize();
            let line = Line::new(jet.point - direction, direction);
            for hit in surface.line(&line, HitSelection::All).unwrap() {
                assert!(hit.span[0] <= hit.at && hit.at <= hit.span[1], "{line:?} {hit:?}");
                let miss = (hit.point - line.origin).cross(direction.normalize()).length();
                assert!(hit.tangent || miss <= 1.01 * surface.tolerance(), "{line:?} {hit:?}: {miss}");
            }
        }
    }
}

#[test]
fn creases_between_sheets() {
    // The keel of a hull of two sides: touched across the ship, passed from above.
    let sides = crate::shapes::wigley_hull().map(Sheet::Grid);
    let hull = Surface::new(sides.into(), None, &Job::default()).unwrap();
    for j in [3, 11, 20, 29] {
        let keel = hull.jet(Place { sheet: 0, cell: [j, 0], u: 0.3, v: 0.0 }).point;
        for (direction, expected) in [(DVec3::Y, (2, true)), (DVec3::new(0.1, 0.0, 1.0), (1, false))] {
            let hits = hull.line(&Line::new(keel - direction, direction), HitSelection::All).unwrap();
            let here: Vec<_> = hits.iter().filter(|hit| hit.point.distance(keel) < 1e-9).collect();
            assert_eq!(here.len(), 1, "{hits:?}");
            assert_eq!((here[0].multiplicity, here[0].tangent), expected, "{hits:?}");
        }
    }
}

#[test]
fn tangents_at_sides_cross_a_closed_surface_an_even_number_of_times() {
    let point = |u: f64, v: f64| {
        let ring = 2.0 + 0.8 * (TAU * v).cos();
        DVec3::new(ring * (TAU * u).cos(), ring * (TAU * u).sin(), 0.8 * (TAU * v).sin())
    };
    let surface = sheet_of([8, 8], [true, true], Scheme::SixTap, point);
    let mut random = Random(11);
    for k in 0..600_u32 {
        let place = Place { sheet: 0, cell: [k % 8, k / 8 % 8], u: 0.5 * f64::from(k % 3 % 2), v: 0.0 };
        let (jet, along) = (surface.jet(place), random.point(1.0));
        // Inside the ring a tangent may be within the tolerance of the surface in several places.
        if (3..=5).contains(&place.cell[1]) {
            continue;
        }
        let line = Line::new(jet.point, along.x * jet.u + along.y * jet.v);
        let hits = surface.line(&line, HitSelection::All).unwrap();
        assert!(multiplicities(&hits).is_multiple_of(2), "{k}: {hits:?}");
        // No intersection is reported twice.
        let length = line.direction.length();
        for hit in hits.iter().filter(|hit| !hit.tangent) {
            let within = |touch: &&Hit| touch.tangent && touch.span[0] <= hit.at && hit.at <= touch.span[1];
            let steep = hit.normal.dot(line.direction).abs() > 1e-3 * length;
            assert!(steep || !hits.iter().any(|touch| within(&touch)), "{k}: {hits:?}");
        }
        assert_eq!(surface.line(&line, HitSelection::First).unwrap()[0].place, hits[0].place);
    }
}
