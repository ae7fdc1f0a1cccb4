//! Scenes from a seed.

use features::{Crater, Shape};
use hardware_model::{
    BankPlace, BlendWeight, Channels, CrossingServer, DataBanks, Drum, DrumQueue, FeatureParts, Gate,
    IoProcessor, KindBank, KindBanks, LatePolicy, LevelSwitch, LevelTurn, Organisation, ShadowParts,
};
use landscape::{Layer, Photometry, Sun};
use quantities::{radians, unit_interval};
use scenario::{
    Curvature, FeatureLight, Occlusion, Projection, RangeLaw, RangeProgramme, ShadowFineness, TextureInShadow,
};

use crate::random_parts::{behind_the_terrain, parts};
use crate::scene::{ComparedScene, UPDATE_HZ, level_of};

/// Throws that depend on the seed and their number alone.
#[derive(Debug, Clone)]
pub struct Dice {
    seed: u64,
    thrown: u64,
}

impl Dice {
    /// Dice of one seed.
    pub fn new(seed: u64) -> Self {
        Self { seed, thrown: 0 }
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.thrown += 1;
        low + (high - low) * unit_interval(self.seed, &[self.thrown])
    }

    /// A whole number in `low..=high`.
    pub fn count(&mut self, low: usize, high: usize) -> usize {
        (self.between(low as f64, high as f64 + 1.0) as usize).min(high)
    }

    /// Returns one of `choices`, all equally likely.
    pub fn choose<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.count(0, choices.len() - 1)]
    }

    /// Mean 0, variance 1: the sum of twelve even throws.
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.between(-0.5, 0.5)).sum()
    }
}

/// A scene of random coefficients (variance `scale` squared, all nine words alike), regions of any size, an eye
/// anywhere above the ground, any heading, laws and range programme as they fall.
pub fn scene(seed: u64) -> ComparedScene {
    let mut dice = Dice::new(seed);
    let corners = [dice.count(4, 24), dice.count(4, 24)];
    let size = dice.between(20.0, 900.0);
    let origin = [dice.between(-5e3, 5e3), dice.between(-5e3, 5e3)];
    let scale = size * dice.between(0.005, 0.05);
    let words: Vec<[f64; 9]> =
        (0..corners[0] * corners[1]).map(|_| std::array::from_fn(|_| scale * dice.normal())).collect();
    let mut scene = ComparedScene::over(level_of(size, origin, corners, |m, n| words[m * corners[1] + n]));
    let place = |dice: &mut Dice, axis: usize| {
        origin[axis] + size * dice.between(0.0, 1.0) * (corners[axis] - 1) as f64
    };
    let (x, y) = (place(&mut dice, 0), place(&mut dice, 1));
    scene.stand(x, y, scale * dice.between(0.05, 5.0));
    scene.heading = radians(dice.between(-180.0, 360.0));
    scene.pitch = radians(dice.between(-25.0, 25.0));
    scene.sun =
        Sun { azimuth: radians(dice.between(0.0, 360.0)), elevation: radians(dice.between(1.0, 60.0)) };
    // From several samples a region to less than one.
    scene.samples = dice.count(24, 400) as u32;
    scene.albedo = dice.between(0.1, 1.0);
    scene.range = range(&mut dice, size);
    scene.laws.projection = dice.choose(&[Projection::Exact, Projection::AsReported, Projection::Corrected]);
    scene.laws.curvature = dice.choose(&[Curvature::Parabolic, Curvature::None, Curvature::Exact]);
    scene.laws.occlusion = dice.choose(&[Occlusion::Derivative, Occlusion::PeakHold]);
    scene
}

fn range(dice: &mut Dice, size: f64) -> RangeProgramme {
    let end = size * dice.between(1.0, 20.0);
    let start = end * dice.between(5e-4, 0.02);
    let two_rate = RangeLaw::TwoRate { switch: 0.1 * end, fine_share: 0.5 };
    let laws = [RangeLaw::ConstantRate, two_rate, RangeLaw::ConstantElevation, RangeLaw::Geometric];
    RangeProgramme { law: dice.choose(&laws), start, end }
}

