//! Scenes: Nets in nested groups. Parameters called entry, group and child are indices of entries.
//!
//! @source Deryagin; groups are our own.

pub mod instances;
pub mod transfer;

use crate::capi::context::{create_handle, guard_changing_call, gusset_context, lend};
use crate::capi::glue::{constants, versioned};
use crate::capi::handle::{self, handle};
use crate::capi::input;
use crate::capi::net::gusset_net;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::transform::gusset_transform;
use crate::job::Job;
use crate::net::Net;
use crate::net::scene::{EntryChanges, EntryContent, Scene};
use std::sync::Arc;

/// Kind of a scene entry.
pub type gusset_scene_entry_kind = u32;

/// Net.
pub const GUSSET_SCENE_NET: gusset_scene_entry_kind = 0;

/// Group of entries.
pub const GUSSET_SCENE_GROUP: gusset_scene_entry_kind = 1;

/// Nets in nested groups. Entries may belong to several groups; indices are never reused.
pub struct gusset_scene(pub(crate) Scene);

handle! { gusset_scene }

/// Entry of a scene.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_entry_report {
    /// sizeof(gusset_scene_entry_report).
    pub struct_size: usize,
    /// Map into its groups' space.
    pub transform: gusset_transform,
    /// Entries in a group; 0 for a net.
    pub child_count: usize,
    /// Kind of a scene entry.
    pub kind: gusset_scene_entry_kind,
    /// 1: shown, unless an enclosing group is hidden.
    /// @flag
    pub visible: u32,
}

/// Size of a scene. Top-level entries are outside all groups.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_report {
    /// sizeof(gusset_scene_report).
    pub struct_size: usize,
    /// Paths from top-level entries; at most UINT64_MAX.
    pub instances: u64,
    /// Instances of nets.
    pub net_instances: u64,
    /// Entries that are nets.
    pub nets: u32,
    /// Entries that are groups.
    pub groups: u32,
    /// Entries of the longest path; 0 if empty.
    pub levels: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_scene_entry_report: 120, gusset_scene_report: 40 }

pub(crate) fn scene_of_handle<'a>(scene: *const gusset_scene) -> Result<&'a Scene, Failure> {
    Ok(&handle::get_object(scene, "scene")?.0)
}

fn scene_of_handle_mut<'a>(scene: *mut gusset_scene, job: &Job<'_>) -> Result<&'a mut Scene, Failure> {
    job.check_memory()?;
    Ok(&mut handle::get_object_mut(scene, "scene")?.0)
}

/// Shares the current net of the caller, for a scene; `None` for NULL.
fn share_net_of_handle(net: *const gusset_net) -> Result<Option<Arc<Net<'static>>>, Failure> {
    if net.is_null() { Ok(None) } else { Ok(Some(handle::get_object(net, "net")?.share_net()?)) }
}

/// Makes an empty scene.
///
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_create(
    context: *const gusset_context,
    scene: *mut *mut gusset_scene,
) -> gusset_status {
    create_handle(context, scene, "scene", |_| Ok(gusset_scene(Scene::new())))
}

/// Destroys a scene.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_scene_destroy(scene: *mut gusset_scene) {
    handle::destroy(scene);
}

/// Adds a net, as it is now, or an empty group, at top level.
///
/// @param net NULL adds a group.
/// @param entry receives its index.
/// @errors TOO_LARGE
/// @complexity O(1); O(nodes) for a net in the caller's memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_add(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    net: *const gusset_net,
    entry: *mut u32,
) -> gusset_status {
    let entry = input::cleared_output(entry, u32::MAX, "entry");
    guard_changing_call(context, |job| {
        let (entry, net) = (entry?, share_net_of_handle(net)?);
        let scene = scene_of_handle_mut(scene, job)?;
        *entry = match net {
            Some(net) => scene.add_net(net)?,
            None => scene.add_group()?,
        };
        Ok(())
    })
}

/// Appends an entry to a group, perhaps repeatedly.
///
/// @errors NO_SUCH_ELEMENT (also if group is a net), SCENE_CYCLE
/// @complexity O(1) for a child without children or a top-level group, else O(the fewer of entries
///     below child and above group).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_add_child(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    group: u32,
    child: u32,
) -> gusset_status {
    guard_changing_call(context, |job| Ok(scene_of_handle_mut(scene, job)?.add_child(group, child)?))
}

/// Removes the first occurrence of an entry from a group.
///
/// @errors NO_SUCH_ELEMENT (also if child is not in the group)
/// @complexity O(children of the group + groups of the child).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_remove_child(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    group: u32,
    child: u32,
) -> gusset_status {
    guard_changing_call(context, |job| Ok(scene_of_handle_mut(scene, job)?.remove_child(group, child)?))
}

