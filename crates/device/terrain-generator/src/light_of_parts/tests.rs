use hardware_model::{AnalogParts, LoopParts, MultiplierParts, ReflectivityParts};
use landscape::{GroupLight, Photometry, Sun, SweepLight};
use signal::{LANES, Lanes, Real};

use super::{LitGroup, PartsLight, light_full_scales, light_wires, to_map};
use crate::{LIGHT, Profile, TerrainGenerator};

const H: f64 = 50e-9;
const SAMPLES: usize = 60;
const SUN: Sun = Sun { azimuth: 0.7, elevation: 0.4 };

/// A group over ground of given slopes, along and across, by lane and sample.
struct Scene {
    light: [SweepLight; LANES],
    directions: [[f64; 2]; LANES],
    ends: [usize; LANES],
    ranges: Vec<f64>,
    slopes: fn(usize, usize) -> [f64; 2],
}

impl Scene {
    fn new(law: Photometry, slopes: fn(usize, usize) -> [f64; 2]) -> Self {
        let directions: [[f64; 2]; LANES] = std::array::from_fn(|lane| {
            let (sin, cos) = libm::sincos(0.1 * lane as f64 - 0.3);
            [cos, sin]
        });
        Self {
            light: directions.map(|direction| SweepLight::new(&SUN, 0.8, law, direction)),
            directions,
            ends: [SAMPLES; LANES],
            ranges: (1..=SAMPLES).map(|k| 3.0 * k as f64).collect(),
            slopes,
        }
    }

    fn profile<S: Real>(&self) -> Profile<S> {
        let mut profile = Profile::default();
        profile.resize(SAMPLES);
        for sample in 0..SAMPLES {
            for lane in 0..LANES {
                let [along, across] = (self.slopes)(lane, sample);
                profile.height[sample][lane] = S::from_f64(0.1 * sample as f64 - 3.0);
                profile.along[sample][lane] = S::from_f64(along);
                profile.across[sample][lane] = S::from_f64(across);
            }
        }
        profile
    }

    fn group(&self) -> LitGroup<'_> {
        LitGroup {
            sun: SUN.direction(),
            light: &self.light,
            directions: &self.directions,
            ends: &self.ends,
            ranges: &self.ranges,
        }
    }

    fn lit<S: Real>(&self, light: &PartsLight) -> Vec<Lanes<S>> {
        let mut profile = self.profile::<S>();
        light.run(&self.group(), &mut profile);
        profile.reflectivity
    }

    /// The wire called `tg.light.NAME` in lane 2.
    fn wire(&self, light: &PartsLight, name: &str) -> Vec<f64> {
        light.wires(&self.group(), &self.profile::<f64>(), 2)[number(name)].clone()
    }

    /// The same of ideal parts.
    fn law(&self, name: &str) -> Vec<f64> {
        light_wires(SUN.direction(), self.directions[2], &self.profile::<f64>(), 2)[number(name)].clone()
    }
}

fn number(name: &str) -> usize {
    LIGHT.iter().position(|signal| signal.name == format!("tg.light.{name}")).expect("a wire of the stage")
}

fn parts(figures: ReflectivityParts) -> AnalogParts {
    AnalogParts { full_scale: 10.0, reflectivity: figures, ..AnalogParts::ideal() }
}

fn stage(figures: ReflectivityParts) -> PartsLight {
    PartsLight::new(H, &parts(figures), 7)
}

fn hills(lane: usize, sample: usize) -> [f64; 2] {
    let place = 0.2 * sample as f64 + lane as f64;
    [0.5 * libm::sin(place), 0.3 * libm::cos(1.3 * place)]
}

/// The slope along the sweep of lane 2 turns round at sample 20: the length of the normal stays.
fn turned<const PERCENT: usize>(_: usize, sample: usize) -> [f64; 2] {
    let slope = 0.01 * PERCENT as f64;
    [if sample < 20 { slope } else { -slope }, 0.0]
}

