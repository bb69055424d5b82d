//! Seams under maps of nodes: cut where the image is no longer in equal steps, and merged again.
//!
//! Invariant: two parts of a cut seam share the pair between them, so that [`merge_seams`] undoes
//! [`map_seam`] followed by the inverse map. O(pairs), and O(s log s) for s seams.

use crate::topology::{Run, Seam};
use gusset_base::alloc;
use gusset_base::error::Result;

/// Row and column, or a step from one to the next.
type Place = (i64, i64);

/// Returns the seam of `count` pairs from the first one on, in equal steps.
fn seam_from(first: [Place; 2], steps: [Place; 2], count: u32) -> Seam {
    let [a, b] = [0, 1].map(|k| Run {
        row: first[k].0 as u32,
        column: first[k].1 as u32,
        row_step: steps[k].0 as i32,
        column_step: steps[k].1 as i32,
    });
    Seam { a, b, count }
}

fn steps([p, q]: [Place; 2], [r, s]: [Place; 2]) -> [Place; 2] {
    [(r.0 - p.0, r.1 - p.1), (s.0 - q.0, s.1 - q.1)]
}

/// Appends the image of a seam under a map of nodes that may drop some. The image is cut where its
/// steps change. O(pairs).
pub(crate) fn map_seam(seam: Seam, place: impl Fn(Place) -> Option<Place>, out: &mut Vec<Seam>) -> Result<()> {
    // A pair of a node and itself glues nothing.
    let glues = |piece: &Seam| [start(*piece).0, end(*piece)].iter().any(|[a, b]| a != b);
    let mut flush = |piece: Option<Seam>| piece.filter(glues).map_or(Ok(()), |piece| alloc::push(out, piece));
    let mut current: Option<Seam> = None;
    for k in 0..seam.count {
        let (Some(a), Some(b)) = (place(seam.a.place(k)), place(seam.b.place(k))) else {
            flush(current.take())?;
            continue;
        };
        let pair = [a, b];
        current = Some(match current {
            None => seam_from(pair, [(0, 0); 2], 1),
            Some(piece) if end(piece) == pair => piece,
            Some(piece) if piece.count == 1 => seam_from(end(piece), steps(end(piece), pair), 2),
            Some(piece) if steps(end(piece), pair) == start(piece).1 => Seam { count: piece.count + 1, ..piece },
            Some(piece) => {
                flush(Some(piece))?;
                seam_from(end(piece), steps(end(piece), pair), 2)
            }
        });
    }
    flush(current)
}

/// The start of a seam in one of its spellings: its first pair and its steps.
type Start = ([Place; 2], [Place; 2]);

/// Merges seams that continue each other: one begins with the last pair of another and has its
/// steps. O(s log s).
pub(crate) fn merge_seams(seams: &[Seam]) -> Result<Vec<Seam>> {
    let mut starts: Vec<(Start, usize)> = alloc::with_capacity(4 * seams.len())?;
    for (index, seam) in seams.iter().enumerate().filter(|(_, seam)| seam.count > 1) {
        starts.extend(seam.spellings().map(|seam| (start(seam), index)));
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
            let (_, steps) = start(whole);
            while let Some(next) = continuation(&starts, &used, (end(whole), steps)) {
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
fn continuation(starts: &[(Start, usize)], used: &[bool], wanted: Start) -> Option<usize> {
    let from = starts.partition_point(|&(start, _)| start < wanted);
    let here = starts[from..].iter().take_while(|&&(start, _)| start == wanted);
    here.map(|&(_, index)| index).find(|&index| !used[index])
}

fn end(seam: Seam) -> [Place; 2] {
    [seam.a.place(seam.count - 1), seam.b.place(seam.count - 1)]
}

fn start(seam: Seam) -> Start {
    let steps = |run: Run| (i64::from(run.row_step), i64::from(run.column_step));
    ([seam.a.place(0), seam.b.place(0)], [steps(seam.a), steps(seam.b)])
}
