//! Sheets from tangents, splines, patches, nets of curves and frames: interpolation, smoothness,
//! and distance from the truth.

use crate::shapes::wigley;
use glam::DVec3;
use gusset::curve::frame::{Correspondence, FrameOptions, frame};
use gusset::curve::{Curve, CurveKind, CurveView, Options, Outlines, Points};
use gusset::surface::construct::{CurveNet, FrameSurface, Tangents, Twists};
use gusset::surface::{Grid, Nodes, Patches, Scheme, Sheet};
use gusset::{Element, Error, Job};
use std::f64::consts::TAU;

/// The largest errors of position, and of the normal if it is asked for, at 5 x 5 places of every
/// cell.
pub(crate) fn errors(sheet: &Sheet<'_>, truth: impl Fn(f64, f64) -> (DVec3, DVec3)) -> [f64; 2] {
    let [h, w] = sheet.cells();
    let mut worst = [0.0_f64; 2];
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        for (s, t) in (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0)) {
            let (point, normal) = truth(i as f64 + s, j as f64 + t);
            worst[0] = worst[0].max(sheet.jet(i, j, s, t).point.distance(point));
            worst[1] = worst[1].max(sheet.normal(i, j, s, t).cross(normal).length());
        }
    }
    worst
}

pub(crate) fn torus(u: f64, v: f64) -> (DVec3, DVec3) {
    let ring = 1.0 + 0.4 * u.cos();
    let normal = DVec3::new(u.cos() * v.cos(), u.cos() * v.sin(), u.sin());
    (DVec3::new(ring * v.cos(), ring * v.sin(), 0.4 * u.sin()), normal)
}

/// Orders of errors from one refinement to the next.
fn orders(all: [[f64; 2]; 3]) -> [[f64; 2]; 2] {
    [0, 1].map(|k| [0, 1].map(|e| (all[k][e] / all[k + 1][e]).log2()))
}

/// S_u, S_v and S_uv of the torus at h x w cells, by the parameters of nodes.
fn with_tangents(h: usize, w: usize, twists: u32) -> Sheet<'static> {
    let (du, dv) = (TAU / h as f64, TAU / w as f64);
    let at = |k: usize| (du * (k / (w + 1) % h) as f64, dv * (k % (w + 1) % w) as f64);
    let all = || (0..(h + 1) * (w + 1)).map(at);
    let data: Vec<f64> = all().flat_map(|(u, v)| torus(u, v).0.to_array()).collect();
    let nodes = Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap();
    let su: Vec<DVec3> =
        all().map(|(u, v)| 0.4 * du * DVec3::new(-u.sin() * v.cos(), -u.sin() * v.sin(), u.cos())).collect();
    let sv: Vec<DVec3> = all().map(|(u, v)| dv * (1.0 + 0.4 * u.cos()) * DVec3::new(-v.sin(), v.cos(), 0.0)).collect();
    let suv: Vec<DVec3> =
        all().map(|(u, v)| 0.4 * du * dv * DVec3::new(u.sin() * v.sin(), -u.sin() * v.cos(), 0.0)).collect();
    let twists = match twists {
        0 => Twists::Differences,
        1 => Twists::Adini,
        2 => Twists::Zero,
        _ => Twists::Given(&suv),
    };
    let tangents = Tangents { nodes: &nodes, u: &su, v: &sv, twists, closed: [true, true] };
    Sheet::from_tangents(&tangents, &Job::default()).unwrap()
}