fn assert_near(found: &[f64], expected: &[f64], within: f64) {
    assert_eq!(found.len(), expected.len());
    for (sample, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).abs() < within, "{sample}: {found}, not {expected}");
    }
}

#[test]
fn the_wires_of_the_stage_are_named() {
    assert_eq!(LIGHT.len(), light_full_scales(&AnalogParts::ideal()).len());
    assert!(LIGHT.iter().all(|signal| signal.name.starts_with("tg.light.")));
}

fn is_the_law<S: Real>(within: f64) {
    let laws = [
        Photometry::Lambert,
        Photometry::LommelSeeliger,
        Photometry::LunarLambert,
        Photometry::Specular { strength: 0.5, exponent: 12 },
    ];
    for law in laws {
        let scene = Scene::new(law, hills);
        let found =
            scene.lit::<S>(&stage(ReflectivityParts { slope_full_scale: 2.0, ..ReflectivityParts::IDEAL }));
        let generator = TerrainGenerator { buffer: &[], region_size: 1.0, ranges: &scene.ranges, datum: 0.0 };
        let mut profile = scene.profile::<S>();
        generator.reflect(&GroupLight::new(&scene.light), 0..SAMPLES, &mut profile);
        for (found, expected) in found.iter().zip(&profile.reflectivity) {
            for lane in 0..LANES {
                assert!((found[lane].to_f64() - expected[lane].to_f64()).abs() < within, "{law:?}");
            }
        }
    }
}

#[test]
fn ideal_parts_are_the_law() {
    is_the_law::<f64>(1e-14);
    is_the_law::<f32>(3e-7);
    let scene = Scene::new(Photometry::Lambert, hills);
    let ideal = stage(ReflectivityParts::IDEAL);
    for signal in LIGHT {
        let name = &signal.name["tg.light.".len()..];
        assert_near(&scene.wire(&ideal, name), &scene.law(name), 1e-14);
    }
}

/// What the feedback is off by counts by the inverse of |N|: most over level ground, least where slopes are at full scale.
#[test]
fn the_error_of_the_divider_is_largest_where_the_normal_is_shortest() {
    let offset = 0.002;
    let mut light = stage(ReflectivityParts { slope_full_scale: 4.0, ..ReflectivityParts::IDEAL });
    light.stage.divider.offset = offset;
    let off = |slopes: fn(usize, usize) -> [f64; 2]| {
        let scene = Scene::new(Photometry::Lambert, slopes);
        scene.wire(&light, "cosine")[30] - scene.law("cosine")[30]
    };
    let span = 33.0_f64.sqrt();
    assert!((off(|_, _| [0.0; 2]) + span * offset).abs() < 1e-14);
    assert!((off(|_, _| [4.0, 0.0]) + span / 17.0_f64.sqrt() * offset).abs() < 1e-14);
}

#[test]
fn divider_and_root_solve_what_stands_in_their_feedback() {
    let mut light = stage(ReflectivityParts::IDEAL);
    (light.stage.root.offset, light.stage.root.scale) = (0.003, 1.01);
    (light.stage.divider.scale, light.stage.divider.feed_output) = (0.99, 0.004);
    light.stage.divider.feed_divisor = -0.002;
    let scene = Scene::new(Photometry::Lambert, hills);
    let [squares, root, facing, cosine] =
        ["squares", "root", "facing", "cosine"].map(|name| scene.wire(&light, name));
    let span = 3.0_f64.sqrt();
    for sample in 0..SAMPLES {
        let (d, y) = (root[sample] / span, cosine[sample]);
        let fed_back = 1.01 * d * d + 0.003;
        assert!((fed_back - squares[sample] / 3.0).abs() < 1e-14);
        let fed_back = 0.99 * y * d + 0.004 * y - 0.002 * d;
        assert!((fed_back - facing[sample] / span).abs() < 1e-14);
    }
}

