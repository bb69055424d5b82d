//! Scenes: Nets in nested groups.
//!
//! @source Deryagin; groups are our own.

pub mod instances;

use crate::capi::context::{create, guard_change, gusset_context, lend};
use crate::capi::glue::versioned;
use crate::capi::handle::{self, handle};
use crate::capi::input;
use crate::capi::net::gusset_net;
use crate::capi::status::{Failure, gusset_status};
use crate::capi::transform::gusset_transform;
use crate::job::Job;
use crate::net::Net;
use crate::net::scene::{Content, EntryChanges, Scene};
use std::sync::Arc;

/// What an entry of a scene is.
pub type gusset_scene_entry_kind = u32;

/// A net.
pub const GUSSET_SCENE_NET: gusset_scene_entry_kind = 0;

/// A group of entries.
pub const GUSSET_SCENE_GROUP: gusset_scene_entry_kind = 1;

/// Nets in groups in groups, at any depth; an entry may be in several groups. Entries are known by
/// indices, which are never given twice. Functions that take it as const may run at the same time
/// in many threads; those that change it need it for themselves.
pub struct gusset_scene(pub(crate) Scene);

handle! { gusset_scene }

/// An entry of a scene.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_entry_report {
    /// sizeof(gusset_scene_entry_report), set by the caller.
    pub struct_size: usize,
    /// Into the space of the groups that it is in.
    pub transform: gusset_transform,
    /// The number of entries in a group; 0 for a net.
    pub child_count: usize,
    /// GUSSET_SCENE_NET or GUSSET_SCENE_GROUP.
    pub kind: gusset_scene_entry_kind,
    /// 1 if it is shown; a group that it is in may hide it all the same.
    pub visible: u32,
}

/// How much is in a scene.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_report {
    /// sizeof(gusset_scene_report), set by the caller.
    pub struct_size: usize,
    /// Instances of nets and groups: ways from entries in no group; UINT64_MAX if there are more.
    pub instances: u64,
    /// Instances of nets alone.
    pub net_instances: u64,
    /// Entries that are nets.
    pub nets: u32,
    /// Entries that are groups.
    pub groups: u32,
    /// The longest way from an entry in no group: 1 if no group has entries, 0 for an empty scene.
    pub levels: u32,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_scene_entry_report: 120, gusset_scene_report: 40 }

pub(crate) fn scene<'a>(scene: *const gusset_scene) -> Result<&'a Scene, Failure> {
    Ok(&handle::get(scene, "scene")?.0)
}

fn changed<'a>(scene: *mut gusset_scene, job: &Job<'_>) -> Result<&'a mut Scene, Failure> {
    job.memory()?;
    Ok(&mut handle::get_mut(scene, "scene")?.0)
}

/// A net of the caller's as it is now, for a scene to keep; none for NULL.
fn shared(net: *const gusset_net) -> Result<Option<Arc<Net<'static>>>, Failure> {
    if net.is_null() { Ok(None) } else { Ok(Some(handle::get(net, "net")?.share()?)) }
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
    create(context, scene, "scene", |_| Ok(gusset_scene(Scene::new())))
}

/// Destroys a scene; NULL is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn gusset_scene_destroy(scene: *mut gusset_scene) {
    handle::destroy(scene);
}

/// Adds a net as it is now, or an empty group, in no group yet.
///
/// Later changes of the handle of the net do not change the scene.
///
/// @param net the net; NULL for a group.
/// @param entry receives its index.
/// @errors TOO_LARGE
/// @complexity O(1), and O(nodes) for a net in the caller's memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_add(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    net: *const gusset_net,
    entry: *mut u32,
) -> gusset_status {
    let entry = input::output(entry, u32::MAX, "entry");
    guard_change(context, |job| {
        let (entry, net) = (entry?, shared(net)?);
        let scene = changed(scene, job)?;
        *entry = match net {
            Some(net) => scene.add_net(net)?,
            None => scene.add_group()?,
        };
        Ok(())
    })
}

/// Puts an entry into a group, behind what is in it; again, if it is in it already.
///
/// @param group the index of the group.
/// @param child the index of the entry.
/// @errors NO_SUCH_ELEMENT (no such entry, or group is a net), SCENE_CYCLE
/// @complexity O(1) for an entry without children or a group in no group; at most O(entries below
///     the one or above the other, whichever are fewer).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_add_child(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    group: u32,
    child: u32,
) -> gusset_status {
    guard_change(context, |job| Ok(changed(scene, job)?.add_child(group, child)?))
}