#[test]
fn tangents_on_a_torus() {
    for (twists, position, normal) in [(0, 3.8, 2.9), (1, 3.8, 2.9), (2, 1.9, 0.9), (3, 3.8, 2.9)] {
        let all = [16, 32, 64].map(|h| {
            let sheet = with_tangents(h, 2 * h, twists);
            assert_eq!(sheet.is_closed(), [true, true]);
            errors(&sheet, |u, v| torus(TAU * u / h as f64, TAU * v / (2 * h) as f64))
        });
        for [p, n] in orders(all) {
            assert!(p >= position && n >= normal, "{twists}: {all:?}");
        }
        if twists != 2 {
            assert!(with_tangents(16, 32, twists).largest_crease_angle(&Job::default()).unwrap() < 1e-7);
        }
    }
    // Triangles, beside them, are of order 2.
    let flat = [16, 32, 64].map(|h| {
        let sheet = with_tangents(h, 2 * h, 0);
        let [h, w] = sheet.cells();
        let middle = |i, j| sheet.corner(i, j).midpoint(sheet.corner(i + 1, j + 1));
        let apart = |i, j| f64::abs(f64::hypot(f64::hypot(middle(i, j).x, middle(i, j).y) - 1.0, middle(i, j).z) - 0.4);
        (0..h).flat_map(|i| (0..w).map(move |j| (i, j))).map(|(i, j)| apart(i, j)).fold(0.0, f64::max)
    });
    assert!((flat[1] / flat[2]).log2() > 1.9 && (flat[1] / flat[2]).log2() < 2.1, "{flat:?}");
}

#[test]
fn tangents_that_do_not_fit() {
    let job = Job::default();
    let data: Vec<f64> = (0..9).flat_map(|k| [f64::from(k / 3), f64::from(k % 3), 0.0]).collect();
    let nodes = Nodes::strided(data, 3, 3, 0, 0).unwrap();
    let (u, v) = (vec![DVec3::X; 9], vec![DVec3::Y; 9]);
    let given = Tangents { nodes: &nodes, u: &u, v: &v, twists: Twists::Differences, closed: [false, false] };
    // A plane is one to the bit's rounding.
    let sheet = Sheet::from_tangents(&given, &job).unwrap();
    assert!(sheet.jet(1, 0, 0.3, 0.6).point.distance(DVec3::new(1.3, 0.6, 0.0)) < 1e-15);
    assert!(matches!(Sheet::from_tangents(&Tangents { u: &u[..8], ..given }, &job), Err(Error::ArrayTooShort { .. })));
    let mut bad = v.clone();
    bad[5].z = f64::NAN;
    let found = Sheet::from_tangents(&Tangents { v: &bad, ..given }, &job);
    assert!(matches!(found, Err(Error::NotFinite { element: Element::Node, index: 5, .. })));
    let found = Sheet::from_tangents(&Tangents { twists: Twists::Given(&bad), ..given }, &job);
    assert!(matches!(found, Err(Error::NotFinite { element: Element::Node, index: 5, .. })));
    let found = Sheet::from_tangents(&Tangents { closed: [true, false], ..given }, &job);
    assert!(matches!(found, Err(Error::NetTooSmall { .. })));
}

#[test]
fn patches_of_mixed_degrees() {
    // The same quadratic by linear patch, raised to cubic and to the seventh degree.
    let net = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, 1.0, 0.0), DVec3::new(1.0, 1.0, 2.0), DVec3::Y * 2.0, DVec3::ONE];
    let low = Patches::<4>::new(&net, [2, 1], 1, 1).unwrap();
    let high = Patches::<8>::new(&net, [2, 1], 1, 1).unwrap();
    for k in 0..36 {
        let (u, v) = (f64::from(k / 6) / 5.0, f64::from(k % 6) / 5.0);
        let row = |a: usize| net[2 * a].lerp(net[2 * a + 1], v);
        let truth = row(0) * (1.0 - u) * (1.0 - u) + row(1) * 2.0 * u * (1.0 - u) + row(2) * u * u;
        assert!(low.get(0, 0).point(u, v).distance(truth) < 1e-14);
        assert!(high.get(0, 0).point(u, v).distance(truth) < 1e-14);
    }
    assert!(matches!(Patches::<4>::new(&net, [4, 1], 1, 1), Err(Error::OptionOutOfRange { .. })));
    assert!(matches!(Patches::<4>::new(&net, [2, 1], 0, 1), Err(Error::EmptyMesh { .. })));
    // All points one: a sheet without normals, but a sheet.
    let one = Sheet::Cubic(Patches::new(&[DVec3::ONE; 4], [1, 1], 1, 1).unwrap());
    assert_eq!(one.normal(0, 0, 0.5, 0.5), DVec3::ZERO);
    assert_eq!(one.to_mesh(&Default::default(), &Job::default()).unwrap().mesh.face_count(), 0);
}

