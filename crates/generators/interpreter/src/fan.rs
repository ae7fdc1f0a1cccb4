//! Azimuths of the sweeps, lines of the raster, ground range of the samples (sections 3, 15.3, 18, 22 no. 2).

use hardware_model::SweepMemoryKind;
use scenario::{FieldOfView, Projection, RangeLaw, RangeProgramme};

use crate::scene::SceneData;

/// Far below one accumulator step a sweep: counts as nothing (section 6.5).
const NOTHING: f64 = 1e-15;
/// Cells of a line of the screen that a scan converter keeps while the yoke turns (sheet of the sweep memory).
const CELLS_A_LINE: f64 = 4.0;

/// Ground range of every sample (m): an opinion of its own.
pub fn range_programme(programme: &RangeProgramme, samples: u32) -> Vec<f64> {
    let (start, end, count) = (programme.start, programme.end, samples as usize);
    let steps = (count - 1) as f64;
    let sample = |k: usize| {
        let k = k as f64;
        match programme.law {
            RangeLaw::ConstantRate => (k + 1.0) * end / count as f64,
            RangeLaw::TwoRate { switch, fine_share } => {
                let fine = (fine_share * steps).round().clamp(1.0, (steps - 1.0).max(1.0));
                let (fine_step, coarse_step) = (switch / (fine + 1.0), (end - switch) / (steps - fine));
                fine_step * (k.min(fine) + 1.0) + coarse_step * (k - fine).max(0.0)
            }
            RangeLaw::ConstantElevation => {
                let (near, far) = (1.0 / start, 1.0 / end);
                1.0 / (near + k * (far - near) / steps)
            }
            RangeLaw::Geometric => start * libm::pow(end / start, k / steps),
        }
    };
    (0..count).map(sample).collect()
}

/// Field of view and lines of what the sweeps write: the screen, or the box around it while the yoke turns (18).
pub fn written_raster(scene: &SceneData<'_>) -> (FieldOfView, f64) {
    let raster = &scene.settings.raster;
    let (w, h) = (raster.field.tan_half_width, raster.field.tan_half_height);
    let Some(yoke) = scene.settings.yoke else { return (raster.field, f64::from(raster.lines)) };
    let half = 0.5 * yoke.travel;
    // Half size of the box along an axis: the corner lies farthest out when it is on the axis.
    let size = |along: f64, across: f64| {
        let angle = half.min(libm::atan2(across, along));
        along * libm::cos(angle) + across * libm::sin(angle)
    };
    let field = FieldOfView { tan_half_width: size(w, h), tan_half_height: size(h, w) };
    let cells = match scene.settings.sweep_memory {
        SweepMemoryKind::ScanConverter => CELLS_A_LINE,
        SweepMemoryKind::DigitalMemory => 1.0,
    };
    (field, (f64::from(raster.lines) * field.tan_half_height / h * cells).ceil())
}

/// Tangent of the azimuth of a sweep from the heading.
pub fn tangent(scene: &SceneData<'_>, sweep: u32) -> f64 {
    let count = f64::from(scene.settings.raster.sweeps);
    (2.0 * f64::from(sweep) + 1.0 - count) / count * widest(scene)
}

/// Direction of a sweep over the ground: cosine (north) and sine (east) of its azimuth.
pub fn direction(scene: &SceneData<'_>, sweep: u32) -> [f64; 2] {
    let tan_beta = tangent(scene, sweep);
    let root = (1.0 + tan_beta * tan_beta).sqrt();
    let (cos_beta, sin_beta) = (1.0 / root, tan_beta / root);
    let whole = |cosine: f64| if cosine.abs() < NOTHING { 0.0 } else { cosine };
    let (cos, sin) = (whole(libm::cos(scene.heading)), whole(libm::sin(scene.heading)));
    [cos * cos_beta - sin * sin_beta, sin * cos_beta + cos * sin_beta]
}

/// Largest tangent of azimuth that a corner of the picture needs.
fn widest(scene: &SceneData<'_>) -> f64 {
    let (field, _) = written_raster(scene);
    let (right, down) = (field.tan_half_width, field.tan_half_height);
    match scene.settings.laws.projection {
        Projection::AsReported | Projection::Corrected => right,
        Projection::Exact => {
            let forward = |y: f64| libm::cos(scene.pitch) + y * libm::sin(scene.pitch);
            (right / forward(down)).max(right / forward(-down))
        }
    }
}
