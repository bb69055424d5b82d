//! Seams whose nodes go elsewhere.

use crate::alloc;
use crate::error::Result;
use crate::net::topology::{Run, Seam};

/// Row and column, or a step from one to the next.
type Place = (i64, i64);

/// A run of pairs, while it is being put together.
#[derive(Clone, Copy)]
struct Piece {
    first: [Place; 2],
    last: [Place; 2],
    count: u32,
}

impl Piece {
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

/// Appends what becomes of a seam whose nodes go where `place` says, or are left out.
///
/// Where the steps change the seam is cut, and the two pieces share the pair between them: that is how [`joined`] knows
/// them again. O(pairs).
pub(crate) fn carried(seam: Seam, place: impl Fn(Place) -> Option<Place>, out: &mut Vec<Seam>) -> Result<()> {
    let mut flush = |piece: Option<Piece>| match piece {
        // Pairs of a node and itself say nothing.
        Some(piece) if piece.first[0] != piece.first[1] || piece.last[0] != piece.last[1] => {
            alloc::push(out, piece.seam())
        }
        _ => Ok(()),
    };
    let mut current: Option<Piece> = None;
    for k in 0..seam.count {
        let (Some(a), Some(b)) = (place(seam.a.place(k)), place(seam.b.place(k))) else {
            flush(current.take())?;
            continue;
        };
        let pair = [a, b];
        current = Some(match current {
            None => Piece { first: pair, last: pair, count: 1 },
            Some(piece) if piece.last == pair => piece,
            Some(piece) if piece.count == 1 || step(piece.last, pair) == piece.step() => {
                Piece { last: pair, count: piece.count + 1, ..piece }
            }
            Some(piece) => {
                flush(Some(piece))?;
                Piece { first: piece.last, last: pair, count: 2 }
            }
        });
    }
    flush(current)
}

/// A seam in one of the four ways to write it: the pair it begins with, and the steps from there.
type Way = ([Place; 2], [Place; 2]);

/// Seams of which each begins with the pair that another ends with, and goes on in the same steps, made one. O(s log s).
pub(crate) fn joined(seams: &[Seam]) -> Result<Vec<Seam>> {
    let mut starts: Vec<(Way, usize)> = alloc::with_capacity(4 * seams.len())?;
    for (index, seam) in seams.iter().enumerate().filter(|(_, seam)| seam.count > 1) {
        starts.extend(ways(*seam).map(|way| (way, index)));
    }
    starts.sort_unstable();
    let mut used = alloc::filled(false, seams.len())?;
    let mut out = alloc::with_capacity(seams.len())?;
    for (index, &seam) in seams.iter().enumerate() {
        if std::mem::replace(&mut used[index], true) {
            continue;
        }
        let mut whole = seam;
        // Onward from the last pair, then, turned round, onward from the first.
        for _ in 0..if seam.count > 1 { 2 } else { 0 } {
            let (_, steps) = ways(whole)[0];
            while let Some(next) = onward(&starts, &used, end(whole), steps) {
                used[next] = true;
                whole.count += seams[next].count - 1;
            }
            whole = turned(whole);
        }
        out.push(whole);
    }
    Ok(out)
}

/// The first unused seam that begins with a pair and has these steps.
fn onward(starts: &[(Way, usize)], used: &[bool], pair: [Place; 2], steps: [Place; 2]) -> Option<usize> {
    let from = starts.partition_point(|&(way, _)| way < (pair, steps));
    let here = starts[from..].iter().take_while(|&&(way, _)| way == (pair, steps));
    here.map(|&(_, index)| index).find(|&index| !used[index])
}

fn end(seam: Seam) -> [Place; 2] {
    [seam.a.place(seam.count - 1), seam.b.place(seam.count - 1)]
}

fn turned(seam: Seam) -> Seam {
    let turn = |run: Run| {
        let (row, column) = run.place(seam.count - 1);
        Run { row: row as u32, column: column as u32, row_step: -run.row_step, column_step: -run.column_step }
    };
    Seam { a: turn(seam.a), b: turn(seam.b), count: seam.count }
}

fn ways(seam: Seam) -> [Way; 4] {
    let steps = |run: Run| (i64::from(run.row_step), i64::from(run.column_step));
    let way = |seam: Seam| ([seam.a.place(0), seam.b.place(0)], [steps(seam.a), steps(seam.b)]);
    let swapped = |([p, q], [s, t]): Way| ([q, p], [t, s]);
    let (there, back) = (way(seam), way(turned(seam)));
    [there, swapped(there), back, swapped(back)]
}
