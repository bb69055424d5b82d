//! List of scans and their poses, as in the Stanford 3D Scanning Repository (`bun.conf`).
//!
//! Each line `bmesh FILE tx ty tz qi qj qk qr` names a scan, a translation in the unit of the scan, and a quaternion with its real part
//! last. The quaternion rotates the coordinate axes, so that the points turn the other way. Other lines, such as `camera`, and comments
//! after `#` mean nothing. The name may have blanks. A scan may be a file of any format except another list.
//!
//! A scan that several lines name is loaded once and placed several times, which costs a placement for each line. Only a single mesh
//! may be repeated. Therefore, reading takes time and memory linear in the list and the scans that it names.

mod pose;
mod read_scan_list;
mod scans;

#[cfg(test)]
mod scan_list_tests;

pub(crate) use read_scan_list::read_scan_list;
