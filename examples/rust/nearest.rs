//! Finds the nearest points on a smooth surface through a grid of nodes.

use gusset::glam::DVec3;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Job, Result};

fn main() -> Result<()> {
    // ! [surface]
    // 101 rows of 101 nodes, x, y, z one after another.
    let at = |i: usize, j: usize| [i as f64 / 50.0 - 1.0, j as f64 / 50.0 - 1.0];
    let nodes: Vec<f64> = (0..101 * 101)
        .flat_map(|node| {
            let [x, y] = at(node / 101, node % 101);
            [x, y, 0.2 * (5.0 * x).sin() * (4.0 * y).cos()]
        })
        .collect();

    let job = Job::default();
    let grid = Grid::new(Nodes::strided(&nodes, 101, 101, 0, 0)?, [false, false], Scheme::default())?;
    let surface = Surface::new(vec![Sheet::Grid(grid)], None, &job)?;
    // ! [surface]

    // ! [one]
    let query = DVec3::new(0.3, -0.2, 1.0);
    if let Some(nearest) = surface.closest(query, f64::INFINITY) {
        println!("{} at distance {:.6}", nearest.point, nearest.distance);
        println!("not nearer than {:.6}, proven: {}", nearest.bound, nearest.proven);
    }
    // ! [one]

    // ! [many]
    // Many queries share the threads of the job. Farther than 0.5 from the surface: `None`.
    let queries: Vec<DVec3> = (0..1000).map(|k| DVec3::new(0.0, 0.0, f64::from(k) / 1000.0)).collect();
    let answers = surface.closest_all(&queries, 0.5, &job)?;
    println!("{} of {} are near", answers.iter().flatten().count(), queries.len());
    // ! [many]
    assert!(answers[0].is_some() && answers[999].is_none());
    Ok(())
}

#[test]
fn it_runs() {
    main().unwrap();
}
