//! Isophotes: curves of points whose normals make given angles with a direction. At 90 degrees they
//! are the silhouettes.
//!
//! Let H be the component of N = S_u x S_v along the direction, and P the squared length of the
//! component across it. The angle is alpha where H has the sign of cos alpha and sin^2 alpha H^2 =
//! cos^2 alpha P. At 90 degrees this is H = 0. At 0 and 180 degrees, both components across vanish,
//! which happens at isolated points. These equations do not suffer from cancellation at any angle.

use super::cone_culling;
use super::contour_lattice::ContourLattice;
use super::contour_paths::{SheetContourSet, add_point_paths};
use super::contour_search::{ContourArcs, ContourSearch};
use super::contour_source::{ContourSource, LevelsAndDataOfCell, SideContinuity, levels_between};
use super::creases::find_creases_at_angles;
use super::normal_fields::sum_of_squared_fields;
use super::point_spacing::{PointSpacing, add_leus_points};
use super::projected_normals::{ProjectedBlockCorners, ProjectedNormals, frame_with_third_axis};
use crate::cells::SheetCells;
use crate::checks::{check_ascending, unit_vector};
use crate::ranges::angle_range_to_third_axis;
use crate::subdivision::BernsteinField;
use crate::{NormalKind, Paths, Place, Sheet, Surface};
use glam::{DVec2, DVec3};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, par};
use std::f64::consts::PI;
use std::ops::Range;

/// Sines and cosines below this count as 0.
const MIN_NONZERO_SINE: f64 = 1e-8;
/// Largest error of the angles of points caused by rounding, in radians.
const MAX_ANGLE_ERROR_RADIANS: f64 = 1e-6;
/// Number of blocks that a thread searches in one task.
const BLOCKS_PER_TASK: usize = 64;

/// The equation H = 0.
struct SilhouetteSource<'a, C, const N: usize>(&'a ProjectedNormals<'a, C, N>);

impl<C: SheetCells<N>, const N: usize, const M: usize> ContourSource<M> for SilhouetteSource<'_, C, N> {
    type BlockData = ProjectedBlockCorners;
    type CellData = BernsteinField<M>;
    type BlockCache = ();

    fn prepare_block(&self, cells: [Range<usize>; 2], (): &mut ()) -> Option<ProjectedBlockCorners> {
        Some(self.0.project_block_corners(&cells))
    }

    fn may_level_cross_cell(&self, block: &ProjectedBlockCorners, cell: [usize; 2]) -> bool {
        let [low, high] = block.normal_component_ranges(cell)[2];
        if low > 0.0 || high < 0.0 {
            return false;
        }
        let of = self.0.hodographs(cell);
        let rounding_error = self.0.normal_rounding_error(&of);
        let [low, high] = of.normal_component_ranges()[2];
        low <= rounding_error && high >= -rounding_error
    }

    fn prepare_cell(
        &self,
        _: &ProjectedBlockCorners,
        cell: [usize; 2],
        (): &mut (),
    ) -> LevelsAndDataOfCell<BernsteinField<M>> {
        let of = self.0.hodographs(cell);
        LevelsAndDataOfCell {
            levels: 0..1,
            rounding_error: self.0.normal_rounding_error(&of),
            shared_data: of.normal_component(2),
        }
    }

    fn field_with_zeros_at_level(&self, base: &BernsteinField<M>, _: usize) -> BernsteinField<M> {
        *base
    }

    fn side_continuity(&self) -> SideContinuity {
        self.0.continuity
    }
}

/// The equation sin^2 alpha H^2 = cos^2 alpha P.
struct IsophoteSource<'a, C, const N: usize, const H: usize> {
    normals: &'a ProjectedNormals<'a, C, N>,
    classes: &'a AngleClasses,
}

/// The squares that the equations of a cell's angles share.
struct SquaredNormalFields<const M: usize> {
    along: BernsteinField<M>,
    across: BernsteinField<M>,
}

