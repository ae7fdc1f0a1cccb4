//! Where effects of a scene stand on the screen: in true perspective, as bodies do.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use light_points::{Disc, LeastDiameter, projected_diameter};
use quantities::radians;
use raster::{Pattern, Sampling};
use scenario::{Effects, LightPoint, LightSource, Overlay, Sheet, SkyDisc};

use super::matter::{Effect, Feature, Lamp, Matter, Pane, Tier, is_invisible};
use super::outline::Outline;
use super::screen::Screen;
use crate::outlook::Outlook;
use crate::standing::NEAR;
use crate::view::View;

/// A disc of the sky that reaches this near to a right angle from the axis of view (deg) is looked for all over the screen.
/// Chosen: the tangent is still small enough for a box.
const ASIDE_DEG: f64 = 88.0;

/// An eye and its screen.
#[derive(Debug, Clone, Copy)]
pub struct Placing<'a> {
    /// The ground around the eye.
    pub outlook: &'a Outlook<'a>,
    /// The view of the eye.
    pub view: &'a View,
    /// The raster of the picture.
    pub screen: Screen,
}

impl Placing<'_> {
    /// All that can be on the screen. What is no number, lies nearer than 1 mm ahead or has no area is left out.
    pub fn features(&self, effects: &Effects) -> Vec<Feature> {
        let Effects { lights, sheets, overlays, discs } = effects;
        let overlays = overlays.iter().filter_map(|overlay| self.overlay(overlay));
        let sheets = sheets.iter().filter_map(|sheet| self.pane(sheet));
        let lights = lights.iter().filter_map(|light| self.light(light));
        let discs = (0..).zip(discs).filter_map(|(id, disc)| self.disc(id, disc));
        overlays.chain(sheets).chain(lights).chain(discs).collect()
    }

    fn overlay(&self, overlay: &Overlay) -> Option<Feature> {
        let corners = overlay.corners.iter().map(|corner| self.screen.in_halves(*corner)).collect();
        let matter = Matter::Overlay(Effect::of(overlay.colour, overlay.share));
        let outline = Outline::polygon(corners)?;
        Some(Feature { tier: Tier::Eye, priority: overlay.priority, id: overlay.id, outline, matter })
    }

    fn pane(&self, sheet: &Sheet) -> Option<Feature> {
        let middle = sheet.corners.iter().sum::<DVec3>() / sheet.corners.len() as f64;
        let eye = middle - self.to(middle)?;
        let (outline, nearness) = self.polygon(&sheet.corners, eye)?;
        let normal = sheet.normal();
        let distance = normal.dot(middle - eye);
        let is_seen = distance.is_finite() && distance != 0.0 && !is_invisible(sheet.medium);
        let (priority, id) = (sheet.priority, sheet.id);
        let matter = Matter::Pane(Pane { sheet: sheet.clone(), normal, distance, nearness });
        is_seen.then_some(Feature { tier: Tier::Scene, priority, id, outline, matter })
    }

    /// What a polygon covers as it is seen from `eye`, and the least and largest inverse depth (1/m) of its corners.
    fn polygon(&self, corners: &[DVec3], eye: DVec3) -> Option<(Outline, [f64; 2])> {
        let ahead = clipped(corners, |corner| self.view.ahead(corner - eye));
        let places = ahead.iter().map(|corner| self.view.project(corner - eye, 0.0));
        let corners = places.map(|place| Some(self.screen.in_pixels(place?)));
        let outline = Outline::polygon(corners.collect::<Option<_>>()?)?;
        let each = ahead.iter().map(|corner| 1.0 / self.view.ahead(corner - eye));
        Some((outline, [each.clone().fold(f64::INFINITY, f64::min), each.fold(f64::NEG_INFINITY, f64::max)]))
    }

    fn light(&self, light: &LightPoint) -> Option<Feature> {
        let (tier, to, disc) = self.source(light)?;
        let middle = self.screen.in_pixels(self.view.project(to, NEAR)?);
        let lamp = Lamp {
            nearness: if tier == Tier::Star { 0.0 } else { 1.0 / self.view.ahead(to) },
            colour: light.colour,
            middle,
            intensity: disc.intensity,
            light: disc.light(),
            is_beam: light.calligraphic,
        };
        let outline = Outline::Circle { middle, radius: disc.diameter / 2.0 };
        let is_lit = lamp.light.is_finite() && lamp.light > 0.0 && middle.iter().all(|at| at.is_finite());
        let matter = Matter::Lamp(lamp);
        is_lit.then_some(Feature { tier, priority: light.priority, id: light.id, outline, matter })
    }

    /// How far a light point is, the way to it from the eye (m; a unit vector to a star), and its disc.
    fn source(&self, light: &LightPoint) -> Option<(Tier, DVec3, Disc)> {
        match light.source {
            LightSource::Lamp { at, diameter } => {
                let to = self.to(at)?;
                let projected = projected_diameter(diameter, to.length(), self.screen.focal()).ok()?;
                Some((Tier::Scene, to, Disc::of_lamp(projected, light.towards(at - to), least()?)))
            }
            LightSource::Star { direction, magnitude } => {
                let disc = Disc::of_star(magnitude, least()?).ok()?;
                Some((Tier::Star, direction, disc.dimmed(light.intensity)))
            }
        }
    }

    fn disc(&self, id: u32, disc: &SkyDisc) -> Option<Feature> {
        let (radius, aside) =
            (disc.angular_diameter / 2.0, libm::acos(self.view.ahead(disc.direction).clamp(-1.0, 1.0)));
        let bounds = match self.view.project(disc.direction, NEAR) {
            Some(place) if aside + radius < radians(ASIDE_DEG) => {
                // No part lies farther from the middle than the one that is farthest from the axis.
                let reach = libm::tan(aside + radius) - libm::tan(aside);
                [-reach, reach].map(|reach| self.screen.in_pixels(place.map(|at| at + reach)))
            }
            _ if aside - radius < FRAC_PI_2 => [[0.0; 2], self.screen.size().map(|size| size as f64)],
            _ => return None,
        };
        let (outline, matter) = (Outline::Cone(*disc, bounds), Matter::Disc(*disc));
        let is_seen = radius > 0.0 && disc.direction.is_finite();
        is_seen.then_some(Feature { tier: Tier::Disc, priority: 0, id, outline, matter })
    }

    /// From the eye to a place of the axes of the ground (m), which stands lower by the drop of the lunoid; `None` where the
    /// lunoid has ended.
    fn to(&self, place: DVec3) -> Option<DVec3> {
        let eye = DVec3::from_array(self.outlook.eye());
        let range = libm::hypot(place.x - eye.x, place.y - eye.y);
        let is_there = range < self.outlook.end();
        is_there.then(|| place - eye - DVec3::Z * self.outlook.drop(range))
    }
}

/// The part of a convex polygon that lies at least [`NEAR`] ahead.
fn clipped(corners: &[DVec3], ahead: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (index, &from) in corners.iter().enumerate() {
        let to = corners[(index + 1) % corners.len()];
        let [begin, end] = [from, to].map(|corner| ahead(corner) - NEAR);
        if begin >= 0.0 {
            kept.push(from);
        }
        if (begin < 0.0) != (end < 0.0) {
            kept.push(from + (to - from) * (begin / (begin - end)));
        }
    }
    kept
}

/// The least disc of a light point: 1.5 pixels, as where sampling points are.
fn least() -> Option<LeastDiameter> {
    LeastDiameter::new(LeastDiameter::DEFAULT, &Sampling::new(Pattern::Sixteen)).ok()
}
