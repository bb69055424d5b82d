//! Visible nets of a scene: Where each net of a scene is in the world, and all of them as one net.

use crate::capi::context::{create, guard_change, gusset_context};
use crate::capi::glue::fixed;
use crate::capi::input::{self, choice, fill};
use crate::capi::net::arrange::gusset_direction;
use crate::capi::net::join::gusset_concatenate_options;
use crate::capi::net::{gusset_net, read};
use crate::capi::scene::{gusset_scene, scene};
use crate::capi::status::gusset_status;
use crate::capi::transform::gusset_transform;
use crate::net::scene::{Instance, Scene};
use crate::net::{BridgeMode, Direction, JoinOptions};

/// One way to an entry from an entry in no group.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_scene_instance {
    /// Into the space of the scene.
    pub world: gusset_transform,
    /// The entry.
    pub entry: u32,
    /// The instance of the group that it is in, by its place in the list; UINT32_MAX if it is in
    /// none.
    pub parent: u32,
    /// 1 unless it or a group on the way is hidden.
    pub visible: u32,
    /// 0.
    pub reserved: u32,
}

fixed! { gusset_scene_instance: 112 }

/// All instances and where they are: each behind the group that it is in, children in order.
///
/// @param instances room for capacity of them, or NULL with capacity 0 to ask for their number.
/// @param capacity see instances.
/// @param written receives it.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE (more than 2^24, as sharing can make of few entries: refused
///     before any is looked at)
/// @complexity O(entries + instances).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_world_transforms(
    context: *const gusset_context,
    scene: *const gusset_scene,
    instances: *mut gusset_scene_instance,
    capacity: usize,
    written: *mut usize,
) -> gusset_status {
    let written = input::output(written, 0, "written");
    guard_change(context, |job| {
        let written = written?;
        let scene = self::scene(scene)?;
        fill((instances, capacity, "instances"), scene.instance_count()?, written, job, || {
            Ok(scene.instances(job)?.into_iter().map(|Instance { entry, parent, visible, world }| {
                let (world, visible) = (world.into(), visible.into());
                gusset_scene_instance { world, entry, parent, visible, reserved: 0 }
            }))
        })
    })
}

/// Joins the nets of all visible instances, where they are in the space of the scene, to one.
///
/// Nets under transforms that mirror are flipped where the others would be opposed to them, as if
/// options said turn. gusset_scene_unflatten_create is the inverse.
///
/// @param options NULL for each net below the one before, with hidden bridges.
/// @errors EMPTY_SCENE (no visible net), TOO_LARGE (more than 2^24 instances, or nodes), as
///     gusset_net_concatenate_create
/// @complexity O(entries + instances + nodes).
/// @source Deryagin, scenes as "a single whole".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_flatten_create(
    context: *const gusset_context,
    scene: *const gusset_scene,
    options: *const gusset_concatenate_options,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |job| {
        let options = if options.is_null() {
            JoinOptions { mode: BridgeMode::Hide, ..JoinOptions::new(Direction::Down) }
        } else {
            input::read(options, false, "options")?.checked()?
        };
        Ok(gusset_net::new(self::scene(scene)?.flatten(&options, job)?))
    })
}

/// A scene of the nets between the bridges of a direction that run from side to side and were made
/// last, all at once: the inverse of gusset_scene_flatten_create, in one group (entry 0).
///
/// Nets come back as they are in the space of the flat one, bit for bit; copies that were made to
/// equalise sizes are removed.
///
/// @param direction that of the bridges.
/// @errors CROSSING_CELL
/// @complexity O(nodes).
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_scene_unflatten_create(
    context: *const gusset_context,
    net: *const gusset_net,
    direction: gusset_direction,
    scene: *mut *mut gusset_scene,
) -> gusset_status {
    create(context, scene, "scene", |job| Ok(gusset_scene(Scene::of_flat(read(net)?, choice(direction)?, job)?)))
}
