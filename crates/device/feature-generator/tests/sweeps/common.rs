//! Scenes and programs for the tests of the block.

use feature_generator::{FeatureGenerator, FeatureProfile, FeatureProgram, Schedule};
use features::{Crater, Features, Shape};
use hardware_model::{FeatureParts, Organisation};
use proptest::prelude::Strategy;
use signal::{LANES, Real};

/// A sweep: eye (north, east; m) and azimuth (rad).
pub type Sweep = ([f64; 2], f64);

pub fn bowl(centre: [f64; 2], r1: f64) -> Crater {
    Crater::new(centre, Shape::Bowl { r1 }, 0.2 * r1, 0.0).unwrap()
}

pub fn rimmed(centre: [f64; 2], r1: f64, r2: f64, depth: f64, rim: f64) -> Crater {
    Crater::new(centre, Shape::RimmedBowl { r1, r2 }, depth, rim).unwrap()
}

pub fn parts(organisation: Organisation, sub_generators: Option<u32>) -> FeatureParts {
    FeatureParts { organisation, sub_generators }
}

pub fn program(
    features: &Features,
    parts: FeatureParts,
    (eye, angle): Sweep,
    range: [f64; 2],
) -> FeatureProgram {
    let schedule =
        Schedule { features, parts, region_origin: [0.0; 2], region_size: 100.0, among: None, absent: &[] };
    let (sin, cos) = quantities::sin_cos(angle);
    let mut program = FeatureProgram::default();
    schedule.write(eye, [cos, sin], range, &mut program);
    program
}

/// A group that draws all features.
pub fn run<S: Real>(
    features: &Features,
    sweeps: &[Sweep; LANES],
    ranges: &[f64],
    profile: &mut FeatureProfile<S>,
) {
    let range = [0.0, ranges[ranges.len() - 1]];
    let programs = sweeps.map(|sweep| program(features, FeatureParts::default(), sweep, range));
    FeatureGenerator { ranges }.run(features, &programs, profile);
}

/// Height, slope along and slope across at a range of a sweep, asked of the landscape.
pub fn expected(features: &Features, (eye, angle): Sweep, range: f64) -> [f64; 3] {
    let (sin, cos) = quantities::sin_cos(angle);
    let rise = features.at(eye[0] + range * cos, eye[1] + range * sin);
    let [hx, hy] = rise.slopes;
    [rise.height, hx * cos + hy * sin, hy * cos - hx * sin]
}

/// Distance (m) to the nearest circle at which a slope jumps.
pub fn nearest_kink(features: &Features, (eye, angle): Sweep, range: f64) -> f64 {
    let (sin, cos) = quantities::sin_cos(angle);
    let at = [eye[0] + range * cos, eye[1] + range * sin];
    let apart = |crater: &Crater| {
        let [dx, dy] = [0, 1].map(|axis| at[axis] - crater.centre()[axis]);
        let rho = (dx * dx + dy * dy).sqrt();
        crater.kinks().map(|kink| (kink - rho).abs()).fold(f64::INFINITY, f64::min)
    };
    features.craters().iter().map(|crater| apart(&crater)).fold(f64::INFINITY, f64::min)
}

/// Ranges of samples, in geometric steps from 1 m to about 500 m.
pub fn ranges() -> Vec<f64> {
    (0..250).map(|sample| libm::pow(1.025, f64::from(sample))).collect()
}

/// Craters of all types and sizes around the origin.
pub fn scene() -> impl Strategy<Value = Features> {
    let radii = proptest::array::uniform3(0.1..1.0f64);
    let one = (proptest::array::uniform2(-300.0..300.0f64), -1.0..6.0f64, radii, 0..3u32);
    let crater = one.prop_map(|(centre, size, [inner, depth, rim], kind)| {
        let radius = libm::exp2(size);
        let shape = match kind {
            0 => Shape::Bowl { r1: radius },
            1 => Shape::RimmedBowl { r1: radius, r2: (1.1 + inner) * radius },
            _ => Shape::FlatFloor { r1: 0.8 * inner * radius, r2: radius, r3: (1.1 + rim) * radius },
        };
        let rim = if kind == 0 { 0.0 } else { 0.1 * rim * radius };
        Crater::new(centre, shape, 0.4 * depth * radius, rim).unwrap()
    });
    proptest::collection::vec(crater, 0..80).prop_map(Features::new)
}

/// The sweeps of a group: lane by lane another way.
pub fn sweeps() -> impl Strategy<Value = [Sweep; LANES]> {
    let one = (proptest::array::uniform2(-100.0..100.0f64), 0.0..6.3f64);
    proptest::array::uniform8(one)
}
