//! What shades and colours of a page mean.

use crate::canvas::{Anchor, Area, Canvas};
use crate::frame::SMALL;
use crate::lettering;

use super::crossing::Verticals;
use super::page::RegisterColour;
use crate::flow::{flow, rows};

/// Height of a row.
const ROW: f32 = 20.0;
/// From one entry to the next.
const APART: f32 = 14.0;
/// Width of the patch of a shade, and of a colour.
const PATCH: [f32; 2] = [20.0, 8.0];
/// From a patch to its word.
const GAP: f32 = 5.0;

/// One entry of the key.
enum Entry {
    Blanked,
    Text(String),
    Register(RegisterColour),
}

/// The key of a page, in rows that fit its width.
pub(crate) struct Key {
    entries: Vec<(Entry, (usize, f32))>,
    rows: usize,
}

impl Key {
    /// The key to what is shaded, if anything is, and to the crossings of the fine and of the coarse level.
    pub fn new(is_blanked: bool, fine: &Verticals, coarse: &Verticals, room: f32) -> Self {
        let mut entries: Vec<Entry> = is_blanked.then_some(Entry::Blanked).into_iter().collect();
        entries.extend(counted(fine, coarse).into_iter().map(Entry::Text));
        let loaded =
            |colour: &RegisterColour| [fine, coarse].iter().any(|level| level.colours().contains(colour));
        entries.extend(RegisterColour::ALL.into_iter().filter(loaded).map(Entry::Register));
        let places = flow(entries.iter().map(Entry::width), APART, room);
        let rows = rows(&places);
        Self { entries: entries.into_iter().zip(places).collect(), rows }
    }

    /// Pixels that it takes.
    pub fn height(&self) -> f32 {
        ROW * self.rows as f32
    }

    /// Draws it from `left` on, its first row at `base`.
    pub fn draw(&self, canvas: &mut Canvas, left: f32, base: f32) {
        for (entry, (row, along)) in &self.entries {
            entry.draw(canvas, (left + along, base + ROW * *row as f32));
        }
    }
}

/// How many crossings are seen, and how many of them are drawn; then what their colours are.
fn counted(fine: &Verticals, coarse: &Verticals) -> Vec<String> {
    let of = |(level, what): (&Verticals, &str)| {
        let (count, drawn) = (level.count, level.drawn());
        let some = if drawn < count { format!(", {drawn} drawn") } else { String::new() };
        let plural = if count == 1 { "" } else { "s" };
        (count > 0).then(|| format!("{count} {what} crossing{plural}{some};"))
    };
    let mut texts: Vec<String> = [(fine, "region"), (coarse, "coarse")].into_iter().filter_map(of).collect();
    if !texts.is_empty() {
        texts.push("loaded there:".into());
    }
    texts
}

impl Entry {
    fn width(&self) -> f32 {
        let patch = match self {
            Self::Blanked => PATCH[0] + GAP,
            Self::Register(_) => PATCH[1] + GAP,
            Self::Text(_) => 0.0,
        };
        patch + lettering::width(&self.word(), SMALL)
    }

    fn word(&self) -> String {
        match self {
            Self::Blanked => "blanked".into(),
            Self::Text(text) => text.clone(),
            Self::Register(colour) => format!("{} {}", colour.letter(), colour.word()),
        }
    }

    fn draw(&self, canvas: &mut Canvas, (left, base): (f32, f32)) {
        let palette = canvas.palette();
        let word = match self {
            Self::Blanked => {
                let patch = Area { left, top: base - 9.0, width: PATCH[0], height: 11.0 };
                canvas.fill(patch, palette.shade);
                canvas.border(patch, palette.faint);
                left + PATCH[0] + GAP
            }
            Self::Register(colour) => {
                let patch = Area { left, top: base - 8.0, width: PATCH[1], height: 8.0 };
                canvas.fill(patch, colour.of(palette));
                left + PATCH[1] + GAP
            }
            Self::Text(_) => left,
        };
        canvas.text(&self.word(), (word, base), Anchor::Left, SMALL, palette.soft);
    }
}
