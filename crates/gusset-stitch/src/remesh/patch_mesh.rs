//! The triangles of a patch with their neighbours. Splits of a triangle or a side, and edge flips,
//! take O(1). Collapses and walks around a vertex are linear in its triangles.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_mesh::NONE;

/// A triangulated patch under construction.
pub(crate) struct PatchMesh {
    /// The positions of the vertices, the rim first.
    pub(crate) points: Vec<DVec3>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// For each side from corner k to the next, the triangle across it, or [`NONE`].
    pub(super) triangles_across_sides: Vec<[u32; 3]>,
}

fn next_corner(k: usize) -> usize {
    (k + 1) % 3
}

impl PatchMesh {
    /// Pairs the triangles. O(T log T).
    pub(crate) fn new(points: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<PatchMesh> {
        let mut sides = alloc::with_capacity(3 * triangles.len())?;
        for (t, corners) in triangles.iter().enumerate() {
            for k in 0..3 {
                let (u, v) = (corners[k], corners[next_corner(k)]);
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
        Ok(PatchMesh { points, triangles, triangles_across_sides: across })
    }

    pub(crate) fn try_clone(&self) -> Result<PatchMesh> {
        Ok(PatchMesh {
            points: alloc::copied(&self.points)?,
            triangles: alloc::copied(&self.triangles)?,
            triangles_across_sides: alloc::copied(&self.triangles_across_sides)?,
        })
    }

    pub(crate) fn corner_points(&self, t: usize) -> [DVec3; 3] {
        self.triangles[t].map(|v| self.points[v as usize])
    }

    /// Returns the triangle across side `k` of triangle `t`, and the index of the side there;
    /// `None` at the rim.
    pub(crate) fn triangle_across(&self, t: usize, k: usize) -> Option<(usize, usize)> {
        let s = self.triangles_across_sides[t][k];
        if s == NONE {
            return None;
        }
        let head = self.triangles[t][next_corner(k)];
        (0..3).find(|&j| self.triangles[s as usize][j] == head).map(|j| (s as usize, j))
    }

    /// Splits triangle `t` into three that meet at `point`: t and the last two. Side 0 of each is
    /// one of the old sides.
    pub(crate) fn split_triangle(&mut self, t: usize, point: DVec3) -> Result<[usize; 3]> {
        let middle = self.points.len() as u32;
        alloc::push(&mut self.points, point)?;
        let parts = [t, self.triangles.len(), self.triangles.len() + 1];
        let (old, across) = (self.triangles[t], self.triangles_across_sides[t]);
        for (k, &part) in parts.iter().enumerate() {
            let corners = [old[k], old[next_corner(k)], middle];
            let around = [across[k], parts[next_corner(k)] as u32, parts[next_corner(next_corner(k))] as u32];
            if part == t {
                (self.triangles[t], self.triangles_across_sides[t]) = (corners, around);
            } else {
                alloc::push(&mut self.triangles, corners)?;
                alloc::push(&mut self.triangles_across_sides, around)?;
                self.replace_neighbour(across[k], t as u32, part as u32);
            }
        }
        Ok(parts)
    }

    /// Splits side `k` of triangle `t`, which is not on the rim, at `point`. Returns the four
    /// triangles at the new vertex.
    pub(crate) fn split_side(
        &mut self,
        (t, k): (usize, usize),
        (s, j): (usize, usize),
        point: DVec3,
    ) -> Result<[usize; 4]> {
        let middle = self.points.len() as u32;
        alloc::push(&mut self.points, point)?;
        let (a, b) = (self.triangles[t][k], self.triangles[t][next_corner(k)]);
        let (c, d) = (self.triangles[t][next_corner(next_corner(k))], self.triangles[s][next_corner(next_corner(j))]);
        let [beyond_bc, beyond_ca] = [
            self.triangles_across_sides[t][next_corner(k)],
            self.triangles_across_sides[t][next_corner(next_corner(k))],
        ];
        let [beyond_ad, beyond_db] = [
            self.triangles_across_sides[s][next_corner(j)],
            self.triangles_across_sides[s][next_corner(next_corner(j))],
        ];
        let (t2, s2) = (self.triangles.len(), self.triangles.len() + 1);
        alloc::reserve(&mut self.triangles, 2)?;
        alloc::reserve(&mut self.triangles_across_sides, 2)?;
        (self.triangles[t], self.triangles_across_sides[t]) = ([a, middle, c], [s2 as u32, t2 as u32, beyond_ca]);
        (self.triangles[s], self.triangles_across_sides[s]) = ([b, middle, d], [t2 as u32, s2 as u32, beyond_db]);
        self.triangles.extend([[middle, b, c], [middle, a, d]]);
        self.triangles_across_sides.extend([[s as u32, beyond_bc, t as u32], [t as u32, beyond_ad, s as u32]]);
        self.replace_neighbour(beyond_bc, t as u32, t2 as u32);
        self.replace_neighbour(beyond_ad, s as u32, s2 as u32);
        Ok([t, s, t2, s2])
    }

    /// Flips the side shared by triangles `t` (its side `k`) and `s` (its side `j`).
    pub(crate) fn flip_side(&mut self, (t, k): (usize, usize), (s, j): (usize, usize)) {
        let (a, b) = (self.triangles[t][k], self.triangles[t][next_corner(k)]);
        let (c, d) = (self.triangles[t][next_corner(next_corner(k))], self.triangles[s][next_corner(next_corner(j))]);
        let [beyond_bc, beyond_ca] = [
            self.triangles_across_sides[t][next_corner(k)],
            self.triangles_across_sides[t][next_corner(next_corner(k))],
        ];
        let [beyond_ad, beyond_db] = [
            self.triangles_across_sides[s][next_corner(j)],
            self.triangles_across_sides[s][next_corner(next_corner(j))],
        ];
        (self.triangles[t], self.triangles_across_sides[t]) = ([a, d, c], [beyond_ad, s as u32, beyond_ca]);
        (self.triangles[s], self.triangles_across_sides[s]) = ([d, b, c], [beyond_db, beyond_bc, t as u32]);
        self.replace_neighbour(beyond_ad, s as u32, t as u32);
        self.replace_neighbour(beyond_bc, t as u32, s as u32);
    }

    /// Lists the triangles around corner `k` of triangle `t` in order, with the index of the corner
    /// in each. Returns true if the vertex is inside the patch.
    pub(crate) fn one_ring(&self, t: usize, k: usize, star: &mut Vec<(usize, usize)>) -> Result<bool> {
        star.clear();
        let centre = self.triangles[t][k];
        let mut here = (t, k);
        loop {
            alloc::push(star, here)?;
            // The side that ends in the centre begins there in the triangle across.
            let Some(beyond) = self.triangle_across(here.0, next_corner(next_corner(here.1))) else {
                return Ok(false);
            };
            here = beyond;
            let s = here.0;
            debug_assert_eq!(self.triangles[s][here.1], centre);
            if s == t {
                return Ok(true);
            }
        }
    }

    /// Returns true for a triangle that [`PatchMesh::collapse_edge`] removed.
    pub(crate) fn is_removed(&self, t: usize) -> bool {
        self.triangles[t][0] == NONE
    }

    /// Moves corner `k` of triangle `t`, whose one-ring is `star`, onto the next corner. Removes
    /// the two triangles at the edge between them, and the vertex.
    pub(crate) fn collapse_edge(&mut self, (t, k): (usize, usize), star: &[(usize, usize)]) {
        let onto = self.triangles[t][next_corner(k)];
        for &(s, j) in star {
            self.triangles[s][j] = onto;
        }
        for &(s, j) in [star[0], star[star.len() - 1]].iter() {
            // The sides that do not vanish: for t, the ones after and before the collapsed side.
            let sides = if s == t { [next_corner(j), next_corner(next_corner(j))] } else { [next_corner(j), j] };
            let [x, y] = sides.map(|side| self.triangles_across_sides[s][side]);
            self.replace_neighbour(x, s as u32, y);
            self.replace_neighbour(y, s as u32, x);
            (self.triangles[s], self.triangles_across_sides[s]) = ([NONE; 3], [NONE; 3]);
        }
    }

    /// Renumbers the remaining triangles and the vertices that they use. Vertices below `rim` keep
    /// their numbers. Returns the old number of each remaining vertex.
    pub(crate) fn renumber_remaining(&mut self, rim: usize) -> Result<Vec<u32>> {
        let mut number = alloc::filled(NONE, self.points.len())?;
        self.triangles.retain(|triangle| triangle[0] != NONE);
        self.triangles.as_flattened().iter().for_each(|&v| number[v as usize] = 0);
        number[..rim].fill(0);
        let kept = alloc::gather((0..self.points.len() as u32).filter(|&v| number[v as usize] == 0))?;
        for (new, &old) in kept.iter().enumerate() {
            number[old as usize] = new as u32;
            self.points[new] = self.points[old as usize];
        }
        self.points.truncate(kept.len());
        self.triangles.iter_mut().for_each(|triangle| *triangle = triangle.map(|v| number[v as usize]));
        let mesh = PatchMesh::new(std::mem::take(&mut self.points), std::mem::take(&mut self.triangles))?;
        *self = mesh;
        Ok(kept)
    }

    /// Replaces the neighbour `old` of triangle `t` by `new`.
    fn replace_neighbour(&mut self, t: u32, old: u32, new: u32) {
        if t != NONE {
            for side in self.triangles_across_sides[t as usize].iter_mut().filter(|side| **side == old) {
                *side = new;
            }
        }
    }

    /// Returns true if the patch has an edge from corner `k` of triangle `t` to vertex `v`.
    pub(crate) fn has_edge(&self, t: usize, k: usize, v: u32) -> bool {
        self.any_triangle_around(t, k, |s| self.triangles[s].contains(&v))
    }

    /// Returns true if `test` holds for a triangle around corner `k` of triangle `t`.
    pub(super) fn any_triangle_around(&self, t: usize, k: usize, test: impl Fn(usize) -> bool) -> bool {
        let centre = self.triangles[t][k];
        let corner = |t: usize| (0..3).find(|&k| self.triangles[t][k] == centre).unwrap_or(0);
        // Walk in one direction, and then, if the rim was met, in the other.
        for way in 0..2 {
            let mut here = t;
            loop {
                if test(here) {
                    return true;
                }
                let side = if way == 0 { corner(here) } else { next_corner(next_corner(corner(here))) };
                let beyond = self.triangles_across_sides[here][side];
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
