//! Joins two open meshes by a strip of new faces.

use gusset::mesh::{Faces, MeshView, PositionBuffer, Positions};
use gusset::stitch::{Options, Request, stitch};
use gusset::{Job, Result};

fn main() -> Result<()> {
    // Two open pyramids, point up and point down, with a gap between their square rims.
    let up = [[0.0_f32, 0.0, 2.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0], [-1.0, 0.0, 1.0], [0.0, -1.0, 1.0]];
    let down = up.map(|[x, y, z]| [x, -y, -z]);
    let triangles = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];

    // ! [view]
    let job = Job::default();
    let a = MeshView::new(Positions::from(&up[..]), Faces::triangles(&triangles)?, &job)?;
    let b = MeshView::new(Positions::from(&down[..]), Faces::triangles(&triangles)?, &job)?;
    // ! [view]

    // ! [stitch]
    // `None` for both loops takes the two that are nearest to each other.
    let request = Request { a: &a, loop_a: None, b: Some(&b), loop_b: None };
    let stitched = stitch(&request, &Options::default(), &job)?;

    let mesh = &stitched.mesh;
    println!("{} vertices, {} faces", mesh.positions.len(), mesh.face_count());
    println!("{} new faces, {} loops left", stitched.strip_faces.len(), stitched.quality.loops_left);
    // ! [stitch]

    // ! [result]
    // The result has the scalar type of the first piece.
    let PositionBuffer::F32(points) = &mesh.positions else { unreachable!("the first piece is in single precision") };
    assert_eq!(points[..up.len()], up);
    for face in mesh.faces() {
        println!("{face:?}");
    }
    // ! [result]
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
