//! Stitching, held against Euler's formula, edge counts by hashing, and shapes whose area and
//! volume are known.

use crate::common::{Soup, cap, edge_counts, euler, sheet, volume};
use gusset::mesh::{Faces, Mesh, MeshView, Positions};
use gusset::stitch::{Cells, Extent, Meridians, Options, Orientation, Request, Rows, Stitch, stitch};
use gusset::{Error, Job, Progress, Side};
use proptest::prelude::*;
use std::f64::consts::PI;
use std::ops::ControlFlow;

fn join(a: &Soup, b: &Soup, options: &Options) -> Result<Stitch, Error> {
    stitch(&Request { a: &a.view(), loop_a: None, b: Some(&b.view()), loop_b: None }, options, &Job::default())
}

fn faces(mesh: &Mesh) -> impl Iterator<Item = &[u32]> + Clone {
    mesh.face_offsets.windows(2).map(|w| &mesh.face_corners[w[0] as usize..w[1] as usize])
}

/// Closed, manifold at every edge, consistently oriented.
fn assert_closed(mesh: &Mesh) {
    for (edge, counts) in edge_counts(faces(mesh)) {
        assert_eq!(counts, (1, 1), "edge {edge:?}");
    }
}

#[test]
fn two_caps_make_a_sphere() {
    for meridians in [Meridians::MinArea, Meridians::Index] {
        for (n, m) in [(3, 3), (3, 17), (40, 64), (64, 40), (50, 50)] {
            let (a, b) = (cap(n, 8, 0.1, 1.0), cap(m, 8, 0.1, -1.0));
            let joined = join(&a, &b, &Options { meridians, ..Options::default() }).unwrap();
            assert_closed(&joined.mesh);
            assert_eq!(euler(faces(&joined.mesh)), 2);
            assert_eq!(joined.strip_faces.len() as u32, n + m);
            assert_eq!(joined.mesh.face_count(), a.faces().count() + b.faces().count() + (n + m) as usize);
            assert!(!joined.turned);
            let quality = joined.quality;
            assert_eq!((quality.loops_left, quality.non_manifold_edges, quality.orientation_conflicts), (0, 0, 0));
            if n.min(m) >= 40 {
                // The unit sphere's volume, and the area of its zone of height 0.2, up to the
                // polygons' own error.
                let v = volume(|v| joined.mesh.positions.get(v).to_array(), faces(&joined.mesh));
                assert!((v - 4.0 / 3.0 * PI).abs() < 0.06, "{v}");
                assert!((quality.area - 2.0 * PI * 0.2).abs() < 0.02, "{}", quality.area);
                assert!(quality.min_angle > 0.2 && quality.max_aspect < 4.0, "{quality:?}");
            }
        }
    }
}

#[test]
fn the_parts_of_the_result_agree() {
    let (a, b) = (cap(12, 3, 0.2, 1.0), cap(7, 2, 0.2, -1.0));
    let joined = join(&a, &b, &Options::default()).unwrap();
    // Old positions, bit for bit; old faces, corner for corner.
    for (soup, map) in [(&a, &joined.maps[0]), (&b, &joined.maps[1])] {
        for (v, point) in soup.points.iter().enumerate() {
            assert_eq!(joined.mesh.positions.get(map.vertices[v]).to_array(), *point);
        }
        for (f, face) in soup.faces().enumerate() {
            let new: Vec<u32> = face.iter().map(|&v| map.vertices[v as usize]).collect();
            assert_eq!(faces(&joined.mesh).nth(map.faces[f] as usize).unwrap(), new);
        }
    }
    // The strip alone is the strip in the whole.
    let names: Vec<u32> = joined.rims.concat();
    let alone: Vec<Vec<u32>> = faces(&joined.strip).map(|f| f.iter().map(|&v| names[v as usize]).collect()).collect();
    let inside: Vec<Vec<u32>> =
        faces(&joined.mesh).skip(joined.strip_faces.start as usize).map(<[u32]>::to_vec).collect();
    assert_eq!(alone, inside);
    for (i, &v) in names.iter().enumerate() {
        assert_eq!(joined.strip.positions.get(i as u32), joined.mesh.positions.get(v));
    }
    // The first meridian is the shortest of all there could be.
    let length = |i: usize, j: usize| {
        let at = |side: usize, k: usize| joined.mesh.positions.get(joined.rims[side][k]);
        at(0, i).distance(at(1, j))
    };
    let shortest = (0..12).flat_map(|i| (0..7).map(move |j| length(i, j))).fold(f64::INFINITY, f64::min);
    assert_eq!(length(0, 0), shortest);
    // Meridians: a lattice path over both rims, and each one an edge of the strip.
    let edges = edge_counts(faces(&joined.mesh));
    assert_eq!((joined.meridians[0], *joined.meridians.last().unwrap()), ([0, 0], [12, 7]));
    for &[i, j] in &joined.meridians {
        let (u, v) = (joined.rims[0][i as usize % 12], joined.rims[1][j as usize % 7]);
        assert!(edges.contains_key(&(u.min(v), u.max(v))));
    }
}

