//! The pieces that the two sides of a search are divided into, each with a hull that contains it.
//!
//! A surface is divided into sheets, blocks of their indices, cells, and halves of cells; a curve
//! into segments and halves of segments. The hull of a range or block is given by the corners of a
//! box, the hull of any other piece by its control points. A piece is divided once, and all its
//! pairs share the parts. Memory: the control points of all pieces.

use super::control_net::{ControlNet, DerivativeBalls};
use crate::cells::{SheetCells, cells_of_block};
use crate::index::OrientedBox;
use crate::{Surface, each_sheet};
use glam::DMat3;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::hull_distance::SimplexCorner;
use gusset_curve::CurveView;
use std::ops::Range;

/// An affine map applied to all points. For a plane it keeps the component along the normal, for an
/// infinite line the components across it. Units of length are powers of two.
#[derive(Debug, Clone, Copy)]
pub(super) struct AffineView {
    pub(super) origin: DVec3,
    pub(super) linear_map: DMat3,
    pub(super) unit: f64,
}

impl AffineView {
    fn map_point(&self, point: DVec3) -> DVec3 {
        self.linear_map * ((point - self.origin) / self.unit)
    }
}

/// One side of a search.
#[derive(Debug, Clone, Copy)]
pub(super) enum DistanceSide<'a> {
    Surface(&'a Surface<'a>),
    Curve(&'a CurveView<'a>),
    /// The origin of the view.
    Point,
}

/// The kind of a piece.
#[derive(Debug, Clone, Copy)]
enum PieceKind {
    /// Consecutive sheets or segments.
    Range {
        from: usize,
        to: usize,
    },
    Block {
        sheet: usize,
        level: usize,
        row: usize,
        column: usize,
    },
    ControlNet,
}

/// A position: the sheet or segment, the cell, and parameters in it.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub(super) struct PiecePosition {
    pub(super) sheet_or_segment: usize,
    pub(super) cell: [usize; 2],
    pub(super) parameters: [f64; 2],
}

#[derive(Debug, Clone)]
pub(super) struct SearchPiece {
    kind: PieceKind,
    /// The range of its hull among the points.
    first_hull_point: usize,
    shape: [usize; 2],
    bounds: Aabb,
    /// The ranges of its parts; for nets, along each parameter. Empty until the piece is divided.
    part_ranges: [[usize; 2]; 2],
    /// For nets: the position of the start, the size as a fraction of the cell or segment, and the
    /// balls, once computed.
    low_position: PiecePosition,
    parameter_size: [f64; 2],
    balls: Option<DerivativeBalls>,
}

/// The pieces of one side of a search.
#[derive(Debug)]
pub(super) struct SidePieces<'a> {
    source: DistanceSide<'a>,
    view: AffineView,
    points: Vec<DVec3>,
    pieces: Vec<SearchPiece>,
}

impl<'a> SidePieces<'a> {
    /// Creates piece 0, which is the whole side.
    pub(super) fn new(source: DistanceSide<'a>, view: AffineView) -> Result<Self> {
        let mut made = SidePieces { source, view, points: Vec::new(), pieces: Vec::new() };
        match source {
            DistanceSide::Surface(surface) => made.add_sheets_or_segments(0, surface.len())?,
            DistanceSide::Curve(curve) => made.add_sheets_or_segments(0, curve.len())?,
            DistanceSide::Point => made.add_net(&[DVec3::ZERO], [1, 1], PiecePosition::default(), [1.0; 2])?,
        }
        Ok(made)
    }

    /// The balls of a net. Computed once.
    pub(super) fn net_balls(&mut self, piece: usize) -> DerivativeBalls {
        if let Some(known) = self.pieces[piece].balls {
            return known;
        }
        let balls = self.control_net(piece).map_or_else(DerivativeBalls::default, |net| net.derivative_balls());
        self.pieces[piece].balls = Some(balls);
        balls
    }

    pub(super) fn hull_points(&self, piece: usize) -> &[DVec3] {
        let SearchPiece { first_hull_point: first, shape, .. } = self.pieces[piece];
        &self.points[first..first + shape[0] * shape[1]]
    }

    pub(super) fn bounding_box(&self, piece: usize) -> &Aabb {
        &self.pieces[piece].bounds
    }

