//! The offset surface of a sheet.

use crate::{Grid, Nodes, Scheme, Sheet};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::node_normals::node_normals;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_curve::frame::node_distances;

const PROGRESS_STAGE: &str = "offsetting";

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
                let nodes = alloc::collect((0..h * w).map(|k| self.corner(k / w, k % w)))?;
                // Scaled to coordinates near 1, whose squares and inverses neither overflow nor
                // underflow.
                let unit = common_unit(&nodes);
                let nodes = alloc::collect(nodes.iter().map(|&p| p / unit))?;
                let own = node_normals(&nodes, [h, w], closed)?;
                alloc::collect((0..height * width).map(|k| own[k / width % h * w + k % width % w]))?
            }
            _ => alloc::collect((0..height * width).map(|k| {
                let ([i, u], [j, v]) =
                    (cell_and_parameter_of_line(k / width, rows), cell_and_parameter_of_line(k % width, columns));
                self.normal(i as usize, j as usize, u, v)
            }))?,
        };
        job.step(0.3, PROGRESS_STAGE)?;
        let same = |k: usize| {
            let (i, j) = (k / width, k % width);
            let [i, j] = [(i, rows, closed[0]), (j, columns, closed[1])].map(|(i, n, c)| if c { i % n } else { i });
            i * width + j
        };
        let mut data = alloc::with_capacity(3 * height * width)?;
        for k in (0..height * width).map(same) {
            data.extend((corner(k) + distance(k) * normals[k]).to_array());
        }
        let nodes = Nodes::strided(data, height, width, 0, 0)?;
        let made = Sheet::Grid(Grid::new(nodes, closed, Scheme::SixTap)?);
        let mut deviation = 0.0f64;
        for k in 0..rows * columns {
            job.sub_job(0.5, 1.0).step_every(1 << 12, k, rows * columns, PROGRESS_STAGE)?;
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
