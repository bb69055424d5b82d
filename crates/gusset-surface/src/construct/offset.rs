//! The offset surface of a sheet.

use crate::{Grid, Nodes, Scheme, Sheet};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::node_normals::node_normals;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_curve::frame::node_distances;

const PROGRESS_STAGE: &str = "offsetting";
/// Number of corners or cells between two progress reports.
const CORNERS_PER_REPORT: usize = 1 << 12;

impl Sheet<'_> {
    /// Returns the sheet through the corners of this sheet's cells, each moved along the surface's
    /// normal. Also returns the largest error, measured in the middles of the cells. Corners
    /// without a normal do not move.
    ///
    /// Normals at nodes of a grid are computed from circles through neighbours. They are exact on
    /// planes, spheres and cylinders. For patches, the surface's own normals are used.
    ///
    /// `distances` holds one distance for all corners, one for each line of corners along v, or one
    /// for each corner. A line that closes the sheet counts, but moves with the first line.
    ///
    /// O(cells).
    ///
    /// # Errors
    /// [`ValuesDiffer`](gusset_base::Error::ValuesDiffer) for any other number of distances,
    /// [`BadValue`](gusset_base::Error::BadValue) if a distance is not finite,
    /// [`NetTooSmall`](gusset_base::Error::NetTooSmall),
    /// [`NotFinite`](gusset_base::Error::NotFinite) if a corner overflows,
    /// [`OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Cancelled`](gusset_base::Error::Cancelled).
    pub fn offset(&self, distances: &[f64], job: &Job<'_>) -> Result<(Sheet<'static>, f64)> {
        let ([rows, columns], closed) = (self.cells(), self.is_closed());
        let [height, width] = [rows + 1, columns + 1];
        let distance = node_distances(distances, [height, width])?;
        let corner = |k: usize| self.corner(k / width, k % width);
        let normals = match self {
            Sheet::Grid(_) => {
                // Without the repeated lines.
                let [h, w] = [height - usize::from(closed[0]), width - usize::from(closed[1])];
                let nodes = (0..h * w).map(|k| self.corner(k / w, k % w));
                let nodes = alloc::collect_cancellable(nodes, &job.sub_job(0.0, 0.1), PROGRESS_STAGE)?;
                // Scaled to coordinates near 1, whose squares and inverses neither overflow nor
                // underflow.
                let unit = common_unit(&nodes);
                let nodes = nodes.iter().map(|&p| p / unit);
                let nodes = alloc::collect_cancellable(nodes, &job.sub_job(0.1, 0.15), PROGRESS_STAGE)?;
                let own = node_normals(&nodes, [h, w], closed, &job.sub_job(0.15, 0.25), PROGRESS_STAGE)?;
                let normals = (0..height * width).map(|k| own[k / width % h * w + k % width % w]);
                alloc::collect_cancellable(normals, &job.sub_job(0.25, 0.3), PROGRESS_STAGE)?
            }
            _ => alloc::try_collect((0..height * width).map(|k| {
                job.sub_job(0.0, 0.3).step_every(CORNERS_PER_REPORT, k, height * width, PROGRESS_STAGE)?;
                let ([i, u], [j, v]) =
                    (cell_and_parameter_of_line(k / width, rows), cell_and_parameter_of_line(k % width, columns));
                Ok::<_, Error>(self.normal(i as usize, j as usize, u, v))
            }))?,
        };
        job.step(0.3, PROGRESS_STAGE)?;
        let same = |k: usize| {
            let (i, j) = (k / width, k % width);
            let [i, j] = [(i, rows, closed[0]), (j, columns, closed[1])].map(|(i, n, c)| if c { i % n } else { i });
            i * width + j
        };
        let mut data = alloc::with_capacity(3 * height * width)?;
        for k in 0..height * width {
            job.sub_job(0.3, 0.5).step_every(CORNERS_PER_REPORT, k, height * width, PROGRESS_STAGE)?;
            let k = same(k);
            data.extend((corner(k) + distance(k) * normals[k]).to_array());
        }
        let nodes = Nodes::strided(data, height, width, 0, 0)?;
        let made = Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap)?);
        let mut deviation = 0.0f64;
        for k in 0..rows * columns {
            job.sub_job(0.5, 1.0).step_every(CORNERS_PER_REPORT, k, rows * columns, PROGRESS_STAGE)?;
            let (i, j) = (k / columns, k % columns);
            let corners = [[i, j], [i, j + 1], [i + 1, j], [i + 1, j + 1]].map(|[i, j]| distance(same(i * width + j)));
            let by = corners.iter().sum::<f64>() / 4.0;
            let wanted = self.jet(i, j, 0.5, 0.5).point + by * self.normal(i, j, 0.5, 0.5);
            deviation = deviation.max(made.jet(i, j, 0.5, 0.5).point.distance(wanted));
        }
        Ok((made, deviation))
    }
}

/// The cell that a line of corners belongs to, and the parameter of the line in it.
fn cell_and_parameter_of_line(line: usize, cells: usize) -> [f64; 2] {
    let cell = line.min(cells - 1);
    [cell as f64, (line - cell) as f64]
}

#[cfg(test)]
mod tests {
    use super::CORNERS_PER_REPORT;
    use crate::{Grid, Nodes, Patches, Scheme, Sheet};
    use glam::DVec3;
    use gusset_base::job::{Job, Progress};
    use std::cell::Cell;
    use std::ops::ControlFlow;

    /// Counts the reports of each tenth of the progress.
    #[derive(Default)]
    struct ReportsOfTenths([Cell<usize>; 11]);

    impl Progress for ReportsOfTenths {
        fn step(&self, fraction: f64, _: &'static str) -> ControlFlow<()> {
            let tenth = &self.0[(10.0 * fraction) as usize];
            tenth.set(tenth.get() + 1);
            ControlFlow::Continue(())
        }
    }

    #[test]
    fn every_part_of_an_offset_reports() {
        let side = 400;
        let nodes = (0..side * side).flat_map(|k| [(k / side) as f64, (k % side) as f64, (k % 7) as f64 / 10.0]);
        let nodes = Nodes::strided(nodes.collect::<Vec<_>>(), side, side, 0, 0).unwrap();
        let grid = Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::SixTap).unwrap());
        let square = [DVec3::ZERO, DVec3::Y, DVec3::X, DVec3::ONE];
        let points: Vec<_> = (0..10_000).flat_map(|k| square.map(|p| p + f64::from(k) * DVec3::Y)).collect();
        let patches = Sheet::Cubic(Patches::new(&points, [1, 1], 1, 10_000).unwrap());
        for (sheet, first) in [(grid, 4), (patches, 20_000 / CORNERS_PER_REPORT - 2)] {
            let reports = ReportsOfTenths::default();
            sheet.offset(&[0.1], &Job::new(1, &reports)).unwrap();
            let in_tenths = |from: usize, to: usize| reports.0[from..to].iter().map(Cell::get).sum::<usize>();
            let [rows, columns] = sheet.cells();
            assert!(in_tenths(0, 3) >= first, "{reports:?}", reports = reports.0);
            assert!(in_tenths(3, 5) >= rows * columns / CORNERS_PER_REPORT, "{reports:?}", reports = reports.0);
            assert!(in_tenths(5, 11) >= rows * columns / CORNERS_PER_REPORT, "{reports:?}", reports = reports.0);
        }
    }
}