#[test]
fn a_piece_inside_out_is_turned_refused_or_kept() {
    let (a, b) = (cap(20, 4, 0.2, 1.0), cap(30, 4, 0.2, -1.0).turned());
    let fixed = join(&a, &b, &Options::default()).unwrap();
    assert!(fixed.turned);
    assert_closed(&fixed.mesh);
    assert!(volume(|v| fixed.mesh.positions.get(v).to_array(), faces(&fixed.mesh)) > 3.5);

    let refuse = Options { orientation: Orientation::Refuse, ..Options::default() };
    assert!(matches!(join(&a, &b, &refuse), Err(Error::OrientationConflict { .. })));
    assert!(join(&a, &b.turned(), &refuse).is_ok());

    let keep = Options { orientation: Orientation::Keep, ..Options::default() };
    let kept = join(&a, &b, &keep).unwrap();
    assert!(!kept.turned);
    assert_closed(&kept.mesh);
}

#[test]
fn one_mesh_of_two_parts_or_of_one() {
    // Two caps in one mesh, the second inside out.
    let soup = cap(20, 4, 0.2, 1.0).and(&cap(30, 4, 0.2, -1.0).turned());
    let view = soup.view();
    let request = Request { a: &view, loop_a: None, b: None, loop_b: None };
    let joined = stitch(&request, &Options::default(), &Job::default()).unwrap();
    assert!(joined.turned && joined.maps[1].vertices.is_empty());
    assert_closed(&joined.mesh);
    assert_eq!(euler(faces(&joined.mesh)), 2);

    // A tube becomes a torus: connected already, so nothing is turned.
    let n = 12;
    let mut tube = Soup { offsets: vec![0], ..Soup::default() };
    for ring in 0..4 {
        for i in 0..n {
            let t = std::f64::consts::TAU * f64::from(i) / f64::from(n);
            tube.points.push([t.cos(), t.sin(), f64::from(ring)]);
        }
    }
    for ring in 0..3 {
        for i in 0..n {
            let (k, next) = (ring * n + i, ring * n + (i + 1) % n);
            tube.face(&[k, next, next + n, k + n]);
        }
    }
    let view = tube.view();
    let request = Request { a: &view, loop_a: None, b: None, loop_b: None };
    let joined = stitch(&request, &Options::default(), &Job::default()).unwrap();
    assert_closed(&joined.mesh);
    assert_eq!(euler(faces(&joined.mesh)), 0);
}

#[test]
fn edges_that_the_mesh_already_has_are_avoided_or_the_strip_refused() {
    // A band of one ring of quads: its rims are joined by edges already.
    let band = |n: u32| {
        let mut soup = Soup { offsets: vec![0], ..Soup::default() };
        for ring in 0..2 {
            for i in 0..n {
                let t = std::f64::consts::TAU * f64::from(i) / f64::from(n);
                soup.points.push([t.cos(), t.sin(), f64::from(ring)]);
            }
        }
        for i in 0..n {
            soup.face(&[i, (i + 1) % n, n + (i + 1) % n, n + i]);
        }
        soup
    };
    let soup = band(8);
    let view = soup.view();
    let request = Request { a: &view, loop_a: None, b: None, loop_b: None };
    let joined = stitch(&request, &Options::default(), &Job::default()).unwrap();
    assert_closed(&joined.mesh);
    assert_eq!(euler(faces(&joined.mesh)), 0);

    // A band of triangles round a prism uses six of the nine edges between its rims: no strip is
    // left.
    let mut prism = band(3);
    prism.corners.clear();
    prism.offsets = vec![0];
    for i in 0..3 {
        let k = (i + 1) % 3;
        prism.face(&[i, k, 3 + k]);
        prism.face(&[i, 3 + k, 3 + i]);
    }
    let view = prism.view();
    let request = Request { a: &view, loop_a: None, b: None, loop_b: None };
    for meridians in [Meridians::MinArea, Meridians::Index] {
        let options = Options { meridians, ..Options::default() };
        assert!(matches!(stitch(&request, &options, &Job::default()), Err(Error::NoStrip { .. })));
    }
}

