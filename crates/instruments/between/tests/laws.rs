//! Waveforms between samples: the machine's bits at samples, and the laws of the parts in between.

use std::path::Path;

use between::Between;
use front_door::{Opened, Wishes};
use generator::Session;
use lockstep::Engines;
use machine::Prepare;
use scenario::{Pose, Scalar};
use scope::{Look, Looking};
use signal::{Unit, Waveform};

const FRAME: u64 = 1;
const SWEEP: u32 = 20;

/// A shipped scenario on a machine, of which one sweep is told between samples.
struct Told {
    opened: Opened,
    engines: Engines,
    session: Box<dyn Session>,
    pose: Pose,
    pool: rayon::ThreadPool,
}

impl Told {
    fn new(scenario: &str, machine: &str, set: &[(&str, &str)]) -> Self {
        Self::of(scenario, machine, set, 240)
    }

    fn of(scenario: &str, machine: &str, set: &[(&str, &str)], samples: u32) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../../scenarios/{scenario}.toml"));
        let set = set.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())).collect();
        let wishes = Wishes {
            machine: Some(machine.into()),
            set,
            sweeps: Some(48),
            samples: Some(samples),
            scalar: Some(Scalar::F64),
            ..Wishes::default()
        };
        let opened = front_door::open(&path, &wishes).unwrap();
        let stage = opened.machine_stage().unwrap();
        let pose = opened.poses(&stage.stage(), FRAME..FRAME + 1).unwrap().rows()[0].pose;
        Self {
            session: stage.clone().prepare(),
            engines: Engines::new(stage),
            opened,
            pose,
            pool: rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap(),
        }
    }

    /// The waveforms of `names` at `steps` a sample; once a sample as everybody records them.
    fn waves(&self, names: &[&str], steps: u32) -> Vec<Waveform> {
        let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
        let (clocks, pose) = (self.opened.settings.timebase, &self.pose);
        if steps == 1 {
            let raster = [self.opened.settings.raster.columns, self.opened.settings.raster.lines];
            let raster = raster.map(|count| count as usize);
            let look = Look { session: &*self.session, pool: &self.pool, frame: FRAME, pose, raster };
            return look.at(names, SWEEP..SWEEP + 1).unwrap();
        }
        let divided = clocks.divided(steps).unwrap();
        let between = Between::new(&self.engines, &self.pool, (FRAME, pose), [clocks, divided]);
        between.at(names, SWEEP..SWEEP + 1).unwrap()
    }

    fn values(&self, name: &str, steps: u32) -> Vec<f64> {
        self.waves(&[name], steps).remove(0).values
    }

    /// Length of a sample (s).
    fn sample(&self) -> f64 {
        1.0 / self.opened.settings.timebase.sample_rate().hertz()
    }
}

#[test]
fn at_samples_the_values_are_the_machines_bits() {
    for machine in ["ideal", "pra-nominal", "modern-analog"] {
        let told = Told::of("full-drive", machine, &[], 80);
        let names = ["sweep.*", "tg.*", "mu.*", "dpp.*", "fg.*", "sm.*"];
        let (plain, fine) = (told.waves(&names, 1), told.waves(&names, 4));
        assert_eq!(plain.len(), fine.len());
        assert!(plain.len() > 300, "{machine}: {} waveforms", plain.len());
        for (plain, fine) in plain.iter().zip(&fine) {
            let name = plain.signal.name;
            assert_eq!(name, fine.signal.name);
            let instants: Vec<f64> = plain.times.iter().map(|time| time * 4.0).collect();
            assert_eq!(instants, fine.times, "{machine}: {name}");
            let at_samples: Vec<u64> = match plain.values.len() == fine.values.len() {
                true => fine.values.iter().map(|value| value.to_bits()).collect(),
                false => fine.values.iter().step_by(4).map(|value| value.to_bits()).collect(),
            };
            let expected: Vec<u64> = plain.values.iter().map(|value| value.to_bits()).collect();
            assert_eq!(at_samples, expected, "{machine}: {name}");
        }
    }
}

/// A wire that goes straight from sample to sample is named with its reason, and no other is.
#[test]
fn what_goes_straight_is_named() {
    for (machine, named) in [("pra-nominal", true), ("ideal", false)] {
        let told = Told::new("full-drive", machine, &[]);
        let clocks = told.opened.settings.timebase;
        let divided = clocks.divided(2).unwrap();
        let between = Between::new(&told.engines, &told.pool, (FRAME, &told.pose), [clocks, divided]);
        let names = ["tg.sum.height", "fg.height", "mu.vs1", "dpp.y", "sm.video"];
        let waves = between.at(names.map(str::to_owned).to_vec(), SWEEP..SWEEP + 1).unwrap();
        let straight = between.straight();
        assert!(!straight.contains_key("tg.sum.height"));
        for wave in waves.iter().filter(|wave| wave.signal.name != "tg.sum.height") {
            assert_eq!(straight.contains_key(wave.signal.name), named, "{machine}: {straight:?}");
            let halves = wave.values.chunks_exact(2).zip(wave.values.iter().skip(2).step_by(2));
            let is_straight = |(pair, next): (&[f64], &f64)| pair[1] == pair[0] + (next - pair[0]) * 0.5;
            if named && wave.signal.unit != Unit::Gate {
                assert!(halves.into_iter().all(is_straight), "{machine}: {}", wave.signal.name);
            }
        }
    }
}

