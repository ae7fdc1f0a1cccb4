//! What things send and let through, and how near they are.

use std::cmp::Ordering;

use generator::Label;
use glam::DVec3;
use light_points::{Blending, Light};
use scenario::{Medium, Sheet, SkyDisc};

use super::outline::Outline;
use crate::standing::is_before;

/// Which things lie before all others, whatever their distance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// It is fixed to the eye.
    Eye,
    /// A place of the scene.
    Scene,
    /// A disc of the sky.
    Disc,
    /// A star, behind all else.
    Star,
}

/// A thing that is drawn over the opaque picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Which things it lies before.
    pub tier: Tier,
    /// Of two that are equally near the higher is seen.
    pub priority: i8,
    /// Of two of the same priority the lower is seen.
    pub id: u32,
    /// Part of the screen that it covers.
    pub outline: Outline,
    /// What it is made of.
    pub matter: Matter,
}

/// What a thing is.
#[derive(Debug, Clone, PartialEq)]
pub enum Matter {
    /// A polygon that is fixed to the eye.
    Overlay(Effect),
    /// A translucent polygon of the scene.
    Pane(Pane),
    /// A lamp or a star.
    Lamp(Lamp),
    /// The sun or the Earth.
    Disc(SkyDisc),
}

/// What something adds at a place and lets through from behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// Light that it sends (linear red, green, blue, at least 0).
    pub added: [f64; 3],
    /// Share of light from behind that it lets through, 0 to 1.
    pub translucency: f64,
}

impl Effect {
    /// Something of a colour that lets a share of light through.
    pub fn of(colour: [f64; 3], translucency: f64) -> Self {
        Self { added: colour.map(|channel| (1.0 - translucency) * channel), translucency }
    }
}

/// A sheet as an eye sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct Pane {
    /// The sheet with its colour and medium.
    pub sheet: Sheet,
    /// Its unit normal: north, east, up.
    pub normal: DVec3,
    /// Distance (m) of its plane from the eye, signed along the normal; not 0.
    pub distance: f64,
    /// Least and largest nearness (1/m) of its corners: beyond its edges its plane says nothing.
    pub nearness: [f64; 2],
}

/// A light point as an eye sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamp {
    /// Inverse depth (1/m); 0 of a star.
    pub nearness: f64,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// Its middle on the screen (pixels).
    pub middle: [f64; 2],
    /// Intensity of its disc, at least 0.
    pub intensity: f64,
    /// Intensity times area (pixels squared).
    pub light: f64,
    /// Whether a beam of its own draws it.
    pub is_beam: bool,
}

/// What an eye meets at a place when nothing else is in its way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Back {
    /// Depth along the axis of view (m) of the opaque picture; infinite where there is no place.
    pub depth: f64,
    /// Whether the sky is seen.
    pub is_open: bool,
}

impl Back {
    /// Nothing but sky is there.
    pub const SKY: Self = Self { depth: f64::INFINITY, is_open: true };
}

impl Feature {
    /// Inverse of its depth along the axis of view (1/m) where `ray`, of depth 1, meets it.
    fn nearness(&self, ray: DVec3) -> f64 {
        match &self.matter {
            Matter::Overlay(_) => f64::INFINITY,
            Matter::Pane(pane) => {
                (pane.normal.dot(ray) / pane.distance).clamp(pane.nearness[0], pane.nearness[1])
            }
            Matter::Lamp(lamp) => lamp.nearness,
            Matter::Disc(_) => 0.0,
        }
    }

    /// Which of two is nearer along a ray: the lesser.
    pub fn order(&self, other: &Self, ray: DVec3) -> Ordering {
        let nearer = || other.nearness(ray).total_cmp(&self.nearness(ray));
        let higher = || other.priority.cmp(&self.priority);
        self.tier.cmp(&other.tier).then_with(nearer).then_with(higher).then(self.id.cmp(&other.id))
    }

    /// Whether the opaque picture does not hide it along a ray.
    pub fn is_before(&self, ray: DVec3, back: Back) -> bool {
        match self.tier {
            Tier::Eye => true,
            Tier::Scene => is_before(self.priority, 1.0 / self.nearness(ray), back.depth),
            Tier::Disc | Tier::Star => back.is_open,
        }
    }

    /// What it does along a ray.
    pub fn effect(&self, ray: DVec3) -> Effect {
        match &self.matter {
            Matter::Overlay(effect) => *effect,
            Matter::Pane(pane) => {
                let translucency = pane.sheet.translucency(pane.normal.dot(ray) / ray.length());
                Effect::of(pane.sheet.colour, translucency)
            }
            Matter::Lamp(lamp) => {
                let Light { added, translucency } = Light::new(lamp.intensity, Blending::Hiding);
                Effect { added: lamp.colour.map(|channel| added * channel), translucency }
            }
            Matter::Disc(disc) => {
                Effect { added: disc.light(ray.normalize()).unwrap_or_default(), translucency: 0.0 }
            }
        }
    }

    /// The lamp, if a beam of its own draws it.
    pub fn beam(&self) -> Option<&Lamp> {
        match &self.matter {
            Matter::Lamp(lamp) => Some(lamp).filter(|lamp| lamp.is_beam),
            _ => None,
        }
    }

    /// Label of pixels that it fills. Discs of the sky have the label of the sky.
    pub fn label(&self) -> Option<Label> {
        match self.matter {
            Matter::Overlay(_) => Some(Label::EyeFixed),
            Matter::Pane(_) => Some(Label::Sheet),
            Matter::Lamp(_) => Some(Label::Light),
            Matter::Disc(_) => None,
        }
    }
}

/// Whether a medium lets nothing be seen of itself.
pub fn is_invisible(medium: Medium) -> bool {
    matches!(medium, Medium::Share(share) if share >= 1.0)
}
