//! Polylines. The standard lacks curves, but has faces of two corners, which are loose edges. A
//! curve continues wherever two of them meet.

use glam::DVec3;
use gusset::error::Result;
use gusset::filters::data::Curves;
use gusset::mesh::NONE;
use gusset_base::alloc;
use gusset_base::sort::Buckets;

/// Edges, and the edges at each vertex.
struct EdgeGraph<'a> {
    edges: &'a [[u32; 2]],
    /// The edges at each vertex.
    edges_at_vertex: Buckets<u32>,
    is_used_edge: Vec<bool>,
}

impl<'a> EdgeGraph<'a> {
    fn new(edges: &'a [[u32; 2]], vertex_count: usize) -> Result<Self> {
        let ends = edges.iter().zip(0..).flat_map(|(ends, edge)| ends.map(|vertex| (vertex as usize, edge)));
        Ok(EdgeGraph {
            edges,
            edges_at_vertex: Buckets::new(vertex_count, NONE, ends)?,
            is_used_edge: alloc::filled(false, edges.len())?,
        })
    }

    fn edges_at(&self, vertex: u32) -> &[u32] {
        self.edges_at_vertex.get(vertex as usize)
    }

    /// True if curves continue through a vertex, because it has two edges.
    fn has_two_edges(&self, vertex: u32) -> bool {
        self.edges_at(vertex).len() == 2
    }

    /// Uses an edge at a vertex. Returns its other end.
    fn take_unused_edge(&mut self, vertex: u32) -> Option<u32> {
        let edge = *self.edges_at(vertex).iter().find(|&&edge| !self.is_used_edge[edge as usize])?;
        self.is_used_edge[edge as usize] = true;
        let [a, b] = self.edges[edge as usize];
        Some(if a == vertex { b } else { a })
    }

    /// Follows unused edges from a vertex to the next vertex where curves end, or back to the
    /// start.
    fn follow_chain(&mut self, from: u32, chain: &mut Vec<u32>) -> Result<()> {
        chain.clear();
        alloc::push(chain, from)?;
        let mut vertex = from;
        while let Some(next) = self.take_unused_edge(vertex) {
            alloc::push(chain, next)?;
            vertex = next;
            if vertex == from || !self.has_two_edges(vertex) {
                break;
            }
        }
        Ok(())
    }
}

/// Chains edges to curves: first open curves, starting from the lowest vertex, then closed ones.
pub(super) fn chain_edges(edges: &[[u32; 2]], vertex_count: usize, place: impl Fn(u32) -> DVec3) -> Result<Curves> {
    let mut graph = EdgeGraph::new(edges, vertex_count)?;
    let mut curves = Curves { offsets: vec![0], ..Curves::default() };
    let mut chain = Vec::new();
    for pass in [false, true] {
        for vertex in 0..vertex_count as u32 {
            while graph.has_two_edges(vertex) == pass {
                graph.follow_chain(vertex, &mut chain)?;
                if chain.len() < 2 {
                    break;
                }
                let closed = chain.len() > 3 && chain.first() == chain.last();
                chain.truncate(chain.len() - usize::from(closed));
                alloc::extend(&mut curves.points, chain.iter().map(|&vertex| place(vertex).to_array()))?;
                alloc::push(&mut curves.offsets, curves.points.len() as u32)?;
                alloc::push(&mut curves.closed, closed)?;
            }
        }
    }
    Ok(curves)
}

/// The edges of curves.
pub(super) fn edges_of_curves(curves: &Curves) -> Result<Vec<[u32; 2]>> {
    let mut edges = Vec::new();
    for (ends, &closed) in curves.offsets.windows(2).zip(&curves.closed) {
        let (first, end) = (ends[0], ends[1]);
        for vertex in first + 1..end {
            alloc::push(&mut edges, [vertex - 1, vertex])?;
        }
        if closed && end - first > 2 {
            alloc::push(&mut edges, [end - 1, first])?;
        }
    }
    Ok(edges)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chains_from_edges(edges: &[[u32; 2]], count: usize) -> (Vec<Vec<u32>>, Vec<bool>) {
        let curves = chain_edges(edges, count, |vertex| DVec3::splat(f64::from(vertex))).unwrap();
        let points: Vec<u32> = curves.points.iter().map(|point| point[0] as u32).collect();
        let chains = curves.offsets.windows(2).map(|ends| points[ends[0] as usize..ends[1] as usize].to_vec());
        (chains.collect(), curves.closed)
    }

    #[test]
    fn edges_are_chained_between_ends_and_junctions() {
        // A line, a triangle, and a star of three legs, one of which has two edges; vertex 6 is
        // isolated.
        let edges = [[2, 0], [0, 1], [3, 4], [5, 4], [3, 5], [7, 8], [9, 7], [7, 10], [10, 11]];
        let (chains, closed) = chains_from_edges(&edges, 12);
        assert_eq!(chains, [vec![1, 0, 2], vec![7, 8], vec![7, 9], vec![7, 10, 11], vec![3, 4, 5]]);
        assert_eq!(closed, [false, false, false, false, true]);
    }

    #[test]
    fn every_edge_is_in_one_curve() {
        // Two loops that share a vertex, and a double edge.
        let edges = [[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0], [5, 6], [6, 5]];
        let (chains, closed) = chains_from_edges(&edges, 7);
        let count: usize =
            chains.iter().zip(&closed).map(|(chain, &closed)| chain.len() - 1 + usize::from(closed)).sum();
        assert_eq!(count, edges.len());
        assert_eq!(closed.iter().filter(|&&closed| closed).count(), 2);
    }

    #[test]
    fn curves_give_their_edges_back() {
        let points = vec![[0.0; 3]; 6];
        let curves = Curves { points, offsets: vec![0, 3, 6], closed: vec![false, true] };
        assert_eq!(edges_of_curves(&curves).unwrap(), [[0, 1], [1, 2], [3, 4], [4, 5], [5, 3]]);
    }
}
