//! Duplicate faces: faces with the same vertices, in either direction. The first one stays.

use super::repair_request::DropReason;
use crate::check::duplicate_face_groups;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::MeshView;

/// Marks the duplicate faces to drop; `None` without duplicates. O(F log F) comparisons of faces.
pub(super) fn mark_duplicates(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Option<Vec<Option<DropReason>>>> {
    let groups = duplicate_face_groups(mesh, &[], job)?;
    if groups.is_empty() {
        return Ok(None);
    }
    let mut reasons = alloc::filled(None, mesh.faces().len())?;
    for (first, f) in groups {
        reasons[f as usize] = (f != first).then_some(DropReason::Duplicate);
    }
    Ok(Some(reasons))
}
