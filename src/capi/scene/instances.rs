//! Visible nets of a scene: Lists instances, and joins their nets into one.

use crate::capi::context::{create_handle, guard_changing_call, gusset_context};
use crate::capi::glue::fixed;
use crate::capi::input::{self, fill_buffer, read_choice};
use crate::capi::net::arrange::gusset_direction;
use crate::capi::net::join::gusset_concatenate_options;
use crate::capi::net::{gusset_net, net_of_handle};
use crate::capi::scene::{gusset_scene, scene_of_handle};
use crate::capi::status::gusset_status;
use crate::capi::transform::gusset_transform;
use crate::net::scene::{Instance, Scene};
use crate::net::{BridgeMode, Direction, JoinOptions};

/// Path from top level to an entry.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_scene_instance {
    /// Map into the scene's space.
    pub world: gusset_transform,
    /// The entry.
    pub entry: u32,
    /// Instance of the enclosing group, or UINT32_MAX.
    pub parent: u32,
    /// 1 unless the entry or an enclosing group is hidden.
    /// @flag
    pub visible: u32,
    /// 0.
    pub reserved: u32,
}

fixed! { gusset_scene_instance: 112 }

/// Writes all instances: each after its group, children in order.
///
/// @param instances receives the instances.
/// @errors BUFFER_TOO_SMALL, TOO_LARGE (more than 2^24 instances)
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
    let written = input::cleared_output(written, 0, "written");
    guard_changing_call(context, |job| {
        let written = written?;
        let scene = self::scene_of_handle(scene)?;
        fill_buffer((instances, capacity, "instances"), scene.instance_count()?, written, job, || {
            Ok(scene.instances(job)?.into_iter().map(|Instance { entry, parent, visible, world }| {
                let (world, visible) = (world.into(), visible.into());
                gusset_scene_instance { world, entry, parent, visible, reserved: 0 }
            }))
        })
    })
}

/// Joins all visible nets into one, in the scene's space.
///
/// Mirrored nets are flipped: turn counts as 1. gusset_scene_unflatten_create is the inverse.
///
/// @param options NULL: nets from top to bottom, with hidden bridges.
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
    create_handle(context, net, "net", |job| {
        let options = if options.is_null() {
            JoinOptions { mode: BridgeMode::Hide, ..JoinOptions::new(Direction::Down) }
        } else {
            input::read_versioned_struct(options, false, "options")?.checked()?
        };
        Ok(gusset_net::new(self::scene_of_handle(scene)?.flatten(&options, job)?))
    })
}

/// Splits a net at the last-made bridges of a direction from side to side, into one group, entry 0.
///
/// Parts keep their bits in net's space; copies that equalised sizes are removed.
///
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
    create_handle(context, scene, "scene", |job| {
        Ok(gusset_scene(Scene::from_flat_net(net_of_handle(net)?, read_choice(direction)?, job)?))
    })
}
