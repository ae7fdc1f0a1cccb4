//! From slopes to reflectivity (section 7; sheet of the terrain generator for laws beyond Lambert's).

use landscape::Photometry;

use crate::scene::SceneData;

/// Share of Lommel and Seeliger's law in the Moon's light, ascending powers of the sine of half the phase angle:
/// numbers of the model, fitted to McEwen's cubic.
const LUNAR: [f64; 6] =
    [1.0, -2.2210139902647366, 3.840379366714423, -5.6989020576452685, 6.983089757032966, -5.063234815652837];
/// Least sum of both cosines that is divided by.
const GRAZING: f64 = 1e-6;

/// Sun, law and albedo of a sweep.
#[derive(Debug, Clone, Copy)]
pub struct Light {
    to_sun: [f64; 3],
    albedo: f64,
    law: Photometry,
    direction: [f64; 2],
}

impl Light {
    /// The light of `scene` on a sweep along `direction`.
    pub fn of(scene: &SceneData<'_>, direction: [f64; 2]) -> Self {
        let (e, a) = (scene.sun.elevation, scene.sun.azimuth);
        Self {
            to_sun: [libm::cos(e) * libm::cos(a), libm::cos(e) * libm::sin(a), libm::sin(e)],
            albedo: scene.landscape.albedo(),
            law: *scene.landscape.photometry(),
            direction,
        }
    }

    /// Reflectivity of ground with slopes (hx, hy) that is seen under an elevation of tangent `sight` (below 0
    /// downwards); below 0 the face is turned from the sun.
    pub fn reflectivity(&self, [hx, hy]: [f64; 2], sight: f64) -> f64 {
        let normal_length = (1.0 + hx * hx + hy * hy).sqrt();
        let [north, east, up] = self.to_sun;
        self.beyond_lambert((up - hx * north - hy * east) / normal_length, [hx, hy], sight)
    }

    /// The unit vector to the sun: north, east, up.
    pub fn to_sun(&self) -> [f64; 3] {
        self.to_sun
    }

    /// The same where something else tells `mu0`, the cosine of the angle between sun and normal.
    pub fn beyond_lambert(&self, mu0: f64, [hx, hy]: [f64; 2], sight: f64) -> f64 {
        let normal_length = (1.0 + hx * hx + hy * hy).sqrt();
        let [north, east, up] = self.to_sun;
        // From the ground back to the eye.
        let sight_length = (1.0 + sight * sight).sqrt();
        let to_eye =
            [-self.direction[0] / sight_length, -self.direction[1] / sight_length, -sight / sight_length];
        let mu = (to_eye[2] - hx * to_eye[0] - hy * to_eye[1]) / normal_length;
        let cos_g = north * to_eye[0] + east * to_eye[1] + up * to_eye[2];
        self.albedo * mu0 * factor(self.law, mu0, mu, cos_g)
    }
}

fn factor(law: Photometry, mu0: f64, mu: f64, cos_g: f64) -> f64 {
    let lommel_seeliger = 2.0 / (mu0.abs() + mu.max(0.0)).max(GRAZING);
    match law {
        Photometry::Lambert => 1.0,
        Photometry::LommelSeeliger => lommel_seeliger,
        Photometry::LunarLambert => {
            let sin_half = (0.5 * (1.0 - cos_g)).clamp(0.0, 1.0).sqrt();
            let powers = (0..6).map(|k| LUNAR[k] * libm::pow(sin_half, k as f64));
            let share = powers.sum::<f64>().max(0.0);
            share * lommel_seeliger + 1.0 - share
        }
        Photometry::Specular { strength, exponent } => {
            let mirrored = (2.0 * mu0.max(0.0) * mu.max(0.0) - cos_g).clamp(0.0, 1.0);
            1.0 + strength * libm::pow(mirrored, f64::from(exponent))
        }
    }
}
