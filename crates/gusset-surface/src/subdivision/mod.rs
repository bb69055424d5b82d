//! Equations over patches in Bernstein form: the common roots of two fields, and the common points
//! of a curve and a patch. All solutions are found; the engine is
//! [`gusset_base::geom::subdivision`].

mod curve_crossings;
mod field;
mod roots;

pub(crate) use curve_crossings::{Crossings, CurveWorkspace, crossings};
pub(crate) use field::Field;
pub(crate) use roots::{Roots, roots, simple_roots};
