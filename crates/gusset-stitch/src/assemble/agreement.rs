//! Makes components that face each other agree in orientation, by union-find with parity.

use super::assemble_request::{Assembly, Outcome};
use super::candidates::FacingLoops;
use super::combined_pieces::CombinedPieces;
use super::piece_loops::PieceLoops;
use crate::stitch::sense::{arcs_run_the_same_way, rims_disagree};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::ParitySets;
use gusset_base::sort::sort_distinct;
use gusset_mesh::NONE;

impl CombinedPieces {
    /// Turns components over so that facing loops agree in orientation. Returns for each pair
    /// whether it can be joined. If `keep_orientation`, turns nothing and accepts every pair.
    pub(super) fn make_orientations_agree(
        &mut self,
        loops: &mut PieceLoops,
        found: &mut [FacingLoops],
        keep_orientation: bool,
    ) -> Result<Vec<Outcome>> {
        let mut outcomes = alloc::filled(Outcome::Joined, found.len())?;
        if keep_orientation {
            return Ok(outcomes);
        }
        let mut components = alloc::collect(loops.candidates.iter().map(|candidate| candidate.component))?;
        sort_distinct(&mut components);
        let place = |component: u32| components.partition_point(|&other| other < component) as u32;
        let mut agreement = ParitySets::new(components.len())?;
        // Overlapping pieces already agree in orientation, whatever their loops suggest.
        let mut first_of = alloc::filled(NONE, self.assembly.maps.len())?;
        for candidate in loops.candidates.iter().filter(|candidate| candidate.piece != NONE) {
            let (first, own) = (&mut first_of[candidate.piece as usize], place(candidate.component));
            if *first == NONE {
                *first = own;
            }
            if !self.overlapping_pairs.is_empty() {
                agreement.union(*first, own, false);
            }
        }
        for [first, second] in self.overlapping_pairs.iter().map(|pair| pair.map(|k| first_of[k as usize])) {
            if first != NONE && second != NONE {
                agreement.union(first, second, false);
            }
        }
        for (facing, outcome) in found.iter().zip(&mut outcomes) {
            let [i, j] = facing.rims.map(|r| loops.candidates[r].component);
            let [a, b] = loops.facing_sides(facing)?;
            let against = match facing.arcs {
                None => rims_disagree(&a, &b)?,
                Some(_) => arcs_run_the_same_way(&a.points, &b.points)?,
            };
            // Turning does not help within one component: such loops are accepted as they run.
            if i != j && !agreement.union(place(i), place(j), against) {
                *outcome = Outcome::OrientationConflict;
            }
        }
        let mut turned = alloc::copied(&components)?;
        turned.retain(|&component| agreement.find(place(component)).1);
        let is_turned = |component: u32| turned.binary_search(&component).is_ok();
        let Assembly { mesh, turned: faces_turned, .. } = &mut self.assembly;
        for (face, turned) in mesh.face_offsets.windows(2).zip(faces_turned) {
            let corners = &mut mesh.face_corners[face[0] as usize..face[1] as usize];
            if is_turned(loops.components.find(corners[0])) {
                corners[1..].reverse();
                *turned ^= true;
            }
        }
        for (rim, candidate) in loops.rims.iter_mut().zip(&loops.candidates) {
            if is_turned(candidate.component) {
                rim.adapt_to_turned_surface();
            }
        }
        // Places count along the loops in their new direction.
        for facing in found {
            if let Some(arcs) = &mut facing.arcs {
                for (arc, r) in arcs.iter_mut().zip(facing.rims) {
                    let (n, component) = (loops.rims[r].vertices.len(), loops.candidates[r].component);
                    if is_turned(component) {
                        arc.first = (2 * n - arc.first - arc.count) % n;
                    }
                }
            }
        }
        Ok(outcomes)
    }
}
