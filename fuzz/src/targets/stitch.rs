//! Two pieces, joined in every way: an error, or a mesh of all old faces and the strip.

use crate::input;
use crate::input::Soup;
use gusset::Job;
use gusset::stitch::{Cells, Extent, Fairing, Meridians, Options, Request, Rows, stitch};

type Choices = [u8; 5];

fn options([meridians, rows, cells, fairing, extent]: Choices) -> Options {
    use Meridians::{ArcLength, Greedy, Index, MinArea, MinDiagonal, Quad, Smooth};
    Options {
        meridians: [ArcLength, Greedy, Index, MinArea, MinDiagonal, Quad, Smooth][usize::from(meridians % 7)],
        rows: [Rows::None, Rows::MeanEdge, Rows::Count(u32::from(rows / 3))][usize::from(rows % 3)],
        cells: [Cells::Triangles, Cells::Quads][usize::from(cells % 2)],
        fairing: [Fairing::None, Fairing::ThinPlate][usize::from(fairing % 2)],
        extent: [Extent::WholeLoops, Extent::OpenArcs, Extent::Auto][usize::from(extent % 3)],
        ..Options::default()
    }
}

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Soup, Soup, Choices)>(bytes) else { return };
    let (a, b, choices) = input;
    a.visit(|a| {
        b.visit(|b| {
            let request = Request { a, loop_a: None, b: Some(b), loop_b: None };
            if let Ok(joined) = stitch(&request, &options(choices), &Job::default()) {
                let old = a.faces().len() + b.faces().len();
                assert_eq!(joined.mesh.face_count(), old + joined.strip_faces.len());
                input::expect_valid(&joined.mesh, |_| {});
            }
        });
    });
}