/// A terrain [`scene`] with craters of all types, of any size and nested as they fall, texture, any law of reflection,
/// two levels or one, and words that come late or at once.
pub fn landscape(seed: u64) -> ComparedScene {
    let mut scene = scene(seed);
    let mut dice = Dice::new(seed ^ 0x6c75_6e61);
    scene.craters = craters(&mut dice, &scene);
    let raised = scene.craters.iter().map(Crater::highest).sum::<f64>();
    scene.eye[2] += raised;
    if dice.count(0, 2) > 0 {
        let layer = |dice: &mut Dice| Layer {
            cell: scene.range.end * dice.between(0.002, 0.05),
            amplitude: dice.between(0.01, 0.3),
            range: scene.range.end * dice.between(0.1, 1.5),
        };
        scene.texture = (0..dice.count(1, 3)).map(|_| layer(&mut dice)).collect();
    }
    let highlight =
        Photometry::Specular { strength: dice.between(0.1, 2.0), exponent: dice.count(1, 60) as u32 };
    let laws = [Photometry::Lambert, Photometry::LommelSeeliger, Photometry::LunarLambert, highlight];
    scene.photometry = dice.choose(&laws);
    scene.laws.feature_light = dice.choose(&[FeatureLight::Combined, FeatureLight::AsReported]);
    scene.laws.texture_in_shadow = dice.choose(&[TextureInShadow::On, TextureInShadow::Off]);
    if dice.count(0, 3) == 0 {
        scene.coarse = Some(coarse(&mut dice, &scene));
    }
    if dice.count(0, 2) == 0 {
        slow(&mut dice, &mut scene);
    }
    let mut dice = Dice::new(seed ^ 0x6469_6769);
    if dice.count(0, 2) == 0 {
        craters_on_a_line(&mut dice, &mut scene);
    }
    if dice.count(0, 2) == 0 {
        processor(&mut dice, &mut scene);
    }
    if dice.count(0, 2) == 0 {
        drums(&mut dice, &mut scene);
    }
    if dice.count(0, 9) == 0 {
        shadows(&mut dice, &mut scene);
    }
    let mut dice = Dice::new(seed ^ 0x6261_6e6b);
    if scene.data_banks.drum.is_some() && dice.count(0, 3) > 0 {
        kind_banks(&mut dice, &mut scene);
    }
    let mut dice = Dice::new(seed ^ 0x7061_7274);
    if dice.count(0, 2) == 0 {
        scene.parts = (parts(&mut dice, scene.step()), seed);
        if scene.coarse.is_some() {
            // The coarse array begins where it is seen, and has forgotten all but e^-7 of an overload before that.
            scene.parts.0.amplifier.recovery = 0.0;
        }
    }
    let mut dice = Dice::new(seed ^ 0x626c_656e);
    if scene.coarse.is_some() {
        scene.parts.0.level_blend.slope_term = dice.count(0, 3) > 0;
        if dice.count(0, 3) == 0 {
            scene.parts.0.level_blend.weight = BlendWeight::Cubic;
        }
    }
    let mut dice = Dice::new(seed ^ 0x7475_726e);
    if scene.coarse.is_some() && scene.turn != 0.0 && dice.count(0, 2) > 0 {
        let rate = scene.turn.abs() * UPDATE_HZ as f64 * dice.between(0.3, 1.2);
        scene.level_turn = LevelTurn { rate, share: dice.between(0.2, 0.9) };
    }
    let mut dice = Dice::new(seed ^ 0x6772_6169);
    if dice.count(0, 2) > 0 {
        scene.crater_gain = [(); 3].map(|()| dice.between(0.0, 4.0));
    }
    scene
}

/// The same landscape on a machine of which every block may have real parts.
pub fn machine(seed: u64) -> ComparedScene {
    let mut scene = landscape(seed);
    let mut dice = Dice::new(seed ^ 0x6265_616d);
    if dice.count(0, 2) == 0 {
        scene.parts.1 = seed;
        behind_the_terrain(&mut dice, scene.step(), &mut scene.parts.0);
        scene.gate = dice.choose(&[Gate::Presence, Gate::Presence, Gate::SelfKeyed]);
    }
    if !scene.parts.0.beam_is_ideal() {
        // Without it rounding says whether level ground falls.
        scene.parts.0.comparator.hysteresis = dice.choose(&[0.001, 0.01]);
    }
    scene
}