#[test]
fn loops_given_by_hand() {
    let (a, b) = (cap(6, 1, 0.2, 1.0), cap(5, 1, 0.2, -1.0));
    let (view_a, view_b) = (a.view(), b.view());
    let (ring_a, ring_b): (Vec<u32>, Vec<u32>) = ((1..7).collect(), (1..6).collect());
    let run = |loop_a: &[u32], loop_b: &[u32]| {
        let request = Request { a: &view_a, loop_a: Some(loop_a), b: Some(&view_b), loop_b: Some(loop_b) };
        stitch(&request, &Options::default(), &Job::default())
    };
    let joined = run(&ring_a, &ring_b).unwrap();
    assert_closed(&joined.mesh);
    // Either direction, any start: the same strip.
    let mut other = ring_b.clone();
    other.reverse();
    other.rotate_left(2);
    let again = run(&ring_a, &other).unwrap();
    assert_closed(&again.mesh);
    assert_eq!(again.rims, joined.rims);

    assert_eq!(run(&[1, 2], &ring_b), Err(Error::LoopTooShort { side: Side::A, count: 2 }));
    assert_eq!(run(&[], &ring_b), Err(Error::LoopTooShort { side: Side::A, count: 0 }));
    assert_eq!(run(&ring_a, &[1, 2, 1, 2]), Err(Error::LoopRepeatsVertex { side: Side::B, vertex: 1 }));
    assert_eq!(run(&[1, 2, 0], &ring_b), Err(Error::LoopEdgeNotFree { side: Side::A, place: 1, vertex: 2 }));
    let count = view_b.positions().len() as u32;
    assert_eq!(run(&ring_a, &[1, 2, 99]), Err(Error::LoopIndexOutOfRange { number: 1, place: 2, vertex: 99, count }));
    let request = Request { a: &view_a, loop_a: Some(&ring_a), b: None, loop_b: Some(&ring_a) };
    let both = stitch(&request, &Options::default(), &Job::default());
    assert_eq!(both, Err(Error::LoopsShareVertex { vertex: 1 }));
}

#[test]
fn a_twist_turns_the_start() {
    let (a, b) = (cap(16, 2, 0.2, 1.0), cap(16, 2, 0.2, -1.0));
    let start = |twist| join(&a, &b, &Options { twist, ..Options::default() }).unwrap().rims;
    let plain = start(0);
    for twist in [1, -1, 5, 16 + 3, i64::MAX, i64::MIN] {
        let twisted = start(twist);
        assert_eq!(twisted[0], plain[0]);
        assert_eq!(twisted[1][0], plain[1][twist.rem_euclid(16) as usize]);
    }
}

#[test]
fn nothing_to_stitch() {
    let tetrahedron = Soup::flat(4, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]]);
    assert_eq!(join(&tetrahedron, &sheet(1, 1), &Options::default()), Err(Error::NoLoop { side: Side::A }));
    assert_eq!(join(&sheet(1, 1), &tetrahedron, &Options::default()), Err(Error::NoLoop { side: Side::B }));
}

#[test]
fn scalar_types() {
    let points_32: Vec<[f32; 3]> = cap(9, 2, 0.2, 1.0).points.iter().map(|p| p.map(|x| x as f32)).collect();
    let (a, b) = (cap(9, 2, 0.2, 1.0), cap(9, 2, 0.2, -1.0));
    let faces = Faces::polygons(&a.offsets, &a.corners).unwrap();
    let single = MeshView::new(Positions::from(points_32.as_slice()), faces, &Job::default()).unwrap();
    let double = b.view();
    let run =
        |a, b| stitch(&Request { a, loop_a: None, b: Some(b), loop_b: None }, &Options::default(), &Job::default());
    assert_eq!(run(&single, &double), Err(Error::MixedScalars));
    let joined = run(&double, &single).unwrap();
    assert_closed(&joined.mesh);
    assert_eq!(joined.mesh.positions.get(joined.maps[1].vertices[3]).x, f64::from(points_32[3][0]));
}

