//! Elevation, the report's occlusion circuit, and deflection (sections 15.1 to 15.4).

use scenario::{Curvature, Occlusion, Projection};

const MOON_RADIUS: f64 = 1_737_400.0;
/// A fall of the tangent from a sample to the next place that is the end of the stored ground.
const CLIFF: f64 = 0.25;
/// A rim nearer to a sample than this part of a step is no support for a curve.
const NEAREST: f64 = 0.125;

/// Tangent of the elevation of ground at height `h` and range `z` for an eye at `eye` (m).
pub fn elevation(h: f64, eye: f64, z: f64, curvature: Curvature) -> f64 {
    let drop = match curvature {
        Curvature::None => 0.0,
        Curvature::Parabolic => z * z / (2.0 * MOON_RADIUS),
        // A chord of half angle a / 2 falls by z tan(a / 2), the sine of a being z / R.
        Curvature::Exact => z * libm::tan(0.5 * libm::asin((z / MOON_RADIUS).min(1.0))),
    };
    (h - drop - eye) / z
}

/// A rim that the sweep crosses between samples `step - 1` and `step`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rim {
    /// Number of the sample at which the step ends.
    pub step: usize,
    /// Part of it, 0..=1.
    pub share: f64,
    /// Tangent of its elevation.
    pub elevation: f64,
}

/// What the circuit is shown, sample by sample: the rims of the step before it, then the elevation, or the summit of the
/// curve between its neighbours, which a real derivative circuit would see pass.
pub fn shown(elevations: &[f64], rims: &[Rim]) -> Vec<Vec<f64>> {
    let of_step = |step: usize| rims.iter().filter(move |rim| rim.step == step);
    let one = |k: usize| {
        let mut seen: Vec<f64> = of_step(k).map(|rim| rim.elevation).collect();
        let is_inner = k > 0 && k + 1 < elevations.len();
        if !is_inner {
            seen.push(elevations[k]);
            return seen;
        }
        // Neighbours on the same smooth piece: the next sample, or a rim before it.
        let before = of_step(k).next_back().map(|rim| (1.0 - rim.share, rim.elevation));
        let after = of_step(k + 1).next().map(|rim| (rim.share, rim.elevation));
        let left = before.unwrap_or((1.0, elevations[k - 1]));
        let right = after.unwrap_or((1.0, elevations[k + 1]));
        // The ground ends beyond the next place, which may be a rim before the next sample.
        let cliff = elevations[k] - right.1 >= CLIFF;
        seen.push(if cliff { elevations[k] } else { summit(left, elevations[k], right) });
        seen
    };
    (0..elevations.len()).map(one).collect()
}

/// The summit of the parabola through three places, if the middle one is the highest of them: left and right are given by
/// their distances from it, in steps, and their values.
fn summit((a, left): (f64, f64), middle: f64, (c, right): (f64, f64)) -> f64 {
    if !(left < middle && right <= middle) || a < NEAREST || c < NEAREST {
        return middle;
    }
    // y = middle + s x + q x^2 through (-a, left) and (c, right).
    let (rise, fall) = ((middle - left) / a, (right - middle) / c);
    let q = (fall - rise) / (a + c);
    let s = rise + q * a;
    middle - s * s / (4.0 * q)
}

/// What the circuit remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circuit {
    law: Occlusion,
    before: Option<f64>,
    /// Elevation in the sample-and-hold, as a tangent.
    pub held: f64,
    /// Whether the video is blanked.
    pub blank: bool,
}

impl Circuit {
    /// Nothing has been seen.
    pub fn at_start(law: Occlusion) -> Self {
        Self { law, before: None, held: f64::NEG_INFINITY, blank: false }
    }

    /// Shows the circuit the next elevation.
    pub fn step(&mut self, eta: f64) {
        let falls = self.before.is_some_and(|before| eta < before);
        match self.law {
            // While blanked the derivative is ignored: only the return to the held elevation counts.
            Occlusion::Derivative if self.blank => self.blank = eta < self.held,
            Occlusion::Derivative => self.blank = falls,
            Occlusion::PeakHold => self.blank = eta < self.held,
        }
        if !self.blank {
            self.held = eta;
        }
        self.before = Some(eta);
    }
}

/// Constants of a sweep: `Y / D = (a - b t) / (c + e t)`, positive down (section 15.3).
#[derive(Debug, Clone, Copy)]
pub struct Deflection {
    law: Projection,
    pitch: f64,
    beta: f64,
    /// Lines of the raster, and tangent of half its height.
    raster: (f64, f64),
}

impl Deflection {
    /// For a sweep at the azimuth of tangent `tan_beta` from the heading.
    pub fn of(law: Projection, pitch: f64, tan_beta: f64, raster: (f64, f64)) -> Self {
        Self { law, pitch, beta: libm::atan(tan_beta), raster }
    }

    /// Display line, from the top, of ground under an elevation of tangent `t`.
    pub fn line(&self, t: f64) -> f64 {
        let (sin, cos) = (libm::sin(self.pitch), libm::cos(self.pitch));
        let cos_beta = libm::cos(self.beta);
        let down = match self.law {
            Projection::AsReported => (sin - cos * t) / (cos + sin * t),
            Projection::Corrected => -t / cos_beta,
            Projection::Exact => (sin * cos_beta - cos * t) / (cos * cos_beta + sin * t),
        };
        let (lines, tan_half_height) = self.raster;
        0.5 * lines * (1.0 + down / tan_half_height)
    }
    /// Lines of the raster.
    pub fn lines(&self) -> f64 {
        self.raster.0
    }

    /// Middle and half of the tangents between both edges of the picture; 0 and 1 where the sweep does not run from the lower edge
    /// to the upper one.
    pub fn field(&self) -> [f64; 2] {
        let [top, bottom] = [-self.raster.1, self.raster.1].map(|down| self.tangent(down));
        let is_sound = top > bottom && top.is_finite() && bottom.is_finite();
        if is_sound { [0.5 * (top + bottom), 0.5 * (top - bottom)] } else { [0.0, 1.0] }
    }

    /// Tangent of the elevation that is `down` below the middle of the picture, of the distance: [`line`](Self::line) solved for it.
    fn tangent(&self, down: f64) -> f64 {
        let (sin, cos) = (libm::sin(self.pitch), libm::cos(self.pitch));
        let cos_beta = libm::cos(self.beta);
        match self.law {
            Projection::AsReported => (sin - down * cos) / (cos + down * sin),
            Projection::Corrected => -down * cos_beta,
            Projection::Exact => cos_beta * (sin - down * cos) / (cos + down * sin),
        }
    }
}

/// The cubic with value and derivative (a step) at both ends: its value and derivative at `s`.
pub(crate) fn hermite(s: f64, [y0, m0]: [f64; 2], [y1, m1]: [f64; 2]) -> (f64, f64) {
    let (s2, s3) = (s * s, s * s * s);
    let value = (2.0 * s3 - 3.0 * s2 + 1.0) * y0
        + (s3 - 2.0 * s2 + s) * m0
        + (3.0 * s2 - 2.0 * s3) * y1
        + (s3 - s2) * m1;
    let slope = 6.0 * (s2 - s) * (y0 - y1) + (3.0 * s2 - 4.0 * s + 1.0) * m0 + (3.0 * s2 - 2.0 * s) * m1;
    (value, slope)
}