impl<C, const N: usize, const H: usize> IsophoteSource<'_, C, N, H> {
    /// The indices of the angles in a range, or whose supplements are in it, and of all angles
    /// between them.
    fn levels_in_range(&self, [low, high]: [f64; 2]) -> Range<usize> {
        let AngleClasses { radians, unsigned, .. } = self.classes;
        let own = levels_between(radians, [low, high], 0.0);
        if !unsigned {
            return own;
        }
        match levels_between(radians, [PI - high, PI - low], 0.0) {
            others if others.is_empty() => own,
            others if own.is_empty() => others,
            others => own.start.min(others.start)..own.end.max(others.end),
        }
    }
}

impl<C: SheetCells<N>, const N: usize, const H: usize, const M: usize> ContourSource<M>
    for IsophoteSource<'_, C, N, H>
{
    type BlockData = ProjectedBlockCorners;
    type CellData = SquaredNormalFields<M>;
    type BlockCache = ();

    fn prepare_block(&self, cells: [Range<usize>; 2], (): &mut ()) -> Option<ProjectedBlockCorners> {
        Some(self.normals.project_block_corners(&cells))
    }

    fn may_level_cross_cell(&self, block: &ProjectedBlockCorners, cell: [usize; 2]) -> bool {
        if self.levels_in_range(angle_range_to_third_axis(&block.normal_component_ranges(cell), 0.0)).is_empty() {
            return false;
        }
        let of = self.normals.hodographs(cell);
        !self
            .levels_in_range(angle_range_to_third_axis(
                &of.normal_component_ranges(),
                self.normals.normal_rounding_error(&of),
            ))
            .is_empty()
    }

    fn prepare_cell(
        &self,
        _: &ProjectedBlockCorners,
        cell: [usize; 2],
        (): &mut (),
    ) -> LevelsAndDataOfCell<SquaredNormalFields<M>> {
        let of = self.normals.hodographs(cell);
        let [first, second, along]: [BernsteinField<H>; 3] = std::array::from_fn(|k| of.normal_component(k));
        let [u, v] = of.max_speeds();
        let levels = self.levels_in_range(angle_range_to_third_axis(
            &of.normal_component_ranges(),
            self.normals.normal_rounding_error(&of),
        ));
        let rounding_error = 4.0 * u * v * self.normals.normal_rounding_error(&of);
        LevelsAndDataOfCell {
            levels,
            rounding_error,
            shared_data: SquaredNormalFields {
                along: sum_of_squared_fields(&[along]),
                across: sum_of_squared_fields(&[first, second]),
            },
        }
    }

    fn level_count(&self) -> usize {
        self.classes.other_sines_and_cosines.len().max(1)
    }

    /// Increases with the cosine of the angle, where H has the sign of cos alpha.
    fn field_with_zeros_at_level(&self, base: &SquaredNormalFields<M>, level: usize) -> BernsteinField<M> {
        let [sin, cos] = self.classes.other_sines_and_cosines[level];
        let sign = if cos < 0.0 && !self.classes.unsigned { -1.0 } else { 1.0 };
        base.along.linear_combination(sign * sin * sin, &base.across, -sign * cos * cos)
    }

    /// Accepts the arcs on which H has the sign of cos alpha, because pi - alpha satisfies the same
    /// equation. The sign is constant along an arc: H and P vanish together only where the normal
    /// does not exist, as at poles, where the sign is undetermined. Close to such a place inside a
    /// cell, arcs that were linked without being resolved may have both signs.
    fn does_arc_belong_to_level(
        &self,
        cell: [usize; 2],
        level: usize,
        places: impl FnOnce() -> [DVec2; 3],
    ) -> Option<bool> {
        if self.classes.unsigned {
            return Some(true);
        }
        let rounding_error = self.normals.normal_rounding_error(&self.normals.hodographs(cell));
        let patch = self.normals.cells.cell_patch(cell[0], cell[1]);
        let sign = self.classes.other_sines_and_cosines[level][1].signum();
        let along = places().map(|at| sign * patch.jet(at.x, at.y).normal().dot(self.normals.frame[2]));
        let (right, wrong) = (along.iter().any(|&x| x > rounding_error), along.iter().any(|&x| x < -rounding_error));
        if right && wrong { None } else { Some(!wrong) }
    }

    fn side_continuity(&self) -> SideContinuity {
        self.normals.continuity
    }
}

