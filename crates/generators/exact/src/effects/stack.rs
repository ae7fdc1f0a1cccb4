//! One pixel: what lies over its opaque picture, from near to far.

use generator::Label;
use glam::DVec3;
use smallvec::SmallVec;

use super::matter::{Back, Effect, Feature, Tier};
use super::outline::Outline;
use super::screen::Screen;
use crate::view::View;

/// Sub-rays of a pixel that an edge crosses. Chosen: as many as a word has bits.
pub const SUB_RAYS: u32 = 64;

/// Step between the lines of two sub-rays in neighbouring columns (1/64 pixel). Chosen: every column and every line of 1/64
/// pixel has one sub-ray, and of all steps this one tells the area beside a straight edge best.
const LATTICE: u32 = 37;

/// Share of the light at a pixel's centre above which a label is that of an effect.
const LABEL_SHARE: f64 = 0.5;

/// The opaque picture behind the effects.
pub trait Surface {
    /// What is met at a place in pixels.
    fn back(&mut self, at: [f64; 2]) -> Back;

    /// The same with its light (linear red, green, blue).
    fn lit(&mut self, at: [f64; 2]) -> (Back, [f64; 3]);
}

/// A thing that covers a part of a pixel.
#[derive(Debug, Clone, Copy)]
pub struct Part<'a> {
    feature: &'a Feature,
    /// Its number in the frame.
    index: usize,
    /// Share of the pixel that it covers, 0 to 1.
    share: f64,
    /// What it does along the ray of the pixel's centre.
    effect: Effect,
    /// The sub-rays that meet it, bit by bit, where they are looked at.
    met: u64,
    /// Share of the pixel that each of them stands for; 1 where they are not looked at.
    weight: f64,
}

impl<'a> Part<'a> {
    /// A thing with its number in the frame and the share (above 0 to 1) of a pixel that it covers.
    pub fn new(feature: &'a Feature, index: usize, share: f64) -> Self {
        let effect = Effect { added: [0.0; 3], translucency: 1.0 };
        Self { feature, index, share, effect, met: u64::MAX, weight: 1.0 }
    }

    /// What it does along a sub-ray. Only a disc of the sky is another from one to the next.
    fn effect(&self, ray: DVec3) -> Effect {
        if self.is_cone() { self.feature.effect(ray) } else { self.effect }
    }

    fn is_cone(&self) -> bool {
        matches!(self.feature.outline, Outline::Cone(..))
    }

    /// Weighs the sub-rays that meet it; of a disc of the sky they tell the share too.
    fn weigh(&mut self, met: u64) {
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

/// How much of a calligraphic point a pixel has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reached {
    /// Number of the point in the frame.
    pub index: usize,
    /// Area of its disc in the pixel.
    pub aperture: f64,
    /// The same where its light reaches the eye, times the share of light that does.
    pub visible: f64,
}

/// What effects make of a pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Mix {
    /// Light that they add (linear red, green, blue).
    pub added: [f64; 3],
    /// Share of the opaque picture's light that they let through: red, green, blue.
    pub through: [f64; 3],
    /// Their label, if most of the light at the centre is theirs.
    pub label: Option<Label>,
    /// What is seen of calligraphic points.
    pub beams: SmallVec<[Reached; 2]>,
}

/// One pixel with the things that cover it.
#[derive(Debug)]
pub struct Stack<'a> {
    /// The picture.
    pub screen: &'a Screen,
    /// The view of the eye.
    pub view: &'a View,
    /// Top left corner of the pixel (pixels).
    pub low: [f64; 2],
    /// The things, at least one.
    pub parts: Parts<'a>,
}

impl<'a> Stack<'a> {
    /// What the things make of the pixel before a surface.
    pub fn mix(mut self, surface: &mut impl Surface) -> Mix {
        let centre = self.at([0.5; 2]);
        let ray = self.ray(centre);
        self.sort(ray);
        self.parts.iter_mut().for_each(|part| part.effect = part.feature.effect(ray));
        let in_scene = self.is_in_scene();
        let back = if in_scene { surface.back(centre) } else { Back::SKY };
        let label = self.label(centre, ray, back);
        let is_even = !in_scene || self.is_even(ray, back, surface);
        let mix = if is_even && self.is_simple(ray, back) {
            self.whole(ray, back)
        } else {
            self.sampled(is_even.then_some(back), surface)
        };
        Mix { label, ..mix }
    }

