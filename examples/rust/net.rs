//! Builds regular nets of quads, and makes meshes of them.

use gusset::check::check;
use gusset::glam::DVec3;
use gusset::mesh::Scalar;
use gusset::net::convert::{Diagonal, MeshOptions};
use gusset::net::primitive::{Primitive, Request};
use gusset::net::{Net, Shape, Sides, Topology};
use gusset::{Job, Result};

fn main() -> Result<()> {
    // ! [torus]
    let job = Job::default();
    let torus = Request::new(Primitive::Torus { radius: 2.0, minor_radius: 0.5 }).build_net(&job)?;
    let options = MeshOptions { triangles: Some(Diagonal::Shorter), ..MeshOptions::default() };
    let converted = torus.to_mesh(&options, &job)?;

    let report = check(&converted.mesh.view(&job)?, &job)?;
    println!("{} vertices, {} triangles, genus {:?}", report.vertices, report.faces, report.genus);
    // ! [torus]
    assert!(report.closed && report.genus == Some(1));

    // ! [own]
    // A net of your own: a sheet of 3 rows of 4 nodes, whose sides are not glued.
    let topology = Topology::from_sides(Shape::new(3, 4)?, Sides::SHEET);
    let sheet = Net::from_fn(topology, Scalar::F64, |i, j| DVec3::new(j as f64, i as f64, 0.0))?;
    let quads = sheet.to_mesh(&MeshOptions::default(), &job)?.mesh;
    // ! [own]
    assert_eq!(quads.face_count(), 6);
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