/// Behind a step each part decays by its own pole; the divider's is the slower the shorter the normal.
#[test]
fn a_step_decays_by_the_pole_of_each_part() {
    let band = Some(1e6);
    let with = |change: fn(&mut ReflectivityParts, Option<f64>)| {
        let mut figures = ReflectivityParts::IDEAL;
        change(&mut figures, band);
        stage(figures)
    };
    let remains = |scene: &Scene, light: &PartsLight, wire: &str| {
        let [found, law] = [scene.wire(light, wire), scene.law(wire)];
        (found[26] - law[26]) / (found[25] - law[25])
    };
    let pole = |gain: f64| libm::exp(-gain * H * 2.0 * std::f64::consts::PI * 1e6);
    let flat = Scene::new(Photometry::Lambert, turned::<10>);
    let steep = Scene::new(Photometry::Lambert, turned::<100>);
    let product = with(|figures, band| figures.multiplier.bandwidth = band);
    let summer = with(|figures, band| figures.summer_bandwidth = band);
    let divider = with(|figures, band| figures.divider.bandwidth = band);
    let cases = [
        (&flat, &product, "product.n", 1.0),
        (&flat, &summer, "facing", 1.0),
        (&flat, &divider, "cosine", (1.01_f64 / 3.0).sqrt()),
        (&steep, &divider, "cosine", (2.0_f64 / 3.0).sqrt()),
    ];
    for (scene, light, wire, gain) in cases {
        let found = remains(scene, light, wire);
        assert!((found - pole(gain)).abs() < 1e-9, "{wire}: {found}, not {}", pole(gain));
    }
    let root = with(|figures, band| figures.root.bandwidth = band);
    let climbing = Scene::new(Photometry::Lambert, |_, sample| [if sample < 20 { 0.0 } else { 0.8 }, 0.0]);
    let gain = (1.64_f64 / 3.0).sqrt();
    assert!((remains(&climbing, &root, "root") - pole(gain)).abs() < 1e-9);
}

/// The height waits for the light: over ground that bends slowly, light is late by far less than its parts are.
#[test]
fn the_light_comes_with_its_height() {
    let figures = ReflectivityParts {
        multiplier: MultiplierParts { bandwidth: Some(2e6), ..MultiplierParts::IDEAL },
        summer_bandwidth: Some(3e6),
        root: LoopParts { bandwidth: Some(4e6), error: 0.0 },
        divider: LoopParts { bandwidth: Some(2e6), error: 0.0 },
        ..ReflectivityParts::IDEAL
    };
    let light = stage(figures);
    let tau = |band: f64| 1.0 / (2.0 * std::f64::consts::PI * band);
    let late = tau(2e6) + tau(3e6) + tau(2e6) * 3.0_f64.sqrt();
    assert!((light.ahead * H - late).abs() < 1e-15);
    let scene = Scene::new(Photometry::Lambert, |_, sample| [0.004 * sample as f64 - 0.12, 0.0]);
    let [found, law] = [scene.wire(&light, "cosine"), scene.law("cosine")];
    let rate = (law[31] - law[30]) / H;
    let off = (found[30] - law[30]) / rate;
    assert!(off.abs() < 0.05 * late, "{off} s of {late} s");
}

#[test]
fn slopes_leak_past_multipliers_by_their_rate() {
    let mut light = stage(ReflectivityParts::IDEAL);
    light.stage.products[0].leak = parts::Feedthrough::new(H, 0.01, 1e6);
    let scene = Scene::new(Photometry::Lambert, |_, sample| [0.004 * sample as f64, 0.0]);
    let [found, law] = [scene.wire(&light, "product.n"), scene.law("product.n")];
    let [north, _] = to_map(scene.directions[2], [0.004, 0.0]);
    let leak = 0.01 / (2.0 * std::f64::consts::PI * 1e6) * north / H;
    for sample in 1..SAMPLES {
        assert!((found[sample] - law[sample] - leak).abs() < 1e-14, "{sample}");
    }
}

