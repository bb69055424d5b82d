//! Affine maps: Maps of points, as three rows of four numbers.

use glam::{DAffine3, DVec3};

/// Affine map of points.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub struct gusset_transform {
    /// x' = rows[0] x + rows[1] y + rows[2] z + rows[3]; then y', then z'.
    /// @shape 3 4
    pub rows: [f64; 12],
}

impl From<DAffine3> for gusset_transform {
    fn from(map: DAffine3) -> Self {
        let [x, y, z] = [map.matrix3.row(0), map.matrix3.row(1), map.matrix3.row(2)];
        let t = map.translation;
        gusset_transform { rows: [x.x, x.y, x.z, t.x, y.x, y.y, y.z, t.y, z.x, z.y, z.z, t.z] }
    }
}

impl From<gusset_transform> for DAffine3 {
    fn from(given: gusset_transform) -> Self {
        let r = given.rows;
        let column = |k: usize| DVec3::new(r[k], r[4 + k], r[8 + k]);
        DAffine3::from_cols(column(0), column(1), column(2), column(3))
    }
}
