//! Scenes from a seed.

use landscape::Sun;
use quantities::{radians, unit_interval};
use scenario::{Curvature, Occlusion, Projection, RangeLaw, RangeProgramme};

use crate::{Scene, level_of};

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

    /// One of `choices`.
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
pub fn scene(seed: u64) -> Scene {
    let mut dice = Dice::new(seed);
    let corners = [dice.count(4, 24), dice.count(4, 24)];
    let size = dice.between(20.0, 900.0);
    let origin = [dice.between(-5e3, 5e3), dice.between(-5e3, 5e3)];
    let scale = size * dice.between(0.005, 0.05);
    let words: Vec<[f64; 9]> =
        (0..corners[0] * corners[1]).map(|_| std::array::from_fn(|_| scale * dice.normal())).collect();
    let mut scene = Scene::over(level_of(size, origin, corners, |m, n| words[m * corners[1] + n]));
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
    scene.laws.curvature = dice.choose(&[Curvature::Parabolic, Curvature::None]);
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