    /// Place in pixels of a place in the pixel.
    fn at(&self, within: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.low[axis] + within[axis])
    }

    fn ray(&self, at: [f64; 2]) -> DVec3 {
        self.view.ray_ahead(self.screen.on_plane(at))
    }

    /// Near to far along a ray.
    fn sort(&mut self, ray: DVec3) {
        self.parts.sort_by(|a, b| a.feature.order(b.feature, ray));
    }

    /// Whether the opaque picture can hide anything of it.
    fn is_in_scene(&self) -> bool {
        self.parts.iter().any(|part| part.feature.tier != Tier::Eye)
    }

    /// Whether order and visibility at all four corners are those of the centre.
    fn is_even(&self, ray: DVec3, back: Back, surface: &mut impl Surface) -> bool {
        let is_seen = |part: &Part| part.feature.is_before(ray, back);
        [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].into_iter().all(|corner| {
            let at = self.at(corner);
            let (ray, back) = (self.ray(at), surface.back(at));
            let is_same = |part: &Part| part.feature.is_before(ray, back) == is_seen(part);
            let in_order = |pair: &[Part]| pair[0].feature.order(pair[1].feature, ray).is_le();
            self.parts.iter().all(is_same) && self.parts.windows(2).all(in_order)
        })
    }

    /// Whether shares say all: no more than one thing that is seen covers the pixel in part.
    fn is_simple(&self, ray: DVec3, back: Back) -> bool {
        let seen = || self.parts.iter().filter(|part| part.feature.is_before(ray, back));
        !seen().any(Part::is_cone) && seen().filter(|part| part.share < 1.0).count() <= 1
    }

    /// Shares of the pixel, which depend on each other in no way.
    fn whole(&self, ray: DVec3, back: Back) -> Mix {
        let mut run = Run::new();
        for part in self.parts.iter().filter(|part| part.feature.is_before(ray, back)) {
            run.pass(part, part.effect, part.share);
        }
        let through = [run.through; 3];
        self.mixed(run.added, through, &run.visible)
    }

    /// The mean over the sub-rays, before a back that is the same all over or before the surface. What a thing adds in the
    /// pixel is in proportion to its area, not to how many sub-rays it covers.
    fn sampled(mut self, even: Option<Back>, surface: &mut impl Surface) -> Mix {
        self.weigh();
        let (mut added, mut visible) = ([0.0; 3], SmallVec::<[(usize, f64); 2]>::new());
        let (mut through, mut whole, mut mean) = ([0.0; 3], [0.0; 3], 0.0);
        for (number, within) in sub_rays().enumerate() {
            let at = self.at(within);
            let ray = self.ray(at);
            let (back, light) = even.map_or_else(|| surface.lit(at), |back| (back, [1.0; 3]));
            if even.is_none() {
                self.sort(ray);
            }
            let run = self.run(number, ray, back);
            mean += run.through / f64::from(SUB_RAYS);
            for channel in 0..3 {
                added[channel] += run.added[channel];
                through[channel] += run.through * light[channel];
                whole[channel] += light[channel];
            }
            visible.extend(run.visible);
        }
        let share = |channel: usize| {
            if whole[channel] > 0.0 { through[channel] / whole[channel] } else { mean }
        };
        self.mixed(added, [0, 1, 2].map(share), &visible)
    }

    /// Along one sub-ray. A thing that none of them meets, a sliver, adds its light all over the pixel and hides nothing.
    fn run(&self, number: usize, ray: DVec3, back: Back) -> Run {
        let mut run = Run::new();
        for part in self.parts.iter().filter(|part| part.feature.is_before(ray, back)) {
            let effect = part.effect(ray);
            if part.met == 0 {
                run.pass(part, Effect { translucency: 1.0, ..effect }, 1.0);
            } else if part.met >> number & 1 == 1 {
                run.pass(part, effect, 1.0);
            }
        }
        run
    }

    /// Finds which sub-rays meet each thing.
    fn weigh(&mut self) {
        let places: Vec<_> = sub_rays().map(|within| self.at(within)).map(|at| (at, self.ray(at))).collect();
        let screen = self.screen;
        for part in &mut self.parts {
            let is_met = |(at, ray): &([f64; 2], DVec3)| part.feature.outline.covers(screen, *at, *ray);
            let bit = |(number, place)| u64::from(is_met(place)) << number;
            let is_full = part.share >= 1.0 && !part.is_cone();
            let met = if is_full { u64::MAX } else { places.iter().enumerate().map(bit).sum() };
            part.weigh(met);
        }
    }

    /// The label of what has more than half of the weight at the centre.
    fn label(&self, centre: [f64; 2], ray: DVec3, back: Back) -> Option<Label> {
        let (mut through, mut shares) = (1.0, [0.0; Label::ALL.len()]);
        for part in &self.parts {
            let covers = || part.feature.outline.covers(self.screen, centre, ray);
            if part.feature.beam().is_none() && part.feature.is_before(ray, back) && covers() {
                let share = through * (1.0 - part.effect.translucency);
                through *= part.effect.translucency;
                part.feature.label().into_iter().for_each(|label| shares[usize::from(label.code())] += share);
            }
        }
        Label::ALL.iter().copied().find(|label| shares[usize::from(label.code())] > LABEL_SHARE)
    }

    fn mixed(&self, added: [f64; 3], through: [f64; 3], visible: &[(usize, f64)]) -> Mix {
        let reached = |part: &Part| {
            let of_it = visible.iter().filter(|(index, _)| *index == part.index);
            let visible = of_it.map(|(_, visible)| visible).sum();
            Reached { index: part.index, aperture: part.share, visible }
        };
        let beams = self.parts.iter().filter(|part| part.feature.beam().is_some()).map(reached).collect();
        Mix { added, through, label: None, beams }
    }
}