/// A curve through points: Bézier segments of degree 3, C2.
pub(crate) fn through(points: &[DVec3], closed: bool) -> Curve {
    let rows: Vec<[f64; 3]> = points.iter().map(DVec3::to_array).collect();
    let outlines = Outlines { points: Points::from(&rows[..]), offsets: None, closed, constraints: &[] };
    let options = Options { curve: CurveKind::CubicC2, ..Options::default() };
    gusset::curve::fit(&outlines, &options, &Job::default()).unwrap().curve(0).to_owned().unwrap()
}

/// The largest distance of a curve's points, 4 a segment, from the nearest point of the sheet.
pub(crate) fn distance_from(sheet: &Sheet<'static>, curve: CurveView<'_>) -> f64 {
    let surface = gusset::surface::Surface::new(vec![sheet.clone()], None, &Job::default()).unwrap();
    let mut worst = 0.0_f64;
    for segment in 0..curve.len() {
        for t in [0.05, 0.3, 0.6, 0.9] {
            let place = gusset::curve::Place { segment: segment as u32, t };
            let point = curve.point(place).unwrap();
            worst = worst.max(surface.closest(point, f64::INFINITY).unwrap().distance);
        }
    }
    worst
}

#[test]
fn nets_of_curves_contain_them() {
    let job = Job::default();
    let f = |u: f64, v: f64| DVec3::new(u, v, 0.3 * (2.0 * u + 0.5).sin() * (1.5 * v).cos());
    for (h, w) in [(2, 2), (3, 2), (4, 5), (7, 8)] {
        // Uneven lines; columns beyond the rows and the other way round; every second one turned
        // round.
        let (us, vs): (Vec<f64>, Vec<f64>) = (
            (0..h).map(|k| (k as f64).powf(1.2) / 2.0).collect(),
            (0..w).map(|k| 0.7 * k as f64 + 0.1 * (k as f64).sin()).collect(),
        );
        let curve = |along_u: bool, fixed: f64, at: &[f64], turned: bool| {
            let mut points: Vec<DVec3> = at.iter().map(|&t| if along_u { f(t, fixed) } else { f(fixed, t) }).collect();
            if turned {
                points.reverse();
            }
            through(&points, false)
        };
        let rows: Vec<Curve> = us.iter().enumerate().map(|(k, &u)| curve(false, u, &vs, k % 2 == 1)).collect();
        let columns: Vec<Curve> = vs.iter().enumerate().map(|(k, &v)| curve(true, v, &us, k % 2 == 1)).collect();
        let (rows, columns): (Vec<_>, Vec<_>) =
            (rows.iter().map(Curve::view).collect(), columns.iter().map(Curve::view).collect());
        let net = CurveNet { rows: &rows, columns: &columns, closed: [false, false], tolerance: None };
        let sheet = Sheet::from_curves(&net, &job).unwrap();
        assert_eq!(sheet.cells(), [h - 1, w - 1]);
        for (k, l) in (0..h).flat_map(|k| (0..w).map(move |l| (k, l))) {
            assert!(sheet.corner(k, l).distance(f(us[k], vs[l])) < 1e-13, "{k} {l}");
        }
        for &curve in rows.iter().chain(&columns) {
            let apart = distance_from(&sheet, curve);
            assert!(apart < 1e-12, "{h} x {w}: {apart}");
        }
    }
}

