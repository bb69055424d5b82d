//! Seams under maps of nodes: cut where the image is no longer in equal steps, and merged again.
//!
//! Invariant: two parts of a cut seam share the pair between them, so that [`merge_seams`] undoes
//! [`map_seam`] followed by the inverse map. O(pairs), and O(s log s) for s seams.

use crate::topology::{Seam, SeamRun};
use gusset_base::alloc;
use gusset_base::error::Result;

/// Row and column, or a step from one to the next.
type RowColumn = (i64, i64);

/// Returns the seam of `count` pairs from the first one on, in equal steps.
fn seam_from_steps(first: [RowColumn; 2], steps: [RowColumn; 2], count: u32) -> Seam {
    let [a, b] = [0, 1].map(|k| SeamRun {
        row: first[k].0 as u32,
        column: first[k].1 as u32,
        row_step: steps[k].0 as i32,
        column_step: steps[k].1 as i32,
    });
    Seam { a, b, count }
}

fn steps_between([p, q]: [RowColumn; 2], [r, s]: [RowColumn; 2]) -> [RowColumn; 2] {
    [(r.0 - p.0, r.1 - p.1), (s.0 - q.0, s.1 - q.1)]
}

/// Appends the image of a seam under a map of nodes that may drop some. The image is cut where its
/// steps change. O(pairs).
pub(crate) fn map_seam(
    seam: Seam,
    map_place: impl Fn(RowColumn) -> Option<RowColumn>,
    out: &mut Vec<Seam>,
) -> Result<()> {
    // A pair of a node and itself glues nothing.
    let glues = |piece: &Seam| [seam_start(*piece).0, last_pair(*piece)].iter().any(|[a, b]| a != b);
    let mut flush = |piece: Option<Seam>| piece.filter(glues).map_or(Ok(()), |piece| alloc::push(out, piece));
    let mut current: Option<Seam> = None;
    for k in 0..seam.count {
        let (Some(a), Some(b)) =
            (map_place(seam.a.row_and_column_of_node(k)), map_place(seam.b.row_and_column_of_node(k)))
        else {
            flush(current.take())?;
            continue;
        };
        let pair = [a, b];
        current = Some(match current {
            None => seam_from_steps(pair, [(0, 0); 2], 1),
            Some(piece) if last_pair(piece) == pair => piece,
            Some(piece) if piece.count == 1 => {
                seam_from_steps(last_pair(piece), steps_between(last_pair(piece), pair), 2)
            }
            Some(piece) if steps_between(last_pair(piece), pair) == seam_start(piece).1 => {
                Seam { count: piece.count + 1, ..piece }
            }
            Some(piece) => {
                flush(Some(piece))?;
                seam_from_steps(last_pair(piece), steps_between(last_pair(piece), pair), 2)
            }
        });
    }
    flush(current)
}

/// The start of a seam in one of its spellings: its first pair and its steps.
type SeamStart = ([RowColumn; 2], [RowColumn; 2]);

/// Merges seams that continue each other: one begins with the last pair of another and has its
/// steps. O(s log s).
pub(crate) fn merge_seams(seams: &[Seam]) -> Result<Vec<Seam>> {
    let mut starts: Vec<(SeamStart, usize)> = alloc::with_capacity(4 * seams.len())?;
    for (index, seam) in seams.iter().enumerate().filter(|(_, seam)| seam.count > 1) {
        starts.extend(seam.equivalent_spellings().map(|seam| (seam_start(seam), index)));
    }
    starts.sort_unstable();
    let mut used = alloc::filled(false, seams.len())?;
    let mut out = alloc::with_capacity(seams.len())?;
    for (index, &seam) in seams.iter().enumerate() {
        if std::mem::replace(&mut used[index], true) {
            continue;
        }
        let mut whole = seam;
        // Extended from the last pair, then, reversed, from the first.
        for _ in 0..if seam.count > 1 { 2 } else { 0 } {
            let (_, steps) = seam_start(whole);
            while let Some(next) = find_unused_seam(&starts, &used, (last_pair(whole), steps)) {
                used[next] = true;
                whole.count += seams[next].count - 1;
            }
            whole = whole.reversed();
        }
        out.push(whole);
    }
    Ok(out)
}

/// Returns the first unused seam with a given start.
fn find_unused_seam(starts: &[(SeamStart, usize)], used: &[bool], wanted: SeamStart) -> Option<usize> {
    let from = starts.partition_point(|&(start, _)| start < wanted);
    let here = starts[from..].iter().take_while(|&&(start, _)| start == wanted);
    here.map(|&(_, index)| index).find(|&index| !used[index])
}

fn last_pair(seam: Seam) -> [RowColumn; 2] {
    [seam.a.row_and_column_of_node(seam.count - 1), seam.b.row_and_column_of_node(seam.count - 1)]
}

fn seam_start(seam: Seam) -> SeamStart {
    let steps = |run: SeamRun| (i64::from(run.row_step), i64::from(run.column_step));
    ([seam.a.row_and_column_of_node(0), seam.b.row_and_column_of_node(0)], [steps(seam.a), steps(seam.b)])
}
