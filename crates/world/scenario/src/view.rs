//! The view: everything that is asked of a picture, whatever draws it.

use quantities::Rate;

use crate::{Display, FieldOfView, Laws, LevelSwitch, ShadowFineness, Yoke};

/// What every image generator is asked for: pixels, field, clock, display, and the laws that it shares with its judge.
#[derive(Debug, Clone, PartialEq)]
pub struct View {
    /// Columns of the picture, 1..=8192.
    pub columns: u32,
    /// Lines of the picture, 1..=8192.
    pub lines: u32,
    /// Field of view that the picture shows.
    pub field: FieldOfView,
    /// Pictures computed a second.
    pub update: Rate,
    /// Pictures shown a second, a whole multiple of `update`.
    pub refresh: Rate,
    /// From reflectivity to grey.
    pub display: Display,
    /// Law switches, the pixel rule among them.
    pub laws: Laws,
    /// Ground ranges at which ground begins and ends to be seen (m).
    pub ranges: [f64; 2],
    /// Deflection yoke, where the display turns the picture with the vehicle's roll.
    pub yoke: Option<Yoke>,
    /// Switch from the fine level of the ground to the coarse one, where the scenario has two.
    pub levels: Option<LevelSwitch>,
    /// How finely remote shadow is worked out, where it is drawn.
    pub shadows: Option<ShadowFineness>,
}