/// Remote shadow, as coarse as it may be: what it is does not matter here, but when its words come.
fn shadows(dice: &mut Dice, scene: &mut ComparedScene) {
    let finest = scene.range.end * 0.01;
    scene.shadows = Some(ShadowFineness { finest, angle: 0.02, reach: None });
    scene.sun.elevation = radians(dice.between(2.0, 15.0));
    let loads_a_sweep = dice.between(1.0, 100.0);
    let rate = 4.0 * loads_a_sweep * (UPDATE_HZ as f64) * f64::from(scene.sweeps);
    scene.segment_words = dice.choose(&[None, Some(rate)]);
    scene.shadow_controller =
        ShadowParts::Digital { line_generators: dice.choose(&[None, Some(1), Some(4)]) };
}

/// Ticks of a frame of a scene.
fn ticks_of_frame(scene: &ComparedScene) -> f64 {
    scene.master_hz as f64 / UPDATE_HZ as f64
}

/// Words of craters that take time, or few sub-generators, in either organisation.
fn craters_on_a_line(dice: &mut Dice, scene: &mut ComparedScene) {
    let loads_a_sweep = dice.between(1.0, 40.0);
    let rate = 8.0 * loads_a_sweep * (UPDATE_HZ as f64) * f64::from(scene.sweeps);
    scene.feature_words = dice.choose(&[None, Some(rate)]);
    scene.feature_generator = FeatureParts {
        organisation: dice.choose(&[Organisation::Scheduled, Organisation::ByRegion]),
        sub_generators: dice.choose(&[None, Some(1), Some(2), Some(4)]),
    };
}

/// A processor that is late now and then, on a clock slow enough to be followed tick by tick.
fn processor(dice: &mut Dice, scene: &mut ComparedScene) {
    scene.master_hz = scene.master_hz.min(UPDATE_HZ * u64::from(scene.sweeps * scene.samples) * 4);
    let sweep = ticks_of_frame(scene) / f64::from(scene.sweeps);
    scene.cpu.sweep_setup = (sweep * dice.choose(&[0.0, 0.3, 1.0, 2.3]) * dice.between(0.5, 1.0)) as u64;
    scene.cpu.frame_tables = (sweep * dice.between(0.0, 6.0)) as u64;
    scene.cpu.memory_cycle = dice.count(0, 2) as u64;
    scene.cpu.dma_cycles_per_word = dice.count(0, 2) as u32;
    if dice.count(0, 3) == 0 {
        scene.loader.served_by = CrossingServer::CpuInterrupt;
        scene.cpu.longest_instruction = dice.count(0, 9) as u64;
        scene.cpu.interrupt = dice.count(0, 4) as u64;
        scene.cpu.priority_levels = dice.choose(&[None, Some(1)]);
    }
}

/// Drums that bring corners while the view turns.
fn drums(dice: &mut Dice, scene: &mut ComparedScene) {
    let frame = ticks_of_frame(scene);
    let record_words = 9 * dice.choose(&[1, 1, 4, 9]);
    scene.data_banks = DataBanks {
        drum: Some(Drum {
            rotation: (frame * dice.between(0.02, 2.0)) as u64 + 1,
            word: frame / f64::from(record_words) * dice.between(0.0005, 0.02),
            record_words,
            queue: dice.choose(&[DrumQueue::Fifo, DrumQueue::ShortestLatency]),
            count: dice.count(1, 4) as u32,
        }),
        channels: Channels { count: dice.choose(&[None, Some(1), Some(2)]), word: 0.0 },
        buffer_words: dice.choose(&[None, Some(9 * 200), Some(9 * 40)]),
    };
    scene.turn = radians(dice.between(-40.0, 40.0));
}

