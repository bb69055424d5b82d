//! Equations over patches in Bernstein form: common roots of two fields, and common points of a
//! curve and a patch. None is missed; the engine is [`gusset_base::geom::subdivision`].

mod curve_crossings;
mod field;
mod roots;

pub(crate) use curve_crossings::{Crossings, CurveWorkspace, crossings};
pub(crate) use field::Field;
pub(crate) use roots::{Roots, roots, simple_roots};