/// The angles of a query by kind.
#[derive(Default)]
struct AngleClasses {
    silhouettes: Vec<u32>,
    /// The angles 0 and 180 degrees, with the sign of the cosine.
    poles: Vec<(u32, f64)>,
    /// Sines and cosines of the other angles, and the angles in radians.
    other_sines_and_cosines: Vec<[f64; 2]>,
    radians: Vec<f64>,
    /// All angles except 0 and 180 degrees.
    crossed_angles: Vec<f64>,
    level_numbers: Vec<u32>,
    /// Whether a normal and its opposite are equivalent.
    unsigned: bool,
}

impl Surface<'_> {
    /// Finds the curves on which the surface's normal makes given angles with a direction. Curves
    /// are sorted by angle (`levels` of the paths), then by lowest cell. At 90 degrees they are the
    /// silhouettes of the surface seen along the direction. At 0 and 180 degrees, isolated points
    /// take the place of curves, and are returned as paths of one point each. Seen from the side of
    /// the normals, smaller angles are to the left of a curve.
    ///
    /// `angles` are in radians, ascending, from 0 to pi. If `unsigned`, a normal and its opposite
    /// are equivalent, and the largest angle is pi / 2.
    ///
    /// The angles refer to the interpolant's normals, which are of third order. Normals at nodes
    /// are of fourth order, and so are the [`Surface::contours`] of their cosines.
    ///
    /// Finds every curve of a regular surface, like [`Surface::section`]. The normals of Bézier
    /// patches and of the four-point scheme are discontinuous across sides. Where the angle jumps
    /// past a given one, the curve runs along the side between the cells. If this continues for
    /// more than a cell, the curve ends, and the ends and the sides are listed as unresolved.
    ///
    /// At a pole, where the normal does not exist, a curve ends or passes. A pole that may have the
    /// angle itself is listed as unresolved. The first query builds the cones of normals in
    /// O(cells). After that, a query takes about O(cells that are crossed).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the direction is zero or not finite, or the angles are out of
    /// range or not ascending; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn isophotes(
        &self,
        axis: DVec3,
        angles: &[f64],
        unsigned: bool,
        spacing: PointSpacing,
        job: &Job<'_>,
    ) -> Result<Paths> {
        let axis = unit_vector(axis, "direction")?;
        check_ascending(angles, "levels")?;
        let max = if unsigned { 0.5 * PI } else { PI };
        angles.iter().try_for_each(|&angle| {
            Error::require(
                (0.0..=max + 1e-15).contains(&angle),
                "levels",
                angle,
                if unsigned { "from 0 to pi / 2" } else { "from 0 to pi" },
            )
        })?;
        let mut search = IsophoteSearch {
            surface: self,
            frame: frame_with_third_axis(axis),
            classes: AngleClasses::new(angles, unsigned)?,
            chord: self.chord_tolerance(spacing)?,
            curves: SheetContourSet::default(),
            points: Vec::new(),
        };
        for k in 0..self.len() {
            let part = self.sheet_job(k, job);
            match self.sheet(k) {
                Sheet::Grid(cells) => search.search_sheet::<_, 4, 6, 11>(k, cells, &part)?,
                Sheet::Cubic(cells) => search.search_sheet::<_, 4, 6, 11>(k, cells, &part)?,
                Sheet::High(cells) => search.search_sheet::<_, 8, 14, 27>(k, cells, &part)?,
            }
        }
        let IsophoteSearch { curves, points, .. } = search;
        let mut isophotes = curves.into_paths(self, &job.sub_job(0.9, 1.0))?;
        add_point_paths(self, &points, &mut isophotes)?;
        self.report_wrong_angles(axis, angles, unsigned, &mut isophotes)?;
        add_leus_points(isophotes, spacing)
    }

    /// Reports places of curves where the normal is regular, but makes another angle: once for
    /// successive points of a cell.
    fn report_wrong_angles(&self, axis: DVec3, angles: &[f64], unsigned: bool, paths: &mut Paths) -> Result<()> {
        let mut last: Option<Place> = None;
        for k in 0..paths.len() {
            let goal = angles[paths.levels[k] as usize];
            for at in paths.ends[k] as usize..paths.ends[k + 1] as usize {
                let (place, normal) = (paths.places[at], paths.normals[at]);
                let along = normal.dot(axis);
                let angle = libm::atan2(normal.cross(axis).length(), if unsigned { along.abs() } else { along });
                let known = last.is_some_and(|last| (last.sheet, last.cell) == (place.sheet, place.cell));
                if (angle - goal).abs() > MAX_ANGLE_ERROR_RADIANS
                    && !known
                    && self.local_geometry(place).normal.kind == NormalKind::Regular
                {
                    alloc::push(&mut paths.unresolved, place)?;
                    last = Some(place);
                }
            }
        }
        Ok(())
    }
}

