//! Points between the marks of an arc: where the arc is a graph, each is the root of a polynomial in the other parameter, so that they lie
//! on the interpolant whatever their distance.

use super::cell::{Graph, Link};
use super::side::bracketed;
use crate::carcass::Patch;
use crate::carcass::solve::{Field, polynomial};
use glam::{DVec2, DVec3};

/// Halvings of an arc.
const DEPTH: u32 = 12;

/// An arc over its patch.
struct Curve<'a, const N: usize, const M: usize> {
    patch: &'a Patch<N>,
    field: &'a Field<M>,
    graph: Graph,
    chord: f64,
}

/// A place on it.
#[derive(Clone, Copy)]
struct Node {
    at: DVec2,
    point: DVec3,
}

/// Adds the places between the ends of an arc that keep the chords within `chord` of it, as seen at their middles and quarters.
pub(super) fn refine<const N: usize, const M: usize>(
    patch: &Patch<N>,
    field: &Field<M>,
    link: &Link,
    chord: f64,
    places: &mut Vec<DVec2>,
) {
    let Some(graph) = link.graph else { return };
    let curve = Curve { patch, field, graph, chord };
    let [from, to] = [link.from.at, link.to.at].map(|at| Node { at, point: patch.point(at.x, at.y) });
    let middle = curve.between(from, to);
    curve.halve(from, middle, to, DEPTH, places);
}

impl<const N: usize, const M: usize> Curve<'_, N, M> {
    /// The place whose parameter is amid two others.
    fn between(&self, a: Node, b: Node) -> Node {
        let Graph { over, range } = self.graph;
        let along = 0.5 * (a.at[over] + b.at[over]);
        let c: [f64; M] = match over {
            0 => std::array::from_fn(|k| polynomial(&self.field.c.map(|row| row[k]), along)[0]),
            _ => self.field.c.map(|row| polynomial(&row, along)[0]),
        };
        let mut at = DVec2::splat(along);
        at[1 - over] = bracketed(&c, range);
        Node { at, point: self.patch.point(at.x, at.y) }
    }

    /// Adds what is needed between `from` and `to`, whose middle is known.
    fn halve(&self, from: Node, middle: Node, to: Node, depth: u32, places: &mut Vec<DVec2>) {
        let quarters = [self.between(from, middle), self.between(middle, to)];
        let far = |node: &Node| distance_squared(node.point, from.point, to.point) > self.chord * self.chord;
        if depth == 0 || ![quarters[0], middle, quarters[1]].iter().any(far) {
            return;
        }
        self.halve(from, quarters[0], middle, depth - 1, places);
        places.push(middle.at);
        self.halve(middle, quarters[1], to, depth - 1, places);
    }
}

/// The square of the distance of a point from a segment.
fn distance_squared(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let (from, along) = (point - a, b - a);
    let length = along.length_squared();
    let t = if length > 0.0 { (from.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    (from - t * along).length_squared()
}
