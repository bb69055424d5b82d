//! Which triangles cut each other, in integers: slow, exact, and by another way than the library's,
//! which asks edges about triangles. Here two planes meet in a line, and the parts of that line
//! that lie in the triangles are compared.

use std::cmp::Ordering;
use std::ops::Range;

/// A point of whole coordinates.
pub type Point = [i64; 3];

fn from_to(p: Point, q: Point) -> [i128; 3] {
    [0, 1, 2].map(|k| i128::from(q[k]) - i128::from(p[k]))
}

fn cross(u: [i128; 3], v: [i128; 3]) -> [i128; 3] {
    [0, 1, 2].map(|k| u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3])
}

fn dot(u: [i128; 3], v: [i128; 3]) -> i128 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// The normal; 0 for a triangle without area.
fn normal(t: [Point; 3]) -> [i128; 3] {
    cross(from_to(t[0], t[1]), from_to(t[0], t[2]))
}

/// A fraction; the denominator is positive.
#[derive(Clone, Copy)]
struct Ratio(i128, i128);

impl Ratio {
    fn cmp(&self, other: &Ratio) -> Ordering {
        (self.0 * other.1).cmp(&(other.0 * self.1))
    }
}

/// The least and the greatest coordinate along `axis` of the points where a triangle is at height
/// 0.
fn span(t: [Point; 3], heights: [i128; 3], axis: usize) -> Option<[Ratio; 2]> {
    let mut found = Vec::new();
    for k in 0..3 {
        let (h, i, x, y) = (heights[k], heights[(k + 1) % 3], i128::from(t[k][axis]), i128::from(t[(k + 1) % 3][axis]));
        if h == 0 {
            found.push(Ratio(x, 1));
        }
        if h.signum() * i.signum() < 0 {
            found.push(Ratio((x * i - y * h) * (i - h).signum(), (i - h).abs()));
        }
    }
    Some([*found.iter().min_by(|x, y| x.cmp(y))?, *found.iter().max_by(|x, y| x.cmp(y))?])
}

/// Triangles in one plane, seen along `axis`; the first `shared` vertices of both are the same.
fn cut_in_plane(p: [Point; 3], q: [Point; 3], shared: usize, axis: usize) -> bool {
    let turn = |a: Point, b: Point, c: Point| cross(from_to(a, b), from_to(a, c))[axis].signum();
    match shared {
        // Apart if an edge of one has the other one strictly on its far side.
        0 => ![(p, q), (q, p)].iter().any(|&(p, q)| {
            let inside = turn(p[0], p[1], p[2]);
            (0..3).any(|k| q.iter().all(|&v| turn(p[k], p[(k + 1) % 3], v) * inside < 0))
        }),
        // The angles at the vertex overlap if a side of one lies in the other.
        1 => [(p, q), (q, p)].iter().any(|&(p, q)| {
            let side = turn(p[0], p[1], p[2]);
            q[1..].iter().any(|&v| turn(p[0], p[1], v) * side >= 0 && turn(p[0], v, p[2]) * side >= 0)
        }),
        2 => turn(p[0], p[1], p[2]) == turn(p[0], p[1], q[2]),
        _ => true,
    }
}

/// Do two triangles with an area have points in common, what lies at vertices of both, and between
/// these, apart?
fn cut(v: [Point; 3], w: [Point; 3]) -> bool {
    let shared: Vec<Point> = v.iter().copied().filter(|x| w.contains(x)).collect();
    let first = |t: [Point; 3]| {
        let mut order = shared.clone();
        order.extend(t.iter().filter(|x| !shared.contains(x)));
        [order[0], order[1], order[2]]
    };
    let (p, q) = (first(v), first(w));
    let (n, m) = (normal(p), normal(q));
    let line = cross(n, m);
    let Some(axis) = (0..3).find(|&k| line[k] != 0) else {
        let axis = (0..3).find(|&k| n[k] != 0).unwrap();
        return dot(n, from_to(p[0], q[0])) == 0 && cut_in_plane(p, q, shared.len(), axis);
    };
    let spans =
        [span(p, p.map(|x| dot(m, from_to(q[0], x))), axis), span(q, q.map(|x| dot(n, from_to(p[0], x))), axis)];
    let [Some([low, high]), Some([from, to])] = spans else { return false };
    let low = if low.cmp(&from).is_lt() { from } else { low };
    let high = if high.cmp(&to).is_gt() { to } else { high };
    match shared.len() {
        0 => low.cmp(&high).is_le(),
        1 => low.cmp(&high).is_lt(),
        _ => false,
    }
}

/// Whether each triangle has an area.
pub fn have_area(triangles: &[[Point; 3]]) -> Vec<bool> {
    triangles.iter().map(|&t| normal(t) != [0; 3]).collect()
}

/// All pairs of triangles with an area that cut each other. The first one of a pair is in `later`, the second one
/// comes before it.
pub fn cut_pairs(triangles: &[[Point; 3]], later: Range<u32>) -> Vec<[u32; 2]> {
    let has_area = have_area(triangles);
    let mut found = Vec::new();
    for f in later.filter(|&f| has_area[f as usize]) {
        let before = (0..f).filter(|&g| has_area[g as usize]);
        found.extend(before.filter(|&g| cut(triangles[f as usize], triangles[g as usize])).map(|g| [f, g]));
    }
    found
}
