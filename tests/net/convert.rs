//! Nets to meshes and back, heights and range images.

use crate::common::{self, edge_counts, euler, faces_of};
use crate::nets::{Surface, any_topology, job, same, shape, sphere, torus};
use crate::space::{is_hidden, is_present};
use glam::DVec3;
use gusset::Error;
use gusset::boundary::boundary_loops;
use gusset::check::check;
use gusset::mesh::{NONE, PositionBuffer, Scalar};
use gusset::net::convert::{Diagonal, Heights, MeshOptions, net_of_grid, net_of_heights};
use gusset::net::primitive::{Primitive, Request};
use gusset::net::topology::{ContractedLinks, SeamRun};
use gusset::net::{BridgeMode, Direction, JoinOptions, Net, NodeClasses, Seam, Sides, Topology, concatenate};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn any_options() -> impl Strategy<Value = MeshOptions> {
    let triangles = prop_oneof![Just(None), Just(Some(Diagonal::Shorter)), Just(Some(Diagonal::Fixed))];
    (triangles, any::<[bool; 4]>()).prop_map(|(triangles, [weld, keep_unused, fill_corners, texture])| MeshOptions {
        triangles,
        weld,
        keep_unused,
        fill_corners,
        texture,
        max_edge_ratio: None,
    })
}

