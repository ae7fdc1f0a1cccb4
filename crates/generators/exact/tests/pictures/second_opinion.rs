//! Against brute force: marching along each ray in small steps over the landscape's own heights.

use std::sync::Arc;

use crate::scenes::{bumps, draw, landscape, laws, pose, settings, sun};
use hardware_model::Settings;
use landscape::{LUNOID_RADIUS, Landscape, Sun, parabolic_drop};
use proptest::prelude::*;
use scenario::{Curvature, PixelRule, Pose, Projection};

const COLUMNS: u32 = 5;
const LINES: u32 = 6;
const STEP: f64 = 0.01;

/// Ground above the ray at a range (m), or `None` beyond the area: the obvious way.
struct Scene<'a> {
    landscape: &'a Landscape,
    settings: &'a Settings,
    pose: &'a Pose,
    azimuth: f64,
    rise: f64,
}

impl Scene<'_> {
    /// Place of a range; one that leaves the area by the rounding of an angle is put back on the edge.
    fn place(&self, range: f64) -> [f64; 2] {
        let [x, y, _] = self.pose.eye;
        let [south, west, north, east] = self.landscape.level().extent();
        let snap = |at: f64, low: f64, high: f64| {
            let inside = at.clamp(low, high);
            if (at - inside).abs() < 1e-12 { inside } else { at }
        };
        let [to_north, to_east] = [libm::cos(self.azimuth), libm::sin(self.azimuth)];
        [snap(x + range * to_north, south, north), snap(y + range * to_east, west, east)]
    }

    fn above(&self, range: f64) -> Option<f64> {
        let [x, y] = self.place(range);
        let drop = match self.settings.laws.curvature {
            Curvature::None => 0.0,
            Curvature::Parabolic => parabolic_drop(range),
            Curvature::Exact => LUNOID_RADIUS - (LUNOID_RADIUS * LUNOID_RADIUS - range * range).sqrt(),
        };
        Some(self.landscape.height(x, y)? - drop - self.pose.eye[2] - self.rise * range)
    }

    /// The first range whose sample is not below the ray; infinite if there is none, or it is the first.
    fn march(&self) -> f64 {
        let [near, far] = [self.settings.range.start, self.settings.range.end];
        let mut range = near;
        while range <= far {
            match self.above(range) {
                None => break,
                Some(above) if above >= 0.0 && range == near => break,
                Some(above) if above >= 0.0 => return range,
                Some(_) => range += STEP,
            }
        }
        f64::INFINITY
    }
}

/// Azimuth and rise of a place on the view-plane, by rotation matrix or by angles.
fn angles(projection: Projection, pose: &Pose, x: f64, y: f64) -> (f64, f64) {
    let azimuth = pose.attitude.heading + libm::atan(x);
    match projection {
        Projection::Exact => {
            let [u, v, w] = (pose.attitude.to_terrain() * glam::DVec3::new(1.0, x, y)).to_array();
            (libm::atan2(v, u), -w / libm::hypot(u, v))
        }
        Projection::AsReported => (azimuth, libm::tan(pose.attitude.pitch - libm::atan(y))),
        Projection::Corrected => (azimuth, -y * libm::cos(libm::atan(x))),
    }
}

/// Draws and compares every pixel; counts those that show ground.
fn check(landscape: &Arc<Landscape>, light: Sun, settings: &Settings, pose: &Pose) -> usize {
    let (intensity, ranges) = draw(landscape, light, settings, pose);
    let field = settings.raster.field;
    let mut seen = 0;
    for (index, (&intensity, &range)) in intensity.iter().zip(&ranges).enumerate() {
        let (column, line) = (index as u32 % COLUMNS, index as u32 / COLUMNS);
        let x = field.tan_half_width * (f64::from(2 * column + 1) / f64::from(COLUMNS) - 1.0);
        let y = field.tan_half_height * (f64::from(2 * line + 1) / f64::from(LINES) - 1.0);
        let (azimuth, rise) = angles(settings.laws.projection, pose, x, y);
        let scene = Scene { landscape, settings, pose, azimuth, rise };
        let (marched, range) = (scene.march(), f64::from(range));
        assert!(
            range.is_infinite() == (intensity == 0.0) || range.is_finite(),
            "{index}: {range} {intensity}"
        );
        // Marching may step over a crest that the ray only just meets, never the other way round.
        assert!(range <= marched + 1e-4, "{index}: {range}, but the ground is met at {marched}");
        if range.is_finite() {
            let above = scene.above(range).unwrap_or(0.0);
            assert!(above.abs() < 1e-3, "{index}: at {range} the ground is {above} above the ray");
            let [px, py] = scene.place(range);
            let shade = landscape.at(px, py).map(|point| point.albedo * light.reflectivity(point.slopes));
            let shade = shade.unwrap_or(f64::from(intensity));
            assert!((f64::from(intensity) - shade).abs() < 1e-4, "{index}: {intensity}, not {shade}");
            if range > settings.range.start + STEP {
                assert!(scene.above(range - STEP).unwrap() < 1e-3, "{index}: not the first");
            }
            seen += 1;
        }
    }
    seen
}

fn projections() -> impl Strategy<Value = Projection> {
    prop_oneof![Just(Projection::Exact), Just(Projection::AsReported), Just(Projection::Corrected)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn bumpy_ground(
        seed in any::<u64>(),
        relief in 0.1..2.0f64,
        eye in (10.0..38.0f64, 10.0..38.0f64, 0.2..3.0f64),
        (pitch, heading) in (-25.0..15.0f64, 0.0..360.0f64),
        projection in projections(),
        curved in any::<bool>(),
    ) {
        let ground = landscape(bumps(seed, relief), 0.9);
        let curvature = if curved { Curvature::Parabolic } else { Curvature::None };
        let settings = settings(COLUMNS, LINES, laws(projection, curvature, PixelRule::Centre), [0.5, 45.0]);
        let height = ground.height(eye.0, eye.1).unwrap() + eye.2;
        check(&ground, sun(200.0, 30.0), &settings, &pose([eye.0, eye.1, height], pitch, heading));
    }
}

#[test]
fn eyes_on_corners_and_boundaries_along_axes_and_diagonals() {
    let ground = landscape(bumps(3, 1.0), 1.0);
    let mut seen = 0;
    for place in
        [[24.0, 24.0], [24.0, 21.0], [19.0, 16.0], [0.0, 0.0], [48.0, 48.0], [0.0, 24.0], [48.0, 11.0]]
    {
        for heading in [0.0, 45.0, 90.0, 180.0, 225.0, 270.0, 1e-9, 90.0 - 1e-9] {
            for (projection, pitch) in
                [(Projection::Exact, 0.0), (Projection::Exact, -9.0), (Projection::AsReported, -9.0)]
            {
                let settings = settings(
                    COLUMNS,
                    LINES,
                    laws(projection, Curvature::None, PixelRule::Centre),
                    [0.5, 45.0],
                );
                let height = ground.height(place[0], place[1]).unwrap() + 1.2;
                let pose = pose([place[0], place[1], height], pitch, heading);
                seen += check(&ground, sun(200.0, 30.0), &settings, &pose);
            }
        }
    }
    assert!(seen > 1000, "{seen} pixels of ground");
}
