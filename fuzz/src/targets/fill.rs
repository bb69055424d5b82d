//! Holes of any mesh, filled with every weight: an error, or a valid mesh that begins with the old
//! faces.

use crate::input;
use crate::input::Soup;
use gusset::Job;
use gusset::fill::{Continuity, Fairing, Keep, LoopSelection, Options, Refinement, Weight, fill_holes};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Soup, bool, bool, bool, bool, bool)>(bytes) else { return };
    let (soup, plain, faired, borders, curved, uncreased) = input;
    soup.visit(|mesh| {
        let options = Options {
            weight: Weight::default(),
            refinement: if plain { Refinement::None } else { Refinement::default() },
            fairing: if faired { Fairing::ThinPlate } else { Fairing::None },
            continuity: if curved { Continuity::C2 } else { Continuity::C1 },
            ignore_creases: uncreased,
            keep: if borders { Keep::OuterBorders } else { Keep::None },
            ..Options::default()
        };
        if let Ok(filled) = fill_holes(mesh, LoopSelection::All, &options, &Job::default()) {
            assert!(filled.mesh.face_count() >= mesh.faces().len());
            input::expect_valid(&filled.mesh, |_| {});
        }
    });
}
