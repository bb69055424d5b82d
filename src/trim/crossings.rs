//! Kept faces of different pieces that cut each other.

use super::layer::Layer;
use super::region::Region;
use crate::alloc;
use crate::error::Result;
use crate::intersect::{Soup, intersecting_pairs_where};
use crate::job::Job;
use crate::sort::sort_distinct;
use glam::DVec3;
use std::sync::atomic::{AtomicBool, Ordering};

/// The faces of each piece that cut one of a piece before it. O(F log F).
pub(super) fn crossings(layers: &[Layer], regions: &[Region<'_, '_>], job: &Job<'_>) -> Result<Vec<Vec<u32>>> {
    let mut points: Vec<DVec3> = Vec::new();
    // Triangles, the pieces and the faces that they are of.
    let (mut triangles, mut of): (Vec<[u32; 3]>, Vec<[u32; 2]>) = (Vec::new(), Vec::new());
    for ((layer, region), k) in layers.iter().zip(regions).zip(0..) {
        let first = points.len() as u32;
        alloc::append(&mut points, &layer.scan.points)?;
        for (triangle, &f) in layer.triangles.iter().zip(&layer.faces).filter(|(_, f)| region.keeps[**f as usize]) {
            alloc::push(&mut triangles, triangle.map(|v| v + first))?;
            alloc::push(&mut of, [k, f])?;
        }
    }
    let soup = Soup { at: |v: u32| points[v as usize], new: &triangles, old: &[] };
    // That of the later piece, as elsewhere: what went here on one side and there on the other
    // would leave neither.
    let worse = |s: u32, t: u32| if of[s as usize][0] > of[t as usize][0] { s } else { t };
    // Each face is found once, by whichever pair: where many lie in one, not all pairs are listed,
    // and the faces are the same in any order.
    let is_found = alloc::collect((0..triangles.len()).map(|_| AtomicBool::new(false)))?;
    let wanted = |s: u32, t: u32| {
        of[s as usize][0] != of[t as usize][0] && !is_found[worse(s, t) as usize].load(Ordering::Relaxed)
    };
    let list = |s: u32, t: u32| !is_found[worse(s, t) as usize].swap(true, Ordering::Relaxed);
    let mut found = alloc::filled(Vec::new(), layers.len())?;
    for [s, t] in intersecting_pairs_where(&soup, &wanted, &list, job)? {
        let [k, f] = of[worse(s, t) as usize];
        alloc::push(&mut found[k as usize], f)?;
    }
    found.iter_mut().for_each(sort_distinct);
    Ok(found)
}
