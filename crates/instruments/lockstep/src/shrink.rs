//! A scene that differs, made as small as it can be while it still differs.

use hardware_model::{
    AmplifierParts, AnalogParts, FunctionGeneratorParts, LatePolicy, LevelTurn, SweepParts,
};
use landscape::Photometry;
use scenario::{Curvature, Occlusion, Projection, RangeLaw};

use crate::scene::{ComparedScene, level_of};

/// What makes a scene simpler; a step that changes nothing is none.
type Step = fn(&ComparedScene) -> Option<ComparedScene>;

/// Simplifying steps with their names, the coarsest first.
const STEPS: &[(&str, Step)] = &[
    ("one sweep", |scene| changed(scene, |scene| scene.sweeps = 1)),
    ("one level", |scene| changed(scene, |scene| scene.coarse = None)),
    ("no texture", |scene| changed(scene, |scene| scene.texture.clear())),
    ("no nearer switch", |scene| changed(scene, |scene| scene.level_turn = LevelTurn::NEVER)),
    ("no gain of texture", |scene| changed(scene, |scene| scene.crater_gain = [1.0; 3])),
    ("no crater", |scene| changed(scene, |scene| scene.craters.clear())),
    ("the first half of the craters", |scene| {
        let half = scene.craters.len().div_ceil(2);
        changed(scene, |scene| scene.craters.truncate(half))
    }),
    ("the second half of the craters", |scene| {
        let half = scene.craters.len() / 2;
        changed(scene, |scene| drop(scene.craters.drain(..half)))
    }),
    ("ideal parts", |scene| changed(scene, |scene| scene.parts.0 = AnalogParts::ideal())),
    ("one-pole parts", |scene| {
        changed(scene, |scene| {
            let parts = &mut scene.parts.0;
            (parts.sweep, parts.amplifier) = (SweepParts::IDEAL, AmplifierParts::IDEAL);
        })
    }),
    ("exact function generators", |scene| {
        changed(scene, |scene| scene.parts.0.function_generator = FunctionGeneratorParts::IDEAL)
    }),
    ("Lambert's law", |scene| changed(scene, |scene| scene.photometry = Photometry::Lambert)),
    ("wired transfers", |scene| {
        changed(scene, |scene| {
            (scene.loader.access, scene.loader.pointer, scene.loader.strobe) = (0, 0, 0);
            scene.loader.late_policy = LatePolicy::StrobeThrough;
        })
    }),
    ("level ground", |scene| changed(scene, |scene| keep_words(scene, &[]))),
    ("ground without derivatives of second order", |scene| {
        changed(scene, |scene| keep_words(scene, &[0, 1, 3, 4]))
    }),
    ("no pitch", |scene| changed(scene, |scene| scene.pitch = 0.0)),
    ("a flat Moon", |scene| changed(scene, |scene| scene.laws.curvature = Curvature::None)),
    ("peak-hold", |scene| changed(scene, |scene| scene.laws.occlusion = Occlusion::PeakHold)),
    ("exact projection", |scene| changed(scene, |scene| scene.laws.projection = Projection::Exact)),
    ("constant rate", |scene| changed(scene, |scene| scene.range.law = RangeLaw::ConstantRate)),
    ("half the samples", |scene| {
        let samples = (scene.samples / 2).max(8);
        changed(scene, |scene| scene.samples = samples)
    }),
    ("half the range", |scene| {
        (scene.range.end > 4.0 * scene.range.start).then(|| {
            let mut half = scene.clone();
            half.range.end *= 0.5;
            half
        })
    }),
];

/// Most steps tried: each takes something away, so there are not many.
const MOST_ROUNDS: usize = 40;

fn changed(scene: &ComparedScene, change: impl FnOnce(&mut ComparedScene)) -> Option<ComparedScene> {
    let mut simpler = scene.clone();
    change(&mut simpler);
    (simpler != *scene).then_some(simpler)
}

/// Sets all words but those of `kept` to 0.
fn keep_words(scene: &mut ComparedScene, kept: &[usize]) {
    let level = &scene.level;
    let (corners, words) = (level.corners(), level.words().to_vec());
    let plain = |m: usize, n: usize| {
        let old = words[m * corners[1] + n];
        std::array::from_fn(|word| if kept.contains(&word) { old[word] } else { 0.0 })
    };
    scene.level = level_of(level.region_size(), level.origin(), corners, plain);
}

/// The smallest scene found that `differs` still says something of, what that is, and what was left out on the way.
/// Scenes that cannot be drawn differ in nothing.
pub fn shrink(scene: ComparedScene, differs: impl Fn(&ComparedScene) -> Option<String>) -> Option<Shrunk> {
    let mut now = Shrunk { difference: differs(&scene)?, scene, left_out: Vec::new() };
    for _ in 0..MOST_ROUNDS {
        let found = STEPS.iter().find_map(|(name, step)| {
            let simpler = step(&now.scene)?;
            Some((*name, differs(&simpler)?, simpler))
        });
        let Some((name, difference, scene)) = found else { break };
        now.left_out.push(name);
        (now.difference, now.scene) = (difference, scene);
    }
    Some(now)
}

/// A scene that differs, as small as it could be made.
#[derive(Debug, Clone, PartialEq)]
pub struct Shrunk {
    /// The scene that still differs.
    pub scene: ComparedScene,
    /// How it differs, in words.
    pub difference: String,
    /// What was made simpler, in order.
    pub left_out: Vec<&'static str>,
}

impl Shrunk {
    /// What is left of it, in a few words.
    pub fn describe(&self) -> String {
        let ComparedScene {
            level, sweeps, samples, craters, texture, eye, heading, pitch, laws, range, ..
        } = &self.scene;
        let [north, east] = level.corners();
        format!(
            "{sweeps} sweeps of {samples} samples over {north} x {east} corners of {} m from {:?} m; {} craters {craters:?}; \
             {} layers of texture; {:?}; {} levels; eye {eye:?} m, heading {heading} rad, pitch {pitch} rad; {laws:?}; {range:?}; \
             loader {:?}; parts {:?}; made simpler: {}",
            level.region_size(),
            level.origin(),
            craters.len(),
            texture.len(),
            self.scene.photometry,
            1 + usize::from(self.scene.coarse.is_some()),
            self.scene.loader,
            self.scene.parts,
            if self.left_out.is_empty() { "nothing".to_owned() } else { self.left_out.join(", ") },
        )
    }
}
