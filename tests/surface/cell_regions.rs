//! Chains of cells, diameters of regions and regions without holes.

use crate::reference::{empty, samples, sheets};
use crate::shapes::Random;
use glam::DVec3;
use gusset::surface::reference::{
    CellGridShape, CellMask, Diameters, euler_characteristic, integer_diameter, shortest_chain,
};
use gusset::{Element, Error, Job};

/// The shortest chains between all pairs of cells, by relaxation.
fn by_relaxation(region: &CellMask) -> Option<usize> {
    let lattice = region.lattice();
    let all: Vec<_> = region.cells().collect();
    let mut longest = 0;
    for &from in &all {
        let mut steps = vec![usize::MAX; lattice.len()];
        steps[lattice.index(from)] = 1;
        loop {
            let mut changed = false;
            for &cell in &all {
                let around = lattice.neighbours(cell).filter(|&other| region.get(other));
                let near = around.map(|other| steps[lattice.index(other)]).min().unwrap_or(usize::MAX);
                if near < usize::MAX && near + 1 < steps[lattice.index(cell)] {
                    (steps[lattice.index(cell)], changed) = (near + 1, true);
                }
            }
            if !changed {
                break;
            }
        }
        longest = all.iter().map(|&cell| steps[lattice.index(cell)]).max()?.max(longest);
    }
    (longest < usize::MAX).then_some(longest)
}

#[test]
fn chains_and_integer_diameters() {
    let job = Job::default();
    let mut random = Random(11);
    for (cells, closed) in [
        ([6, 9], [false; 2]),
        ([5, 8], [true, false]),
        ([7, 6], [true; 2]),
        ([1, 9], [false; 2]),
        ([4, 3], [false, true]),
    ] {
        let lattice = CellGridShape { cells, closed };
        // (6), and its half in closed directions.
        let whole = CellMask::full(lattice).unwrap();
        let expected = [0, 1].map(|k| if closed[k] { cells[k] / 2 + 1 } else { cells[k] });
        assert_eq!(integer_diameter(&whole, &job), Ok(Some(expected[0].max(expected[1]))));
        assert_eq!(by_relaxation(&whole), Some(expected[0].max(expected[1])));
        for share in [0.2, 0.45, 0.6, 0.8] {
            let mut region = empty(lattice);
            (0..lattice.len()).for_each(|k| region.set(lattice.cell(k), random.next() < share));
            let truth = by_relaxation(&region);
            assert_eq!(integer_diameter(&region, &job).unwrap(), if region.count() == 0 { Some(0) } else { truth });
            let all: Vec<_> = region.cells().collect();
            let Some((&from, &to)) = all.first().zip(all.last()) else { continue };
            let Some(found) = shortest_chain(&region, from, to, &job).unwrap() else {
                assert!(truth.is_none());
                continue;
            };
            assert!(found.first() == Some(&from) && found.last() == Some(&to));
            assert!(found.windows(2).all(|pair| lattice.neighbours(pair[0]).any(|other| other == pair[1])));
            assert!(found.iter().all(|&cell| region.get(cell)) && truth.is_none_or(|truth| found.len() <= truth));
        }
    }
    let region = empty(CellGridShape { cells: [2, 2], closed: [false; 2] });
    assert_eq!(integer_diameter(&region, &job), Ok(Some(0)));
    assert_eq!(
        shortest_chain(&region, [0, 0], [1, 1], &job),
        Err(Error::NoSuch { element: Element::Cell, index: 0, count: region.lattice().len() as u64 })
    );
    assert!(shortest_chain(&region, [0, 2], [1, 1], &job).is_err());
}

#[test]
fn regions_without_holes() {
    let lattice = CellGridShape { cells: [6, 7], closed: [false; 2] };
    let euler_characteristic = |region: &CellMask| euler_characteristic(region, &Job::default()).unwrap();
    let whole = CellMask::full(lattice).unwrap();
    assert_eq!(euler_characteristic(&whole), 1);
    let mut holed = whole.clone();
    holed.set([2, 3], false);
    assert_eq!(euler_characteristic(&holed), 0);
    let mut two = empty(lattice);
    [[0, 0], [3, 3]].into_iter().for_each(|cell| two.set(cell, true));
    assert_eq!(euler_characteristic(&two), 2);
    // Cells that meet at a corner only are in one part.
    let mut corner = empty(lattice);
    [[0, 0], [1, 1]].into_iter().for_each(|cell| corner.set(cell, true));
    assert_eq!(euler_characteristic(&corner), 1);
    for (closed, expected) in [([true, false], 0), ([true, true], 0)] {
        let ring = CellMask::full(CellGridShape { closed, ..lattice }).unwrap();
        assert_eq!(euler_characteristic(&ring), expected);
    }
}

/// (2), (3), (5): chains and regions of real cells are within their bounds.
#[test]
fn regions_are_no_wider_than_their_bounds() {
    for sheet in sheets() {
        let sizes = Diameters::new(&sheet, &Job::default()).unwrap().euclidean;
        let lattice = sizes.lattice();
        let whole = CellMask::full(lattice).unwrap();
        let path = shortest_chain(&whole, [0, 0], lattice.cell(lattice.len() - 1), &Job::default()).unwrap().unwrap();
        let points: Vec<_> = path.iter().flat_map(|&cell| samples(&sheet, cell)).collect();
        let width = |points: &[(DVec3, DVec3)]| {
            points.iter().flat_map(|a| points.iter().map(move |b| a.0.distance(b.0))).fold(0.0, f64::max)
        };
        let of_chain: f64 = path.iter().map(|&cell| sizes.get(cell)).sum();
        assert!(width(&points) <= of_chain * (1.0 + 1e-14));
        let all: Vec<_> = whole.cells().map(|cell| samples(&sheet, cell)[12]).collect();
        let integer = integer_diameter(&whole, &Job::default()).unwrap().unwrap();
        assert!(width(&all) <= sizes.region_bound(&whole, integer).unwrap());
    }
}