impl AngleClasses {
    fn new(angles: &[f64], unsigned: bool) -> Result<Self> {
        let mut classes = AngleClasses { unsigned, ..AngleClasses::default() };
        for (k, &angle) in angles.iter().enumerate() {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            if sin.abs() >= MIN_NONZERO_SINE {
                alloc::push(&mut classes.crossed_angles, angle)?;
            }
            if cos.abs() < MIN_NONZERO_SINE {
                alloc::push(&mut classes.silhouettes, k as u32)?;
            } else if sin.abs() < MIN_NONZERO_SINE {
                alloc::push(&mut classes.poles, (k as u32, cos))?;
                if unsigned {
                    alloc::push(&mut classes.poles, (k as u32, -cos))?;
                }
            } else {
                alloc::push(&mut classes.other_sines_and_cosines, [sin, cos])?;
                alloc::push(&mut classes.radians, angle)?;
                alloc::push(&mut classes.level_numbers, k as u32)?;
            }
        }
        Ok(classes)
    }
}

/// The search of all sheets, and its results.
struct IsophoteSearch<'a> {
    surface: &'a Surface<'a>,
    frame: [DVec3; 3],
    classes: AngleClasses,
    chord: Option<f64>,
    curves: SheetContourSet,
    points: Vec<(u32, Place)>,
}

