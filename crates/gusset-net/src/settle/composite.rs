//! The model of a composite: its lines, films, clamps and unknowns. O(nodes).

use super::SettleOptions;
use super::energy::{BridgeLine, ElasticLaw, FilmQuad, MIN_RELATIVE_LENGTH};
use super::energy_model::EnergyModel;
use super::motion::RigidMotion;
use super::parts::{BODY_SLOT_FLAG, CompositeParts, NO_BODY, is_rigid, properties_with_force};
use crate::planarise::elimination_order::visit_in_elimination_order;
use crate::planarise::scaled_vertices::ScaledVertices;
use crate::{Bridge, BridgeKind, Net};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use std::ops::Range;

/// Lines made between two progress reports.
const LINES_PER_REPORT: usize = 1 << 10;

/// The model of a composite net.
pub(super) struct CompositeModel {
    pub(super) model: EnergyModel,
    /// The initial points of the model, with rigid bodies in their rest shape.
    pub(super) initial_points: Vec<DVec3>,
    /// The points of the model.
    pub(super) points: Vec<DVec3>,
    pub(super) motion_of_body: Vec<RigidMotion>,
    /// The units of energies and of forces, in the host's units.
    pub(super) energy_unit: [f64; 2],
    /// The numbers of bridges with and without a force.
    pub(super) settled_bridges: u32,
    pub(super) idle_bridges: u32,
    /// The films: their quads, and their initial area.
    pub(super) film_quads_and_areas: Vec<(Range<usize>, f64)>,
    /// The part of the model that belongs to each bridge with forces.
    pub(super) elements_of_bridges: Vec<BridgeElements>,
}

/// The unknowns, lines and quads of a bridge.
#[derive(Clone)]
pub(super) struct BridgeElements {
    pub(super) unknowns: Range<usize>,
    pub(super) lines: Range<usize>,
    pub(super) quads: Range<usize>,
}

struct CompositeBuilder<'a> {
    net: &'a Net<'a>,
    reference: &'a Net<'a>,
    rest_ratio: f64,
    parts: &'a CompositeParts,
    surface: &'a ScaledVertices,
    force_scale: ForceScale,
    composite: CompositeModel,
}

/// The force relative to which properties are expressed.
#[derive(Clone, Copy)]
enum ForceScale {
    /// The largest finite property.
    Largest(f64),
    /// The largest stiffness over the square of the unit. The quotient may overflow or underflow;
    /// all other forces are then negligible.
    Stiffness(f64),
}

/// The range of stiffness over the square of the unit and the largest property. Outside this range,
/// squares of forces would overflow or underflow.
const PLAIN_STIFFNESS_RANGE: [f64; 2] = [1e-100, 1e100];

impl ForceScale {
    fn from_bridges(parts: &CompositeParts, net: &Net<'_>, unit: f64) -> ForceScale {
        let forces = || {
            parts
                .bridges
                .iter()
                .map(|&index| &net.bridges()[index])
                .filter_map(|b| Some((b, properties_with_force(b)?)))
        };
        let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
        let largest =
            forces().fold(0.0, |most: f64, (_, p)| most.max(p.tension).max(p.elasticity).max(finite(p.stiffness)));
        let largest = if largest > 0.0 { largest } else { 1.0 };
        let stiffest = forces().fold(0.0, |most: f64, (_, p)| most.max(finite(p.stiffness)));
        let [least, most] = PLAIN_STIFFNESS_RANGE;
        if stiffest == 0.0 || (least..=most).contains(&(stiffest / largest / unit / unit)) {
            return ForceScale::Largest(largest);
        }
        let scale = ForceScale::Stiffness(stiffest);
        let is_weaker = |x: f64| scale.relative_force(x, unit) <= 1.0;
        let others_are =
            forces().all(|(b, p)| is_weaker(p.tension * length_of_film_unit(b, unit)) && is_weaker(p.elasticity));
        if others_are { scale } else { ForceScale::Largest(largest) }
    }

    /// Returns a force relative to this scale.
    fn relative_force(self, force: f64, unit: f64) -> f64 {
        match self {
            ForceScale::Largest(largest) => force / largest,
            ForceScale::Stiffness(stiffest) => force * unit / stiffest * unit,
        }
    }

