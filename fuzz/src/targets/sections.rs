//! Sections of any mesh by planes of each kind: an error, or polylines whose points are on their edges
//! and whose segments are in their faces, closed if the mesh is.

use crate::agree::agreed;
use crate::input::{self, Cloud, Soup};
use glam::DVec3;
use gusset::mesh::section::{
    InPlane, Options, PlaneStack, Sections, cut_by_planes, cut_by_stack, planes_about_axis, planes_across_polyline,
};
use gusset::mesh::{MeshView, NONE};
use gusset::{Job, Result};
use std::collections::HashMap;

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((soup, cloud, [kind, choice, coarseness])) = input::taken::<(Soup, Cloud, [u8; 3])>(bytes) else { return };
    let points = input::places(&cloud);
    let options = Options {
        in_plane: if kind < 128 { InPlane::Above } else { InPlane::Below },
        tolerance: if coarseness < 200 { 0.0 } else { f64::from(coarseness - 200) },
    };
    soup.visit(|mesh| {
        let Ok(sections) = agreed(choice, |job| cut(mesh, kind, &points, &options, job)) else { return };
        check_sources(mesh, &sections);
        if is_closed(mesh) {
            assert!(sections.paths().iter().all(|path| path.is_closed));
        }
        if options.tolerance > 0.0 {
            let all = cut(mesh, kind, &points, &Options { tolerance: 0.0, ..options }, &Job::default());
            assert_eq!(all.map(|all| all.paths().to_vec()), Ok(sections.paths().to_vec()));
        }
    });
}

/// Cuts by planes that follow from some points: a stack, planes about an axis, or planes across the
/// polyline of the points.
fn cut(mesh: &MeshView<'_>, kind: u8, points: &[DVec3], options: &Options, job: &Job<'_>) -> Result<Sections> {
    let place = |k: usize| points.get(k).copied().unwrap_or(DVec3::ONE);
    let values: Vec<f64> = points.iter().skip(3).map(|point| point.x).collect();
    let planes = match kind % 3 {
        0 => {
            let mut offsets = values;
            offsets.sort_unstable_by(f64::total_cmp);
            offsets.dedup();
            let stack = PlaneStack { point: place(0), normal: place(1), offsets: &offsets };
            return cut_by_stack(mesh, &stack, options, job);
        }
        1 => planes_about_axis(place(0), place(1), place(2), &values)?,
        _ => {
            let distances: Vec<f64> = (0..4).map(|k| place(k).y.abs()).collect();
            planes_across_polyline(points, kind & 64 != 0, &distances)?
        }
    };
    cut_by_planes(mesh, &planes, options, job)
}

fn check_sources(mesh: &MeshView<'_>, sections: &Sections) {
    let paths = sections.paths();
    assert_eq!(sections.starts().len(), paths.len() + 1);
    assert!(paths.windows(2).all(|pair| pair[0].plane <= pair[1].plane));
    for (k, path) in paths.iter().enumerate() {
        let range = sections.range(k);
        assert!(range.len() > 1 && path.length >= 0.0 && path.area.is_finite());
        assert!(path.parent == NONE || paths[path.parent as usize].plane == path.plane);
        assert_eq!(path.parent == NONE, path.depth == 0);
        for i in range.clone() {
            let [a, b] = sections.edges()[i].map(|v| mesh.positions().get(v));
            let t = sections.parameters()[i];
            let size = a.abs().max_element().max(b.abs().max_element());
            assert!((0.0..=1.0).contains(&t));
            assert!(sections.points()[i].distance(a.lerp(b, t)) <= 1e-12 * size, "{a} {b} {t}");
            let face = sections.faces()[i];
            assert_eq!(face == NONE, !path.is_closed && i + 1 == range.end);
            if face != NONE {
                let corners = mesh.faces().corner_range(face as usize).map(|h| mesh.faces().corner(h as u32));
                let corners: Vec<u32> = corners.collect();
                assert!(sections.edges()[i].iter().all(|v| corners.contains(v)));
            }
        }
    }
}

/// True if each edge has one face on each side, and each face at least three sides.
fn is_closed(mesh: &MeshView<'_>) -> bool {
    let mut balance: HashMap<[u32; 2], [u32; 2]> = HashMap::new();
    for face in 0..mesh.faces().len() {
        let corners: Vec<u32> = mesh.faces().corner_range(face).map(|h| mesh.faces().corner(h as u32)).collect();
        for (k, &u) in corners.iter().enumerate() {
            let v = corners[(k + 1) % corners.len()];
            if u == v {
                return false;
            }
            balance.entry([u.min(v), u.max(v)]).or_default()[usize::from(u > v)] += 1;
        }
    }
    balance.values().all(|uses| *uses == [1, 1])
}