/// Takes an entry out of a group: the first one, if it is in it several times.
///
/// @param group the index of the group.
/// @param child the index of the entry.
/// @errors NO_SUCH_ELEMENT (if it is not in the group)
/// @complexity O(children of the group + groups of the child).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_remove_child(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    group: u32,
    child: u32,
) -> gusset_status {
    guard_change(context, |job| Ok(changed(scene, job)?.remove_child(group, child)?))
}

/// Removes an entry from the scene and from all groups; what was in a group stays.
///
/// @param entry its index.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(children of its groups + groups of its children).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_remove(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    entry: u32,
) -> gusset_status {
    guard_change(context, |job| Ok(changed(scene, job)?.remove(entry)?))
}

/// A change of the visibility of an entry.
pub type gusset_visibility = u32;
/// None.
pub const GUSSET_VISIBILITY_KEEP: gusset_visibility = 0;
/// To visible.
pub const GUSSET_VISIBILITY_SHOW: gusset_visibility = 1;
/// To hidden, with all that is in the entry.
pub const GUSSET_VISIBILITY_HIDE: gusset_visibility = 2;

/// The changes of an entry of a scene. All zeros: none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_scene_changes {
    /// sizeof(gusset_scene_changes), set by the caller.
    pub struct_size: usize,
    /// The net that replaces the one of the entry, as it is now; NULL: it stays. The entry keeps its
    /// index, its groups and its transform.
    pub net: *const gusset_net,
    /// The place of the entry in the space of the groups that it is in, twelve finite numbers; NULL:
    /// it stays.
    pub transform: *const gusset_transform,
    /// A change of the visibility of an entry.
    pub visibility: gusset_visibility,
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_scene_changes: 32 reserved }

/// Changes an entry: its net, its transform, its visibility.
///
/// On failure the entry is as it was.
///
/// @param entry its index.
/// @param changes what changes.
/// @errors UNKNOWN_VALUE (visibility), NO_SUCH_ELEMENT (with the entry (also for a net in place of
///     a group)), OUT_OF_RANGE (the transform)
/// @complexity O(1), and O(nodes) for a net in the caller's memory.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_set_entry(
    context: *const gusset_context,
    scene: *mut gusset_scene,
    entry: u32,
    changes: *const gusset_scene_changes,
) -> gusset_status {
    guard_change(context, |job| {
        let given = input::read(changes, false, "changes")?;
        let transform = (!given.transform.is_null()).then(|| input::reference(given.transform, "transform"));
        let changes = EntryChanges {
            net: shared(given.net)?,
            transform: transform.transpose()?.map(|&transform| transform.into()),
            visible: match given.visibility {
                GUSSET_VISIBILITY_KEEP => None,
                GUSSET_VISIBILITY_SHOW => Some(true),
                GUSSET_VISIBILITY_HIDE => Some(false),
                other => return Err(Failure::unknown("visibility", other.into())),
            },
        };
        Ok(changed(scene, job)?.set_entry(entry, changes)?)
    })
}

/// What an entry is.
///
/// @param entry its index.
/// @param report its struct_size set.
/// @errors NO_SUCH_ELEMENT
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_get_entry(
    scene: *const gusset_scene,
    entry: u32,
    report: *mut gusset_scene_entry_report,
) -> gusset_status {
    lend!(scene, report, |gusset_scene(scene)| {
        let (kind, child_count) = match scene.content(entry)? {
            Content::Net(_) => (GUSSET_SCENE_NET, 0),
            Content::Group(children) => (GUSSET_SCENE_GROUP, children.len()),
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

/// The net of an entry, as a handle that shares its memory until it is changed.
///
/// @param entry its index.
/// @errors NO_SUCH_ELEMENT (for a group)
/// @complexity O(1).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_net_create(
    context: *const gusset_context,
    scene: *const gusset_scene,
    entry: u32,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |_| Ok(gusset_net::of_shared(self::scene(scene)?.net(entry)?.clone())))
}

/// The entries in a group, in order.
///
/// @param group its index.
/// @param children room for capacity indices, or NULL with capacity 0 to ask for their number.
/// @param capacity see children.
/// @param written receives it.
/// @errors NO_SUCH_ELEMENT (for a net), BUFFER_TOO_SMALL
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
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let written = written?;
        input::copy((children, capacity, "children"), self::scene(scene)?.children(group)?, written, job)
    })
}

/// How much is in a scene.
///
/// @param report its struct_size set.
/// @complexity O(entries + children), however many instances there are.
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_get_report(
    scene: *const gusset_scene,
    report: *mut gusset_scene_report,
) -> gusset_status {
    lend!(scene, report, |gusset_scene(scene)| {
        let counts = scene.counts()?;
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
