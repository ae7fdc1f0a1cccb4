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
    /// Contrast alone, with nothing taken off for the cut-off.
    drive: f32,
}

impl TubeLaw {
    /// The law of `parts`, with contrast set so that video of the reflectivity `white` drives the tube to white.
    pub fn new(parts: &PictureTubeParts, white: f64) -> Self {
        let (above, drive) = (1.0 - parts.cut_off, libm::pow(white, -1.0 / parts.correction));
        Self {
            drive: drive as f32,
            gain: (drive / above) as f32,
            cut_off: (parts.cut_off / above) as f32,
            gamma: parts.gamma as f32,
            white: white as f32,
        }
    }

    /// How far the video `video` drives the tube: 1 for white.
    pub fn drive(&self, video: f32) -> f32 {
        video * self.drive
    }

    /// Light of the video `video`, in the unit of reflectivity; 0 or more.
    #[inline]
    pub fn light(&self, video: f32) -> f32 {
        self.white * libm::powf((video * self.gain - self.cut_off).max(0.0), self.gamma)
    }
}
