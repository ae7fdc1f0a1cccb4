//! The modified terrain generator: a fine one near, a coarse one far (section 8).

use hardware_model::{BlendWeight, LevelBlendParts, Loader};
use landscape::Level;
use scenario::LevelSwitch;

use crate::clock::Clock;
use crate::frame::Frame;
use crate::given::Given;
use crate::parts::{self, Figures};
use crate::scene::SceneData;
use crate::server::Interrupts;
use crate::walk::{ARRAYS, Course, Walk, walk};

/// Terrain at one sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroundSample {
    /// Height of the terrain (m).
    pub height: f64,
    /// Slopes to the north and to the east.
    pub slopes: [f64; 2],
}

/// Both generators of a sweep, and what they make together.
#[derive(Debug, Clone)]
pub struct Terrain {
    /// Walk of the fine generator.
    pub fine: Walk,
    /// The coarse one, where there is one.
    pub coarse: Option<Walk>,
    /// What is drawn, sample by sample, up to the end of the stored ground.
    pub ground: Vec<GroundSample>,
}

fn interrupts<'a>(scene: &SceneData<'a>, sweep: u32, given: &Given<'_>) -> Interrupts<'a> {
    let held = given.frame.held.get(sweep as usize).copied().unwrap_or(0);
    let begins = Clock::of(scene, sweep).seen(0.0);
    Interrupts {
        cpu: &scene.settings.cpu,
        held: (held > 0).then_some(begins + held),
        place: (scene.frame, sweep),
        draw: given.draw,
        seed: scene.settings.seed,
    }
}

impl Terrain {
    /// Ground range at which the farther generator ends (m).
    pub fn end(&self, scene: &SceneData<'_>) -> f64 {
        let end = scene.settings.range.end;
        let switch = scene.switch(scene.frame, scene.heading).filter(|_| self.coarse.is_some());
        let far = switch.map_or(end, |switch| switch.range);
        let fine = self.fine.edge.unwrap_or(far).min(end);
        self.coarse.as_ref().map_or(fine, |coarse| coarse.edge.unwrap_or(end).max(fine))
    }
}

/// The figures of the array over a level, if it has real parts.
fn figures(scene: &SceneData<'_>, level: &Level, number: usize, given: &Given<'_>) -> Option<Figures> {
    let analog = &scene.settings.analog;
    let step = given.between as f64 / scene.settings.timebase.sample_rate().hertz();
    let of_parts = || parts::figures::figures(step, level, analog, &given.parts, ARRAYS[number]);
    (!analog.terrain_is_ideal()).then(of_parts)
}

/// The terrain of sweep `sweep` along `direction`, without the corners that are missing on each level.
pub fn terrain(scene: &SceneData<'_>, sweep: u32, direction: [f64; 2], given: &Given<'_>) -> Terrain {
    let Given { ranges, frame: Frame { missing, .. }, between, .. } = *given;
    let interrupts = interrupts(scene, sweep, given);
    let loader = &scene.settings.loader;
    let switch = scene.switch(scene.frame, scene.heading).filter(|_| scene.coarse().is_some());
    let until = switch.map_or(f64::INFINITY, |switch| switch.range);
    let level = scene.fine();
    let near = figures(scene, level, 0, given);
    let parts = near.as_ref().map(|figures| (figures, &given.parts));
    let course = Course {
        level,
        missing: &missing[0],
        number: 0,
        loader,
        direction,
        sweep,
        interrupts,
        until,
        between,
        parts,
    };
    let fine = walk(scene, &course, ranges);
    let (Some(level), Some(switch)) = (scene.coarse(), switch) else {
        let ground =
            fine.samples.iter().map(|s| GroundSample { height: s.height, slopes: s.slopes }).collect();
        return Terrain { fine, coarse: None, ground };
    };
    // Words are held back on the fine level alone.
    let plain = Loader { delays: Vec::new(), ..loader.clone() };
    let far = figures(scene, level, 1, given);
    let parts = far.as_ref().map(|figures| (figures, &given.parts));
    let until = f64::INFINITY;
    let course = Course { level, missing: &missing[1], number: 1, loader: &plain, until, parts, ..course };
    let coarse = walk(scene, &course, ranges);
    let ground = both([&fine, &coarse], (switch, scene.settings.analog.level_blend), direction, ranges);
    Terrain { fine, coarse: Some(coarse), ground }
}

/// The fine level up to the switch, or to its own edge; over the last stretch before it fades into the coarse one.
/// Without its slope term the blend mixes slopes as it mixes heights.
fn both(
    [fine, coarse]: [&Walk; 2],
    (LevelSwitch { range: switch, blend }, parts): (LevelSwitch, LevelBlendParts),
    [cos, sin]: [f64; 2],
    ranges: &[f64],
) -> Vec<GroundSample> {
    let switch = fine.edge.unwrap_or(switch);
    let mut ground = Vec::new();
    for (k, &range) in ranges.iter().enumerate() {
        let (near, far) = (fine.samples.get(k), coarse.samples.get(k));
        let shown = match (near, far) {
            (None, None) => break,
            (Some(near), _) if range <= switch - blend => {
                GroundSample { height: near.height, slopes: near.slopes }
            }
            (Some(near), Some(far)) => {
                let part = (range - (switch - blend)) / blend;
                let (p2, p3) = (part * part, part * part * part);
                let (w, rate) = match parts.weight {
                    BlendWeight::Quintic => (
                        1.0 - 10.0 * p3 + 15.0 * p3 * part - 6.0 * p3 * p2,
                        -30.0 * p2 * (1.0 - part) * (1.0 - part) / blend,
                    ),
                    BlendWeight::Cubic => (1.0 - 3.0 * p2 + 2.0 * p3, 6.0 * (p2 - part) / blend),
                };
                let rate = if parts.slope_term { rate } else { 0.0 };
                let step = near.height - far.height;
                let slope = |axis: usize, c: f64| {
                    w * near.slopes[axis] + (1.0 - w) * far.slopes[axis] + rate * step * c
                };
                GroundSample {
                    height: w * near.height + (1.0 - w) * far.height,
                    slopes: [slope(0, cos), slope(1, sin)],
                }
            }
            (Some(near), None) => GroundSample { height: near.height, slopes: near.slopes },
            (None, Some(far)) => GroundSample { height: far.height, slopes: far.slopes },
        };
        ground.push(shown);
    }
    ground
}
