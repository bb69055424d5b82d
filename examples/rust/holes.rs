//! Fills the holes of a mesh, and says what became of each.

use gusset::check::check;
use gusset::fill::{HoleStatus, Limits, LoopSelection, Options, fill_holes};
use gusset::mesh::{Faces, MeshView, Positions};
use gusset::stitch::Finish;
use gusset::{Job, Result};

fn main() -> Result<()> {
    // A cube of quads without its top.
    let corners: [[f64; 3]; 8] = std::array::from_fn(|v| [v & 1, v >> 1 & 1, v >> 2].map(|bit| bit as f64));
    let face_offsets = [0, 4, 8, 12, 16, 20];
    let face_corners = [0, 2, 3, 1, 0, 1, 5, 4, 1, 3, 7, 5, 3, 2, 6, 7, 2, 0, 4, 6];

    // ! [fill]
    let job = Job::default();
    let faces = Faces::polygons(&face_offsets, &face_corners)?;
    let mesh = MeshView::new(Positions::from(&corners[..]), faces, &job)?;

    let options = Options {
        // New vertices as dense as those around the hole, on a smooth surface.
        finish: Finish::Blend,
        limits: Limits { edges: Some(1000), ..Limits::default() },
        ..Options::default()
    };
    let filled = fill_holes(&mesh, LoopSelection::All, &options, &job)?;
    // ! [fill]

    // ! [holes]
    for hole in &filled.holes {
        match hole.status {
            HoleStatus::Filled => println!("filled by {} faces: {:?}", hole.faces.len(), hole.finish),
            other => println!("left open: {other:?}, rim {:?}", &filled.rims[hole.rim.clone()]),
        }
    }
    let report = check(&filled.mesh.view(&job)?, &job)?;
    println!("closed: {}, oriented: {}, genus: {:?}", report.closed, report.oriented, report.genus);
    // ! [holes]
    assert!(report.closed && report.genus == Some(0));
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
