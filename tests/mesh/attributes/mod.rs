//! Attributes carried over to results.

mod fields;
mod rules;
mod splits;
mod textures;

use crate::common::{Soup, Steady};
use glam::DVec3;
use gusset::Job;
use gusset::attributes::{Channel, Counts, Domain, Origins, Output, Rule, ValueType, carry_values_over};
use gusset::mesh::Mesh;

/// The doubles that [`carry_values_over`] writes.
fn carried(origins: &Origins, domain: Domain, rule: Rule, components: usize, inputs: &[Vec<f64>]) -> Vec<f64> {
    let mut channel = Channel::new(domain, ValueType::F64, components as u32, rule).unwrap();
    for input in inputs {
        channel.push(bytemuck::cast_slice(input), 0, input.len() / components).unwrap();
    }
    let count = origins.table(domain).len();
    let mut out = vec![f64::NAN; count * components];
    let mut output =
        Output::new(bytemuck::cast_slice_mut(&mut out), 0, count, channel.value_type_and_components()).unwrap();
    carry_values_over(origins, &channel, &mut output, &Job::new(0, &Steady::default())).unwrap();
    out
}

/// The pieces and the result of an operation.
struct Case {
    name: &'static str,
    pieces: Vec<Soup>,
    mesh: Mesh,
    origins: Origins,
}

impl Case {
    /// The values of a function of positions, of the elements of each piece.
    fn given(&self, domain: Domain, of: impl Fn(DVec3) -> f64) -> Vec<Vec<f64>> {
        let values = |soup: &Soup| {
            let at = |v: u32| of(DVec3::from_array(soup.points[v as usize]));
            match domain {
                Domain::Vertices => (0..soup.points.len() as u32).map(at).collect(),
                Domain::Corners => soup.corners.iter().map(|&v| at(v)).collect(),
                Domain::Faces => soup.faces().map(|face| face.iter().map(|&v| at(v)).sum::<f64>()).collect(),
            }
        };
        self.pieces.iter().map(values).collect()
    }

    fn at(&self, v: u32) -> DVec3 {
        self.mesh.positions.get(v)
    }

    /// Sums, signs, counts.
    fn assert_sound(&self) {
        let name = self.name;
        let counts = |soup: &Soup| Counts {
            vertices: soup.points.len(),
            corners: soup.corners.len(),
            faces: soup.faces().count(),
        };
        assert_eq!(self.origins.inputs(), self.pieces.iter().map(counts).collect::<Vec<_>>(), "{name}");
        let lengths = [self.mesh.positions.len(), self.mesh.face_corners.len(), self.mesh.face_count()];
        for (domain, length) in [Domain::Vertices, Domain::Corners, Domain::Faces].into_iter().zip(lengths) {
            let table = self.origins.table(domain);
            assert_eq!(table.len(), length, "{name}: {domain:?}");
            let total: usize = self.origins.inputs().iter().map(|counts| counts.count(domain)).sum();
            for k in 0..length {
                let (sources, weights) = table.row(k);
                assert!(sources.iter().all(|&source| (source as usize) < total), "{name}: {domain:?} {k}");
                assert!(weights.iter().all(|&w| w > 0.0), "{name}: {domain:?} {k}");
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{name}: {domain:?} {k} {weights:?}");
            }
        }
    }
}