    /// The control net, if the piece is a net.
    pub(super) fn control_net(&self, piece: usize) -> Option<ControlNet<'_>> {
        let net_piece = &self.pieces[piece];
        matches!(net_piece.kind, PieceKind::ControlNet)
            .then(|| ControlNet { points: self.hull_points(piece), shape: net_piece.shape })
    }

    /// The number of control points stored.
    pub(super) fn point_count(&self) -> usize {
        self.points.len()
    }

    /// The position of given parameters of a net.
    pub(super) fn position_at(&self, piece: usize, at: [f64; 2]) -> PiecePosition {
        let SearchPiece { low_position: whereabouts, parameter_size: size, .. } = self.pieces[piece];
        let at = [0, 1].map(|k| (whereabouts.parameters[k] + size[k] * at[k]).clamp(0.0, 1.0));
        PiecePosition { parameters: at, ..whereabouts }
    }

    /// True for a whole cell or segment.
    pub(super) fn is_whole_cell_or_segment(&self, piece: usize) -> bool {
        self.pieces[piece].parameter_size == [1.0; 2]
    }

    /// The longer side of a net, as a fraction of its cell or segment.
    pub(super) fn parameter_size(&self, piece: usize) -> f64 {
        self.pieces[piece].parameter_size[0].max(self.pieces[piece].parameter_size[1])
    }

    /// Parameters close to the point of a net that is a weighted sum of control points. `side`
    /// selects the control point of this piece from each corner.
    pub(super) fn start_parameters(
        &self,
        piece: usize,
        corners: &[SimplexCorner],
        side: impl Fn(&SimplexCorner) -> usize,
    ) -> [f64; 2] {
        let Some(net) = self.control_net(piece) else { return [0.5; 2] };
        let mut sum = [0.0; 2];
        for corner in corners {
            let at = net.greville_parameters(side(corner));
            (0..2).for_each(|k| sum[k] += corner.weight * at[k]);
        }
        sum.map(|t| t.clamp(0.0, 1.0))
    }

    /// How much dividing a piece may gain, and along which parameter: the size of a box, or the
    /// deviation of a net from flatness.
    pub(super) fn gain_and_parameter_of_division(&mut self, piece: usize) -> (f64, usize) {
        let [u, v] = match self.pieces[piece].kind {
            PieceKind::ControlNet => self.net_balls(piece).flatness_gain_by_split(),
            _ => [self.pieces[piece].bounds.diagonal(), 0.0],
        };
        if u >= v { (u, 0) } else { (v, 1) }
    }

    /// The length of a net that is practically flat, and the longer parameter.
    pub(super) fn length_and_longer_parameter_of_flat_net(&mut self, piece: usize) -> (f64, usize) {
        let [u, v] = self.net_balls(piece).max_extents();
        if u >= v { (u, 0) } else { (v, 1) }
    }

    /// The parts of a piece. A net is divided along the given parameter.
    pub(super) fn divide_piece(&mut self, piece: usize, parameter: usize) -> Result<Range<usize>> {
        let SearchPiece { kind, part_ranges: parts, .. } = self.pieces[piece];
        let parameter = if matches!(kind, PieceKind::ControlNet) { parameter } else { 0 };
        if parts[parameter] == [0; 2] {
            let first = self.pieces.len();
            match kind {
                PieceKind::Range { from, to } if to - from > 1 => {
                    let middle = from + (to - from) / 2;
                    self.add_sheets_or_segments(from, middle)?;
                    self.add_sheets_or_segments(middle, to)?;
                }
                PieceKind::Range { from, .. } => self.add_root_block(from)?,
                PieceKind::Block { sheet, level: 0, row, column } => self.add_cells_of_block(sheet, [row, column])?,
                PieceKind::Block { sheet, level, row, column } => self.add_child_blocks(sheet, level, [row, column])?,
                PieceKind::ControlNet => self.halve_net(piece, parameter)?,
            }
            self.pieces[piece].part_ranges[parameter] = [first, self.pieces.len()];
        }
        let [first, last] = self.pieces[piece].part_ranges[parameter];
        Ok(first..last)
    }

    /// Adds a piece with a hull of transformed points.
    fn add_piece(&mut self, kind: PieceKind, shape: [usize; 2], points: impl Iterator<Item = DVec3>) -> Result<()> {
        let first = self.points.len();
        for point in points {
            alloc::push(&mut self.points, point)?;
        }
        let bounds = Aabb::from_points(&self.points[first..]);
        let (parts, whereabouts) = ([[0; 2]; 2], PiecePosition::default());
        let piece = SearchPiece {
            kind,
            first_hull_point: first,
            shape,
            bounds,
            part_ranges: parts,
            low_position: whereabouts,
            parameter_size: [1.0; 2],
            balls: None,
        };
        alloc::push(&mut self.pieces, piece)
    }

    /// Adds a net of transformed points.
    fn add_net(
        &mut self,
        points: &[DVec3],
        shape: [usize; 2],
        whereabouts: PiecePosition,
        size: [f64; 2],
    ) -> Result<()> {
        self.add_piece(PieceKind::ControlNet, shape, points.iter().copied())?;
        if let Some(piece) = self.pieces.last_mut() {
            (piece.low_position, piece.parameter_size) = (whereabouts, size);
        }
        Ok(())
    }

    /// Adds a piece whose hull is given by the corners of a parallelepiped.
    fn add_box(&mut self, kind: PieceKind, corners: [DVec3; 8]) -> Result<()> {
        let view = self.view;
        self.add_piece(kind, [8, 1], corners.into_iter().map(|corner| view.map_point(corner)))
    }

    /// Adds sheets or segments. A single segment is added as a net.
    fn add_sheets_or_segments(&mut self, from: usize, to: usize) -> Result<()> {
        let bounds = match self.source {
            DistanceSide::Surface(surface) => {
                (from..to).map(|k| surface.sheet_and_index(k).1.bounding_box()).fold(Aabb::EMPTY, Aabb::union)
            }
            DistanceSide::Curve(curve) if to - from == 1 => {
                let points = alloc::collect(curve.segment(from).iter().map(|&point| self.view.map_point(point)))?;
                // A segment whose points coincide lacks a parameter.
                let count = if points.iter().all(|&point| point == points[0]) { 1 } else { points.len() };
                let whereabouts = PiecePosition { sheet_or_segment: from, ..PiecePosition::default() };
                return self.add_net(&points[..count], [count, 1], whereabouts, [1.0; 2]);
            }
            DistanceSide::Curve(curve) => {
                (from..to).map(|k| Aabb::from_points(curve.segment(k))).fold(Aabb::EMPTY, Aabb::union)
            }
            DistanceSide::Point => Aabb::EMPTY,
        };
        self.add_box(PieceKind::Range { from, to }, corners_of_box(&bounds))
    }

    /// Adds the top block of a sheet.
    fn add_root_block(&mut self, sheet: usize) -> Result<()> {
        let DistanceSide::Surface(surface) = self.source else { return Ok(()) };
        let (_, index) = surface.sheet_and_index(sheet);
        let kind = PieceKind::Block { sheet, level: index.levels().len(), row: 0, column: 0 };
        self.add_box(kind, corners_of_box(&index.bounding_box()))
    }

    /// Adds the children of a block, with their oriented boxes if they exist.
    fn add_child_blocks(&mut self, sheet: usize, level: usize, [row, column]: [usize; 2]) -> Result<()> {
        let DistanceSide::Surface(surface) = self.source else { return Ok(()) };
        let (_, index) = surface.sheet_and_index(sheet);
        let below = &index.levels()[level - 1];
        for child in 0..4 {
            let (r, c) = (2 * row + child / 2, 2 * column + child % 2);
            if below.has_block(r, c) {
                let aligned = || corners_of_box(&below.child_boxes(row, column).child_box(child));
                let hull = below.oriented_box(r, c).map_or_else(aligned, OrientedBox::corners);
                let kind = PieceKind::Block { sheet, level: level - 1, row: r, column: c };
                self.add_box(kind, hull.map(|corner| corner + index.origin()))?;
            }
        }
        Ok(())
    }

    /// Adds the cells of a block.
    fn add_cells_of_block(&mut self, sheet: usize, block: [usize; 2]) -> Result<()> {
        let DistanceSide::Surface(surface) = self.source else { return Ok(()) };
        let (kind, view) = (surface.sheet(sheet), self.view);
        for cell in cells_of_block(block, kind.cells()) {
            let whereabouts = PiecePosition { sheet_or_segment: sheet, cell, parameters: [0.0; 2] };
            each_sheet!(kind, cells => {
                let mut patch = SheetCells::cell_patch(cells, cell[0], cell[1]);
                let side = patch.points.len();
                let points = patch.points.as_flattened_mut();
                points.iter_mut().for_each(|point| *point = view.map_point(*point));
                self.add_net(points, [side, side], whereabouts, [1.0; 2])
            })?;
        }
        Ok(())
    }

    /// Adds the halves of a net.
    fn halve_net(&mut self, piece: usize, parameter: usize) -> Result<()> {
        let SearchPiece { shape, low_position: whereabouts, parameter_size: mut size, .. } = self.pieces[piece];
        let net = ControlNet { points: self.hull_points(piece), shape };
        let count = net.points.len();
        let mut both = alloc::filled(DVec3::ZERO, 2 * count)?;
        net.write_halves(parameter, &mut both);
        size[parameter] *= 0.5;
        for half in 0..2 {
            let mut whereabouts = whereabouts;
            whereabouts.parameters[parameter] += half as f64 * size[parameter];
            self.add_net(&both[half * count..][..count], shape, whereabouts, size)?;
        }
        Ok(())
    }
}

/// The corners of a box.
pub(super) fn corners_of_box(bounds: &Aabb) -> [DVec3; 8] {
    let ends = [bounds.low, bounds.high];
    std::array::from_fn(|k| DVec3::new(ends[k & 1].x, ends[k >> 1 & 1].y, ends[k >> 2].z))
}