#[test]
fn wires_clip() {
    let light = stage(ReflectivityParts { saturation: Some(11.0), ..ReflectivityParts::IDEAL });
    let scene = Scene::new(Photometry::Lambert, |_, sample| [0.1 * sample as f64, 0.0]);
    let [product, square] = ["product.n", "square.n"].map(|name| scene.wire(&light, name));
    assert!((product[SAMPLES - 1] - 1.1 * SUN.direction()[0]).abs() < 1e-14);
    assert_eq!(square[SAMPLES - 1], 1.1);
    assert_near(&product[..10], &scene.law("product.n")[..10], 1e-14);
}

/// Static errors, bandwidths and leaks of the seed: each figure of a model shows, parts of a kind differ, another seed draws others.
#[test]
fn every_figure_shows() {
    let scene = Scene::new(Photometry::Lambert, hills);
    let law = scene.lit::<f64>(&stage(ReflectivityParts::IDEAL));
    let changes: [fn(&mut ReflectivityParts); 10] = [
        |figures| figures.multiplier.error = 0.0025,
        |figures| figures.multiplier.scale_error = 0.002,
        |figures| figures.multiplier.feedthrough = 0.005,
        |figures| figures.multiplier.bandwidth = Some(8e6),
        |figures| figures.summer_bandwidth = Some(20e6),
        |figures| figures.root.error = 0.005,
        |figures| figures.root.bandwidth = Some(5e6),
        |figures| figures.divider.error = 0.01,
        |figures| figures.divider.bandwidth = Some(3e6),
        |figures| figures.saturation = Some(2.0),
    ];
    for (number, change) in changes.into_iter().enumerate() {
        let mut figures = ReflectivityParts::IDEAL;
        change(&mut figures);
        assert!(!figures.stage_is_ideal());
        assert_ne!(scene.lit::<f64>(&stage(figures)), law, "{number}");
    }
    let mut figures = ReflectivityParts::IDEAL;
    changes[0](&mut figures);
    let drawn = stage(figures);
    assert_ne!(drawn.stage.products[0].multiplier, drawn.stage.products[1].multiplier);
    assert_ne!(drawn.stage.products[0].multiplier, drawn.stage.squarers[0].multiplier);
    assert_ne!(scene.lit::<f64>(&PartsLight::new(H, &parts(figures), 8)), scene.lit::<f64>(&drawn));
}

/// Where the profile of a lane ends its slopes stay, whatever the buffer has there.
#[test]
fn nothing_beyond_the_end_is_seen() {
    fn ends(_: usize, sample: usize) -> [f64; 2] {
        if sample < 40 { hills(0, sample) } else { [0.0; 2] }
    }
    fn goes_on(_: usize, sample: usize) -> [f64; 2] {
        hills(0, sample.min(39))
    }
    let light = stage(ReflectivityParts { summer_bandwidth: Some(0.4e6), ..ReflectivityParts::IDEAL });
    assert!(light.ahead > 5.0);
    let [found, expected] = [ends, goes_on].map(|slopes: fn(usize, usize) -> [f64; 2]| {
        let scene = Scene { ends: [40; LANES], ..Scene::new(Photometry::Lambert, slopes) };
        scene.lit::<f64>(&light)
    });
    assert_eq!(found[..40], expected[..40]);
}

/// The wires that are looked at are those that are drawn.
#[test]
fn looking_changes_nothing() {
    let figures = ReflectivityParts {
        multiplier: MultiplierParts { error: 0.0025, bandwidth: Some(8e6), ..MultiplierParts::IDEAL },
        divider: LoopParts { error: 0.01, bandwidth: Some(3e6) },
        ..ReflectivityParts::IDEAL
    };
    let (scene, light) = (Scene::new(Photometry::Lambert, hills), stage(figures));
    let [drawn, cosine] =
        [scene.lit::<f64>(&light).iter().map(|lanes| lanes[2]).collect(), scene.wire(&light, "cosine")];
    assert_eq!(drawn, cosine.iter().map(|cosine| 0.8 * cosine).collect::<Vec<f64>>());
}
