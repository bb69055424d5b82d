//! Shapes: Spheres, cylinders, boxes, tori, one-sided surfaces and others.

use crate::capi::context::{create_handle, gusset_context};
use crate::capi::glue::{c_enum, constants, versioned};
use crate::capi::input::{self, read_choice};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::gusset_net;
use crate::capi::status::{Failure, gusset_status};
use crate::net::closure::{BoxKind, Cuboid};
use crate::net::primitive::{Primitive, Request};

/// Standard shape, its measures, the least rows x columns.
pub type gusset_net_shape = u32;
/// Rectangle at z = 0: size[0], size[1].
pub const GUSSET_NET_PLANE: gusset_net_shape = 0;
/// Sphere with two poles: radius. From 3 x 4 nodes.
pub const GUSSET_NET_SPHERE: gusset_net_shape = 1;
/// Sphere from a disc, its rim one point: radius. From 3 x 3 nodes.
pub const GUSSET_NET_ONE_POLE_SPHERE: gusset_net_shape = 2;
/// Open cylinder: radius, height. At least 4 columns.
pub const GUSSET_NET_TUBE: gusset_net_shape = 3;
/// Closed cylinder: radius, height. From 4 x 4 nodes.
pub const GUSSET_NET_CYLINDER: gusset_net_shape = 4;
/// Regular prism: sides, radius (circumscribed), height. From 4 x (sides + 1) nodes.
pub const GUSSET_NET_PRISM: gusset_net_shape = 5;
/// Cone with base: radius, height. From 3 x 4 nodes.
pub const GUSSET_NET_CONE: gusset_net_shape = 6;
/// Regular pyramid: sides, radius (circumscribed), height. From 3 x (sides + 1) nodes.
pub const GUSSET_NET_PYRAMID: gusset_net_shape = 7;
/// Profile revolved about z: profile, profile_count. At least 4 columns; each point makes a row.
pub const GUSSET_NET_LATHE: gusset_net_shape = 8;
/// Torus: radius, minor_radius (of the tube, smaller). From 4 x 4 nodes.
pub const GUSSET_NET_TORUS: gusset_net_shape = 9;
/// Box: size, cells (which give rows and columns), box_kind.
pub const GUSSET_NET_BOX: gusset_net_shape = 10;
/// Moebius strip: radius (of the middle line), size[0] (width). At least 4 columns.
pub const GUSSET_NET_MOEBIUS: gusset_net_shape = 11;
/// Klein bottle with figure-eight section: radius, minor_radius. From 4 x 4 nodes.
pub const GUSSET_NET_KLEIN: gusset_net_shape = 12;
/// Projective plane as Boy's surface: radius (scale). From 4 x 4 nodes.
pub const GUSSET_NET_PROJECTIVE_PLANE: gusset_net_shape = 13;
/// Two sheets joined along their rim: size[0], size[1], height (thickness). At least 3 rows; 5, 7,
/// ... columns.
pub const GUSSET_NET_PILLOW: gusset_net_shape = 14;

/// Layout of the caps of a box.
pub type gusset_box_kind = u32;
/// Caps close along slits. Unit quads; no seams.
pub const GUSSET_NET_BOX_SLIT: gusset_box_kind = 0;
/// Crosswise unwrapping. Unit quads; two seams.
pub const GUSSET_NET_BOX_CROSS: gusset_box_kind = 1;
/// Concentric rings: fewest nodes; triangles along the diagonals.
pub const GUSSET_NET_BOX_CONCENTRIC: gusset_box_kind = 2;

/// Standard shape and its measures.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_primitive {
    /// sizeof(gusset_net_primitive).
    pub struct_size: usize,
    /// Standard shape, its measures, the least rows x columns.
    pub shape: gusset_net_shape,
    /// Type of coordinates.
    pub scalar: gusset_scalar,
    /// 0: 33. Not for boxes and lathes.
    pub rows: usize,
    /// 0: 65. Not for boxes.
    pub columns: usize,
    /// Above 0.
    pub radius: f64,
    /// Above 0.
    pub minor_radius: f64,
    /// Height along z, above 0.
    pub height: f64,
    /// Sizes along x, y and z, above 0.
    pub size: [f64; 3],
    /// Distance from the axis (at least 0) and height of each point, upwards. Points on the axis
    /// are poles; closed profiles make rings.
    /// @shape profile_count 2
    pub profile: *const f64,
    /// At least 2.
    pub profile_count: usize,
    /// Lateral faces of prisms and pyramids, at least 3.
    pub sides: u32,
    /// Layout of the caps of a box.
    pub box_kind: gusset_box_kind,
    /// Cells of boxes along x, y and z, at least 1.
    pub cells: [u32; 3],
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_primitive: 120 reserved }

