//! The stages of assembly in order, from pieces to one mesh and its report.

use super::candidates::{Candidate, Facing, FacingSearch};
use super::given_pair::GivenPair;
use super::request::{Assembly, Joint, LeftLoop, MaxGap, Options, Outcome, Reason, Selector};
use crate::alloc;
use crate::boundary::{self, Boundary, boundary_loops};
use crate::error::{Error, Result};
use crate::fill::{self, fill_holes};
use crate::geom::Aabb;
use crate::geom::disjoint_sets::{DisjointSets, ParitySets};
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::mesh::{Defect, Mesh, MeshView, NONE, concat, vertex_components};
use crate::repair::orient::{self, Outward, turn_outwards};
use crate::repair::sew::{Sew, sew};
use crate::repair::weld::weld;
use crate::sort::sort_distinct;
use crate::stitch::combine::append_strip;
use crate::stitch::fair_and_check::fair_and_check;
use crate::stitch::pairing::mean_gap;
use crate::stitch::rim::{Bridges, Rim, is_usable, shared_vertex};
use crate::stitch::sense::{arcs_run_the_same_way, rims_disagree};
use crate::stitch::strip::Strip;
use crate::stitch::{self, IndexMap};

/// Assembles open pieces into one mesh: coincident borders are sewn, components oriented alike,
/// loops that face each other across a gap stitched, holes filled, and closed components turned
/// outwards, as the options say.
///
/// O(H log d) for the pieces' H half-edges, O(V log V) for the V vertices on loops, the time of
/// each strip as for [`stitch()`](crate::stitch::stitch()), and where strips are faired or tested
/// for intersections a pass over all faces for each. Linear extra memory.
///
/// # Errors
/// [`Error::EmptyMesh`] without pieces, [`Error::MixedScalars`], [`Error::OptionOutOfRange`] for a
/// gap or tolerance that is negative or not finite, [`Error::BadLoopPair`] for one of `pairs` or
/// `excluded` that names no loops that can be joined, [`Error::TooLarge`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`]. That two loops cannot be joined is no error: see
/// [`Joint::outcome`].
pub fn assemble(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Assembly> {
    if let MaxGap::Given(gap) = options.max_gap {
        Error::require((0.0..f64::INFINITY).contains(&gap), "max_gap", gap)?;
    }
    let mut base = Base::new(pieces, options, &job.part(0.0, 0.3))?;
    let mut loops = Loops::of(&base, &job.part(0.3, 0.4))?;
    let excluded = excluded_pairs(&base, &loops, options)?;
    let mut found = chosen_pairs(&base, &loops, options, &excluded, &job.part(0.4, 0.5))?;
    let joined_wholly = alloc::collect(found.iter().map(|facing| facing.arcs.is_none()))?;

    // Components that face each other are made to agree, nearest first.
    let outcomes = base.make_agree(&mut loops, &mut found, options.keep_orientation)?;
    base.done.joints = alloc::with_capacity(found.len())?;
    let mut hangs = alloc::filled(false, loops.rims.len())?;
    let mut tried = alloc::filled(false, loops.rims.len())?;
    let mut edges = loops.edges_between(&base.done.mesh)?;
    let mean_side = std::cell::OnceCell::new();
    options.strip.note_unread(job);
    let strips = stitch::Options { twist: 0, ..options.strip.of_strip() };
    for (k, (facing, outcome)) in found.iter().zip(outcomes).enumerate() {
        let part = job.part(0.5 + 0.3 * k as f64 / found.len() as f64, 0.5 + 0.3 * (k + 1) as f64 / found.len() as f64);
        let sides = loops.sides(facing)?;
        facing.rims.iter().for_each(|&r| tried[r] = true);
        let shared = shared_vertex(&sides[0], &sides[1])?.is_some();
        let outcome = if outcome == Outcome::Joined && shared { Outcome::ShareVertex } else { outcome };
        let whole = joined_wholly[k];
        let mut joint = Joint {
            sides: [alloc::copied(&sides[0].vertices)?, alloc::copied(&sides[1].vertices)?],
            whole,
            gap: facing.gap * loops.unit,
            outcome,
            vertices: 0..0,
            faces: 0..0,
            intersections: None,
        };
        if outcome == Outcome::Joined {
            let [a, mut b] = sides;
            b.reverse();
            let bridges = edges.between(facing.rims);
            let mean = || *mean_side.get_or_init(|| base.done.mesh.mean_side()) / loops.unit;
            match Strip::between(a, b, &bridges, &strips, mean, &part.part(0.0, 0.6)) {
                Err(Error::NoStrip { .. }) => joint.outcome = Outcome::NoStrip,
                Err(error) => return Err(error),
                Ok(mut strip) => {
                    let checked = fair_and_check(
                        &base.done.mesh,
                        &mut strip,
                        loops.unit,
                        &bridges,
                        &strips,
                        &part.part(0.6, 1.0),
                    )?;
                    let attached = append_strip(&mut base.done.mesh, &strip, loops.unit)?;
                    edges.enter_strip(&strip)?;
                    joint.sides = [strip.a.vertices, strip.b.vertices];
                    joint.vertices = attached.vertices;
                    joint.faces = attached.faces;
                    joint.intersections = checked.intersections;
                    facing.rims.iter().for_each(|&r| hangs[r] = true);
                }
            }
        }
        base.done.joints.push(joint);
    }
    base.done.left = left_loops(loops, options, &excluded, [&hangs, &tried])?;
    let is_near = |left: &&LeftLoop| matches!(left.reason, Reason::LooksAway | Reason::Taken | Reason::NotJoined);
    base.done.near_loops_left = base.done.left.iter().filter(is_near).count() as u32;
    if base.done.near_loops_left > 0 {
        job.note("loops are left although others are near: the account of the assembly says why");
    }
    base.finish(options, &job.part(0.8, 1.0))
}

/// The pieces put together, welded and oriented.
struct Base {
    done: Assembly,
    /// Per vertex of the mesh, the piece that it comes from first.
    piece: Vec<u32>,
}

impl Base {
    fn new(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Self> {
        let (mut mesh, places) = concat::concatenate(pieces)?;
        let (vertex_count, face_count) = (mesh.positions.len(), mesh.face_count());
        let mut vertex_map = alloc::collect((0..vertex_count).map(|v| v as u32))?;
        let mut face_map = alloc::collect((0..face_count).map(|f| f as u32))?;
        let (mut welded_vertices, mut sewn_edges, mut splits) = (0, 0, 0);
        if let Some(how) = &options.weld {
            let (view, part) = (mesh.view(&job.part(0.0, 0.1))?, job.part(0.1, 0.5));
            let sewn = match options.edge_to_edge {
                true => Sew::of(weld(&view, how, &part)?)?,
                false => sew(&view, how, &part)?,
            };
            (welded_vertices, sewn_edges, splits) = (sewn.welded_vertices, sewn.sewn_edges, sewn.splits);
            (mesh, vertex_map, face_map) = (sewn.mesh, sewn.vertex_map, sewn.face_map);
        }
        let mut turned = alloc::filled(false, mesh.face_count())?;
        let mut one_sided = Vec::new();
        if !options.keep_orientation && mesh.face_count() > 0 {
            let how = orient::Options::default();
            let oriented = orient::orient(&mesh.view(&job.part(0.5, 0.6))?, &how, &job.part(0.6, 1.0))?;
            (mesh, turned) = (oriented.mesh, oriented.turned);
            one_sided = alloc::collect(oriented.one_sided.iter().map(|component| component.face))?;
        }
        let mut piece = alloc::filled(NONE, mesh.positions.len())?;
        let mut maps = alloc::with_capacity(pieces.len())?;
        for (k, (view, place)) in pieces.iter().zip(&places).enumerate() {
            let vertices = &vertex_map[place.first_vertex as usize..][..view.positions().len()];
            let faces = &face_map[place.first_face as usize..][..view.faces().len()];
            for &v in vertices.iter().filter(|&&v| v != NONE) {
                piece[v as usize] = piece[v as usize].min(k as u32);
            }
            maps.push(IndexMap { vertices: alloc::copied(vertices)?, faces: alloc::copied(faces)? });
        }
        let done = Assembly {
            mesh,
            maps,
            turned,
            welded_vertices,
            sewn_edges,
            splits,
            one_sided,
            joints: Vec::new(),
            left: Vec::new(),
            holes: Vec::new(),
            hole_rims: Vec::new(),
            loops_left: 0,
            near_loops_left: 0,
            non_manifold_edges: 0,
        };
        Ok(Base { done, piece })
    }

    /// Decides which components are turned over, turns them, and says of each pair whether it can
    /// be joined.
    fn make_agree(&mut self, loops: &mut Loops, found: &mut [Facing], keep: bool) -> Result<Vec<Outcome>> {
        let mut outcomes = alloc::filled(Outcome::Joined, found.len())?;
        if keep {
            return Ok(outcomes);
        }
        let mut components = alloc::collect(loops.candidates.iter().map(|candidate| candidate.component))?;
        sort_distinct(&mut components);
        let place = |component: u32| components.partition_point(|&other| other < component) as u32;
        let mut agreement = ParitySets::new(components.len())?;
        for (facing, outcome) in found.iter().zip(&mut outcomes) {
            let [i, j] = facing.rims.map(|r| loops.candidates[r].component);
            let [a, b] = loops.sides(facing)?;
            let against = match facing.arcs {
                None => rims_disagree(&a, &b)?,
                Some(_) => arcs_run_the_same_way(&a.points, &b.points)?,
            };
            // Turning is no way out within one component: such loops are taken as they are.
            if i != j && !agreement.union(place(i), place(j), against) {
                *outcome = Outcome::OrientationConflict;
            }
        }
        let mut turned = alloc::copied(&components)?;
        turned.retain(|&component| agreement.find(place(component)).1);
        let is_turned = |component: u32| turned.binary_search(&component).is_ok();
        let Assembly { mesh, turned: faces_turned, .. } = &mut self.done;
        for (face, turned) in mesh.face_offsets.windows(2).zip(faces_turned) {
            let corners = &mut mesh.face_corners[face[0] as usize..face[1] as usize];
            if is_turned(loops.components.find(corners[0])) {
                corners[1..].reverse();
                *turned ^= true;
            }
        }
        for (rim, candidate) in loops.rims.iter_mut().zip(&loops.candidates) {
            if is_turned(candidate.component) {
                rim.turn();
            }
        }
        // Places are counted along the loops as they run now.
        for facing in found {
            if let Some(arcs) = &mut facing.arcs {
                for (arc, r) in arcs.iter_mut().zip(facing.rims) {
                    let (n, component) = (loops.rims[r].vertices.len(), loops.candidates[r].component);
                    if is_turned(component) {
                        arc.first = (2 * n - arc.first - arc.count) % n;
                    }
                }
            }
        }
        Ok(outcomes)
    }

    fn finish(self, options: &Options<'_>, job: &Job<'_>) -> Result<Assembly> {
        let mut done = self.done;
        if done.mesh.face_count() == 0 {
            return Ok(done);
        }
        if let Some(how) = &options.fill {
            let how = fill::Options { outward: Outward::Keep, ..*how };
            let filled = fill_holes(&done.mesh.view(&job.part(0.0, 0.1))?, None, &how, &job.part(0.1, 0.4))?;
            (done.mesh, done.holes, done.hole_rims) = (filled.mesh, filled.holes, filled.rims);
        }
        if !(options.keep_orientation || options.keep_inside_out) {
            for f in turn_outwards(&mut done.mesh, &job.part(0.4, 0.6))? {
                // Faces of strips and patches come after those of the pieces.
                if let Some(turned) = done.turned.get_mut(f as usize) {
                    *turned ^= true;
                }
            }
        }
        let view = done.mesh.view(&job.part(0.6, 0.7))?;
        let boundary = boundary_loops(&view, &boundary::Options::default(), &job.part(0.7, 1.0))?;
        done.loops_left = boundary.len() as u32;
        let is_edge = |defect: &&Defect| matches!(defect, Defect::NonManifoldEdge { .. });
        done.non_manifold_edges = boundary.defects().iter().filter(is_edge).count() as u32;
        Ok(done)
    }
}

/// The boundary of the base: loops that can carry a strip, and others.
struct Loops {
    rims: Vec<Rim>,
    candidates: Vec<Candidate>,
    components: DisjointSets,
    /// The loops that cannot, with the reason.
    others: Vec<LeftLoop>,
    /// What the rims' points are multiplied by.
    unit: f64,
}

impl Loops {
    fn of(base: &Base, job: &Job<'_>) -> Result<Self> {
        let mesh = &base.done.mesh;
        let mut loops = Loops {
            rims: Vec::new(),
            candidates: Vec::new(),
            components: DisjointSets::default(),
            others: Vec::new(),
            unit: 1.0,
        };
        if mesh.face_count() == 0 {
            return Ok(loops);
        }
        let view = mesh.view(&job.part(0.0, 0.3))?;
        let boundary: Boundary = boundary_loops(&view, &boundary::Options::default(), &job.part(0.3, 1.0))?;
        loops.components = vertex_components(&view)?;
        for found in boundary.iter() {
            if is_usable(&found) {
                alloc::push(&mut loops.rims, Rim::found(&view, &found)?)?;
            } else {
                let reason = if found.vertices.len() < 3 { Reason::TooShort } else { Reason::NotSimple };
                alloc::push(
                    &mut loops.others,
                    LeftLoop { vertices: alloc::copied(found.vertices)?, reason, gap: f64::INFINITY, allowed_gap: 0.0 },
                )?;
            }
        }
        loops.unit = common_unit(loops.rims.iter().flat_map(|rim| &rim.points));
        let sizes = component_sizes(mesh, &mut loops.components, &loops.rims)?;
        for (rim, size) in loops.rims.iter_mut().zip(sizes) {
            rim.points.iter_mut().for_each(|p| *p /= loops.unit);
            let component = loops.components.find(rim.vertices[0]);
            let piece = base.piece[rim.vertices[0] as usize];
            alloc::push(&mut loops.candidates, Candidate::new(rim, component, piece, size / loops.unit))?;
        }
        Ok(loops)
    }

    /// The two loops, or arcs of them, each with its surface on the left.
    fn sides(&self, facing: &Facing) -> Result<[Rim; 2]> {
        let [r, k] = facing.rims;
        let (mut a, mut b) = (self.rims[r].try_clone()?, self.rims[k].try_clone()?);
        if let Some([arc_a, arc_b]) = facing.arcs {
            a.cut(arc_a)?;
            b.cut(arc_b)?;
        }
        Ok([a, b])
    }

    /// The edges that the mesh has between different rims. A vertex may be on several.
    fn edges_between(&self, mesh: &Mesh) -> Result<Edges> {
        let places = self.places()?;
        let mut on_rim = alloc::filled(false, mesh.positions.len())?;
        places.iter().for_each(|&(v, _)| on_rim[v as usize] = true);
        let mut edges = Edges { of: Vec::new(), places };
        for face in mesh.faces() {
            for (k, &u) in face.iter().enumerate() {
                let v = face[(k + 1) % face.len()];
                if on_rim[u as usize] && on_rim[v as usize] {
                    edges.enter(u, v)?;
                }
            }
        }
        sort_distinct(&mut edges.of);
        Ok(edges)
    }

    fn search<'a>(&'a self, options: &Options<'_>, used: &'a [bool], excluded: &'a [[u32; 2]]) -> FacingSearch<'a> {
        let max_gap = match options.max_gap {
            MaxGap::Given(gap) => Some(gap / self.unit),
            MaxGap::Auto => None,
        };
        FacingSearch {
            rims: &self.rims,
            candidates: &self.candidates,
            used,
            excluded,
            within_components: options.within_components,
            arcs: !options.whole_loops_only,
            max_gap,
        }
    }

    /// Each vertex on a loop with the loop, in ascending order.
    fn places(&self) -> Result<Vec<(u32, u32)>> {
        let mut places = alloc::with_capacity(self.rims.iter().map(|rim| rim.vertices.len()).sum())?;
        for (rim, r) in self.rims.iter().zip(0u32..) {
            places.extend(rim.vertices.iter().map(|&v| (v, r)));
        }
        places.sort_unstable();
        Ok(places)
    }

    /// The loops that a selector names, in ascending order.
    fn named(&self, base: &Base, places: &[(u32, u32)], selector: Selector) -> Result<Vec<usize>> {
        let Some(map) = base.done.maps.get(selector.piece as usize) else {
            return Ok(Vec::new());
        };
        if let Some(&vertex) = map.vertices.get(selector.vertex as usize) {
            return alloc::collect(loops_of(places, vertex).iter().map(|&(_, r)| r as usize));
        }
        let of_piece = |&v: &u32| selector.vertex == NONE && base.piece[v as usize] == selector.piece;
        alloc::gather((0..self.rims.len()).filter(|&r| self.rims[r].vertices.iter().any(of_piece)))
    }
}

/// For each rim, the largest extent of its component along an axis.
fn component_sizes(mesh: &Mesh, components: &mut DisjointSets, rims: &[Rim]) -> Result<Vec<f64>> {
    let of_rims = alloc::collect(rims.iter().map(|rim| components.find(rim.vertices[0])))?;
    let mut roots = alloc::copied(&of_rims)?;
    sort_distinct(&mut roots);
    let mut boxes = alloc::filled(Aabb::EMPTY, roots.len())?;
    for v in 0..mesh.positions.len() as u32 {
        if let Ok(place) = roots.binary_search(&components.find(v)) {
            boxes[place].add(mesh.positions.get(v));
        }
    }
    alloc::collect(of_rims.iter().map(|&root| boxes[roots.partition_point(|&other| other < root)].size().max_element()))
}

/// The entries of `vertex` among places in ascending order.
fn loops_of(places: &[(u32, u32)], vertex: u32) -> &[(u32, u32)] {
    let from = places.partition_point(|&(v, _)| v < vertex);
    let count = places[from..].partition_point(|&(v, _)| v == vertex);
    &places[from..from + count]
}

/// Edges by the rims that they join.
struct Edges {
    /// In ascending order.
    of: Vec<([u32; 2], (u32, u32))>,
    places: Vec<(u32, u32)>,
}

impl Edges {
    /// Appends an edge for every two rims that its ends are on.
    fn enter(&mut self, u: u32, v: u32) -> Result<()> {
        for &(_, r) in loops_of(&self.places, u) {
            for &(_, s) in loops_of(&self.places, v).iter().filter(|&&(_, s)| s != r) {
                alloc::push(&mut self.of, ([r, s], (u, v)))?;
                alloc::push(&mut self.of, ([s, r], (v, u)))?;
            }
        }
        Ok(())
    }

    /// Takes note of the edges of a strip between vertices of its rims: where loops touch, another
    /// strip could use one again.
    fn enter_strip(&mut self, strip: &Strip) -> Result<()> {
        let before = self.of.len();
        let rims = strip.rim_count();
        let name = |k: u32| match (k as usize).checked_sub(strip.a.vertices.len()) {
            Some(k) => strip.b.vertices[k],
            None => strip.a.vertices[k as usize],
        };
        let sides = strip.faces.iter().flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
        for (&k, &j) in sides.filter(|&(&k, &j)| (k.max(j) as usize) < rims) {
            let [u, v] = [name(k), name(j)];
            if [u, v].iter().all(|&v| loops_of(&self.places, v).len() > 1) {
                self.enter(u, v)?;
            }
        }
        if self.of.len() > before {
            sort_distinct(&mut self.of);
        }
        Ok(())
    }

    fn between(&self, rims: [usize; 2]) -> Bridges {
        let rims = rims.map(|r| r as u32);
        let from = self.of.partition_point(|&(pair, _)| pair < rims);
        Bridges::of(self.of[from..].iter().take_while(|&&(pair, _)| pair == rims).map(|&(_, edge)| edge).collect())
    }
}

/// The loops that no strip hangs on, with the reasons.
fn left_loops(
    loops: Loops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    [hangs, tried]: [&[bool]; 2],
) -> Result<Vec<LeftLoop>> {
    let without = alloc::collect(hangs.iter().map(|&hangs| !hangs))?;
    let explained = loops.search(options, hangs, excluded).explain(&without)?;
    let mut left = loops.others;
    for (r, (rim, found)) in loops.rims.into_iter().zip(explained).enumerate() {
        if let Some(found) = found {
            let reason = if tried[r] { Reason::NotJoined } else { found.reason };
            let [gap, allowed_gap] = [found.gap, found.allowed].map(|length| length * loops.unit);
            alloc::push(&mut left, LeftLoop { vertices: rim.vertices, reason, gap, allowed_gap })?;
        }
    }
    left.sort_unstable_by(|x, y| x.vertices.iter().min().cmp(&y.vertices.iter().min()));
    Ok(left)
}

/// The pairs of loops (smaller, larger) that are not to be joined, in ascending order.
fn excluded_pairs(base: &Base, loops: &Loops, options: &Options<'_>) -> Result<Vec<[u32; 2]>> {
    let places = loops.places()?;
    let mut excluded = Vec::new();
    for (k, pair) in options.excluded.iter().enumerate() {
        GivenPair { option: "excluded", number: k as u32, pair }.check_exists(&base.done.maps)?;
        let (first, second) = (loops.named(base, &places, pair[0])?, loops.named(base, &places, pair[1])?);
        let pairs = first.iter().flat_map(|&r| second.iter().map(move |&s| [r.min(s) as u32, r.max(s) as u32]));
        alloc::extend(&mut excluded, pairs)?;
    }
    excluded.sort_unstable();
    Ok(excluded)
}

/// The pairs that were given, and after them those that are found.
fn chosen_pairs(
    base: &Base,
    loops: &Loops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    job: &Job<'_>,
) -> Result<Vec<Facing>> {
    let places = loops.places()?;
    let mut taken = alloc::filled(false, loops.rims.len())?;
    let mut found = alloc::with_capacity(options.pairs.len())?;
    for (k, pair) in options.pairs.iter().enumerate() {
        let given = GivenPair { option: "pairs", number: k as u32, pair };
        given.check_exists(&base.done.maps)?;
        let rims = given.rims(|selector| loops.named(base, &places, selector), &taken)?;
        rims.iter().for_each(|&r| taken[r] = true);
        found.push(Facing { rims, arcs: None, gap: mean_gap(&loops.rims[rims[0]], &loops.rims[rims[1]])? });
    }
    if options.max_gap != MaxGap::Given(0.0) {
        alloc::append(&mut found, &loops.search(options, &taken, excluded).run(job)?)?;
    }
    Ok(found)
}
