//! What a drawing is made of, and the one interface of what it can be drawn on.

use crate::colour::Colour;
use crate::lettering::Size;

/// A rectangle of pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub left: f32,
    pub top: f32,
    pub width: f32,
    pub height: f32,
}

impl Area {
    pub fn right(&self) -> f32 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f32 {
        self.top + self.height
    }
}

/// A line of text in one size and colour.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Letters {
    pub text: String,
    /// Begin of its base line.
    pub at: (f32, f32),
    pub upwards: bool,
    pub size: Size,
    pub colour: Colour,
}

/// One stroke of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mark {
    /// Keeps what follows, letters and images apart, within an area, or lets it go anywhere.
    Clip(Option<Area>),
    Fill(Area, Colour),
    /// Joined lines; with a dash, its ink and its gap (pixels).
    Line {
        points: Vec<(f32, f32)>,
        width: f32,
        dash: Option<[f32; 2]>,
        colour: Colour,
    },
    /// A closed polygon, filled.
    Polygon(Vec<(f32, f32)>, Colour),
    Letters(Letters),
    /// Pixels of an area whose corners lie on whole pixels, line by line.
    Image(Area, Vec<Colour>),
}

impl Mark {
    /// The one colour of a stroke; pixels and clips have none.
    pub fn colour(&self) -> Option<Colour> {
        match self {
            Self::Fill(_, colour) | Self::Polygon(_, colour) | Self::Line { colour, .. } => Some(*colour),
            Self::Letters(letters) => Some(letters.colour),
            Self::Clip(_) | Self::Image(..) => None,
        }
    }
}

/// Something that can be drawn on.
pub(crate) trait Surface {
    /// Takes the next mark of a drawing.
    fn take(&mut self, mark: &Mark);
}