impl IsophoteSearch<'_> {
    /// Adds the curves and points of sheet k.
    fn search_sheet<C: SheetCells<N>, const N: usize, const H: usize, const M: usize>(
        &mut self,
        k: usize,
        cells: &C,
        job: &Job<'_>,
    ) -> Result<()> {
        let IsophoteSearch { surface, frame, ref classes, chord, ref mut curves, ref mut points } = *self;
        let (sheet, cones, job) =
            (surface.sheet(k), surface.cones_of_sheet(k, &job.sub_job(0.0, 0.5))?, job.sub_job(0.5, 1.0));
        let lattice = ContourLattice::new(sheet);
        let is_smooth =
            matches!(sheet, Sheet::Grid(grid) if grid.axes().iter().all(|axis| axis.has_continuous_slopes()));
        let jumps = !is_smooth;
        let continuity = if is_smooth { SideContinuity::UpToRounding } else { SideContinuity::Discontinuous };
        let normals = ProjectedNormals::new(surface, k, cells, frame, continuity);
        // The blocks, row by row, that may have one of some angles.
        let blocks = |angles: &[f64]| {
            cone_culling::select_blocks_by_cones(cones, frame[2], |range| {
                cone_culling::may_have_angle(angles, classes.unsigned, range)
            })
        };
        let passes = classes.silhouettes.len()
            + usize::from(!classes.other_sines_and_cosines.is_empty())
            + classes.poles.len()
            + usize::from(jumps);
        let mut pass = 0;
        let mut next = || {
            pass += 1;
            job.sub_job_of_item(pass - 1, passes)
        };
        let crossed = if classes.silhouettes.is_empty() { Vec::new() } else { blocks(&[0.5 * PI])? };
        for &number in &classes.silhouettes {
            let search = ContourSearch::<_, _, N, H> { cells, source: &SilhouetteSource(&normals), lattice, chord };
            let mut contour_arcs = search.find_arcs(crossed.len(), |k| crossed[k], &next())?;
            contour_arcs.arcs.iter_mut().for_each(|arc| arc.level = number);
            curves.add_sheet_arcs(k, contour_arcs, &lattice, jumps, job.requested_threads())?;
        }
        if !classes.other_sines_and_cosines.is_empty() {
            let source = IsophoteSource::<C, N, H> { normals: &normals, classes };
            let crossed = blocks(&classes.radians)?;
            let search = ContourSearch::<_, _, N, M> { cells, source: &source, lattice, chord };
            let mut contour_arcs = search.find_arcs(crossed.len(), |k| crossed[k], &next())?;
            contour_arcs.arcs.iter_mut().for_each(|arc| arc.level = classes.level_numbers[arc.level as usize]);
            curves.add_sheet_arcs(k, contour_arcs, &lattice, jumps, job.requested_threads())?;
        }
        if jumps {
            let (angles, unsigned) = (&classes.crossed_angles, classes.unsigned);
            let unresolved = find_creases_at_angles(&normals, cones, &lattice, angles, unsigned, &next())?;
            let crease_arcs = ContourArcs { unresolved, ..ContourArcs::default() };
            curves.add_sheet_arcs(k, crease_arcs, &lattice, true, job.requested_threads())?;
        }
        for &(number, sign) in &classes.poles {
            let blocks = blocks(&[if sign > 0.0 { 0.0 } else { PI }])?;
            for part in find_normals_along_axis::<C, N, H>(&normals, k as u32, &lattice, &blocks, sign, &next())? {
                let [simple, unresolved] = part?;
                alloc::extend(points, simple.into_iter().map(|place| (number, place)))?;
                alloc::append(&mut curves.unresolved, &unresolved)?;
            }
        }
        Ok(())
    }
}

/// Finds the places in some blocks where the normal has the direction (`sign` 1), or the opposite
/// one, and the unresolved places.
fn find_normals_along_axis<C: SheetCells<N>, const N: usize, const H: usize>(
    normals: &ProjectedNormals<'_, C, N>,
    sheet: u32,
    lattice: &ContourLattice,
    blocks: &[[u32; 2]],
    sign: f64,
    job: &Job<'_>,
) -> Result<Vec<Result<[Vec<Place>; 2]>>> {
    par::map_cancellable(job, "contours", par::split_into_ranges(blocks.len(), BLOCKS_PER_TASK), |range| {
        let mut found = [Vec::new(), Vec::new()];
        for &block in &blocks[range] {
            let (corners, cells) = normals.block_corners_and_cells(lattice, block);
            for cell in cells {
                let place = |at: DVec2| Place { sheet, cell: cell.map(|k| k as u32), u: at.x, v: at.y };
                for (places, roots) in found.iter_mut().zip(normals.find_normals_along_axis::<H>(&corners, cell, sign)?)
                {
                    alloc::extend(places, roots.into_iter().map(place))?;
                }
            }
        }
        Ok(found)
    })
}
