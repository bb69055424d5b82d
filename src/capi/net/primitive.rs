//! Shapes: Spheres, cylinders, boxes, tori, one-sided surfaces and others.

use crate::capi::context::{create, gusset_context};
use crate::capi::glue::{c_enum, versioned};
use crate::capi::input::{self, choice};
use crate::capi::mesh::gusset_scalar;
use crate::capi::net::gusset_net;
use crate::capi::status::{Failure, gusset_status};
use crate::net::closure::{BoxKind, Cuboid};
use crate::net::primitive::{Primitive, Request};

/// A shape.
pub type gusset_net_shape = u32;
/// A rectangle in the plane z = 0: size[0], size[1].
pub const GUSSET_NET_PLANE: gusset_net_shape = 0;
/// A sphere with two poles: radius. At least 3 rows and 4 columns.
pub const GUSSET_NET_SPHERE: gusset_net_shape = 1;
/// A sphere that is a disc whose rim is drawn together: radius. At least 3 rows and columns.
pub const GUSSET_NET_ONE_POLE_SPHERE: gusset_net_shape = 2;
/// A cylinder without caps: radius, height. At least 4 columns.
pub const GUSSET_NET_TUBE: gusset_net_shape = 3;
/// A cylinder with caps: radius, height. At least 4 rows and columns.
pub const GUSSET_NET_CYLINDER: gusset_net_shape = 4;
/// A prism over a regular polygon: sides, radius (of the circle through its corners), height. At
/// least 4 rows, and a column more than sides.
pub const GUSSET_NET_PRISM: gusset_net_shape = 5;
/// A cone with its base: radius, height. At least 3 rows and 4 columns.
pub const GUSSET_NET_CONE: gusset_net_shape = 6;
/// A pyramid over a regular polygon: sides, radius, height. At least 3 rows, and a column more than
/// sides.
pub const GUSSET_NET_PYRAMID: gusset_net_shape = 7;
/// A profile turned round the z axis: profile, profile_count. At least 4 columns; each point is a
/// row.
pub const GUSSET_NET_LATHE: gusset_net_shape = 8;
/// A torus: radius, minor_radius (of the tube, the smaller). At least 4 rows and columns.
pub const GUSSET_NET_TORUS: gusset_net_shape = 9;
/// A box: size, cells, box_kind. Rows and columns are as the cells say.
pub const GUSSET_NET_BOX: gusset_net_shape = 10;
/// A Moebius strip: radius (of its middle line), size[0] (its width). At least 4 columns.
pub const GUSSET_NET_MOEBIUS: gusset_net_shape = 11;
/// A Klein bottle, a tube with a figure-eight section that makes half a turn: radius, minor_radius.
/// At least 4 rows and columns.
pub const GUSSET_NET_KLEIN: gusset_net_shape = 12;
/// A projective plane, Boy's surface: radius (a scale). At least 4 rows and columns.
pub const GUSSET_NET_PROJECTIVE_PLANE: gusset_net_shape = 13;
/// Two sheets joined along their rim: size[0], size[1], height (their distance in the middle). At
/// least 3 rows, and 5, 7, ... columns.
pub const GUSSET_NET_PILLOW: gusset_net_shape = 14;

/// How the two caps of a box are covered.
pub type gusset_box_kind = u32;
/// Two rims of the cap sweep over it to a slit, which is zipped up. All faces are unit quads, and
/// no seams are needed.
pub const GUSSET_NET_BOX_SLIT: gusset_box_kind = 0;
/// The paper's crosswise unwrapping. All faces are unit quads; two seams.
pub const GUSSET_NET_BOX_CROSS: gusset_box_kind = 1;
/// Concentric rings: fewest nodes, and triangles along the diagonals of the caps.
pub const GUSSET_NET_BOX_CONCENTRIC: gusset_box_kind = 2;

/// A net that is wanted. Measures that the shape does not name are not read.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct gusset_net_primitive {
    /// sizeof(gusset_net_primitive), set by the caller.
    pub struct_size: usize,
    /// One of GUSSET_NET_PLANE to GUSSET_NET_PILLOW.
    pub shape: gusset_net_shape,
    /// The type of coordinates.
    pub scalar: gusset_scalar,
    /// Rows of nodes; 0 for 33. Not read for boxes and lathes.
    pub rows: usize,
    /// Columns of nodes; 0 for 65. Not read for boxes.
    pub columns: usize,
    /// See the shapes; above 0, in the unit of the coordinates.
    pub radius: f64,
    /// See the shapes; above 0.
    pub minor_radius: f64,
    /// See the shapes; above 0, along z.
    pub height: f64,
    /// See the shapes; above 0, along x, y and z.
    pub size: [f64; 3],
    /// Distance from the axis, at least 0, and height of each point, from below to above, at any
    /// alignment. A row on the axis is a pole; a profile that ends where it begins makes a ring.
    pub profile: *const f64,
    /// The number of points, twice as many numbers; at least 2.
    pub profile_count: usize,
    /// Lateral faces of a prism or pyramid, at least 3.
    pub sides: u32,
    /// How the two caps of a box are covered.
    pub box_kind: gusset_box_kind,
    /// Cells of a box along x, y and z, at least 1 each.
    pub cells: [u32; 3],
    /// 0.
    pub reserved: u32,
}

versioned! { gusset_net_primitive: 120 reserved }

c_enum! {
    box_kind: BoxKind { GUSSET_NET_BOX_SLIT => Slit, GUSSET_NET_BOX_CROSS => Cross, GUSSET_NET_BOX_CONCENTRIC => Concentric }
}

impl gusset_net_primitive {
    fn primitive<'a>(&self, profile: &'a [[f64; 2]]) -> Result<Primitive<'a>, Failure> {
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
                Primitive::Cuboid { cuboid: Cuboid { kind: choice(self.box_kind)?, cells: self.cells }, size }
            }
            GUSSET_NET_MOEBIUS => Primitive::Moebius { radius, width: size[0] },
            GUSSET_NET_KLEIN => Primitive::Klein { radius, minor_radius },
            GUSSET_NET_PROJECTIVE_PLANE => Primitive::ProjectivePlane { radius },
            GUSSET_NET_PILLOW => Primitive::Pillow { size: [size[0], size[1]], thickness: height },
            other => return Err(Failure::unknown("shape", other.into())),
        })
    }
}

/// Makes a net of a standard shape, centred at the origin, its axis along z.
///
/// Nodes that are one point have the same bits; closed surfaces have their faces counter-clockwise
/// seen from outside.
///
/// @param primitive what is wanted.
/// @errors OUT_OF_RANGE (a measure that is not positive or beyond the scalar type, too few rows,
///     columns, sides or cells), TOO_LARGE
/// @complexity O(nodes); 12 or 24 bytes a node, and 1/4 for boxes.
/// @source Deryagin, "Closures of nets".
#[unsafe(no_mangle)]
#[must_use]
pub unsafe extern "C" fn gusset_net_primitive_create(
    context: *const gusset_context,
    primitive: *const gusset_net_primitive,
    net: *mut *mut gusset_net,
) -> gusset_status {
    create(context, net, "net", |job| {
        let given = input::read(primitive, false, "primitive")?;
        let point_count = if given.shape == GUSSET_NET_LATHE { given.profile_count } else { 0 };
        let profile: Vec<[f64; 2]> = input::list(given.profile.cast(), point_count, "profile")?;
        let (primitive, scalar) = (given.primitive(&profile)?, choice(given.scalar)?);
        let request = Request { primitive, rows: given.rows, columns: given.columns, scalar };
        Ok(gusset_net::new(request.net(job)?))
    })
}