proptest! {
    #[test]
    fn meshes_are_what_is_left_of_the_cells(
        topology in any_topology(2..7, 2..7),
        hidden in any::<[u8; 2]>(),
        options in any_options(),
    ) {
        let classes = NodeClasses::new(&topology).unwrap();
        let size = topology.shape();
        let mut net = Net::from_fn(topology, Scalar::F64, |i, j| {
            let n = f64::from(classes.representative(size.node(i, j)));
            DVec3::new(n, (n * 1.7).sin(), if n as u32 % 13 == 7 { f64::NAN } else { n * n })
        })
        .unwrap();
        if hidden[0] % 2 == 0 && size.rows() > 2 {
            let at = 1 + u32::from(hidden[1]) % (size.rows() as u32 - 1);
            let kind = gusset::net::BridgeKind::Ribbon;
            let bridge = gusset::net::Bridge::new(Direction::Down, at, size.columns() as u32, kind, BridgeMode::Hide);
            net.bridges_mut().push(bridge);
        }
        let made = net.to_mesh(&options, &job()).unwrap();
        let mesh = &made.mesh;
        prop_assert_eq!(mesh.face_count(), made.cell_of_face.len());
        prop_assert_eq!(mesh.positions.len(), made.node_of_vertex.len());
        prop_assert_eq!(made.vertex_of_node.len(), size.node_count());
        for (node, &vertex) in (0u32..).zip(&made.vertex_of_node) {
            if vertex != NONE {
                let class = if options.weld { classes.representative(node) } else { node };
                prop_assert_eq!(made.node_of_vertex[vertex as usize], class);
                let (i, j) = size.row_and_column(class);
                prop_assert_eq!(mesh.positions.get(vertex), net.get(i, j));
            }
        }
        for (face, &cell) in mesh.faces().zip(&made.cell_of_face) {
            let (i, j) = size.row_and_column_of_cell(cell);
            prop_assert!(is_present(&net, i, j) || options.fill_corners && !is_hidden(&net, i, j));
            let corners = size.corners_of_cell(i, j).map(|node| made.vertex_of_node[node as usize]);
            prop_assert!(face.iter().all(|vertex| corners.contains(vertex)));
            prop_assert!(face.iter().all(|&vertex| mesh.positions.get(vertex).is_finite()));
            prop_assert_eq!(face.iter().collect::<BTreeSet<_>>().len(), face.len());
            prop_assert!(options.triangles.is_none() || face.len() == 3);
        }
        // The same faces and wires as by force.
        if options.weld && options.triangles.is_none() && !options.fill_corners {
            let finite = |class: u32| {
                let (i, j) = size.row_and_column(class);
                net.get(i, j).is_finite()
            };
            let surface = Surface::from_net(&net);
            let expected: Vec<_> = surface.polygons.iter().filter(|p| p.iter().all(|&c| finite(c))).collect();
            prop_assert_eq!(expected.len(), mesh.face_count());
            for (face, polygon) in mesh.faces().zip(expected) {
                let mut turned: Vec<u32> = face.iter().map(|&v| made.node_of_vertex[v as usize]).collect();
                if net.topology().is_reversed() {
                    turned.reverse();
                }
                let at = turned.iter().position(|c| c == &polygon[0]).unwrap();
                turned.rotate_left(at);
                prop_assert_eq!(&turned, polygon);
            }
        }
        if let Some(texture) = &made.texture {
            prop_assert_eq!(texture.corners.len(), mesh.face_corners.len());
            for (&corner, &vertex) in texture.corners.iter().zip(&mesh.face_corners) {
                let [u, v] = texture.coordinates[corner as usize];
                let (j, i) = (u * (size.columns() - 1) as f64, v * (size.rows() - 1) as f64);
                prop_assert!((i - i.round()).abs() < 1e-9 && (j - j.round()).abs() < 1e-9);
                let node = size.node(i.round() as usize, j.round() as usize);
                prop_assert_eq!(made.vertex_of_node[node as usize], vertex);
            }
        }
    }

    #[test]
    fn grids_are_found_again(
        size in (2..6usize, 2..6usize),
        closed in any::<[bool; 4]>(),
        shift in 0..4usize,
        turn in 0..4i32,
        shuffle in any::<u64>(),
    ) {
        // Closed directions need three cells.
        let (h, w) = (size.0 + 3, size.1 + 3);
        let [rows_closed, columns_closed, pole_top, pole_bottom] = closed;
        let poles = rows_closed && !columns_closed;
        let sides = Sides {
            rows_closed,
            columns_closed,
            pole_top: poles && pole_top,
            pole_bottom: poles && pole_bottom,
            ..Sides::SHEET
        };
        let shift = if rows_closed && columns_closed { shift % (w - 1) } else { 0 };
        let topology = if shift == 0 {
            Topology::from_sides(shape(h, w), sides)
        } else {
            let (last, end, by) = (h as u32 - 1, w as u32 - 1, shift as u32);
            let row = |i, j| SeamRun::along_row(i, j, 1);
            let seams = [
                Seam { a: row(last, 0), b: row(0, by), count: end + 1 - by },
                Seam { a: row(last, end - by), b: row(0, 0), count: by + 1 },
            ];
            let links = ContractedLinks::Sides(Sides { columns_closed: false, ..sides });
            Topology::new(shape(h, w), links, &seams).unwrap()
        };
        let classes = NodeClasses::new(&topology).unwrap();
        let net = Net::from_fn(topology, Scalar::F32, |i, j| {
            let n = f64::from(classes.representative(shape(h, w).node(i, j)));
            DVec3::new(n, (n * 1.7).sin(), (n * 0.3).cos())
        })
        .unwrap();
        let net = net.turned_by_quarters(turn, &job()).unwrap();
        let mut mesh = net.to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
        // Faces in another order, each begun elsewhere.
        let mut faces: Vec<Vec<u32>> = mesh.faces().map(<[u32]>::to_vec).collect();
        let mut state = shuffle | 1;
        for k in (1..faces.len()).rev() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            faces.swap(k, (state >> 33) as usize % (k + 1));
            let size = faces[k].len();
            faces[k].rotate_left((state >> 50) as usize % size);
        }
        mesh.face_offsets = std::iter::once(0).chain(faces.iter().scan(0, |sum, face| {
            *sum += face.len() as u32;
            Some(*sum)
        })).collect();
        mesh.face_corners = faces.concat();
        let found = net_of_grid(&mesh.view(&job()).unwrap(), None, &job()).unwrap();
        let [a, b] = [net.shape(), found.net.shape()];
        // A torus that is shifted round has rows of other lengths in the other direction.
        prop_assert!(a == b || a == b.transposed() || shift > 0);
        let again = found.net.to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
        // The same mesh: faces as cycles of positions.
        let cycles = |mesh: &gusset::mesh::Mesh| {
            let mut cycles: Vec<Vec<[u64; 3]>> = mesh.faces().map(|face| {
                let mut cycle: Vec<_> = face.iter().map(|&v| mesh.positions.get(v).to_array().map(f64::to_bits)).collect();
                let least = (0..cycle.len()).min_by_key(|&k| cycle[k]).unwrap();
                cycle.rotate_left(least);
                cycle
            }).collect();
            cycles.sort_unstable();
            cycles
        };
        prop_assert_eq!(cycles(&mesh), cycles(&again));
        prop_assert_eq!(mesh.positions.len(), again.positions.len());
        for (node, &vertex) in (0..).zip(&found.vertex_of_node) {
            let (i, j) = found.net.shape().row_and_column(node);
            prop_assert_eq!(found.net.get(i, j), mesh.positions.get(vertex));
        }
    }
}