    /// Returns a stiffness relative to this scale, in the unit.
    fn relative_stiffness(self, stiffness: f64, unit: f64) -> f64 {
        match self {
            ForceScale::Largest(largest) => stiffness / largest / unit / unit,
            ForceScale::Stiffness(stiffest) => stiffness / stiffest,
        }
    }

    /// Returns the units of energies and of forces.
    fn energy_and_force_units(self, unit: f64) -> [f64; 2] {
        match self {
            ForceScale::Largest(largest) => [largest * unit, largest],
            ForceScale::Stiffness(stiffest) => [stiffest / unit, stiffest / unit / unit],
        }
    }
}

/// Returns the length by which a tension is multiplied to be a force; for films, a line has that
/// length.
fn length_of_film_unit(bridge: &Bridge, unit: f64) -> f64 {
    if bridge.kind == BridgeKind::Tube { unit } else { 1.0 }
}

/// Builds the composite of a net. `slots` are the bodies of its vertices.
pub(super) fn build_composite<'a>(
    net: &'a Net<'a>,
    options: &SettleOptions<'a>,
    (parts, surface, slots): (&'a CompositeParts, &'a ScaledVertices, Vec<u32>),
    job: &Job<'_>,
) -> Result<CompositeModel> {
    let scale = ForceScale::from_bridges(parts, net, surface.unit);
    let (translations, motions) = (Vec::new(), alloc::filled(RigidMotion::IDENTITY, parts.lines_of_part.len())?);
    let (carried, lines, quads) = (Vec::new(), Vec::new(), Vec::new());
    let model = EnergyModel {
        unknown_or_body_of_point: slots,
        translation_unknown_of_body: translations,
        carried_points_and_positions: carried,
        unknown_count: 0,
        lines,
        quads,
    };
    let energy_unit = scale.energy_and_force_units(surface.unit);
    let points = alloc::copied(&surface.positions)?;
    let composite = CompositeModel {
        model,
        points,
        initial_points: Vec::new(),
        motion_of_body: motions,
        energy_unit,
        settled_bridges: 0,
        idle_bridges: 0,
        film_quads_and_areas: Vec::new(),
        elements_of_bridges: Vec::new(),
    };
    let rest_ratio = if options.rest_ratio == 0.0 { 1.0 } else { options.rest_ratio };
    let reference = options.reference.unwrap_or(net);
    let mut builder = CompositeBuilder { net, reference, rest_ratio, parts, surface, force_scale: scale, composite };
    builder.shape_rigid_bodies(options)?;
    for (k, &index) in parts.bridges.iter().enumerate() {
        builder.add_bridge(k, index, &job.sub_job_of_item(k, parts.bridges.len()))?;
    }
    builder.finish_model()
}

