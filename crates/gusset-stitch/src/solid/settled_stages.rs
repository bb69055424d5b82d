//! The stages that have nothing more to do on the mesh as it is.

use super::repair_state::Revision;

/// A stage whose outcome depends on the mesh alone.
#[derive(Clone, Copy)]
pub(super) enum Stage {
    /// Sewing in the first round of a pass.
    FirstSewing,
    LaterSewing,
    FlatFaces,
    Duplicates,
    Contacts,
    Holes,
    Sheets,
    Orientation,
    Intersections,
}

/// Number of stages.
const STAGE_COUNT: usize = Stage::Intersections as usize + 1;

/// The revision of the mesh at which each stage last changed nothing.
#[derive(Default)]
pub(super) struct SettledStages {
    revisions: [Option<Revision>; STAGE_COUNT],
}

impl SettledStages {
    /// Returns true if `stage` changes nothing at `revision`.
    pub(super) fn contains(&self, stage: Stage, revision: Revision) -> bool {
        self.revisions[stage as usize] == Some(revision)
    }

    /// Notes that `stage` ran on the mesh `before` and left it `after`. A stage that changed the mesh may find more.
    pub(super) fn record(&mut self, stage: Stage, before: Revision, after: Revision) {
        self.revisions[stage as usize] = (before == after).then_some(after);
    }
}
