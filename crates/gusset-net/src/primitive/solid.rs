//! The standard shapes, their smallest nets and the ranges of their dimensions.

use super::profile;
use crate::closure::Cuboid;
use gusset_base::error::{Error, Result};
use gusset_mesh::Scalar;

/// A shape and its dimensions, all positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Primitive<'a> {
    /// A rectangle in the plane z = 0, seen from above.
    Plane {
        /// The sizes along x and y.
        size: [f64; 2],
    },
    /// Meridians and parallels; closed by two poles. At least 3 rows and 4 columns.
    Sphere {
        /// The radius.
        radius: f64,
    },
    /// A disc whose rim is contracted to the lowest point; closed by one pole. At least 4 rows and
    /// columns.
    OnePoleSphere {
        /// The radius.
        radius: f64,
    },
    /// A cylinder without caps. At least 4 columns.
    Tube {
        /// The radius.
        radius: f64,
        /// The height, along z.
        height: f64,
    },
    /// A cylinder with caps; both rims are rows. At least 4 rows and 4 columns.
    Cylinder {
        /// The radius.
        radius: f64,
        /// The height, along z.
        height: f64,
    },
    /// A right prism over a regular polygon, with caps; all its vertices are nodes. At least 4
    /// rows, and a column more than sides.
    Prism {
        /// The number of lateral faces, at least 3.
        sides: u32,
        /// The radius of the circle through the polygon's corners. One corner is on the x axis.
        radius: f64,
        /// The height, along z.
        height: f64,
    },
    /// A cone with its base; the rim is a row. At least 3 rows and 4 columns.
    Cone {
        /// The radius of the base.
        radius: f64,
        /// The height, along z; the apex is at the top.
        height: f64,
    },
    /// A right pyramid over a regular polygon, with its base; all its vertices are nodes. At least
    /// 3 rows, and a column more than sides.
    Pyramid {
        /// The number of lateral faces, at least 3.
        sides: u32,
        /// The radius of the circle through the polygon's corners. One corner is on the x axis.
        radius: f64,
        /// The height, along z; the apex is at the top.
        height: f64,
    },
    /// A profile revolved around the z axis, one row for each point. Where the profile touches the
    /// axis, the row is a pole. A profile that ends where it begins makes a closed ring. At least 4
    /// columns; the profile determines the rows.
    Lathe {
        /// Distances from the axis, at least 0, and heights; at least two points.
        profile: &'a [[f64; 2]],
    },
    /// A torus round the z axis. At least 4 rows and columns.
    Torus {
        /// The distance from the axis to the middle of the tube.
        radius: f64,
        /// The radius of the tube, smaller than `radius`.
        minor_radius: f64,
    },
    /// A box of cells. The cells determine rows and columns.
    Cuboid {
        /// The cells along x, y, z, and the covering of the caps.
        cuboid: Cuboid,
        /// The sizes along x, y and z.
        size: [f64; 3],
    },
    /// A Möbius strip round the z axis. At least 4 columns.
    Moebius {
        /// The radius of the middle line.
        radius: f64,
        /// The width of the strip.
        width: f64,
    },
    /// A Klein bottle as a tube with a figure-eight section that makes half a turn. It is an
    /// immersion: the surface intersects itself. At least 4 rows and columns.
    Klein {
        /// The distance from the axis to the middle of the tube.
        radius: f64,
        /// The radius of the section.
        minor_radius: f64,
    },
    /// The projective plane as Boy's surface, in the parametrisation of R. Kusner and R. Bryant (an
    /// immersion). At least 4 rows and columns.
    ProjectivePlane {
        /// A scale; 1 gives the surface as published.
        radius: f64,
    },
    /// A pillow: two sheets joined along their rim. At least 3 rows, and an odd number of columns,
    /// at least 5.
    Pillow {
        /// The sizes along x and y.
        size: [f64; 2],
        /// The thickness in the middle.
        thickness: f64,
    },
}

impl Primitive<'_> {
    /// Returns the smallest numbers of rows and columns.
    pub(super) fn min_rows_and_columns(&self) -> (usize, usize) {
        match *self {
            Primitive::Plane { .. } => (2, 2),
            Primitive::Sphere { .. } | Primitive::Cone { .. } => (3, 4),
            Primitive::Tube { .. } | Primitive::Lathe { .. } | Primitive::Moebius { .. } => (2, 4),
            Primitive::Prism { sides, .. } => (4, sides as usize + 1),
            Primitive::Pyramid { sides, .. } => (3, sides as usize + 1),
            Primitive::Pillow { .. } => (3, 5),
            _ => (4, 4),
        }
    }

    /// Returns [`Error::OptionOutOfRange`] for a dimension outside its range.
    pub(super) fn check_dimensions(&self, scalar: Scalar) -> Result<()> {
        let (min, max) = match scalar {
            Scalar::F32 => (f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX) / 8.0),
            Scalar::F64 => (f64::MIN_POSITIVE, f64::MAX / 8.0),
        };
        let (dimensions, sides): (&[(&'static str, f64)], _) = match *self {
            Primitive::Plane { size } => (&[("size", size[0]), ("size", size[1])], 3),
            Primitive::Sphere { radius }
            | Primitive::OnePoleSphere { radius }
            | Primitive::ProjectivePlane { radius } => (&[("radius", radius)], 3),
            Primitive::Tube { radius, height }
            | Primitive::Cylinder { radius, height }
            | Primitive::Cone { radius, height } => (&[("radius", radius), ("height", height)], 3),
            Primitive::Prism { sides, radius, height } | Primitive::Pyramid { sides, radius, height } => {
                (&[("radius", radius), ("height", height)], sides)
            }
            Primitive::Torus { radius, minor_radius } if minor_radius >= radius => {
                return Error::require(false, "minor_radius", minor_radius, "smaller than the radius");
            }
            Primitive::Torus { radius, minor_radius } | Primitive::Klein { radius, minor_radius } => {
                (&[("radius", radius), ("minor_radius", minor_radius)], 3)
            }
            Primitive::Lathe { profile } => return profile::check_profile(profile, max),
            Primitive::Cuboid { size: [x, y, z], .. } => (&[("size", x), ("size", y), ("size", z)], 3),
            Primitive::Moebius { radius, width } => (&[("radius", radius), ("width", width)], 3),
            Primitive::Pillow { size: [x, y], thickness } => (&[("size", x), ("size", y), ("thickness", thickness)], 3),
        };
        dimensions
            .iter()
            .try_for_each(|(option, value)| Error::require((min..=max).contains(value), option, *value, min..=max))?;
        Error::require(sides >= 3, "sides", sides.into(), "at least 3")
    }
}