#[test]
fn closed_nets_become_closed_manifolds() {
    let one_pole = Net::from_fn(Topology::from_sides(shape(9, 9), Sides::ONE_POLE), Scalar::F32, |i, j| {
        let edge = i == 0 || j == 0 || i == 8 || j == 8;
        let (x, y) = (i as f64 - 4.0, j as f64 - 4.0);
        let ring = x.abs().max(y.abs()) / 4.0;
        if edge { DVec3::Z } else { DVec3::new(y * (1.0 - ring), x * (1.0 - ring), -(1.0 - 2.0 * ring)) }
    });
    let nets = [
        (sphere(9, 17, Scalar::F32, DVec3::ZERO), 2),
        (torus(9, 17, Scalar::F32, DVec3::ZERO), 0),
        (one_pole.unwrap(), 2),
        (sphere(4, 4, Scalar::F64, DVec3::ZERO), 2),
        (torus(4, 4, Scalar::F64, DVec3::ZERO), 0),
    ];
    for (net, chi) in &nets {
        for reformat in [false, true] {
            let (h, w) = (net.shape().rows(), net.shape().columns());
            let large = if reformat {
                net.enlarged_to(h + 5, w + 3, Default::default(), &job()).unwrap()
            } else {
                net.copied().unwrap()
            };
            for triangles in [None, Some(Diagonal::Fixed), Some(Diagonal::Shorter)] {
                let options = MeshOptions { triangles, ..MeshOptions::default() };
                let made = large.to_mesh(&options, &job()).unwrap();
                let found = check(&made.mesh.view(&job()).unwrap(), &job()).unwrap();
                assert!(found.closed && found.manifold && found.oriented, "{found:?}");
                assert_eq!(found.euler, *chi);
                assert!(found.unused_vertices.is_empty() && found.degenerate_faces.is_empty());
                assert_eq!(euler(faces_of(&made.mesh)), *chi);
                assert!(made.wires.is_empty());
            }
        }
    }
    // The peers' 128 edges that stay open: here the unwelded mesh has rims, and the welded one
    // none.
    let loose = nets[0].0.to_mesh(&MeshOptions { weld: false, ..MeshOptions::default() }, &job()).unwrap();
    let open = edge_counts(faces_of(&loose.mesh)).values().filter(|(a, b)| a + b == 1).count();
    assert_eq!(open, 2 * 8 + 2 * 16);
}

#[test]
fn threads_and_flips() {
    let [a, b] = [0.0, 3.0].map(|z| sphere(9, 17, Scalar::F64, DVec3::new(0.0, 0.0, z)));
    let net = concatenate(&a, &b, &JoinOptions::new(Direction::Down), &job()).unwrap();
    let made = net.to_mesh(&MeshOptions::default(), &job()).unwrap();
    assert_eq!(made.wires.len(), 1);
    let ends = made.wires[0].map(|vertex| made.mesh.positions.get(vertex));
    assert_eq!(ends, [DVec3::new(0.0, 0.0, 1.0), DVec3::new(0.0, 0.0, 2.0)]);
    assert_eq!(check(&made.mesh.view(&job()).unwrap(), &job()).unwrap().euler, 4);
    // Flipped nets show the same side.
    let volume = |net: &Net<'_>| {
        let mesh = net.to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
        common::volume(|v| mesh.positions.get(v).to_array(), faces_of(&mesh))
    };
    let flipped = net
        .flipped(Direction::Down, &job())
        .unwrap()
        .transposed(&job())
        .unwrap()
        .flipped(Direction::Right, &job())
        .unwrap();
    assert!(volume(&net) > 7.0 && (volume(&net) - volume(&flipped)).abs() < 1e-12);
    let ribbon = concatenate(&a, &b, &JoinOptions::new(Direction::Right), &job()).unwrap();
    let made = ribbon.to_mesh(&MeshOptions::default(), &job()).unwrap();
    let found = check(&made.mesh.view(&job()).unwrap(), &job()).unwrap();
    assert_eq!((found.euler, found.non_manifold_edges.len()), (3, 16));
}

