//! XYZ and CSV, tables of coordinates: points, or polylines of points.
//!
//! These files follow no standard. The reader takes what CloudCompare, NumPy and spreadsheets write, whatever the extension: columns
//! separated by blanks, tabs, commas or semicolons; decimal commas unless commas separate; header lines; comments after `#`, or in lines
//! that begin with `//`, `%` or `!`; quoted fields.
//!
//! - A header names the columns: `x`, `y`, `z`, `lon`, `lat`, `nx`, `red` and so on, also with a unit (`x_m`). Columns that are not named
//!   are x, y and z, then three whole numbers up to 255 for a colour, and three numbers for a normal of length 1. A file of two
//!   columns has z = 0.
//! - All points become the document's points, and also its polylines, in the order of the file. A blank line begins a new polyline, and
//!   so do a line that begins with `>`, a row of NaN, and a new value in a column before the coordinates (`path`, `contour`), unless
//!   this column changes in each row. A polyline whose last point equals its first is closed.
//! - Rows with an empty coordinate are left out.
//!
//! The writers write points with normals and colours. Polylines are separated by blank lines in XYZ files, and by a column `curve` in CSV
//! files. Reading takes memory of about 50 bytes for each row.

#[cfg(test)]
mod points_tests;
mod read_table;
mod table_columns;
mod table_fields;
mod write_table;

pub(crate) use read_table::read_table as read_csv;
pub(crate) use read_table::read_table as read_xyz;
pub(crate) use write_table::{write_csv, write_xyz};