#[test]
fn any_unit_of_length() {
    let scaled =
        |soup: &Soup, s: f64| Soup { points: soup.points.iter().map(|p| p.map(|x| x * s)).collect(), ..soup.clone() };
    let (a, b) = (cap(10, 2, 0.2, 1.0), cap(8, 2, 0.2, -1.0));
    let plain = join(&a, &b, &Options::default()).unwrap();
    for exponent in [-900, -300, 300, 900] {
        let s = 2f64.powi(exponent);
        let other = join(&scaled(&a, s), &scaled(&b, s), &Options::default()).unwrap();
        assert_eq!(other.mesh.face_corners, plain.mesh.face_corners, "unit 2^{exponent}");
        assert_eq!(other.quality.max_edge, plain.quality.max_edge * s);
        assert_eq!(other.quality.min_angle, plain.quality.min_angle);
    }
}

/// `soup` swung about the line x = 1.5, z = 0 by an angle in degrees: from above to the right, to
/// below.
fn swung(soup: &Soup, degrees: f64) -> Soup {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let mut swung = soup.clone();
    for p in &mut swung.points {
        let [x, y, z] = [p[0] - 1.5, p[1], p[2]];
        *p = [1.5 + x * cos + z * sin, y, z * cos - x * sin];
    }
    swung
}

#[test]
fn orientation_is_judged_right_round_any_bend() {
    // Two cups, mouth to mouth at first, and at last side by side, both open upwards.
    let (a, b) = (cap(24, 4, 0.3, -1.0), cap(20, 4, 0.3, 1.0));
    for degrees in [0.0, 30.0, 60.0, 85.0, 95.0, 120.0, 150.0, 180.0] {
        let b = swung(&b, degrees);
        let joined = join(&a, &b, &Options::default()).unwrap();
        assert!(!joined.turned, "{degrees}");
        let fixed = join(&a, &b.turned(), &Options::default()).unwrap();
        assert!(fixed.turned, "{degrees}");
        assert_eq!(fixed.mesh.positions, joined.mesh.positions);
        let signed = |s: &Stitch| volume(|v| s.mesh.positions.get(v).to_array(), faces(&s.mesh));
        // Two cups and what lies between; a piece that is inside out would take its own volume
        // away. (Quads are not plane, and a turned one starts at another corner, so that the two
        // volumes are not quite the same.)
        let (one, other) = (signed(&joined), signed(&fixed));
        assert!(one > 2.0 && (one - other).abs() < 0.1, "{degrees}: {one} {other}");
    }
}

#[test]
fn nested_rims_are_judged_by_their_curves() {
    // The inner and the outer wall of a thick bowl: both lead upwards, and run opposite ways.
    let (outer, mut inner) = (cap(24, 4, 0.3, -1.0), cap(24, 4, 0.3, -1.0).turned());
    inner.points.iter_mut().for_each(|p| *p = p.map(|x| 0.8 * x));
    assert!(!join(&outer, &inner, &Options::default()).unwrap().turned);
    assert!(join(&outer, &inner.turned(), &Options::default()).unwrap().turned);
}

#[test]
fn only_the_component_on_the_rim_is_turned() {
    let (a, b) = (cap(12, 3, 0.2, 1.0), cap(9, 3, 0.2, -1.0).turned());
    let bystander = cap(5, 2, 0.2, 1.0);
    let mut far = bystander.clone();
    far.points.iter_mut().for_each(|p| p[0] += 10.0);
    let joined = join(&a, &b.and(&far), &Options::default()).unwrap();
    assert!(joined.turned);
    let first = a.faces().count() + b.faces().count();
    let offset = (a.points.len() + b.points.len()) as u32;
    for (now, then) in faces(&joined.mesh).skip(first).zip(bystander.faces()) {
        assert!(now.iter().map(|v| v - offset).eq(then.iter().copied()));
    }
}

struct CancelAfter(std::cell::Cell<u32>);

