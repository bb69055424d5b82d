//! Two loops that run side by side, closed like a zip.
//!
//! Where they are nearer to each other than the vertices of thinned loops, these say nothing of the
//! way between them. From the shortest bridge there is the triangles go round, on that loop where
//! the next bridge is shorter; what they are good for is seen by their cost.

use super::super::chords::Near;
use super::super::search::bands;
use super::improve::{FREE, REPEATS};
use super::opened::Opened;
use super::task::{Closed, Repeats, Task};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;

/// Steps from loop to loop towards a bridge that is shorter than those near it.
const MAX_STEPS: usize = 4;

/// What is found near the zip, if it is better than the best so far; that otherwise, and for other
/// than two loops.
///
/// O(n log n).
pub(super) fn zipped(task: &Task<'_>, best: Closed, job: &Job<'_>) -> Result<Closed> {
    let rims = task.rims;
    let named = best.opened.named(&best.triangles)?;
    let sides = named.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let bridges = sides.filter(|&[u, v]| rims.ring[u as usize] < rims.ring[v as usize]);
    let length = |[u, v]: [u32; 2]| rims.squared(u, v);
    let shortest = bridges.min_by(|&a, &b| length(a).total_cmp(&length(b)).then(a.cmp(&b)));
    let Some([mut u, mut v]) = shortest.filter(|_| rims.loops() == 2) else {
        return Ok(best);
    };
    // To and fro, to where the loops are near each other.
    let nearest = |ring: usize, to: u32| {
        let free = rims.range(ring).filter(|&w| !(task.taken)(to, w));
        free.min_by(|&a, &b| length([a, to]).total_cmp(&length([b, to]))).unwrap_or(to)
    };
    for _ in 0..MAX_STEPS {
        v = nearest(1, u);
        u = nearest(0, v);
    }
    let opened = Opened::loop_of(rims.range(0))?.joined(u as usize, rims.range(1), v)?;
    let triangles = zip(task, &opened, rims.range(1).len())?;
    if !task.is_less(&task.cost(&opened.named(&triangles)?)?, &best.cost) {
        return Ok(best);
    }
    let n = opened.len();
    let same = alloc::collect((0..n).map(|place| place as u32))?;
    let chords = Near::new(n, &triangles, &same, bands(n).next().unwrap_or(1))?;
    let found = task.search(opened, &chords, FREE, Some(&best.cost), Repeats::One(REPEATS), job)?;
    Ok(found.unwrap_or(best))
}

/// From the last edge of the polygon on, `first` being the place of the other end of the bridge.
fn zip(task: &Task<'_>, opened: &Opened, first: usize) -> Result<Vec<[u32; 3]>> {
    let squared = |i: usize, k: usize| task.rims.squared(opened.order[i], opened.order[k]);
    let (mut i, mut k) = (0, opened.len() - 1);
    let mut triangles = alloc::with_capacity(k - 1)?;
    while i < first || k > first + 1 {
        let onwards = k == first + 1 || i < first && squared(i + 1, k) <= squared(i, k - 1);
        let m = if onwards { i + 1 } else { k - 1 };
        triangles.push([i as u32, m as u32, k as u32]);
        (i, k) = if onwards { (m, k) } else { (i, m) };
    }
    Ok(triangles)
}
