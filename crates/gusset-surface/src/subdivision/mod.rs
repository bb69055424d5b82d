//! Equations over patches in Bernstein form: the common roots of two fields, and the common points
//! of a curve and a patch. All solutions are found; the engine is
//! [`gusset_base::geom::subdivision`].

mod curve_crossings;
mod field;
mod roots;

pub(crate) use curve_crossings::{CrossingWorkspace, CurvePatchCrossings, find_crossings};
pub(crate) use field::BernsteinField;
pub(crate) use roots::{FieldRoots, find_roots, find_simple_roots};
