//! One pixel: what lies over its opaque picture, from near to far.

use generator::Label;
use glam::DVec3;
use smallvec::SmallVec;

use super::lattice::sub_rays;
use super::matter::{Back, Effect, Tier};
use super::mean::Mean;
use super::part::{Part, Parts};
use super::run::Run;
use super::screen::Screen;
use crate::view::View;

/// Share of the light at a pixel's centre above which a label is that of an effect.
const LABEL_SHARE: f64 = 0.5;

/// The opaque picture behind the effects.
pub trait Surface {
    /// What is met at a place in pixels.
    fn back(&mut self, at: [f64; 2]) -> Back;

    /// The same with its light (linear red, green, blue).
    fn lit(&mut self, at: [f64; 2]) -> (Back, [f64; 3]);
}

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
    /// The picture as it is so far.
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
        let mut mean = Mean::default();
        for (number, within) in sub_rays().enumerate() {
            let at = self.at(within);
            let ray = self.ray(at);
            let (back, light) = even.map_or_else(|| surface.lit(at), |back| (back, [1.0; 3]));
            if even.is_none() {
                self.sort(ray);
            }
            mean.add(self.run(number, ray, back), light);
        }
        self.mixed(mean.added(), mean.through(), mean.visible())
    }

    /// Along one sub-ray. A thing that none of them meets, a sliver, adds its light all over the pixel and hides nothing.
    fn run(&self, number: usize, ray: DVec3, back: Back) -> Run {
        let mut run = Run::new();
        for part in self.parts.iter().filter(|part| part.feature.is_before(ray, back)) {
            let effect = part.effect_along(ray);
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