c_enum! {
    box_kind: BoxKind { GUSSET_NET_BOX_SLIT => Slit, GUSSET_NET_BOX_CROSS => Cross, GUSSET_NET_BOX_CONCENTRIC => Concentric }
}

impl gusset_net_primitive {
    fn read_primitive<'a>(&self, profile: &'a [[f64; 2]]) -> Result<Primitive<'a>, Failure> {
        let gusset_net_primitive { radius, minor_radius, height, size, sides, .. } = *self;
        Ok(match self.shape {
            GUSSET_NET_PLANE => Primitive::Plane { size: [size[0], size[1]] },
            GUSSET_NET_SPHERE => Primitive::Sphere { radius },
            GUSSET_NET_ONE_POLE_SPHERE => Primitive::OnePoleSphere { radius },
            GUSSET_NET_TUBE => Primitive::Tube { radius, height },
            GUSSET_NET_CYLINDER => Primitive::Cylinder { radius, height },
            GUSSET_NET_PRISM => Primitive::Prism { sides, radius, height },
            GUSSET_NET_CONE => Primitive::Cone { radius, height },
            GUSSET_NET_PYRAMID => Primitive::Pyramid { sides, radius, height },
            GUSSET_NET_LATHE => Primitive::Lathe { profile },
            GUSSET_NET_TORUS => Primitive::Torus { radius, minor_radius },
            GUSSET_NET_BOX => {
                Primitive::Cuboid { cuboid: Cuboid { kind: read_choice(self.box_kind)?, cells: self.cells }, size }
            }
            GUSSET_NET_MOEBIUS => Primitive::Moebius { radius, width: size[0] },
            GUSSET_NET_KLEIN => Primitive::Klein { radius, minor_radius },
            GUSSET_NET_PROJECTIVE_PLANE => Primitive::ProjectivePlane { radius },
            GUSSET_NET_PILLOW => Primitive::Pillow { size: [size[0], size[1]], thickness: height },
            other => {
                return Err(Failure::unknown_choice(
                    "shape",
                    other,
                    &constants![
                        GUSSET_NET_PLANE,
                        GUSSET_NET_SPHERE,
                        GUSSET_NET_ONE_POLE_SPHERE,
                        GUSSET_NET_TUBE,
                        GUSSET_NET_CYLINDER,
                        GUSSET_NET_PRISM,
                        GUSSET_NET_CONE,
                        GUSSET_NET_PYRAMID,
                        GUSSET_NET_LATHE,
                        GUSSET_NET_TORUS,
                        GUSSET_NET_BOX,
                        GUSSET_NET_MOEBIUS,
                        GUSSET_NET_KLEIN,
                        GUSSET_NET_PROJECTIVE_PLANE,
                        GUSSET_NET_PILLOW
                    ],
                ));
            }
        })
    }
}

/// Makes a standard shape at the origin, with axis z.
///
/// Glued nodes have equal bits. Closed surfaces have outward normals.
///
/// @errors OUT_OF_RANGE (measure, too few elements), TOO_LARGE
/// @complexity O(nodes); 12 or 24 bytes a node, and 1/4 byte for boxes.
/// @source Deryagin, "Closures of nets".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_primitive_create(
    context: *const gusset_context,
    primitive: *const gusset_net_primitive,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create_handle(context, net, "net", |job| {
        let given = input::read_versioned_struct(primitive, false, "primitive")?;
        let point_count = if given.shape == GUSSET_NET_LATHE { given.profile_count } else { 0 };
        let profile: Vec<[f64; 2]> = input::copy_input_items(given.profile.cast(), point_count, "profile")?;
        let (primitive, scalar) = (given.read_primitive(&profile)?, read_choice(given.scalar)?);
        let request = Request { primitive, rows: given.rows, columns: given.columns, scalar };
        Ok(gusset_net::new(request.build_net(job)?))
    })
}
