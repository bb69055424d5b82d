//! Closed surfaces by formula, and pieces cut from them.

use crate::common::Soup;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// A sphere of `n` meridians and `rings` rings between the poles, a little out of round so that
/// nothing is as near as anything else.
pub(crate) fn sphere(n: u32, rings: u32) -> Soup {
    let mut soup = Soup { points: vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]], offsets: vec![0], ..Soup::default() };
    let at = |r: u32, i: u32| 2 + r * n + i % n;
    for r in 0..rings {
        let theta = TAU / 2.0 * f64::from(r + 1) / f64::from(rings + 1);
        for i in 0..n {
            let phi = TAU * (f64::from(i) + 0.1 * f64::from(r)) / f64::from(n);
            soup.points.push([1.1 * theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]);
        }
    }
    for i in 0..n {
        soup.face(&[0, at(0, i), at(0, i + 1)]);
        for r in 1..rings {
            soup.face(&[at(r - 1, i), at(r, i), at(r, i + 1), at(r - 1, i + 1)]);
        }
        soup.face(&[1, at(rings - 1, i + 1), at(rings - 1, i)]);
    }
    soup
}

/// The surface of a cube of n^3 cells, faces outwards.
pub(crate) fn cube(n: i32) -> Soup {
    let (mut soup, mut numbers) = (Soup { offsets: vec![0], ..Soup::default() }, HashMap::new());
    for axis in 0..3 {
        for side in [0, n] {
            for (u, v) in (0..n * n).map(|k| (k / n, k % n)) {
                let mut square = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)];
                if side == 0 {
                    square.reverse();
                }
                let face = square.map(|(u, v)| {
                    let mut p = [side; 3];
                    (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (u, v);
                    *numbers.entry(p).or_insert_with(|| {
                        soup.points.push(p.map(|x| f64::from(x) / f64::from(n) - 0.5));
                        soup.points.len() as u32 - 1
                    })
                });
                soup.face(&face);
            }
        }
    }
    soup
}

/// Pieces by the colours of the faces, from their centres, each with vertices of its own; faces
/// without a colour are left out.
pub(crate) fn cut(whole: &Soup, colour: impl Fn([f64; 3]) -> Option<usize>) -> Vec<Soup> {
    let (mut pieces, mut numbers): (Vec<Soup>, Vec<HashMap<u32, u32>>) = (Vec::new(), Vec::new());
    for face in whole.faces() {
        let mean = |k: usize| face.iter().map(|&v| whole.points[v as usize][k]).sum::<f64>() / face.len() as f64;
        let Some(c) = colour([mean(0), mean(1), mean(2)]) else { continue };
        if pieces.len() <= c {
            pieces.resize(c + 1, Soup { offsets: vec![0], ..Soup::default() });
            numbers.resize(c + 1, HashMap::new());
        }
        let piece = &mut pieces[c];
        let renumbered: Vec<u32> = face
            .iter()
            .map(|&v| {
                *numbers[c].entry(v).or_insert_with(|| {
                    piece.points.push(whole.points[v as usize]);
                    piece.points.len() as u32 - 1
                })
            })
            .collect();
        piece.face(&renumbered);
    }
    pieces.retain(|piece| piece.offsets.len() > 1);
    pieces
}

/// The part of a turn that lies before a point, from 0 to 1.
pub(crate) fn around(p: [f64; 3]) -> f64 {
    (p[1].atan2(p[0]) / TAU).rem_euclid(1.0)
}

/// Each piece moved towards its own middle.
pub(crate) fn shrunk(mut pieces: Vec<Soup>, by: f64) -> Vec<Soup> {
    for piece in &mut pieces {
        let count = piece.points.len() as f64;
        let middle = [0, 1, 2].map(|k| piece.points.iter().map(|p| p[k]).sum::<f64>() / count);
        piece.points.iter_mut().for_each(|p| *p = [0, 1, 2].map(|k| p[k] + by * (middle[k] - p[k])));
    }
    pieces
}