/// From near to far through a stack.
struct Run {
    added: [f64; 3],
    /// Share of light that what is nearer lets through.
    through: f64,
    /// The same of nearer calligraphic points, which hide calligraphic points alone.
    veil: f64,
    /// Number of calligraphic points and what is seen of their area.
    visible: SmallVec<[(usize, f64); 2]>,
}

impl Run {
    fn new() -> Self {
        Self { added: [0.0; 3], through: 1.0, veil: 1.0, visible: SmallVec::new() }
    }

    /// Passes a thing that covers `share` of the way.
    fn pass(&mut self, part: &Part, effect: Effect, share: f64) {
        let let_through = 1.0 - share * (1.0 - effect.translucency);
        if part.feature.beam().is_some() {
            self.visible.push((part.index, part.weight * share * self.through * self.veil));
            self.veil *= let_through;
            return;
        }
        for channel in 0..3 {
            self.added[channel] += part.weight * share * self.through * effect.added[channel];
        }
        self.through *= let_through;
    }
}

/// Places of the sub-rays in a pixel, each 0 to 1.
fn sub_rays() -> impl Iterator<Item = [f64; 2]> {
    let place = |unit: u32| (f64::from(unit) + 0.5) / f64::from(SUB_RAYS);
    (0..SUB_RAYS).map(move |k| [place(k), place(k * LATTICE % SUB_RAYS)])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half-planes at all angles and distances from the middle of the pixel.
    #[test]
    fn sub_rays_tell_the_area_beside_an_edge() {
        let mut worst: f64 = 0.0;
        for step in 0..360 {
            let (sin, cos) = quantities::sin_cos(quantities::radians(f64::from(step)));
            for shift in -35..=35 {
                let shift = f64::from(shift) / 50.0;
                let beside = |[x, y]: [f64; 2]| (x - 0.5) * cos + (y - 0.5) * sin > shift;
                let far =
                    |along: f64, out: f64| [0.5 + out * cos - along * sin, 0.5 + out * sin + along * cos];
                let half = [far(-9.0, shift), far(9.0, shift), far(9.0, 9.0), far(-9.0, 9.0)];
                let area = raster::area_within(&half, [0.0; 2], [1.0; 2]);
                let found = sub_rays().filter(|at| beside(*at)).count() as f64 / f64::from(SUB_RAYS);
                worst = worst.max((found - area).abs());
            }
        }
        assert!(worst < 1.0 / 14.0, "{worst}");
    }
}
