//! What covers sampling points: surfaces and lights.

use std::cmp::Ordering;

use raster::{Attribute, DistancePlane};

/// In which slots a translucent feature is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A sheet, a face, the ground; opaque where its translucency is 0.
    Surface,
    /// A light point, which stays in the slots of lights even where it lets nothing through.
    Light,
}

/// A feature as the sampling points see it, checked on making.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feature {
    id: u32,
    priority: i32,
    kind: Kind,
    translucency: f64,
    light: [f64; 3],
    shading: Option<Shading>,
}

/// Colours of the corners of a triangle, in between.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Shading {
    channels: [Attribute; 3],
    plane: DistancePlane,
}

/// A figure that no feature has.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FeatureError {
    /// The share of light that is let through is no share.
    #[error("feature {id}: translucency is {value}: expected a number from 0 (opaque) to 1 (invisible)")]
    Translucency {
        /// Id of the feature at fault.
        id: u32,
        /// The value that was found.
        value: f64,
    },
    /// A channel of a colour is below 0 or not finite.
    #[error("feature {id}: colour has a channel of {value}: expected linear light, at least 0")]
    Colour {
        /// Id of the feature at fault.
        id: u32,
        /// The value that was found.
        value: f64,
    },
    /// The intensity of a light is below 0 or not finite.
    #[error("feature {id}: intensity is {value}: expected a number of at least 0")]
    Intensity {
        /// Id of the feature at fault.
        id: u32,
        /// The value that was found.
        value: f64,
    },
    /// A channel of the background is below 0 or not finite.
    #[error("background has a channel of {0}: expected linear light, at least 0")]
    Background(f64),
}

impl Feature {
    /// A surface of a colour (linear, 0 to 1; more for one that shines) and a translucency (0 opaque to 1 invisible). Where
    /// two features have one distance, the higher `priority` is seen. Where these are equal too, the lower `id` is seen.
    ///
    /// # Errors If the translucency is no share, or a channel is below 0 or not finite.
    #[inline]
    pub fn surface(
        id: u32,
        priority: i32,
        colour: [f64; 3],
        translucency: f64,
    ) -> Result<Self, FeatureError> {
        Self::new(id, priority, Kind::Surface, colour, 1.0 - translucency, translucency)
    }

    /// A light that adds its colour times `added` (at least 0, above 1 where a bright disc covers few sampling points) and lets
    /// `translucency` (0 to 1) through; at 1 it adds and hides nothing. The order is that of [`Feature::surface`].
    ///
    /// # Errors If the translucency is no share, or intensity or a channel is below 0 or not finite.
    pub fn light(
        id: u32,
        priority: i32,
        colour: [f64; 3],
        added: f64,
        translucency: f64,
    ) -> Result<Self, FeatureError> {
        if !is_light(added) {
            return Err(FeatureError::Intensity { id, value: added });
        }
        Self::new(id, priority, Kind::Light, colour, added, translucency)
    }

    /// An opaque surface whose colour (linear red, green, blue) changes over its `plane`. Its order is that of [`Feature::surface`].
    pub fn shaded(id: u32, priority: i32, channels: [Attribute; 3], plane: DistancePlane) -> Self {
        let shading = Some(Shading { channels, plane });
        Self { id, priority, kind: Kind::Surface, translucency: 0.0, light: [0.0; 3], shading }
    }

    #[inline]
    fn new(
        id: u32,
        priority: i32,
        kind: Kind,
        colour: [f64; 3],
        factor: f64,
        translucency: f64,
    ) -> Result<Self, FeatureError> {
        if !(0.0..=1.0).contains(&translucency) {
            return Err(FeatureError::Translucency { id, value: translucency });
        }
        let [red, green, blue] = colour;
        let light = [factor * red, factor * green, factor * blue];
        match colour.iter().chain(&light).find(|channel| !is_light(**channel)) {
            Some(&value) => Err(FeatureError::Colour { id, value }),
            None => Ok(Self { id, priority, kind, translucency, light, shading: None }),
        }
    }

    /// Number that names the feature.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// Which of two features that are equally near is seen: the higher.
    pub fn priority(&self) -> i32 {
        self.priority
    }

    /// Which slots hold it where it is translucent.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Share of light from behind that it lets through, 0 to 1.
    pub fn translucency(&self) -> f64 {
        self.translucency
    }

    /// Light that it sends itself (linear red, green, blue, at least 0), with nothing in front; of a shaded one that of its
    /// places is asked for by [`Feature::light_at`].
    pub fn own_light(&self) -> [f64; 3] {
        self.light
    }

    /// Light that it sends itself at a place on the screen (pixels), at least 0.
    pub fn light_at(&self, place: [f64; 2]) -> [f64; 3] {
        match &self.shading {
            None => self.light,
            Some(Shading { channels, plane }) => {
                let q = plane.at(place);
                let light = |channel: usize| channels[channel].at(place, q).max(0.0);
                [light(0), light(1), light(2)]
            }
        }
    }

    /// Whether it is a surface that lets nothing through.
    pub fn is_opaque(&self) -> bool {
        self.kind == Kind::Surface && self.translucency == 0.0
    }

    /// Whether it changes nothing: no stack stores it.
    pub fn is_invisible(&self) -> bool {
        self.translucency == 1.0 && self.light == [0.0; 3]
    }

    /// Order of features equally near, the nearer first. Features of one priority and id differ by what they look like; beyond that
    /// nobody can tell them apart.
    #[cold]
    pub(crate) fn order_at_one_distance(&self, other: &Self) -> Ordering {
        let own_and_other = || self.light.iter().zip(&other.light);
        other
            .priority
            .cmp(&self.priority)
            .then_with(|| self.id.cmp(&other.id))
            .then_with(|| self.kind.cmp(&other.kind))
            .then_with(|| self.translucency.total_cmp(&other.translucency))
            .then_with(|| own_and_other().fold(Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(b))))
    }
}

/// Whether a number can be an amount of light.
pub(crate) fn is_light(value: f64) -> bool {
    value.is_finite() && value >= 0.0
}