#[test]
fn nets_on_a_torus_have_order_four() {
    let job = Job::default();
    let make = |h: usize| {
        let w = 2 * h;
        let at = |k: usize, n: usize| TAU * k as f64 / n as f64;
        // Curves of degree 7 that are as good as the circles: Hermite data would do; here the
        // quintic in each quarter of a mesh is not needed, as cubics with the exact tangents are of
        // order 4 themselves.
        let circle = |from: &dyn Fn(f64) -> DVec3, n: usize| {
            let mut points = Vec::new();
            let mut ends = vec![0];
            for k in 0..n {
                let (a, b) = (at(k, n), at(k + 1, n) % TAU);
                let step = TAU / n as f64;
                let slope = |t: f64| (from(t + 1e-4) - from(t - 1e-4)) / 2e-4;
                if k == 0 {
                    points.push(from(a));
                }
                let b = if k + 1 == n { 0.0 } else { b };
                points.extend([from(a) + slope(a) * step / 3.0, from(b) - slope(b) * step / 3.0, from(b)]);
                ends.push(points.len() as u32 - 1);
            }
            CurveView::new(&points, &ends, true).unwrap().to_owned().unwrap()
        };
        let rows: Vec<Curve> = (0..h).map(|k| circle(&|v| torus(at(k, h), v).0, w)).collect();
        let columns: Vec<Curve> = (0..w).map(|l| circle(&|u| torus(u, at(l, w)).0, h)).collect();
        let (rows, columns): (Vec<_>, Vec<_>) =
            (rows.iter().map(Curve::view).collect(), columns.iter().map(Curve::view).collect());
        let net = CurveNet { rows: &rows, columns: &columns, closed: [true, true], tolerance: None };
        let sheet = Sheet::from_curves(&net, &job).unwrap();
        assert_eq!((sheet.cells(), sheet.is_closed()), ([h, w], [true, true]));
        assert!(sheet.largest_crease_angle(&job).unwrap() < 1e-6);
        errors(&sheet, |u, v| torus(TAU * u / h as f64, TAU * v / w as f64))
    };
    let all = [10, 20, 40].map(make);
    for [p, n] in orders(all) {
        assert!(p >= 3.8 && n >= 2.9, "{all:?}");
    }
}

#[test]
fn coons_patches_poles_and_skins() {
    let job = Job::default();
    let line = |points: &[DVec3]| {
        let ends: Vec<u32> = (0..points.len() as u32).collect();
        CurveView::new(points, &ends, false).unwrap().to_owned().unwrap()
    };
    // Four polylines: the bilinearly blended patch, in as many cells as there are pieces.
    let (a, b) = (line(&[DVec3::ZERO, DVec3::new(0.0, 0.4, 0.2), DVec3::Y]), line(&[DVec3::X, DVec3::X + DVec3::Y]));
    let (c, d) = (line(&[DVec3::ZERO, DVec3::X]), line(&[DVec3::Y, DVec3::new(0.5, 1.0, 0.3), DVec3::X + DVec3::Y]));
    let (rows, columns) = ([a.view(), b.view()], [c.view(), d.view()]);
    let net = CurveNet { rows: &rows, columns: &columns, closed: [false, false], tolerance: Some(1e-9) };
    let sheet = Sheet::from_curves(&net, &job).unwrap();
    assert_eq!(sheet.cells(), [2, 2]);
    for curve in rows.iter().chain(&columns) {
        assert!(distance_from(&sheet, *curve) < 1e-14);
    }
    // Three sides: the fourth is a point.
    let tip = CurveView::new(&[DVec3::ZERO], &[0], false).unwrap().to_owned().unwrap();
    let side = line(&[DVec3::ZERO, DVec3::X + DVec3::Y]);
    let (rows, columns) = ([tip.view(), b.view()], [c.view(), side.view()]);
    let net = CurveNet { rows: &rows, columns: &columns, closed: [false, false], tolerance: None };
    let sheet = Sheet::from_curves(&net, &job).unwrap();
    assert_eq!(sheet.poles_at_sides(), [[true, false], [false, false]]);
    assert!(sheet.normal(0, 0, 0.0, 0.3).distance(DVec3::Z) < 1e-12);
    // A skin of stations of Wigley's hull with different numbers of points contains them; rows
    // alone, columns alone.
    let stations: Vec<Curve> = (0..9)
        .map(|k| {
            let count = 4 + k % 3;
            through(
                &(0..=count)
                    .map(|i| wigley(0.45 - 0.1 * f64::from(k), -0.06 * (1.0 - f64::from(i) / f64::from(count))))
                    .collect::<Vec<_>>(),
                false,
            )
        })
        .collect();
    let views: Vec<_> = stations.iter().map(Curve::view).collect();
    let net = CurveNet { rows: &views, columns: &[], closed: [false, false], tolerance: None };
    let skin = Sheet::from_curves(&net, &job).unwrap();
    assert_eq!(skin.cells()[0], 8);
    let turned = Sheet::from_curves(&CurveNet { rows: &[], columns: &views, ..net }, &job).unwrap();
    assert_eq!(turned.cells(), [skin.cells()[1], 8]);
    assert!(turned.jet(1, 2, 0.3, 0.6).point.distance(skin.jet(2, 1, 0.6, 0.3).point) < 1e-15);
    for &view in &views {
        assert!(distance_from(&skin, view) < 1e-13);
    }
    // Stations that run backwards are turned.
    let backwards: Vec<Curve> = views.iter().map(|view| view.reversed(&job).unwrap()).collect();
    let mixed: Vec<_> = (0..9).map(|k| if k % 3 == 1 { backwards[k].view() } else { views[k] }).collect();
    let mixed = Sheet::from_curves(&CurveNet { rows: &mixed, ..net }, &job).unwrap();
    for (i, j) in (0..8).flat_map(|i| (0..skin.cells()[1]).map(move |j| (i, j))) {
        assert!(mixed.jet(i, j, 0.4, 0.7).point.distance(skin.jet(i, j, 0.4, 0.7).point) < 1e-12);
    }
}

