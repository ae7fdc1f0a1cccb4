//! From video to light: cut-off and gamma.

use hardware_model::PictureTubeParts;

/// The law of the tube between its contrast control and its face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TubeLaw {
    /// Contrast, over what is left of the video above the cut-off.
    gain: f32,
    cut_off: f32,
    gamma: f32,
    white: f32,
}

impl TubeLaw {
    /// The law of `parts`, with contrast set so that video of the reflectivity `white` drives the tube to white.
    pub fn new(parts: &PictureTubeParts, white: f64) -> Self {
        let above = 1.0 - parts.cut_off;
        Self {
            gain: (libm::pow(white, -1.0 / parts.correction) / above) as f32,
            cut_off: (parts.cut_off / above) as f32,
            gamma: parts.gamma as f32,
            white: white as f32,
        }
    }

    /// Light of the video `video`, in the unit of reflectivity; 0 or more.
    #[inline]
    pub fn light(&self, video: f32) -> f32 {
        self.white * libm::powf((video * self.gain - self.cut_off).max(0.0), self.gamma)
    }
}
