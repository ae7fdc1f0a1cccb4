//! What a picture is drawn on: its pixels and their depths.

use crate::depth::DepthBuffer;
use crate::picture::Picture;

/// A panel that was found at a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Number of the panel.
    pub panel: u32,
    /// Distance (m) of the panel at the pixel, as the depth buffer knows it.
    pub distance: f64,
    /// Whether it was written: nothing nearer stood there before it.
    pub is_written: bool,
}

/// Picture and depth buffer of a frame.
pub(crate) struct Canvas {
    pub picture: Picture,
    pub buffer: DepthBuffer,
    /// How often a pixel was written.
    pub writes: u64,
    /// Pixel whose panels are listed, and those panels with the values of their depths.
    pub watched: Option<usize>,
    pub looks: Vec<Look>,
}

impl Canvas {
    /// Writes a panel (its number and light) into a pixel, if it is the nearest there.
    pub fn write(&mut self, pixel: usize, value: f64, (number, light): (usize, f32)) {
        let is_written = self.buffer.keep(pixel, value);
        if is_written {
            let picture = &mut self.picture;
            picture.light[pixel] = light;
            picture.panel[pixel] = number as u32;
            picture.writes[pixel] = picture.writes[pixel].saturating_add(1);
            self.writes += 1;
        }
        if self.watched == Some(pixel) {
            self.looks.push(Look { panel: number as u32, distance: value, is_written });
        }
    }
}