#[test]
fn nets_that_are_none() {
    let job = Job::default();
    let line = |a: DVec3, b: DVec3| CurveView::new(&[a, b], &[0, 1], false).unwrap().to_owned().unwrap();
    let rows = [0.0, 1.0, 2.0].map(|u| line(DVec3::new(u, 0.0, 0.0), DVec3::new(u, 2.0, 0.0)));
    let columns = [0.0, 1.0, 2.0].map(|v| line(DVec3::new(0.0, v, 0.0), DVec3::new(2.0, v, 0.0)));
    let far = line(DVec3::new(0.0, 1.0, 0.5), DVec3::new(2.0, 1.0, 0.5));
    let (rows, columns) = (rows.each_ref().map(Curve::view), columns.each_ref().map(Curve::view));
    let net = CurveNet { rows: &rows, columns: &columns, closed: [false, false], tolerance: None };
    let sheet = Sheet::from_curves(&net, &job).unwrap();
    assert!(sheet.jet(1, 0, 0.5, 0.25).point.distance(DVec3::new(1.5, 0.25, 0.0)) < 1e-15);
    let kind = |net: CurveNet<'_>| Sheet::from_curves(&net, &job).unwrap_err();
    let apart = [columns[0], far.view(), columns[2]];
    assert_eq!(kind(CurveNet { columns: &apart, ..net }), Error::CurvesApart { row: 0, column: 1, distance: 0.5 });
    // Within a tolerance they meet half way.
    let met = Sheet::from_curves(&CurveNet { columns: &apart, tolerance: Some(0.6), ..net }, &job).unwrap();
    assert!(met.corner(1, 1).distance(DVec3::new(1.0, 1.0, 0.25)) < 1e-15);
    let mixed = [rows[0], rows[2], rows[1]];
    let sorted = Sheet::from_curves(&net, &job).unwrap();
    let mixed = Sheet::from_curves(&CurveNet { rows: &mixed, ..net }, &job).unwrap();
    assert_eq!(mixed.jet(1, 0, 0.5, 0.25), sorted.jet(1, 0, 0.5, 0.25));
    assert!(matches!(kind(CurveNet { rows: &rows[..1], ..net }), Error::NetTooSmall { rows: 1, columns: 3 }));
    assert!(matches!(kind(CurveNet { rows: &[], columns: &[], ..net }), Error::NetTooSmall { .. }));
    assert_eq!(kind(CurveNet { closed: [true, false], ..net }), Error::CurveNotClosed);
    assert!(matches!(kind(CurveNet { tolerance: Some(f64::NAN), ..net }), Error::OptionOutOfRange { .. }));
    let points: Vec<DVec3> = (0..9).map(|k| DVec3::X * f64::from(k)).collect();
    let high = CurveView::new(&points, &[0, 8], false).unwrap();
    assert!(matches!(kind(CurveNet { columns: &[high, columns[1]], ..net }), Error::OptionOutOfRange { .. }));
    let none = CurveView::new(&[], &[0], false).unwrap();
    assert_eq!(kind(CurveNet { columns: &[none, columns[1]], ..net }), Error::EmptyCurve);
}