/// However finely a sweep is told, an instant has one value.
#[test]
fn an_instant_has_one_value() {
    const LIGHT: &[(&str, &str)] = &[
        ("reflectivity.multiplier_bandwidth_mhz", "8"),
        ("reflectivity.root_bandwidth_mhz", "5"),
        ("reflectivity.divider_bandwidth_mhz", "3"),
    ];
    let told = Told::of("full-drive", "pra-nominal", LIGHT, 120);
    let names = [
        "sweep.x",
        "tg.fn.cx.g1",
        "tg.product.22",
        "tg.red.dac4",
        "tg.sum.height",
        "tg.height",
        "tg.light.square.n",
        "tg.light.cosine",
    ];
    for (two, eight) in told.waves(&names, 2).iter().zip(told.waves(&names, 8)) {
        let (name, two) = (two.signal.name, &two.values);
        let scale = two.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let off = two.iter().zip(eight.values.iter().step_by(4)).map(|(a, b)| (a - b).abs());
        let worst = off.fold(0.0, f64::max);
        assert!(worst <= 1e-12 * scale, "{name}: {worst:e} of {scale:e}");
    }
}

/// A lag of 20 ns driven straight from sample to sample: the closed form.
#[test]
fn a_lag_settles_inside_a_sample() {
    const TAU: f64 = 20e-9;
    const STEPS: usize = 8;
    let plain = Told::new("first-light", "ideal", &[]);
    let lagged = Told::new("first-light", "ideal", &[("reflectivity.delay_mismatch_ns", "20")]);
    let (driven, out) = (plain.values("tg.reflectivity", 1), lagged.values("tg.reflectivity", STEPS as u32));
    let h = lagged.sample();
    let (mut most, mut lit) = (0.0_f64, 0);
    // Behind the stored ground wires keep their values.
    for sample in 0..driven.len() - 10 {
        let ([u0, u1], y0) = ([driven[sample], driven[sample + 1]], out[STEPS * sample]);
        // The recorded wire is the light, which is not less than none; the lag has the voltage.
        if [u0, u1, y0, out[STEPS * (sample + 1)]].iter().any(|value| *value <= 0.0) {
            continue;
        }
        lit += 1;
        for step in 1..STEPS {
            let time = h * step as f64 / STEPS as f64;
            let slope = (u1 - u0) / h;
            let right = u0 + slope * (time - TAU) + (y0 - u0 + slope * TAU) * libm::exp(-time / TAU);
            let found = out[STEPS * sample + step];
            assert!((found - right).abs() < 1e-9, "sample {sample}, step {step}: {found} for {right}");
            let straight = y0 + (out[STEPS * (sample + 1)] - y0) * (step as f64 / STEPS as f64);
            most = most.max((found - straight).abs());
        }
    }
    assert!(lit > 50, "{lit} samples in the light");
    assert!(most > 1e-4, "a straight line would do as well: {most:e}");
}

/// On the ideal machine a ramp is a triangle over ground range: between samples too, and with its corners where they are.
#[test]
fn an_ideal_ramp_has_its_corners_between_samples() {
    let told = Told::new("first-light", "ideal", &[]);
    let waves = told.waves(&["sweep.accumulator.x", "sweep.x", "sweep.fold.x"], 16);
    let of = |name: &str| waves.iter().find(|wave| wave.signal.name == name).unwrap();
    let (ramp, folds) = (&of("sweep.x").values, of("sweep.fold.x"));
    assert_eq!(ramp, &of("sweep.accumulator.x").values);
    let ends = ramp.windows(2).rposition(|pair| pair[0] != pair[1]).unwrap();
    let mut between = 0;
    for (&at, &stop) in folds.times.iter().zip(&folds.values) {
        let place = at.floor() as usize;
        if at < 0.0 || place >= ends {
            continue;
        }
        // The triangle touches its stop within the step: the two beside it are as far from it as their rates allow.
        let (before, after) = ((ramp[place] - stop).abs(), (ramp[place + 1] - stop).abs());
        let share = at - at.floor();
        assert!((before * (1.0 - share) - after * share).abs() < 1e-9, "fold at {at}: {before}, {after}");
        between += usize::from(!place.is_multiple_of(16));
    }
    assert!(between > 3, "{between} folds between samples");
}

/// A word that a D/A takes within a sample changes its output there, 30 ns after the fold, and not at the sample.
#[test]
fn a_word_acts_at_its_own_instant() {
    const STEPS: usize = 32;
    let told = Told::new("first-light", "ideal", &[("multiplying_dac.switching_ns", "30")]);
    let waves = told.waves(&["tg.red.dac0", "tg.product.33", "tg.red.word0"], STEPS as u32);
    let of = |name: &str| waves.iter().find(|wave| wave.signal.name == name).unwrap();
    let (sent, product, words) = (&of("tg.red.dac0").values, &of("tg.product.33").values, of("tg.red.word0"));
    let later = 30e-9 / told.sample() * STEPS as f64;
    let mut within = 0;
    for (pair, values) in words.times.windows(2).zip(words.values.windows(2)) {
        let at = pair[1] + later;
        let (before, after) = (at.floor() as usize, at.ceil() as usize);
        let is_alone = (at - pair[0]).min(
            words.times.iter().fold(
                1e9,
                |next, time| {
                    if *time > pair[1] { next.min(time - pair[1]) } else { next }
                },
            ),
        ) > 4.0;
        // Behind the stored ground wires keep their values.
        let is_drawn = after < product.len() - 10 * STEPS;
        if !is_alone
            || !is_drawn
            || before.is_multiple_of(STEPS)
            || [before, after].iter().any(|k| product[*k].abs() < 1e-7)
        {
            continue;
        }
        let [old, new] = [before, after].map(|k| sent[k] / product[k]);
        let change = values[1] - values[0];
        assert!(
            ((new - old) - change).abs() < 1e-6 * change.abs().max(1.0),
            "{at}: {old} to {new}, {change}"
        );
        within += 1;
    }
    assert!(within > 5, "{within} words came within a sample");
}
