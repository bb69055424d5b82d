//! Sets of chords of a loop that a triangulation may use.
//!
//! [`AllChords`] has every chord. [`ChordsNearTriangulation`] has the chords near the sides of a
//! coarser triangulation.

use gusset_base::error::Result;
use gusset_base::sort;
use gusset_base::sort::Buckets;

/// Numbered chords (i, k), i < k, of a loop of n vertices, including the edges (i, i + 1). The
/// chords (i, m) and (m, k) have smaller numbers than (i, k).
pub(super) trait ChordSet {
    fn chord_count(&self) -> usize;
    fn find_chord_number(&self, i: usize, k: usize) -> Option<usize>;
    /// Calls `visit` for every chord, in the order of the numbers.
    fn try_each_chord(&self, visit: impl FnMut(usize, [usize; 2]) -> Result<()>) -> Result<()>;
    /// Calls `visit` for each m between i and k, ascending, for which (i, m) and (m, k) are chords.
    /// Passes m and the numbers of both chords.
    fn visit_apexes(&self, i: usize, k: usize, visit: impl FnMut(usize, [usize; 2]));
}

/// All chords of a loop with this number of vertices.
pub(super) struct AllChords(pub(super) usize);

fn chord_number(i: usize, k: usize) -> usize {
    k * (k - 1) / 2 + (k - 1 - i)
}

impl ChordSet for AllChords {
    fn chord_count(&self) -> usize {
        self.0 * (self.0 - 1) / 2
    }

    fn find_chord_number(&self, i: usize, k: usize) -> Option<usize> {
        Some(chord_number(i, k))
    }

    fn try_each_chord(&self, mut visit: impl FnMut(usize, [usize; 2]) -> Result<()>) -> Result<()> {
        (1..self.0).try_for_each(|k| (0..k).rev().try_for_each(|i| visit(chord_number(i, k), [i, k])))
    }

    fn visit_apexes(&self, i: usize, k: usize, mut visit: impl FnMut(usize, [usize; 2])) {
        (i + 1..k).for_each(|m| visit(m, [chord_number(i, m), chord_number(m, k)]));
    }
}

/// A sparse set of chords, indexed by both ends.
pub(super) struct ChordsNearTriangulation {
    /// The chords (i, k) of one k occupy `first[start[k]..start[k + 1]]`. A chord's number is its
    /// index in `first_ends`.
    starts_by_second_end: Vec<u32>,
    /// The ends i, descending for each k.
    first_ends: Vec<u32>,
    /// For each i, the chords (i, k) as pairs of k, ascending, and the chord's number.
    chords_by_first_end: Buckets<(u32, u32)>,
}

impl ChordsNearTriangulation {
    /// Builds the chords near a coarse triangulation of a loop of `n` vertices.
    ///
    /// `triangles` triangulates the vertices `kept` of the loop. The set has the edges of the loop,
    /// the chords that cut off one vertex, and the chord from the first to the last vertex. It also
    /// has each chord whose ends lie at most `band` vertices from the ends of a side of
    /// `triangles`. O(band^2 n) time and memory.
    pub(super) fn new(n: usize, triangles: &[[u32; 3]], kept: &[u32], band: u32) -> Result<ChordsNearTriangulation> {
        // Each chord is the longest side of exactly one triangle, in the numbering of the vertices.
        let edges = (1..kept.len() as u32).map(|v| (v - 1, v));
        let given = triangles.iter().map(|&[a, _, c]| (a, c)).chain(edges);
        let around = |v: u32| {
            let v = kept[v as usize];
            v.saturating_sub(band)..=(v + band).min(n as u32 - 1)
        };
        let near = given.flat_map(|(u, v)| around(u).flat_map(move |i| around(v).map(move |k| (k as usize, i))));
        let near = near.filter(|&(k, i)| (i as usize) < k);
        let short = (0..n).flat_map(|k| (k.saturating_sub(2)..k).map(move |i| (k, i as u32)));
        let all = near.chain(short).chain([(n - 1, 0)]);
        let (mut start, mut first) = Buckets::new(n, 0u32, all)?.into_parts();
        let (mut from, mut count) = (0, 0);
        for k in 0..n {
            let to = start[k + 1] as usize;
            sort::sort_stable(&mut first[from..to], &|a, b| b.cmp(a));
            let begin = count;
            for at in from..to {
                if count == begin || first[count - 1] != first[at] {
                    first[count] = first[at];
                    count += 1;
                }
            }
            from = to;
            start[k + 1] = count as u32;
        }
        first.truncate(count);
        let places = (0..n).flat_map(|k| (start[k]..start[k + 1]).map(move |number| (k, number)));
        let after =
            Buckets::new(n, (0, 0), places.map(|(k, number)| (first[number as usize] as usize, (k as u32, number))))?;
        Ok(ChordsNearTriangulation { starts_by_second_end: start, first_ends: first, chords_by_first_end: after })
    }

    fn chord_starts_to(&self, k: usize) -> &[u32] {
        &self.first_ends[self.starts_by_second_end[k] as usize..self.starts_by_second_end[k + 1] as usize]
    }
}

impl ChordSet for ChordsNearTriangulation {
    fn chord_count(&self) -> usize {
        self.first_ends.len()
    }

    fn find_chord_number(&self, i: usize, k: usize) -> Option<usize> {
        let after = self.chords_by_first_end.get(i);
        after.binary_search_by_key(&(k as u32), |&(k, _)| k).ok().map(|at| after[at].1 as usize)
    }

    fn try_each_chord(&self, mut visit: impl FnMut(usize, [usize; 2]) -> Result<()>) -> Result<()> {
        for k in 0..self.starts_by_second_end.len() - 1 {
            for number in self.starts_by_second_end[k] as usize..self.starts_by_second_end[k + 1] as usize {
                visit(number, [self.first_ends[number] as usize, k])?;
            }
        }
        Ok(())
    }

    fn visit_apexes(&self, i: usize, k: usize, mut visit: impl FnMut(usize, [usize; 2])) {
        let (after, before, start) =
            (self.chords_by_first_end.get(i), self.chord_starts_to(k), self.starts_by_second_end[k] as usize);
        // Walk the shorter list, and search the longer one.
        if after.len() <= before.len() {
            for &(m, left) in after.iter().take_while(|&&(m, _)| (m as usize) < k) {
                if let Ok(at) = before.binary_search_by(|v| m.cmp(v)) {
                    visit(m as usize, [left as usize, start + at]);
                }
            }
        } else {
            for (at, &m) in before.iter().enumerate().rev().skip_while(|&(_, &m)| m as usize <= i) {
                if let Ok(left) = after.binary_search_by_key(&m, |&(m, _)| m) {
                    visit(m as usize, [after[left].1 as usize, start + at]);
                }
            }
        }
    }
}
