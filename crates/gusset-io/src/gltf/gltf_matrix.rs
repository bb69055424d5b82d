//! Matrices of nodes, in double precision: three rows of four.

use super::gltf_buffers::malformed;
use crate::document::Placement;
use crate::error::{Note, Place, ReadError};
use crate::json_tape::Value;
use gusset_base::alloc;

pub(super) type Matrix = [[f64; 4]; 3];

/// Returns the matrix that applies `inner` first.
pub(super) fn product(outer: &Matrix, inner: &Matrix) -> Matrix {
    if *outer == Placement::IDENTITY {
        return *inner;
    }
    if *inner == Placement::IDENTITY {
        return *outer;
    }
    outer.map(|row| {
        std::array::from_fn(|column| {
            let sum: f64 = (0..3).map(|k| row[k] * inner[k][column]).sum();
            if column == 3 { sum + row[3] } else { sum }
        })
    })
}

/// Returns the matrix of a node relative to its parent.
pub(super) fn matrix_from_node(node: Value<'_>, index: usize, notes: &mut Vec<Note>) -> Result<Matrix, ReadError> {
    if let Some(value) = node.get("matrix") {
        let m = value
            .numbers::<16>()
            .ok_or_else(|| malformed(format!("node {index}: the matrix is not a list of 16 numbers")))?;
        if [m[3], m[7], m[11], m[15]] != [0.0, 0.0, 0.0, 1.0] {
            let text = format!("node {index}: the last row of the matrix is not 0, 0, 0, 1 and is ignored");
            alloc::push(notes, Note::new(Place::Whole, text))?;
        }
        return Ok(std::array::from_fn(|row| std::array::from_fn(|column| m[4 * column + row])));
    }
    fn vector<const N: usize>(
        node: Value<'_>,
        index: usize,
        key: &str,
        usual: [f64; N],
    ) -> Result<[f64; N], ReadError> {
        node.get(key).map_or(Ok(usual), |value| {
            value.numbers().ok_or_else(|| malformed(format!("node {index}: the {key} is not a list of {N} numbers")))
        })
    }
    let rotation = vector(node, index, "rotation", [0.0, 0.0, 0.0, 1.0])?;
    if rotation == [0.0; 4] {
        alloc::push(
            notes,
            Note::new(Place::Whole, format!("node {index}: the rotation is a quaternion of length 0 and is ignored")),
        )?;
    }
    Ok(matrix_from_trs(
        vector(node, index, "translation", [0.0; 3])?,
        rotation,
        vector(node, index, "scale", [1.0; 3])?,
    ))
}

/// Returns the matrix of a scale, then a rotation by a quaternion of any length, then a translation.
pub(super) fn matrix_from_trs(translation: [f64; 3], [x, y, z, w]: [f64; 4], scale: [f64; 3]) -> Matrix {
    let square = x * x + y * y + z * z + w * w;
    let s = if square > 0.0 { 2.0 / square } else { 0.0 };
    let rotation = [
        [1.0 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)],
        [s * (x * y + z * w), 1.0 - s * (x * x + z * z), s * (y * z - x * w)],
        [s * (x * z - y * w), s * (y * z + x * w), 1.0 - s * (x * x + y * y)],
    ];
    std::array::from_fn(|row| {
        let [a, b, c]: [f64; 3] = std::array::from_fn(|column| rotation[row][column] * scale[column]);
        [a, b, c, translation[row]]
    })
}

/// Returns the image of a point.
pub(super) fn transformed(matrix: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    if *matrix == Placement::IDENTITY {
        return [x, y, z];
    }
    matrix.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
}