/// Removes an entry and its places in groups; its children stay.
///
/// @errors NO_SUCH_ELEMENT
/// @complexity O(children of its groups + groups of its children).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_remove(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    entry: u32,
) -> gusset_status {
    guard_changing_call(context, |job| Ok(scene_of_handle_mut(scene, job)?.remove(entry)?))
}

/// Change of visibility.
pub type gusset_visibility = u32;
/// No change.
pub const GUSSET_VISIBILITY_KEEP: gusset_visibility = 0;
/// Shows the entry.
pub const GUSSET_VISIBILITY_SHOW: gusset_visibility = 1;
/// Hides the entry and its children.
pub const GUSSET_VISIBILITY_HIDE: gusset_visibility = 2;

/// Changes of an entry. Default: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_changes {
    /// sizeof(gusset_scene_changes).
    pub struct_size: usize,
    /// New net, as it is now; NULL: no change.
    pub net: *const gusset_net,
    /// New map into its groups' space; NULL: no change.
    pub transform: *const gusset_transform,
    /// Change of visibility.
    pub visibility: gusset_visibility,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_scene_changes: 32 reserved }

/// Changes the net, transform or visibility of an entry.
///
/// @errors NO_SUCH_ELEMENT (also if a group would get a net), OUT_OF_RANGE (transform)
/// @complexity O(1); O(nodes) for a net in the caller's memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_set_entry(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    entry: u32,
    changes: *const gusset_scene_changes,
) -> gusset_status {
    guard_changing_call(context, |job| {
        let given = input::read_versioned_struct(changes, false, "changes")?;
        let transform = (!given.transform.is_null()).then(|| input::checked_reference(given.transform, "transform"));
        let changes = EntryChanges {
            net: share_net_of_handle(given.net)?,
            transform: transform.transpose()?.map(|&transform| transform.into()),
            visible: match given.visibility {
                GUSSET_VISIBILITY_KEEP => None,
                GUSSET_VISIBILITY_SHOW => Some(true),
                GUSSET_VISIBILITY_HIDE => Some(false),
                other => {
                    return Err(Failure::unknown_choice(
                        "visibility",
                        other,
                        &constants![GUSSET_VISIBILITY_KEEP, GUSSET_VISIBILITY_SHOW, GUSSET_VISIBILITY_HIDE],
                    ));
                }
            },
        };
        Ok(scene_of_handle_mut(scene, job)?.set_entry(entry, changes)?)
    })
}

/// Describes an entry.
///
/// @errors NO_SUCH_ELEMENT
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_get_entry(
    scene: *const gusset_scene,
    entry: u32,
    report: *mut gusset_scene_entry_report,
) -> gusset_status {
    lend!(scene, report, |gusset_scene(scene)| {
        let (kind, child_count) = match scene.content(entry)? {
            EntryContent::Net(_) => (GUSSET_SCENE_NET, 0),
            EntryContent::Group(children) => (GUSSET_SCENE_GROUP, children.len()),
        };
        let (transform, visible) = (scene.transform(entry)?.into(), scene.is_visible(entry)?.into());
        gusset_scene_entry_report {
            struct_size: size_of::<gusset_scene_entry_report>(),
            transform,
            child_count,
            kind,
            visible,
        }
    })
}

/// Makes a handle of an entry's net, which shares memory until changed.
///
/// @errors NO_SUCH_ELEMENT (also for a group)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_net_create(
    context: *const gusset_context,
    scene: *const gusset_scene,
    entry: u32,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |_| {
        Ok(gusset_net::from_shared(self::scene_of_handle(scene)?.net(entry)?.clone()))
    })
}

/// Writes the entries of a group, in order.
///
/// @param children receives the entries.
/// @errors NO_SUCH_ELEMENT (also for a net), BUFFER_TOO_SMALL
/// @complexity O(children).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_get_children(
    context: *const gusset_context,
    scene: *const gusset_scene,
    group: u32,
    children: *mut u32,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let written = written?;
        input::copy_to_buffer(
            (children, capacity, "children"),
            self::scene_of_handle(scene)?.children(group)?,
            written,
            job,
        )
    })
}

/// Counts the contents.
///
/// @complexity O(entries + children).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_get_report(
    scene: *const gusset_scene,
    report: *mut gusset_scene_report,
) -> gusset_status {
    lend!(scene, report, |gusset_scene(scene)| {
        let counts = scene.count_elements()?;
        gusset_scene_report {
            struct_size: size_of::<gusset_scene_report>(),
            instances: counts.instances,
            net_instances: counts.net_instances,
            nets: counts.nets,
            groups: counts.groups,
            levels: counts.levels,
            reserved: 0,
        }
    })
}