/// Craters and boundaries of shadow that lie on drums too, together with terrain or apart, edited in up to some frames.
fn kind_banks(dice: &mut Dice, scene: &mut ComparedScene) {
    let frame = ticks_of_frame(scene);
    let kind = |dice: &mut Dice| {
        let record_words = dice.choose(&[9, 24, 200]);
        KindBank {
            place: dice.choose(&[BankPlace::Local, BankPlace::Apart, BankPlace::Together]),
            record_words,
            record_regions: dice.count(1, 3) as u32,
            buffer_words: dice.choose(&[None, Some(600)]),
            edit: frame * dice.choose(&[0.0, 0.03, 0.4, 2.0]) / f64::from(record_words),
        }
    };
    let (features, shadows) = (kind(dice), kind(dice));
    let coarse = dice.choose(&[BankPlace::Apart, BankPlace::Together]);
    let terrain_edit = dice.choose(&[0.0, 0.002]) * frame / 9.0;
    scene.kind_banks = KindBanks { coarse, terrain_edit, features, shadows, ..scene.kind_banks };
}

/// Up to thirty craters that lie wholly on the ground, the nearer ones more often.
fn craters(dice: &mut Dice, scene: &ComparedScene) -> Vec<Crater> {
    let [south, west, north, east] = scene.level.extent();
    let one = |dice: &mut Dice| {
        let far = scene.range.end * dice.between(0.0, 1.0) * dice.between(0.0, 1.0);
        let azimuth = scene.heading + radians(dice.between(-40.0, 40.0));
        let centre = [scene.eye[0] + far * libm::cos(azimuth), scene.eye[1] + far * libm::sin(azimuth)];
        let outer = (scene.level.region_size() * dice.between(0.01, 0.5)).min(0.5 * far + 0.5);
        let (rim, floor) = (dice.between(0.5, 0.9), dice.between(0.1, 0.4));
        let (depth, height) = (outer * dice.between(0.0, 0.4), outer * dice.between(0.0, 0.08));
        let shape = match dice.count(1, 3) {
            1 => Shape::Bowl { r1: outer },
            2 => Shape::RimmedBowl { r1: rim * outer, r2: outer },
            _ => Shape::FlatFloor { r1: floor * outer, r2: rim * outer, r3: outer },
        };
        let height = if matches!(shape, Shape::Bowl { .. }) { 0.0 } else { height };
        let inside = south + outer < centre[0]
            && centre[0] < north - outer
            && west + outer < centre[1]
            && centre[1] < east - outer;
        inside.then(|| Crater::new(centre, shape, depth, height).expect("radii ascend"))
    };
    (0..dice.count(0, 30)).filter_map(|_| one(dice)).collect()
}

/// A second level on regions three times as large, over the same ground and more, and where it takes over.
fn coarse(dice: &mut Dice, scene: &ComparedScene) -> (landscape::Level, LevelSwitch) {
    let fine = &scene.level;
    let size = 3.0 * fine.region_size();
    let corners = fine.corners().map(|corners| corners / 3 + 4);
    let origin = fine.origin().map(|place| place - size);
    let scale = fine.region_size() * 0.02;
    let words: Vec<[f64; 9]> =
        (0..corners[0] * corners[1]).map(|_| std::array::from_fn(|_| scale * dice.normal())).collect();
    let range = scene.range.end * dice.between(0.1, 0.8);
    let blend = dice.choose(&[0.0, 0.5]) * range;
    (level_of(size, origin, corners, |m, n| words[m * corners[1] + n]), LevelSwitch { range, blend })
}

/// A loader that is late now and then.
fn slow(dice: &mut Dice, scene: &mut ComparedScene) {
    let loader = &mut scene.loader;
    loader.late_policy = dice.choose(&[LatePolicy::StrobeThrough, LatePolicy::Latched]);
    loader.access = dice.count(1, 40) as u64;
    loader.pointer = dice.count(0, 5) as u64;
    loader.strobe = dice.count(0, 3) as u64;
    loader.words_per_access = dice.count(1, 9) as u32;
    loader.urgent_first = dice.choose(&[true, false]);
    loader.diagonal_register = dice.choose(&[true, false]);
    loader.served_by = dice.choose(&[CrossingServer::WiredPointers, CrossingServer::IoProcessor]);
    let command = |dice: &mut Dice| dice.count(0, 4) as u64;
    loader.io_processor = IoProcessor { order: command(dice), chain: command(dice), edit: command(dice) };
    // About one tick a step, so that words come some steps after their fold.
    scene.master_hz = 30 * u64::from(scene.sweeps * scene.samples) * dice.count(1, 3) as u64;
}
