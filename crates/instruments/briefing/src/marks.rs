//! Lines and discs over a picture of 8 bits.

use picture::{ColourPicture, Depth, PictureError};

/// Codes of a picture in colour that marks are laid over.
#[derive(Debug, Clone)]
pub struct Canvas {
    size: [usize; 2],
    codes: Vec<u16>,
}

impl Canvas {
    /// A canvas over a picture of 8 bits.
    pub fn over(picture: &ColourPicture) -> Self {
        Self { size: [picture.columns(), picture.lines()], codes: picture.codes().to_vec() }
    }

    /// Lays a line of a width between two places (columns and lines; pixels) in a colour of 8 bits. A line between equal places is a disc.
    pub fn line(&mut self, [from, to]: [[f64; 2]; 2], width: f64, colour: [u16; 3]) {
        let reach = width / 2.0 + 1.0;
        let range = |axis: usize| {
            let [low, high] = [from[axis].min(to[axis]) - reach, from[axis].max(to[axis]) + reach];
            let count = self.size[axis] as f64;
            low.clamp(0.0, count) as usize..high.ceil().clamp(0.0, count) as usize
        };
        for line in range(1) {
            for column in range(0) {
                let middle = [column, line].map(|at| at as f64 + 0.5);
                let share = (width / 2.0 + 0.5 - distance(middle, [from, to])).clamp(0.0, 1.0);
                let first = 3 * (line * self.size[0] + column);
                for (code, over) in self.codes[first..first + 3].iter_mut().zip(colour) {
                    let mixed = f64::from(*code) + share * (f64::from(over) - f64::from(*code));
                    *code = mixed.round() as u16;
                }
            }
        }
    }

    /// The picture with its marks.
    pub fn finish(self) -> Result<ColourPicture, PictureError> {
        ColourPicture::new(self.size[0], self.size[1], Depth::Eight, self.codes)
    }
}

/// Distance of a place from a stretch.
fn distance(place: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let [along, way] = [to, place].map(|end| [end[0] - from[0], end[1] - from[1]]);
    let square = along[0] * along[0] + along[1] * along[1];
    let share =
        if square > 0.0 { ((way[0] * along[0] + way[1] * along[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(way[0] - share * along[0], way[1] - share * along[1])
}
