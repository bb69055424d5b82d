//! Equations over patches in Bernstein form: the common roots of two fields, and the common points
//! of a curve and a patch. All solutions are found; the engine is
//! [`gusset_base::geom::subdivision`].

mod curve_crossings;
mod bernstein_field;
mod field_roots;

pub(crate) use bernstein_field::BernsteinField;
pub(crate) use curve_crossings::{CrossingWorkspace, CurvePatchCrossings, find_crossings};
pub(crate) use field_roots::{FieldRoots, find_roots, find_simple_roots};
