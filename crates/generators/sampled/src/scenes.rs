//! Small scenes for the tests of this crate, whose work can be counted by hand.

use std::sync::Arc;

use generator::Stage;
use glam::DVec3;
use landscape::relief::Relief;
use landscape::{Attitude, Bank, Landscape, Sun};
use quantities::{Rate, radians};
use scenario::{
    Carried, Curvature, Display, Effects, FieldOfView, Laws, LightPoint, LightSource, Medium, Overlay, Pose,
    Scenery, Sheet, View,
};

use crate::hardware::Hardware;
use crate::parameters::Parameters;
use crate::sampled::Sampled;

/// Pitch of the eye (degrees): no ground is in view.
const PITCH: f64 = 60.0;
/// Tangent of half the field of view.
const TANGENT: f64 = 0.1;
/// Place of the eye: north, east, up (m).
const EYE: [f64; 3] = [0.0, 0.0, 2.0];

/// The generator with a clock of 1 kHz, a tick for every piece of work, and as many pixels a tick as a sub-area has.
pub fn slow(update: u64) -> (Sampled, Rate) {
    let shipped = Hardware::shipped().unwrap();
    let hardware = Hardware { sampler_hz: 1000, least_ticks: 1, pixels_tick: 64, ..shipped };
    (Sampled { parameters: Parameters::default(), hardware }, Rate::new(update, 1).unwrap())
}

/// A picture of 16 x 16 pixels: sky with `effects` over level ground that is out of view.
pub fn stage(effects: Effects, update: Rate) -> Stage {
    let ground = Relief::flat(1, [400.0, 400.0], 10.0).build().unwrap();
    let landscape = Landscape::new(Bank::new("test", vec![ground], None).unwrap(), 1.0);
    let sun = Sun { azimuth: 0.0, elevation: 1.0 };
    Stage {
        landscape: Arc::new(landscape),
        scenery: Arc::new(Scenery::still(sun).with_effects(vec![Carried::still(effects)])),
        view: View {
            columns: 16,
            lines: 16,
            field: FieldOfView { tan_half_width: TANGENT, tan_half_height: TANGENT },
            update,
            refresh: update,
            display: Display { white: 1.0, gamma: 1.0 },
            laws: Laws { curvature: Curvature::None, ..Laws::default() },
            ranges: [1.0, 100.0],
            yoke: None,
            levels: None,
            shadows: None,
        },
    }
}

/// The same with a course of `frames` poses that nod: each looks 0.02 rad higher than the one before.
pub fn moving(effects: Effects, update: Rate, frames: u32) -> Stage {
    let nod = |frame: u32| {
        let attitude = Attitude { pitch: pose().attitude.pitch + 0.02 * f64::from(frame), ..pose().attitude };
        Pose { attitude, ..pose() }
    };
    let still = stage(effects, update);
    let scenery = (*still.scenery).clone().with_course((0..frames).map(nod).collect::<Vec<_>>());
    Stage { scenery: Arc::new(scenery), ..still }
}

/// The pose from which the ground is out of view.
pub fn pose() -> Pose {
    let attitude = Attitude { roll: 0.0, pitch: radians(PITCH), heading: 0.0 };
    Pose { time: 0.0, eye: EYE, attitude, yoke: 0.0 }
}

/// The direction that a place on the screen shows: x right and y down, in half widths from its middle.
fn direction([x, y]: [f64; 2]) -> DVec3 {
    let (sin, cos) = quantities::sin_cos(radians(PITCH));
    let [ahead, right, down] = [[cos, 0.0, sin], [0.0, 1.0, 0.0], [sin, 0.0, -cos]].map(DVec3::from_array);
    ahead + TANGENT * (x * right + y * down)
}

/// Half the picture, on the left, behind a pane that lets half of the light through: two triangles.
pub fn pane() -> Overlay {
    let corners = vec![[-1.0, -1.0], [0.0, -1.0], [0.0, 1.0], [-1.0, 1.0]];
    Overlay { id: 0, corners, colour: [0.5; 3], share: 0.5, priority: 0 }
}

/// A star at a place of the screen (half widths from its middle).
pub fn star(id: u32, place: [f64; 2], magnitude: f64, calligraphic: bool) -> LightPoint {
    let source = LightSource::Star { direction: direction(place).normalize(), magnitude };
    LightPoint { id, source, colour: [1.0; 3], intensity: 1.0, lobe: None, priority: 0, calligraphic }
}

/// A triangle across the view at a depth (m), half the picture wide and `size` half heights high, about the middle of the screen.
pub fn sheet(id: u32, depth: f64, size: f64) -> Sheet {
    let corner = |place| DVec3::from_array(EYE) + depth * direction(place);
    let corners = [[-0.5, size], [0.0, -size], [0.5, size]].map(corner).to_vec();
    Sheet { id, corners, colour: [0.5; 3], medium: Medium::Share(0.5), priority: 0 }
}

/// The pane, a raster star at the top right, and a calligraphic one at the bottom right.
pub fn pane_and_stars() -> Effects {
    let lights = vec![star(0, [0.5, -0.5], 0.0, false), star(1, [0.5, 0.5], 1.0, true)];
    Effects { lights, overlays: vec![pane()], ..Effects::default() }
}
