//! Many meshes side by side in one.

use crate::common::{sheet, torus};
use gusset::mesh::{Faces, MeshView, Positions, concatenate};
use gusset::{Error, Job};

#[test]
fn pieces_side_by_side() {
    let (a, b) = (torus(4, 3), sheet(2, 1));
    let (whole, places) = concatenate(&[a.view(), b.view(), a.view()], &Job::default()).unwrap();
    assert_eq!(whole.positions.len(), 12 + 6 + 12);
    assert_eq!(places.iter().map(|p| (p.first_vertex, p.first_face)).collect::<Vec<_>>(), [(0, 0), (12, 12), (18, 14)]);
    let both = a.and(&b).and(&a);
    assert_eq!((&whole.face_corners, &whole.face_offsets), (&both.corners, &both.offsets));
    assert!((0..30).all(|v| whole.positions.get(v).to_array() == both.points[v as usize]));

    let single = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.1, 1.0, 0.0]];
    let triangle = Faces::triangles(&[[0, 1, 2]]).unwrap();
    let single = MeshView::new(Positions::from(&single[..]), triangle, &Job::default()).unwrap();
    assert_eq!(concatenate(&[single, b.view()], &Job::default()).unwrap_err(), Error::MixedScalars);
    let (mixed, _) = concatenate(&[b.view(), single], &Job::default()).unwrap();
    assert_eq!(mixed.positions.get(8).x, f64::from(0.1f32));
    assert_eq!(concatenate(&[], &Job::default()).unwrap_err(), Error::EmptyMesh { what: "pieces" });
}