#[test]
fn frames_and_their_curves() {
    let job = Job::default();
    // Sections of a tube that narrows, closed, with a pole at its end.
    let sections: Vec<[f64; 3]> = (0..8)
        .flat_map(|k| {
            let r = (1.0 - (f64::from(k) / 7.0).powi(2)).max(0.0).sqrt();
            (0..12).map(move |i| {
                let angle = TAU * f64::from(i) / 12.0;
                [r * angle.cos(), r * angle.sin() * 0.8, f64::from(k) * 0.3]
            })
        })
        .collect();
    let offsets: Vec<u32> = (0..=8).map(|k| 12 * k).collect();
    let outlines =
        Outlines { points: Points::from(&sections[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
    for curve_kind in [CurveKind::Composite, CurveKind::BlendC1, CurveKind::BlendC2, CurveKind::CubicC2] {
        let curves = Options { curve: curve_kind, ..Options::default() };
        let options = FrameOptions { across: curves, along: curves, ..FrameOptions::new(Correspondence::Given) };
        let made = frame(&outlines, &options, &job).unwrap();
        let grid = Sheet::from_frame(&made, [false, true], FrameSurface::Nodes, &job).unwrap();
        assert_eq!((grid.cells(), grid.is_closed(), grid.poles_at_sides()[0]), ([7, 12], [false, true], [false, true]));
        let sheet = Sheet::from_frame(&made, [false, true], FrameSurface::Curves, &job).unwrap();
        assert_eq!((sheet.is_closed(), sheet.poles_at_sides()[0]), ([false, true], [false, true]), "{curve_kind:?}");
        for k in 0..7 {
            let apart = distance_from(&sheet, made.across.curve(k));
            assert!(apart < 1e-12, "{curve_kind:?} {k}: {apart}");
        }
        for l in 0..12 {
            let apart = distance_from(&sheet, made.along.curve(l));
            assert!(apart < 1e-12, "{curve_kind:?} {l}: {apart}");
        }
    }
}

/// By z over its shadow on the plane z = 0, at Gauss's points; ends across x count for nothing.
fn volume_below(sheet: &Sheet<'_>) -> f64 {
    let [h, w] = sheet.cells();
    let gauss = [(0.5 - 0.15f64.sqrt(), 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.15f64.sqrt(), 5.0 / 18.0)];
    let mut sum = 0.0;
    for (i, j) in (0..h).flat_map(|i| (0..w).map(move |j| (i, j))) {
        for ((u, a), (v, b)) in gauss.iter().flat_map(|&u| gauss.map(|v| (u, v))) {
            let jet = sheet.jet(i, j, u, v);
            sum += a * b * jet.point.z * jet.u.cross(jet.v).z;
        }
    }
    sum.abs()
}

#[test]
fn hulls_with_decks_have_their_volumes() {
    let job = Job::default();
    for (below, above) in [(7, 0), (9, 3), (13, 1), (21, 5)] {
        // From edge to edge below a flat deck.
        let section = |x: f64| {
            let half = 1.0 - 0.03 * x * x;
            let hull = (0..below).map(|i| 2.0 * f64::from(i) / f64::from(below - 1) - 1.0);
            let hull = hull.map(move |s| [x, half * s, (1.0 + 0.02 * x * x) * s * s]);
            let deck = (1..=above).map(|i| 1.0 - 2.0 * f64::from(i) / f64::from(above + 1));
            hull.chain(deck.map(move |s| [x, half * s, 1.0 + 0.02 * x * x])).collect::<Vec<_>>()
        };
        let stations: Vec<f64> = (-4..=4).map(f64::from).collect();
        let points: Vec<[f64; 3]> = stations.iter().flat_map(|&x| section(x)).collect();
        let offsets: Vec<u32> = (0..=stations.len()).map(|k| (k * section(0.0).len()) as u32).collect();
        let outlines =
            Outlines { points: Points::from(&points[..]), offsets: Some(&offsets), closed: true, constraints: &[] };
        // The area under the curves of the points: 4/3 of half the width times the depth, by
        // Simpson's rule.
        let area = |x: f64| 4.0 / 3.0 * (1.0 - 0.03 * x * x) * (1.0 + 0.02 * x * x);
        let exact: f64 = (0..800)
            .map(|k| f64::from(k) / 100.0 - 4.0)
            .map(|x| (area(x) + 4.0 * area(x + 0.005) + area(x + 0.01)) * 0.01 / 6.0)
            .sum();
        for correspondence in [Correspondence::Given, Correspondence::ArcLength { columns: 24 }] {
            let curves = Options::default();
            let options = FrameOptions { across: curves, along: curves, ..FrameOptions::new(correspondence) };
            let made = frame(&outlines, &options, &job).unwrap();
            let sheet = Sheet::from_frame(&made, [false, true], FrameSurface::Nodes, &job).unwrap();
            let off = volume_below(&sheet) / exact - 1.0;
            assert!(off.abs() < 0.01, "{below} {above} {correspondence:?}: {off}");
            let smooth = FrameOptions { smooth_corners: true, ..options };
            let made = frame(&outlines, &smooth, &job).unwrap();
            let sheet = Sheet::from_frame(&made, [false, true], FrameSurface::Nodes, &job).unwrap();
            println!("{below} {above} {correspondence:?}: {off:.5}, smooth {:.5}", volume_below(&sheet) / exact - 1.0);
        }
    }
}

#[test]
fn hermite_and_grid_agree_where_the_slopes_do() {
    // Tangents that are the six-tap slopes give the six-tap surface.
    let shape = &crate::shapes::SHAPES[2];
    let grid = crate::shapes::grid(shape);
    let [h, w] = grid.cells();
    let sheet = Sheet::Grid(grid.clone());
    let jet = |k: usize| {
        let (i, j) = (k / (w + 1), k % (w + 1));
        let (a, b) = (i.min(h - 1), j.min(w - 1));
        sheet.jet(a, b, (i - a) as f64, (j - b) as f64)
    };
    let jets: Vec<_> = (0..(h + 1) * (w + 1)).map(jet).collect();
    let [u, v, uv] = [
        jets.iter().map(|jet| jet.u).collect::<Vec<_>>(),
        jets.iter().map(|jet| jet.v).collect(),
        jets.iter().map(|jet| jet.uv).collect(),
    ];
    for twists in [Twists::Differences, Twists::Given(&uv)] {
        let given = Tangents { nodes: grid.nodes(), u: &u, v: &v, twists, closed: shape.closed };
        let made = Sheet::from_tangents(&given, &Job::default()).unwrap();
        for k in 0..h * w {
            let (a, b) = (made.jet(k / w, k % w, 0.3, 0.8).point, sheet.jet(k / w, k % w, 0.3, 0.8).point);
            assert!(a.distance(b) < 1e-14);
        }
    }
    let four = Grid::new(grid.nodes().clone(), shape.closed, Scheme::FourPoint).unwrap();
    assert!(Sheet::Grid(four).largest_crease_angle(&Job::default()).unwrap() > 1e-6);
}
