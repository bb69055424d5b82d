//! Few vertices: all trees of bridges are tried.
//!
//! Every triangulation has one tree of shortest bridges, which Prim's algorithm finds from its
//! shortest bridge on. With the bridges in order of length each step says which are not there: all
//! that are shorter than the one taken and lead, as it does, from the loops already joined to the
//! others. So each triangulation comes up once only, and the longer the bridges, the fewer chords
//! there are to try.

use super::super::chords::All;
use super::super::weigh::Cost;
use super::numbered_rims::Rims;
use super::opened::Opened;
use super::task::{Closed, Repeats, Task};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort;

/// So many triangles may be looked at: about 50 ms.
pub(super) const MAX_WORK: f64 = 4e6;

/// How many triangles are looked at for loops of these lengths, about; more than [`MAX_WORK`] if
/// there are too many loops.
pub(super) fn work(lengths: impl Iterator<Item = usize> + Clone) -> f64 {
    let loops = lengths.clone().count();
    let count: usize = lengths.clone().sum();
    let squares: usize = lengths.map(|n| n * n).sum();
    let bridges = (count * count - squares) as f64 / 2.0;
    let trees = match loops {
        2 => bridges,
        3 => bridges * bridges / 3.0,
        _ => f64::INFINITY,
    };
    trees * triangles(count + 2 * loops - 2)
}

/// How many are looked at for one polygon of so many vertices.
pub(super) fn triangles(n: usize) -> f64 {
    (n as f64).powi(3) / 6.0
}

/// The bridges by length, and where each is.
struct Bridges {
    /// Their ends, the smaller first.
    sorted: Vec<[u32; 2]>,
    /// At u n + v the place of (u, v) among them.
    rank: Vec<u32>,
}

impl Bridges {
    fn new(task: &Task<'_>) -> Result<Bridges> {
        let n = task.rims.count() as u32;
        let pairs = (0..n).flat_map(|u| (u + 1..n).map(move |v| [u, v]));
        let mut sorted = alloc::gather(pairs.filter(|&[u, v]| task.rims.joins(u, v) && !(task.taken)(u, v)))?;
        let squared = |[u, v]: [u32; 2]| task.rims.squared(u, v);
        sort::stable(&mut sorted, &|&x, &y| squared(x).total_cmp(&squared(y)).then(x.cmp(&y)));
        let mut rank = alloc::filled(0, (n * n) as usize)?;
        for (&[u, v], at) in sorted.iter().zip(0..) {
            rank[(u * n + v) as usize] = at;
            rank[(v * n + u) as usize] = at;
        }
        Ok(Bridges { sorted, rank })
    }

    fn rank(&self, rims: &Rims, u: u32, v: u32) -> u32 {
        self.rank[u as usize * rims.count() + v as usize]
    }
}

/// Some loops joined by a tree.
struct Branch {
    opened: Opened,
    is_joined: Vec<bool>,
    /// At i k + j the least place in [`Bridges`] that one between the loops i and j may have.
    least: Vec<u32>,
}

impl Branch {
    /// With one more loop, joined at a place to a vertex by the bridge of this rank.
    fn with(&self, rims: &Rims, place: usize, v: u32, rank: u32) -> Result<Branch> {
        let ring = rims.ring[v as usize] as usize;
        let (mut is_joined, mut least) = (alloc::copied(&self.is_joined)?, alloc::copied(&self.least)?);
        let k = is_joined.len();
        for (i, j) in (0..k).flat_map(|i| (0..k).map(move |j| (i, j))) {
            if is_joined[i] != is_joined[j] {
                least[i * k + j] = least[i * k + j].max(rank);
            }
        }
        is_joined[ring] = true;
        Ok(Branch { opened: self.opened.joined(place, rims.range(ring), v)?, is_joined, least })
    }
}

struct Search<'a> {
    task: &'a Task<'a>,
    bridges: Bridges,
    best: Option<Closed>,
    /// What costs no less is passed over.
    limit: Option<Cost>,
    repeats: usize,
}

/// So many searches of one polygon more where edges come twice that they are as much work again.
pub(super) fn repeats(rims: &Rims) -> usize {
    (MAX_WORK / triangles(rims.count() + 2 * rims.loops() - 2)) as usize
}

/// The best triangulation that costs less than `limit`: all are tried. By area it is the least there
/// is, unless edges come twice in more searches than `repeats`; bends and bulges as the search of a
/// single loop treats them.
///
/// O(trees n^3).
pub(super) fn exact(task: &Task<'_>, limit: Option<Cost>, repeats: usize, job: &Job<'_>) -> Result<Option<Closed>> {
    let (rims, k) = (task.rims, task.rims.loops());
    let mut search = Search { task, bridges: Bridges::new(task)?, best: None, limit, repeats };
    let count = search.bridges.sorted.len();
    for rank in 0..count {
        let [u, v] = search.bridges.sorted[rank];
        let ring = rims.ring[u as usize] as usize;
        let range = rims.range(ring);
        let place = (u - range.start) as usize;
        let mut is_joined = alloc::filled(false, k)?;
        is_joined[ring] = true;
        // The first bridge is the shortest of all.
        let least = alloc::filled(rank as u32, k * k)?;
        let alone = Branch { opened: Opened::loop_of(range)?, is_joined, least };
        search.branch(alone.with(rims, place, v, rank as u32)?, &job.share(rank, count))?;
    }
    Ok(search.best)
}

impl Search<'_> {
    fn branch(&mut self, branch: Branch, job: &Job<'_>) -> Result<()> {
        let rims = self.task.rims;
        let ring = |v: u32| rims.ring[v as usize] as usize;
        let k = rims.loops();
        let least = |u: u32, v: u32| branch.least[ring(u) * k + ring(v)];
        if branch.is_joined.iter().all(|&is_joined| is_joined) {
            let bridges = &self.bridges;
            let excluded = |u: u32, v: u32| rims.joins(u, v) && bridges.rank(rims, u, v) < least(u, v);
            let chords = All(branch.opened.len());
            let limit = self.best.as_ref().map(|best| &best.cost).or(self.limit.as_ref());
            let repeats = Repeats::Both(&mut self.repeats);
            let found = self.task.search(branch.opened, &chords, &excluded, limit, repeats, job)?;
            self.best = found.or(self.best.take());
            return Ok(());
        }
        let others = (0..rims.count() as u32).filter(|&v| !branch.is_joined[ring(v)]);
        let places = branch.opened.order.iter().enumerate();
        let mut next = alloc::gather(others.flat_map(|v| places.clone().map(move |(place, &u)| (u, v, place))))?;
        next.retain(|&(u, v, _)| !(self.task.taken)(u, v) && self.bridges.rank(rims, u, v) > least(u, v));
        sort::stable(&mut next, &|x, y| {
            let key = |&(u, v, place): &(u32, u32, usize)| (self.bridges.rank(rims, u, v), place);
            key(x).cmp(&key(y))
        });
        for (u, v, place) in next {
            self.branch(branch.with(rims, place, v, self.bridges.rank(rims, u, v))?, job)?;
        }
        Ok(())
    }
}
