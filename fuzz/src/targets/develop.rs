//! Developments of any mesh: an error, or charts without folds, of discs, with the lengths they say.

use crate::input;
use crate::input::Soup;
use gusset::Job;
use gusset::develop::{Cuts, Distortion, Finish, Options, develop};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some((soup, kind, darts, path)) = input::taken::<(Soup, u8, u8, Vec<u8>)>(bytes) else { return };
    soup.visit(|mesh| {
        let vertices: Vec<u32> = path.iter().take(12).map(|&v| u32::from(v) % mesh.positions().len() as u32).collect();
        let options = Options {
            distortion: [Distortion::Symmetric, Distortion::Rigid, Distortion::Conformal][usize::from(kind % 3)],
            cuts: Cuts { vertices: if kind < 128 { &[] } else { &vertices }, offsets: &[] },
            max_darts: u32::from(darts % 4),
            max_stretch: (darts > 200).then_some(1.1),
            max_iterations: u32::from(kind / 3 % 8),
        };
        let Ok(done) = develop(mesh, &options, &Job::default()) else { return };
        assert_eq!(done.mesh.face_count(), mesh.faces().len());
        assert!(done.points.iter().all(|p| p.is_finite()));
        assert!(done.darts <= options.max_darts);
        let mut faces = 0;
        for chart in &done.charts {
            faces += chart.faces;
            assert!(chart.energy.is_nan() || chart.energy >= 4.0 - 1e-6, "{chart:?}");
            assert!(chart.finish == Finish::Folded || chart.folds == 0, "{chart:?}");
            assert!(matches!(chart.finish, Finish::Folded | Finish::Exact) || chart.overlaps == 0, "{chart:?}");
        }
        assert_eq!(faces as usize, mesh.faces().len());
        let size = done.points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
        for f in 0..mesh.faces().len() {
            let range = mesh.faces().corner_range(f);
            let own = &done.mesh.face_corners[range.clone()];
            for (k, h) in range.enumerate() {
                assert_eq!(done.vertex_map[own[k] as usize], mesh.faces().corner(h as u32));
            }
            if done.charts[done.face_charts[f] as usize].finish == Finish::Exact {
                let [a, b] = [own[0], own[1]];
                let flat = done.points[a as usize].distance(done.points[b as usize]);
                let at = |v: u32| mesh.positions().get(done.vertex_map[v as usize]);
                let wanted = crate::distance(at(a), at(b));
                assert!((flat - wanted).abs() <= 1e-9 * size, "{flat} for {wanted}");
            }
        }
    });
}
