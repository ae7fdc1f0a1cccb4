//! The rings of a crater: in each of them its height is a quadratic in the distance from the centre.

use crate::{Crater, Shape};

/// A ring of a crater, from the outer radius of the ring before, or from the centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Outer radius of the ring (m).
    pub outer: f64,
    /// Height (m) at a distance rho (m) from the centre is `terms[0] rho^2 + terms[1] rho + terms[2]`.
    pub terms: [f64; 3],
}

impl Crater {
    /// The rings from the centre outwards.
    pub fn rings(&self) -> impl Iterator<Item = Ring> + use<> {
        let (depth, rim) = (self.depth(), self.rim());
        let bowl = |r1: f64| Some(Ring { outer: r1, terms: [depth / (r1 * r1), 0.0, -depth] });
        let rings = match self.shape() {
            Shape::Bowl { r1 } => [bowl(r1), None, None],
            Shape::RimmedBowl { r1, r2 } => [bowl(r1), Some(crest(rim, r1, r2)), None],
            Shape::FlatFloor { r1, r2, r3 } => {
                let floor = Ring { outer: r1, terms: [0.0, 0.0, -depth] };
                [Some(floor), Some(wall(depth, r1, r2)), Some(crest(rim, r2, r3))]
            }
        };
        rings.into_iter().flatten()
    }
}

/// `rim (1 - ((2 rho - inner - outer) / (outer - inner))^2)`.
fn crest(rim: f64, inner: f64, outer: f64) -> Ring {
    let (width, middle) = (outer - inner, inner + outer);
    let scale = rim / (width * width);
    Ring { outer, terms: [-4.0 * scale, 4.0 * scale * middle, rim - scale * middle * middle] }
}

/// `depth (((rho - inner) / (outer - inner))^2 - 1)`.
fn wall(depth: f64, inner: f64, outer: f64) -> Ring {
    let width = outer - inner;
    let scale = depth / (width * width);
    Ring { outer, terms: [scale, -2.0 * scale * inner, scale * inner * inner - depth] }
}

#[cfg(test)]
mod tests {
    use crate::{Crater, Shape};

    #[test]
    fn rings_are_the_profile() {
        let shapes = [
            Shape::Bowl { r1: 100.0 },
            Shape::RimmedBowl { r1: 100.0, r2: 140.0 },
            Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 },
        ];
        for (shape, rim) in shapes.into_iter().zip([0.0, 6.0, 6.0]) {
            let crater = Crater::new([0.0; 2], shape, 20.0, rim).unwrap();
            for rho in (0..150).map(f64::from) {
                let ring = crater.rings().find(|ring| rho < ring.outer);
                let [a, b, c] = ring.map_or([0.0; 3], |ring| ring.terms);
                assert!(
                    ((a * rho + b) * rho + c - crater.profile(rho)[0]).abs() < 1e-12,
                    "{shape:?} at {rho}"
                );
            }
            assert_eq!(crater.rings().last().map(|ring| ring.outer), Some(crater.outer()));
        }
    }
}