impl Progress for CancelAfter {
    fn step(&self, fraction: f64, stage: &'static str) -> ControlFlow<()> {
        assert!((0.0..=1.0).contains(&fraction) && !stage.is_empty());
        let left = self.0.get();
        self.0.set(left.saturating_sub(1));
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[test]
fn cancel_at_every_step() {
    let (a, b) = (cap(30, 4, 0.2, 1.0), cap(30, 4, 0.2, -1.0));
    let (view_a, view_b) = (a.view(), b.view());
    let request = Request { a: &view_a, loop_a: None, b: Some(&view_b), loop_b: None };
    let run = |steps: u32| stitch(&request, &Options::default(), &Job::new(1, &CancelAfter(steps.into())));
    let cancelled = (0..1000).take_while(|&steps| run(steps).is_err()).count();
    assert!((5..100).contains(&cancelled), "{cancelled} steps");
    assert!((0..cancelled as u32).all(|steps| run(steps) == Err(Error::Cancelled)));
}

proptest! {
    /// Rims of any shape: jagged, concave, far apart, on each other. Always closed, always the
    /// counts of Euler's formula.
    #[test]
    fn any_two_cones(
        rim_a in prop::collection::vec(any::<(i8, i8, i8)>(), 3..20),
        rim_b in prop::collection::vec(any::<(i8, i8, i8)>(), 3..20),
        index in any::<bool>(),
        twist in -30i64..30,
    ) {
        let cone = |rim: &[(i8, i8, i8)], z: f64| {
            let mut soup = Soup::flat(1, &[]);
            soup.points[0] = [0.0, 0.0, z];
            soup.points.extend(rim.iter().map(|&(x, y, z)| [f64::from(x), f64::from(y), f64::from(z)]));
            let n = rim.len() as u32;
            for i in 0..n {
                soup.face(&[0, 1 + i, 1 + (i + 1) % n]);
            }
            soup
        };
        let (a, b) = (cone(&rim_a, 500.0), cone(&rim_b, -500.0));
        let meridians = if index { Meridians::Index } else { Meridians::MinArea };
        let joined = join(&a, &b, &Options { meridians, twist, ..Options::default() }).unwrap();
        assert_closed(&joined.mesh);
        prop_assert_eq!(euler(faces(&joined.mesh)), 2);
        prop_assert_eq!(joined.strip_faces.len(), rim_a.len() + rim_b.len());
    }

    /// For any pieces, a stitch adds no edge with three faces and no orientation conflict, and
    /// loses no element.
    #[test]
    fn any_soups(
        a in prop::collection::vec(prop::collection::vec(0u32..9, 3..5), 1..12),
        b in prop::collection::vec(prop::collection::vec(0u32..9, 3..5), 1..12),
        within in any::<bool>(),
        meridians in prop::sample::select(vec![Meridians::MinArea, Meridians::Index]),
        extent in prop::sample::select(vec![Extent::WholeLoops, Extent::OpenArcs, Extent::Auto]),
        rows in prop::sample::select(vec![Rows::None, Rows::Count(1), Rows::MeanEdge]),
        cells in prop::sample::select(vec![Cells::Triangles, Cells::Quads]),
        twist in -3i64..4,
    ) {
        // The library ignores borders of faces with fewer than three proper edges; they are omitted
        // here.
        let proper = |f: &&[u32]| (0..f.len()).filter(|&i| f[i] != f[(i + 1) % f.len()]).count() >= 3;
        let soup = |faces: &[Vec<u32>], lift: f64| {
            let list: Vec<&[u32]> = faces.iter().map(Vec::as_slice).chain([&[0, 1, 2][..]]).filter(proper).collect();
            let mut soup = Soup::flat(9, &list);
            soup.points.iter_mut().enumerate().for_each(|(i, p)| *p = [p[0], (i * i % 5) as f64, lift + (i % 3) as f64]);
            soup
        };
        let (a, b) = (soup(&a, 0.0), soup(&b, 7.5));
        let both = a.and(&b);
        let options = Options { meridians, extent, rows, cells, twist, ..Options::default() };
        let made = if within {
            let view = both.view();
            stitch(&Request { a: &view, loop_a: None, b: None, loop_b: None }, &options, &Job::default())
        } else {
            join(&a, &b, &options)
        };
        if let Ok(made) = made {
            let oddities = |counts: &std::collections::HashMap<(u32, u32), (u32, u32)>| {
                let three = counts.iter().filter(|&(&(u, v), &(f, b))| u != v && f + b > 2).count();
                let conflicts = counts.iter().filter(|&(&(u, v), &(f, b))| u != v && f + b == 2 && f != b).count();
                (three, conflicts)
            };
            let (old, new) = (edge_counts(both.faces()), edge_counts(faces(&made.mesh)));
            prop_assert_eq!(oddities(&old), oddities(&new));
            prop_assert_eq!(made.mesh.face_count(), both.faces().count() + made.strip_faces.len());
        }
    }
}
