//! The triangles of a patch with their neighbours, and the two edits of refinement: splits at a
//! centroid and edge flips, each O(1).

use crate::alloc;
use crate::error::Result;
use crate::mesh::NONE;
use glam::DVec3;

/// A triangulated patch under construction.
pub(super) struct PatchMesh {
    /// The rim's points first.
    pub(super) points: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Across the side from corner k to the next: a triangle, or [`NONE`].
    across: Vec<[u32; 3]>,
}

fn next(k: usize) -> usize {
    (k + 1) % 3
}

impl PatchMesh {
    /// O(T log T).
    pub(super) fn new(points: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<PatchMesh> {
        let mut sides = alloc::with_capacity(3 * triangles.len())?;
        for (t, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let (u, v) = (corners[k], corners[next(k)]);
                sides.push((u.min(v), u.max(v), t as u32, k));
            }
        }
        sides.sort_unstable();
        let mut across = alloc::filled([NONE; 3], triangles.len())?;
        for pair in sides.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1)) {
            let ((_, _, t, k), (_, _, s, j)) = (pair[0], pair[1]);
            across[t as usize][k] = s;
            across[s as usize][j] = t;
        }
        Ok(PatchMesh { points, triangles, across })
    }

    pub(super) fn corners(&self, t: usize) -> [DVec3; 3] {
        self.triangles[t].map(|v| self.points[v as usize])
    }

    /// The triangle across side `k` of triangle `t` and the side that it is there; `None` at the
    /// rim.
    pub(super) fn beyond(&self, t: usize, k: usize) -> Option<(usize, usize)> {
        let s = self.across[t][k];
        if s == NONE {
            return None;
        }
        let head = self.triangles[t][next(k)];
        (0..3).find(|&j| self.triangles[s as usize][j] == head).map(|j| (s as usize, j))
    }

    /// Replaces triangle `t` by three that meet at `point`: t and the last two. Side 0 of each is
    /// one of the old sides.
    pub(super) fn split(&mut self, t: usize, point: DVec3) -> Result<[usize; 3]> {
        let middle = self.points.len() as u32;
        alloc::push(&mut self.points, point)?;
        let parts = [t, self.triangles.len(), self.triangles.len() + 1];
        let (old, across) = (self.triangles[t], self.across[t]);
        for (k, &part) in parts.iter().enumerate() {
            let corners = [old[k], old[next(k)], middle];
            let around = [across[k], parts[next(k)] as u32, parts[next(next(k))] as u32];
            if part == t {
                (self.triangles[t], self.across[t]) = (corners, around);
            } else {
                alloc::push(&mut self.triangles, corners)?;
                alloc::push(&mut self.across, around)?;
                self.replace(across[k], t as u32, part as u32);
            }
        }
        Ok(parts)
    }

    /// Turns the side that triangles `t` (its side `k`) and `s` (its side `j`) share into the other
    /// diagonal.
    pub(super) fn flip(&mut self, (t, k): (usize, usize), (s, j): (usize, usize)) {
        let (a, b) = (self.triangles[t][k], self.triangles[t][next(k)]);
        let (c, d) = (self.triangles[t][next(next(k))], self.triangles[s][next(next(j))]);
        let [beyond_bc, beyond_ca] = [self.across[t][next(k)], self.across[t][next(next(k))]];
        let [beyond_ad, beyond_db] = [self.across[s][next(j)], self.across[s][next(next(j))]];
        (self.triangles[t], self.across[t]) = ([a, d, c], [beyond_ad, s as u32, beyond_ca]);
        (self.triangles[s], self.across[s]) = ([d, b, c], [beyond_db, beyond_bc, t as u32]);
        self.replace(beyond_ad, s as u32, t as u32);
        self.replace(beyond_bc, t as u32, s as u32);
    }

    /// Tells triangle `t` that its neighbour `old` is `new` now.
    fn replace(&mut self, t: u32, old: u32, new: u32) {
        if t != NONE {
            for side in self.across[t as usize].iter_mut().filter(|side| **side == old) {
                *side = new;
            }
        }
    }

    /// True if the patch has an edge from corner `k` of triangle `t` to vertex `v`: one walk round
    /// the corner.
    pub(super) fn has_edge(&self, t: usize, k: usize, v: u32) -> bool {
        let centre = self.triangles[t][k];
        let corner = |t: usize| (0..3).find(|&k| self.triangles[t][k] == centre).unwrap_or(0);
        // First one way, then, if the rim was met, the other way.
        for way in 0..2 {
            let mut here = t;
            loop {
                if self.triangles[here].contains(&v) {
                    return true;
                }
                let side = if way == 0 { corner(here) } else { next(next(corner(here))) };
                let beyond = self.across[here][side];
                if beyond == NONE {
                    break;
                }
                here = beyond as usize;
                if here == t {
                    return false;
                }
            }
        }
        false
    }
}
