//! Seams under maps of nodes: cut where the image is no longer in equal steps, and merged again.
//!
//! Invariant: two parts of a cut seam share the pair between them, so that [`merge_seams`] undoes
//! [`map_seam`] followed by the inverse map. O(pairs), and O(s log s) for s seams.

use crate::alloc;
use crate::error::Result;
use crate::net::topology::{Run, Seam};

/// Row and column, or a step from one to the next.
type Place = (i64, i64);

/// Consecutive pairs in equal steps, while they are collected.
#[derive(Clone, Copy)]
struct PartialSeam {
    first: [Place; 2],
    last: [Place; 2],
    count: u32,
}

impl PartialSeam {
    fn step(&self) -> [Place; 2] {
        let n = i64::from(self.count.max(2) - 1);
        [0, 1].map(|k| ((self.last[k].0 - self.first[k].0) / n, (self.last[k].1 - self.first[k].1) / n))
    }

    fn seam(&self) -> Seam {
        let step = self.step();
        let run = |k: usize| Run {
            row: self.first[k].0 as u32,
            column: self.first[k].1 as u32,
            row_step: step[k].0 as i32,
            column_step: step[k].1 as i32,
        };
        Seam { a: run(0), b: run(1), count: self.count }
    }
}

fn step([p, q]: [Place; 2], [r, s]: [Place; 2]) -> [Place; 2] {
    [(r.0 - p.0, r.1 - p.1), (s.0 - q.0, s.1 - q.1)]
}

/// Appends the image of a seam under a map of nodes that may drop some. The image is cut where its
/// steps change. O(pairs).
pub(crate) fn map_seam(seam: Seam, place: impl Fn(Place) -> Option<Place>, out: &mut Vec<Seam>) -> Result<()> {
    let mut flush = |piece: Option<PartialSeam>| match piece {
        // A pair of a node and itself glues nothing.
        Some(piece) if piece.first[0] != piece.first[1] || piece.last[0] != piece.last[1] => {
            alloc::push(out, piece.seam())
        }
        _ => Ok(()),
    };
    let mut current: Option<PartialSeam> = None;
    for k in 0..seam.count {
        let (Some(a), Some(b)) = (place(seam.a.place(k)), place(seam.b.place(k))) else {
            flush(current.take())?;
            continue;
        };
        let pair = [a, b];
        current = Some(match current {
            None => PartialSeam { first: pair, last: pair, count: 1 },
            Some(piece) if piece.last == pair => piece,
            Some(piece) if piece.count == 1 || step(piece.last, pair) == piece.step() => {
                PartialSeam { last: pair, count: piece.count + 1, ..piece }
            }
            Some(piece) => {
                flush(Some(piece))?;
                PartialSeam { first: piece.last, last: pair, count: 2 }
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

/// The first unused seam with a given start.
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
