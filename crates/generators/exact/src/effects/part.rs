//! A thing in a pixel.

use glam::DVec3;
use smallvec::SmallVec;

use super::lattice::SUB_RAYS;
use super::matter::{Effect, Feature};
use super::outline::Outline;

/// A thing that covers a part of a pixel.
#[derive(Debug, Clone, Copy)]
pub struct Part<'a> {
    /// The thing that takes part.
    pub feature: &'a Feature,
    /// Its number in the frame.
    pub index: usize,
    /// Share of the pixel that it covers, 0 to 1.
    pub share: f64,
    /// What it does along the ray of the pixel's centre.
    pub effect: Effect,
    /// The sub-rays that meet it, bit by bit, where they are looked at.
    pub met: u64,
    /// Share of the pixel that each of its places stands for; 1 where the places are not looked at.
    pub weight: f64,
}

impl<'a> Part<'a> {
    /// A thing with its number in the frame and the share (above 0 to 1) of a pixel that it covers.
    pub fn new(feature: &'a Feature, index: usize, share: f64) -> Self {
        let effect = Effect { added: [0.0; 3], translucency: 1.0 };
        Self { feature, index, share, effect, met: u64::MAX, weight: 1.0 }
    }

    /// What it does along a sub-ray. Only a disc of the sky is another from one to the next.
    pub fn effect_along(&self, ray: DVec3) -> Effect {
        if self.is_cone() { self.feature.effect(ray) } else { self.effect }
    }

    /// Whether it is a disc of the sky, whose share sub-rays alone tell.
    pub fn is_cone(&self) -> bool {
        matches!(self.feature.outline, Outline::Cone(..))
    }

    /// Weighs the sub-rays that meet it; of a disc of the sky they tell the share too.
    pub fn weigh(&mut self, met: u64) {
        self.met = met;
        if self.is_cone() {
            self.share = f64::from(met.count_ones()) / f64::from(SUB_RAYS);
        }
        let count = if met == 0 { SUB_RAYS } else { met.count_ones() };
        self.weight = self.share / f64::from(count);
    }
}

/// Things that cover a part of a pixel.
pub type Parts<'a> = SmallVec<[Part<'a>; 8]>;