impl CompositeBuilder<'_> {
    fn add_bridge(&mut self, place: usize, index: usize, job: &Job<'_>) -> Result<()> {
        job.step(0.0, "settle")?;
        let bridge = &self.net.bridges()[index];
        if properties_with_force(bridge).is_none() {
            self.composite.idle_bridges += 1;
            return Ok(());
        }
        self.composite.settled_bridges += 1;
        if is_rigid(bridge) {
            return Ok(());
        }
        let law = self.scaled_elastic_law(index)?;
        let before = self.composite.model.element_counts();
        self.number_inner_vertices(bridge)?;
        let is_film = bridge.kind == BridgeKind::Tube;
        let line_law = if is_film { ElasticLaw { tension: 0.0, ..law } } else { law };
        let centres =
            if bridge.kind == BridgeKind::Thread { self.mean_positions_adjacent_to_bridge(place) } else { [None; 2] };
        let columns = bridge.end as usize;
        for k in 0..columns {
            job.step_every(LINES_PER_REPORT, k, columns, "settle")?;
            let points = self.line_vertices(bridge, k)?;
            let is_copy = (k > 0 && points == self.line_vertices(bridge, 0)?)
                || (k > 1 && points == self.line_vertices(bridge, k - 1)?);
            let exists = points.iter().all(|&p| self.surface.positions[p as usize].is_finite());
            if exists && !is_copy && points.iter().any(|&p| p != points[0]) {
                self.add_line((place, bridge, k), points, line_law, centres)?;
            }
        }
        if is_film && law.tension > 0.0 {
            self.add_film(bridge, law.tension)?;
        }
        let [unknowns, lines, quads] = [0, 1, 2].map(|k| before[k]..self.composite.model.element_counts()[k]);
        alloc::push(&mut self.composite.elements_of_bridges, BridgeElements { unknowns, lines, quads })
    }

    /// Returns the properties in the unit, relative to the largest.
    fn scaled_elastic_law(&self, index: usize) -> Result<ElasticLaw> {
        let bridge = &self.net.bridges()[index];
        let (p, unit) = (bridge.properties, self.surface.unit);
        let film = length_of_film_unit(bridge, unit);
        let tension = match self.force_scale {
            ForceScale::Largest(largest) => p.tension / largest * film,
            ForceScale::Stiffness(_) => self.force_scale.relative_force(p.tension * film, unit),
        };
        let elasticity = self.force_scale.relative_force(p.elasticity, unit);
        let stiffness = self.force_scale.relative_stiffness(p.stiffness, unit);
        for (property, scaled, value) in [("tension", tension, p.tension), ("stiffness", stiffness, p.stiffness)] {
            if !scaled.is_finite() {
                return Err(Error::BadProperty { bridge: index as u32, property, value });
            }
        }
        Ok(ElasticLaw { tension, elasticity, stiffness })
    }

    /// Assigns the vertices of a rigid bridge to the body on both its sides.
    fn add_rigid_bridge(&mut self, place: usize, bridge: &Bridge) {
        let body = BODY_SLOT_FLAG + self.parts.bodies[place];
        for i in bridge.last_line_of_first_net() + 1..bridge.at {
            for k in 0..bridge.end {
                let v = self.vertex_at(i as usize, k as usize) as usize;
                let slot = &mut self.composite.model.unknown_or_body_of_point[v];
                if *slot == NO_BODY {
                    *slot = body;
                }
            }
        }
    }

    fn vertex_at(&self, i: usize, k: usize) -> u32 {
        self.parts.vertex_at(&self.surface.classes, i, k)
    }

    /// Numbers the inner vertices in an order of elimination.
    fn number_inner_vertices(&mut self, bridge: &Bridge) -> Result<()> {
        if bridge.rows == 0 {
            return Ok(());
        }
        let first = bridge.last_line_of_first_net() as usize + 1;
        let size = [bridge.rows as usize, bridge.end as usize];
        visit_in_elimination_order(size, bridge.kind != BridgeKind::Ribbon, &mut |i, k| {
            let v = self.vertex_at(first + i, k);
            let model = &mut self.composite.model;
            if model.unknown_or_body_of_point[v as usize] == NO_BODY && self.surface.positions[v as usize].is_finite() {
                model.unknown_or_body_of_point[v as usize] = model.unknown_count as u32;
                model.unknown_count += 1;
            }
            Ok(())
        })
    }

    /// Returns the vertices of a line from side to side.
    fn line_vertices(&self, bridge: &Bridge, k: usize) -> Result<Vec<u32>> {
        alloc::collect((bridge.last_line_of_first_net() as usize..bridge.at as usize + 1).map(|i| self.vertex_at(i, k)))
    }

    fn add_line(
        &mut self,
        (place, bridge, k): (usize, &Bridge, usize),
        points: Vec<u32>,
        law: ElasticLaw,
        centres: [Option<DVec3>; 2],
    ) -> Result<()> {
        let at = |i: u32| {
            let (i, j) = self.parts.direction.swap_unless_down(i as usize, k);
            self.reference.get(i, j) / self.surface.unit
        };
        let links = bridge.last_line_of_first_net()..bridge.at;
        let rests = links.map(|i| self.rest_ratio * at(i).distance(at(i + 1)));
        let mut rests: Vec<f64> = alloc::collect(rests)?;
        let known = rests.iter().filter(|rest| rest.is_finite());
        let count = known.clone().count();
        let h = if count > 0 { known.sum::<f64>() / count as f64 } else { 0.0 };
        rests.iter_mut().filter(|rest| !rest.is_finite()).for_each(|rest| *rest = 0.0);
        let mut end_targets = [None; 2];
        if law.stiffness > 0.0 && h > MIN_RELATIVE_LENGTH {
            for end in 0..2 {
                let side = points[end * (points.len() - 1)];
                let before = centres[end].or_else(|| self.position_adjacent_to_bridge(place, end, k));
                end_targets[end] = before.map(|before| self.add_clamp_target(side, before, h)).transpose()?.flatten();
            }
        }
        alloc::push(
            &mut self.composite.model.lines,
            BridgeLine { points, rest_lengths: rests, spacing: h, end_targets, law },
        )
    }

    /// Returns the row or column of a part that is adjacent to the bridge's side at an end.
    fn line_adjacent_to_bridge(&self, place: usize, end: usize) -> Option<usize> {
        let rows = &self.parts.lines_of_part[place + end];
        (rows.len() > 1).then(|| if end == 0 { rows.end - 2 } else { rows.start + 1 })
    }

    /// Returns the node before the start of a line, within the part.
    fn position_adjacent_to_bridge(&self, place: usize, end: usize, k: usize) -> Option<DVec3> {
        let before = self.composite.points[self.vertex_at(self.line_adjacent_to_bridge(place, end)?, k) as usize];
        before.is_finite().then_some(before)
    }

    /// Returns, for a thread, the mean of the vertices adjacent to each of its ends.
    fn mean_positions_adjacent_to_bridge(&self, place: usize) -> [Option<DVec3>; 2] {
        let along = self.parts.direction.line_count_and_length(self.net.shape()).1;
        [0, 1].map(|end| {
            let row = self.line_adjacent_to_bridge(place, end)?;
            let (mut sum, mut count) = (DVec3::ZERO, 0.0);
            for k in 0..along {
                let v = self.vertex_at(row, k);
                let is_copy = k > 0 && (v == self.vertex_at(row, k - 1) || v == self.vertex_at(row, 0));
                let position = self.composite.points[v as usize];
                if !is_copy && position.is_finite() {
                    (sum, count) = (sum + position, count + 1.0);
                }
            }
            (count > 0.0).then(|| sum / count)
        })
    }

    /// Adds the target of a line's end: a point at distance `h` from the side's point, in the
    /// direction from `before` to the side's point. The target moves with the side's body. Returns
    /// `None` if both points coincide.
    fn add_clamp_target(&mut self, side: u32, before: DVec3, h: f64) -> Result<Option<u32>> {
        let composite = &mut self.composite;
        let (at, slot) = (composite.points[side as usize], composite.model.unknown_or_body_of_point[side as usize]);
        if at.distance(before) <= MIN_RELATIVE_LENGTH {
            return Ok(None);
        }
        alloc::push(&mut composite.points, at + h * (at - before).normalize())?;
        alloc::push(&mut composite.model.unknown_or_body_of_point, slot)?;
        Ok(Some(composite.points.len() as u32 - 1))
    }

    fn add_film(&mut self, bridge: &Bridge, tension: f64) -> Result<()> {
        let first = self.composite.model.quads.len();
        for i in bridge.last_line_of_first_net() as usize..bridge.at as usize {
            for k in 0..bridge.end as usize - 1 {
                let corners = [(i, k), (i, k + 1), (i + 1, k + 1), (i + 1, k)].map(|(i, k)| self.vertex_at(i, k));
                if corners.iter().all(|&p| self.surface.positions[p as usize].is_finite()) {
                    alloc::push(&mut self.composite.model.quads, FilmQuad { corners, tension })?;
                }
            }
        }
        let quads = first..self.composite.model.quads.len();
        let area = self.composite.film_area(&quads);
        alloc::push(&mut self.composite.film_quads_and_areas, (quads, area))
    }

    /// Gives rigid bodies their inner vertices and their rest shape.
    fn shape_rigid_bodies(&mut self, options: &SettleOptions<'_>) -> Result<()> {
        let parts = self.parts;
        let mut is_rigid_body = alloc::filled(false, parts.lines_of_part.len())?;
        for (place, &index) in parts.bridges.iter().enumerate() {
            let bridge = &self.net.bridges()[index];
            if is_rigid(bridge) {
                self.add_rigid_bridge(place, bridge);
                is_rigid_body[parts.bodies[place] as usize] = true;
            }
        }
        if let Some(reference) = options.reference {
            let bodies = (0u32..).zip(is_rigid_body).filter(|&(_, is_rigid)| is_rigid);
            bodies.for_each(|(body, _)| self.reshape_body(body, reference));
        }
        Ok(())
    }

    /// Gives moving bodies their unknowns.
    fn finish_model(mut self) -> Result<CompositeModel> {
        let count = self.parts.lines_of_part.len();
        let (parts, model) = (self.parts, &mut self.composite.model);
        model.translation_unknown_of_body = alloc::filled(NO_BODY, count)?;
        for body in 0..count {
            if parts.bodies[body] as usize == body && !parts.is_held_body[body] {
                model.translation_unknown_of_body[body] = model.unknown_count as u32;
                model.unknown_count += 1;
            }
        }
        let mut is_carried = alloc::filled(false, model.unknown_or_body_of_point.len())?;
        let lines = model.lines.iter().flat_map(|line| line.points.iter().chain(line.end_targets.iter().flatten()));
        for &point in lines.chain(model.quads.iter().flat_map(|quad| &quad.corners)) {
            is_carried[point as usize] = true;
        }
        for (point, carried) in (0u32..).zip(is_carried) {
            let slot = model.unknown_or_body_of_point[point as usize];
            let moves = (BODY_SLOT_FLAG..NO_BODY).contains(&slot)
                && model.translation_unknown_of_body[(slot - BODY_SLOT_FLAG) as usize] != NO_BODY;
            if carried && moves {
                alloc::push(&mut model.carried_points_and_positions, (point, self.composite.points[point as usize]))?;
            }
        }
        self.composite.initial_points = alloc::copied(&self.composite.points)?;
        Ok(self.composite)
    }

    /// Moves the parts of a body that are not held, and the bridges within it, to their reference
    /// positions relative to the held part.
    fn reshape_body(&mut self, body: u32, reference: &Net<'_>) {
        let (parts, surface, net) = (self.parts, self.surface, self.net);
        let own = |part: &usize| parts.bodies[*part] == body;
        let has_held = (0..parts.lines_of_part.len()).any(|part| own(&part) && parts.held_parts[part]);
        let leads = |part: &usize| own(part) && (parts.held_parts[*part] || !has_held);
        let along = parts.direction.line_count_and_length(net.shape()).1;
        let scaled = |net: &Net<'_>, (i, k): (usize, usize)| {
            let (i, j) = parts.direction.swap_unless_down(i, k);
            surface.scale_position(net.get(i, j))
        };
        let nodes = |part: usize| parts.lines_of_part[part].clone().flat_map(move |i| (0..along).map(move |k| (i, k)));
        let pairs = (0..parts.lines_of_part.len()).filter(leads).flat_map(nodes);
        let pairs = pairs.map(|place| [scaled(reference, place), scaled(net, place)]);
        let motion = RigidMotion::fit_point_pairs(pairs.filter(|[p, q]| p.is_finite() && q.is_finite()));
        let mut place_node = |i: usize, k: usize| {
            let v = parts.vertex_at(&surface.classes, i, k) as usize;
            let at = scaled(reference, (i, k));
            if self.composite.model.unknown_or_body_of_point[v] == BODY_SLOT_FLAG + body
                && at.is_finite()
                && surface.positions[v].is_finite()
            {
                self.composite.points[v] = motion.apply(at);
            }
        };
        for part in (0..parts.lines_of_part.len()).filter(own) {
            if has_held && !parts.held_parts[part] {
                nodes(part).for_each(|(i, k)| place_node(i, k));
            }
            if let Some(&index) = parts.bridges.get(part).filter(|&&index| is_rigid(&net.bridges()[index])) {
                let bridge = &net.bridges()[index];
                let inner = bridge.last_line_of_first_net() as usize + 1..bridge.at as usize;
                inner.for_each(|i| (0..along).for_each(|k| place_node(i, k)));
            }
        }
    }
}

impl CompositeModel {
    pub(super) fn film_area(&self, quads: &Range<usize>) -> f64 {
        self.model.quads[quads.clone()].iter().map(|quad| quad.quad_area(&self.points)).sum()
    }
}