#[test]
fn what_is_no_grid() {
    let mut mesh = sphere(5, 9, Scalar::F64, DVec3::ZERO).to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
    let found = net_of_grid(&mesh.view(&job()).unwrap(), None, &job()).unwrap();
    assert_eq!(found.net.topology().sides(), Some(Sides::TWO_POLES));
    assert_eq!(found.net.shape(), shape(5, 9));
    assert_eq!(found.face_of_cell, (0..32).collect::<Vec<_>>());
    // A face away: rows differ in length, or the grid has a hole.
    let last = *mesh.face_offsets.iter().nth_back(12).unwrap();
    let size = mesh.face_offsets[mesh.face_offsets.len() - 12] - last;
    mesh.face_corners.drain(last as usize..(last + size) as usize);
    let at = mesh.face_offsets.len() - 12;
    mesh.face_offsets.remove(at);
    mesh.face_offsets[at..].iter_mut().for_each(|offset| *offset -= size);
    assert!(matches!(net_of_grid(&mesh.view(&job()).unwrap(), None, &job()), Err(Error::NoGrid { .. })));
    // Triangles only.
    let triangles = MeshOptions { triangles: Some(Diagonal::Fixed), ..MeshOptions::default() };
    let mesh = torus(5, 9, Scalar::F64, DVec3::ZERO).to_mesh(&triangles, &job()).unwrap().mesh;
    assert!(matches!(net_of_grid(&mesh.view(&job()).unwrap(), None, &job()), Err(Error::NoGrid { face: 0 })));
    // Two components: either is a grid, both together are none.
    let [a, b] = [0.0, 9.0].map(|x| sphere(4, 7, Scalar::F64, DVec3::new(x, 0.0, 0.0)));
    let options = JoinOptions { mode: BridgeMode::Hide, ..JoinOptions::new(Direction::Down) };
    let two = concatenate(&a, &b, &options, &job()).unwrap().to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
    let view = two.view(&job()).unwrap();
    assert_eq!(net_of_grid(&view, None, &job()).unwrap_err(), Error::NoGrid { face: 18 });
    for (seed, x) in [(3, 0.0), (20, 9.0), (35, 9.0)] {
        let found = net_of_grid(&view, Some(seed), &job()).unwrap();
        assert_eq!((found.net.shape(), found.net.get(0, 0).x), (shape(4, 7), x));
    }
    assert_eq!(net_of_grid(&view, Some(36), &job()).unwrap_err(), Error::NoGrid { face: 36 });
}

#[test]
fn quads_of_an_unknown_shape_do_not_hang() {
    // A cube: rows go round, and caps are in the way.
    let faces: [&[u32]; 6] = [&[0, 1, 2, 3], &[7, 6, 5, 4], &[0, 4, 5, 1], &[1, 5, 6, 2], &[2, 6, 7, 3], &[3, 7, 4, 0]];
    let soup = common::Soup::flat(8, &faces);
    assert!(matches!(net_of_grid(&soup.view(), None, &job()), Err(Error::NoGrid { .. })));
    // One quad alone is a net.
    let one = common::Soup::flat(4, &[&[0, 1, 2, 3]]);
    assert_eq!(net_of_grid(&one.view(), None, &job()).unwrap().net.shape(), shape(2, 2));
}

#[test]
fn heights_face_up() {
    let values: Vec<f32> = (0..12).map(|n| if n == 5 { -9999.0 } else { n as f32 }).collect();
    for spacing in [[2.0, 3.0], [2.0, -3.0], [-2.0, 3.0], [-2.0, -3.0]] {
        let heights = Heights {
            shape: shape(3, 4),
            values: &values,
            stride: 0,
            spacing,
            origin: DVec3::ONE,
            no_data: Some(-9999.0),
        };
        let net = net_of_heights(&heights, &job()).unwrap();
        assert_eq!(net.get(2, 3), DVec3::new(1.0 + 3.0 * spacing[0], 1.0 + 2.0 * spacing[1], 12.0));
        assert!(net.get(1, 1).z.is_nan());
        for fill_corners in [false, true] {
            let made = net.to_mesh(&MeshOptions { fill_corners, ..MeshOptions::default() }, &job()).unwrap();
            assert_eq!(made.mesh.face_count(), if fill_corners { 6 } else { 2 });
            for face in made.mesh.faces() {
                let [a, b, c] = [0, 1, 2].map(|k| made.mesh.positions.get(face[k]));
                assert!((b - a).cross(c - a).z > 0.0);
            }
        }
    }
    let heights = Heights {
        shape: shape(3, 4),
        values: &values,
        stride: 5,
        spacing: [1.0; 2],
        origin: DVec3::ONE,
        no_data: None,
    };
    assert!(matches!(
        net_of_heights(&heights, &job()),
        Err(Error::ArrayTooShort { what: "heights", needed: 56, given: 48 })
    ));
    let flat = Heights { stride: 0, spacing: [0.0, 1.0], ..heights };
    assert!(matches!(net_of_heights(&flat, &job()), Err(Error::OptionOutOfRange { option: "spacing", .. })));
}

