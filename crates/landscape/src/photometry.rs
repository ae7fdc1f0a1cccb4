//! Laws of reflection (section 7, specular factor; the report invites other functions).

use signal::Real;

/// How much light the ground sends to the eye: `albedo * mu0 * factor`.
///
/// `mu0 = n.s` and `mu = n.v` are the cosines of incidence and emission, `cos_g = s.v` that of the phase angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Photometry {
    /// The same from all directions: factor 1. As reported.
    Lambert,
}

impl Photometry {
    /// Factor to Lambert's `mu0`; 1 for Lambert. Finite for any `mu0`, `mu`; negative cosines count as 0.
    pub fn factor<S: Real>(&self, _mu0: S, _mu: S, _cos_g: S) -> S {
        match self {
            Self::Lambert => S::ONE,
        }
    }
}
