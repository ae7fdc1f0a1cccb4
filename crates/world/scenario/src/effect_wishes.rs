//! What a scenario wants to be seen beside ground and bodies: lamps, stars, sheets, overlays and discs of the sky.

use glam::DVec3;

use crate::{Flash, Lobe, Medium, Moves, StarWish};

/// Everything of a scenario that is seen beside ground and bodies.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EffectWishes {
    /// Lamps, strings of lamps and single stars, in the order of the file.
    pub lights: Vec<LightWish>,
    /// Translucent polygons of the scene, in the order of the file.
    pub sheets: Vec<SheetWish>,
    /// Polygons that are fixed to the eye, in the order of the file.
    pub overlays: Vec<OverlayWish>,
    /// The stars of the sky, where it has any.
    pub stars: Option<StarWish>,
    /// The Earth in the sky, where it is drawn.
    pub earth: Option<EarthWish>,
    /// Whether the disc of the sun is drawn.
    pub sun_disc: bool,
    /// Apparent magnitude of a star that shows white on the least disc of a light point, -50 to 50.
    pub white_magnitude: f64,
}

/// From when until when something is there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Presence {
    /// First time at which it is there (s).
    pub from: f64,
    /// Time from which on it is gone (s); infinite if it stays.
    pub until: f64,
}

/// A lamp, a string of lamps, or a single star.
#[derive(Debug, Clone, PartialEq)]
pub struct LightWish {
    /// Its name; lights, sheets and overlays have different ones.
    pub id: String,
    /// Where it is and how large or bright.
    pub place: LightPlace,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// Intensity of its face, 1 for the display's white.
    pub intensity: f64,
    /// Priority where two things are equally near: the higher is seen.
    pub priority: i8,
    /// Whether a beam of its own draws it.
    pub calligraphic: bool,
    /// To which side it shines, in the axes of what carries it, or north, east, up; `None` is to all sides.
    pub beam: Option<Lobe>,
    /// When it is lit; `None` if always.
    pub flash: Option<Flash>,
    /// When it is there.
    pub presence: Presence,
}

impl LightWish {
    /// How many light points it has: one, or the lamps of a string.
    pub fn lamps(&self) -> u32 {
        match self.place {
            LightPlace::String { count, .. } => count,
            _ => 1,
        }
    }
}

/// Where a light is, and its size or brightness.
#[derive(Debug, Clone, PartialEq)]
pub enum LightPlace {
    /// A lamp over the ground.
    Ground {
        /// Where it stands, or its foot at rest.
        spot: Spot,
        /// Diameter of its face (m), above 0.
        diameter: f64,
        /// How its foot point moves, where it does; the lamp is [`Spot::above`] its foot point.
        moves: Option<Moves>,
    },
    /// Lamps at equal distances, each over its own ground.
    String {
        /// The first and the last.
        ends: [Spot; 2],
        /// How many, 2 or more.
        count: u32,
        /// Diameter of each face (m), above 0.
        diameter: f64,
    },
    /// A lamp on an object: it comes, moves and goes with it.
    Object {
        /// Index of the object.
        object: usize,
        /// Forward, starboard, up from the object's foot point (m); the object's scale does not change it.
        at: DVec3,
        /// Diameter of its face (m), above 0.
        diameter: f64,
    },
    /// A star: infinitely far.
    Sky {
        /// Unit vector to it: north, east, up.
        direction: DVec3,
        /// Apparent magnitude, -50 to 50.
        magnitude: f64,
    },
}

/// A place over the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Its coordinates: north, east (m).
    pub at: [f64; 2],
    /// Height above the ground under it (m).
    pub above: f64,
}

/// A translucent polygon of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SheetWish {
    /// Its name; lights, sheets and overlays have different ones.
    pub id: String,
    /// Corners around it, 3 to 16, in the axes that `place` says (m).
    pub corners: Vec<DVec3>,
    /// What its corners count from.
    pub place: SheetPlace,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// How much light it lets through.
    pub medium: Medium,
    /// Priority where two things are equally near: the higher is seen.
    pub priority: i8,
    /// When it is there.
    pub presence: Presence,
}

/// What the corners of a sheet count from.
#[derive(Debug, Clone, PartialEq)]
pub enum SheetPlace {
    /// North, east, and up above the ground under the first corner.
    Foot,
    /// North, east, and up above the ground under each corner.
    Ground,
    /// North, east, and up above the datum, the plane from which heights of the ground count.
    Datum,
    /// Forward, starboard and up from a foot point that moves.
    Moving(Moves),
}

/// A polygon that is fixed to the eye.
#[derive(Debug, Clone, PartialEq)]
pub struct OverlayWish {
    /// Its name; lights, sheets and overlays have different ones.
    pub id: String,
    /// Corners around it, 3 to 16: x right in half widths, y down in half heights, from the middle.
    pub corners: Vec<[f64; 2]>,
    /// Its colour (linear red, green, blue, 0..=1).
    pub colour: [f64; 3],
    /// Share of light that it lets through (0 opaque to 1 invisible).
    pub share: f64,
    /// Which of two overlays is before the other: the higher.
    pub priority: i8,
    /// When it is there.
    pub presence: Presence,
}

/// The Earth in the sky.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthWish {
    /// Where it is seen; `None` where a date says it.
    pub seen: Option<EarthSeen>,
    /// Share of red, green and blue light that it returns, 0..=1.
    pub albedo: [f64; 3],
}

/// Where the Earth is seen, and how large.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarthSeen {
    /// Unit vector to its middle: north, east, up.
    pub direction: DVec3,
    /// How wide it is seen (rad), above 0.
    pub angular_diameter: f64,
}