/// A plane seen in front of another, whose gap is wider than any edge of either; glued or not, from
/// either side, in quads and triangles.
#[test]
fn steps_of_range_images_are_left_out() {
    let place = |i: usize, j: usize| {
        let front = (3..8).contains(&i) && (4..9).contains(&j);
        DVec3::new(j as f64, i as f64, if front { 9.0 } else { 0.1 * i as f64 })
    };
    for reversed in [false, true] {
        let mut topology = Topology::from_sides(shape(12, 14), Sides::SHEET);
        topology = topology.with_reversed(reversed);
        let net = Net::from_fn(topology, Scalar::F32, place).unwrap();
        for triangles in [None, Some(Diagonal::Shorter), Some(Diagonal::Fixed)] {
            let options = MeshOptions { triangles, ..MeshOptions::default() };
            let whole = net.to_mesh(&options, &job()).unwrap();
            let made = net.to_mesh(&MeshOptions { max_edge_ratio: Some(4.0), ..options }, &job()).unwrap();
            let [all, left] = [&whole, &made].map(|made| {
                let at = |v: &u32| made.mesh.positions.get(*v);
                let faces = made.mesh.faces().zip(&made.cell_of_face);
                let faces: Vec<(Vec<DVec3>, u32)> =
                    faces.map(|(f, &cell)| (f.iter().map(at).collect(), cell)).collect();
                faces
            });
            let is_flat = |(face, _): &(Vec<DVec3>, u32)| face.iter().all(|p| (p.z < 5.0) == (face[0].z < 5.0));
            // The same faces in the same order, and all nodes are in some.
            assert!(left.len() < all.len());
            assert!(all.into_iter().filter(is_flat).eq(left));
            assert_eq!(made.mesh.positions.len(), net.shape().node_count());
        }
        // Cells that are far longer than wide are not steps; cells without length are not steps
        // either.
        for stretch in [DVec3::new(1.0, 4.5, 1.0), DVec3::new(4.5, 1.0, 1.0), DVec3::ZERO] {
            let topology = Topology::from_sides(shape(12, 14), Sides::SHEET);
            let flat = |i: usize, j: usize| stretch * DVec3::new(j as f64, i as f64, 0.0);
            let net = Net::from_fn(topology, Scalar::F64, flat).unwrap();
            for ratio in [4.0, f64::INFINITY] {
                let options = MeshOptions { max_edge_ratio: Some(ratio), ..MeshOptions::default() };
                assert_eq!(net.to_mesh(&options, &job()).unwrap().mesh.face_count(), 11 * 13);
            }
        }
        let none = net.to_mesh(&MeshOptions { max_edge_ratio: Some(1e-9), ..MeshOptions::default() }, &job()).unwrap();
        assert_eq!((none.mesh.face_count(), none.mesh.positions.len()), (0, 0));
        for bad in [0.0, -1.0, f64::NAN] {
            let options = MeshOptions { max_edge_ratio: Some(bad), ..MeshOptions::default() };
            let refused = net.to_mesh(&options, &job());
            assert!(matches!(refused, Err(Error::OptionOutOfRange { option: "max_edge_ratio", .. })));
        }
    }
}

#[test]
fn a_digital_elevation_model() {
    let Some((size, numbers)) = crate::grids::npz("jacksboro_fault_dem.npz", "elevation") else { return };
    let heights = Heights {
        shape: shape(size[0], size[1]),
        values: &numbers,
        stride: 0,
        spacing: [1.0, -1.0],
        origin: DVec3::ZERO,
        no_data: None,
    };
    let net = net_of_heights(&heights, &job()).unwrap();
    let mesh = net.to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
    let view = mesh.view(&job()).unwrap();
    let loops = boundary_loops(&view, &Default::default(), &job()).unwrap();
    assert_eq!((loops.len(), loops.edge_count()), (1, 1490));
    let back = net_of_grid(&view, None, &job()).unwrap();
    // Rows run against y here: its faces are turned, and the other direction comes first.
    assert!(same(&back.net.transposed(&job()).unwrap(), &net));
}

#[test]
fn a_range_image() {
    let Some((size, numbers)) = crate::grids::npz("bun000_range_214x313.npz", "xyz") else { return };
    let numbers: Vec<f32> = numbers.iter().map(|&x| x as f32).collect();
    let points: &[[f32; 3]] = numbers.as_chunks().0;
    let sheet = Topology::from_sides(shape(size[0], size[1]), Sides::SHEET);
    let net = Net::from_fn(sheet, Scalar::F32, |i, j| DVec3::from(points[i * size[1] + j].map(f64::from))).unwrap();
    let options = MeshOptions { keep_unused: true, ..MeshOptions::default() };
    let all = net.to_mesh(&options, &job()).unwrap();
    assert_eq!(all.mesh.positions.len(), 40_256);
    let PositionBuffer::F32(positions) = &all.mesh.positions else { panic!("the type stays") };
    assert!(positions.as_flattened().iter().all(|x| x.is_finite()));
    for fill_corners in [false, true] {
        let made = net.to_mesh(&MeshOptions { fill_corners, ..MeshOptions::default() }, &job()).unwrap();
        let found = check(&made.mesh.view(&job()).unwrap(), &job()).unwrap();
        println!("{} faces, {} of 40256 points, {} loops", found.faces, found.vertices, found.boundary_walks);
        assert!(made.mesh.face_corners.iter().all(|&v| made.mesh.positions.get(v).is_finite()));
        assert!(found.oriented && found.non_manifold_edges.is_empty());
    }
}

#[test]
fn a_volcano() {
    let Some(rows) = crate::grids::csv("volcano_maunga_whau_61x87.csv") else { return };
    let size = shape(rows.len(), rows[0].len());
    let heights = Heights {
        shape: size,
        values: &rows.concat(),
        stride: 0,
        spacing: [10.0; 2],
        origin: DVec3::ZERO,
        no_data: None,
    };
    let mesh = net_of_heights(&heights, &job()).unwrap().to_mesh(&MeshOptions::default(), &job()).unwrap().mesh;
    assert_eq!((mesh.positions.len(), mesh.face_count()), (61 * 87, 60 * 86));
}

/// Where many nodes are one point, two cells may share three corners, and so a diagonal: then one
/// takes the other.
#[test]
fn triangles_of_glued_nets_are_manifold() {
    for (primitive, chi) in [
        (Primitive::Pillow { size: [2.0, 1.0], thickness: 0.5 }, 2),
        (Primitive::ProjectivePlane { radius: 1.0 }, 1),
        (Primitive::OnePoleSphere { radius: 1.0 }, 2),
        (Primitive::Klein { radius: 2.0, minor_radius: 0.5 }, 0),
        (Primitive::Torus { radius: 2.0, minor_radius: 0.5 }, 0),
    ] {
        for (rows, columns) in [(4, 5), (5, 5), (6, 7), (9, 13)] {
            let request = Request { rows, columns, ..Request::new(primitive) };
            let net = request.build_net(&job()).unwrap();
            for diagonal in [Diagonal::Shorter, Diagonal::Fixed] {
                let options = MeshOptions { triangles: Some(diagonal), ..MeshOptions::default() };
                let mesh = net.to_mesh(&options, &job()).unwrap().mesh;
                let mut edges: BTreeMap<[u32; 2], usize> = BTreeMap::new();
                for face in mesh.faces() {
                    for k in 0..3 {
                        let [a, b] = [face[k], face[(k + 1) % 3]];
                        *edges.entry([a.min(b), a.max(b)]).or_default() += 1;
                    }
                }
                let what = format!("{primitive:?} {rows} x {columns} {diagonal:?}");
                assert!(edges.values().all(|&faces| faces == 2), "{what}");
                let euler = mesh.positions.len() as i64 - edges.len() as i64 + mesh.face_count() as i64;
                assert_eq!(euler, chi, "{what}");
            }
        }
    }
}
