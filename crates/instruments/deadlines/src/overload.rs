//! The overload map of a frame: its picture, dimmed, and on it what was lost.

use generator::{Loss, PlaneKind, Planes};
use picture::{ColourPicture, Depth, Encoder, Picture, Transfer};

use crate::{DeadlineError, Other};

/// Colours of the losses, the lowest layer first: a sub-area that is late is larger than what lies on it.
const LAYERS: [(Loss, [u32; 3]); 4] = [
    (Loss::Late, [220, 40, 60]),
    (Loss::List, [255, 150, 0]),
    (Loss::Stack, [0, 140, 255]),
    (Loss::Light, [255, 255, 255]),
];

/// Share of its brightness that a pixel of the picture keeps, in hundredths; the rest is the colour of a loss.
const DIMMED: u32 = 40;

/// What a frame lost, pixel by pixel.
pub struct OverloadMap {
    /// The map as a picture of 8 bits.
    pub picture: ColourPicture,
    /// Pixels with each loss.
    pub pixels: Vec<(Loss, usize)>,
}

impl OverloadMap {
    /// The map of frame `frame`, whose generator fills [`PlaneKind::Overload`].
    ///
    /// # Errors
    /// If the frame cannot be drawn.
    pub fn of(other: &Other, frame: u64) -> Result<Self, DeadlineError> {
        let view = &other.stage().view;
        let size = [view.columns, view.lines].map(|count| count as usize);
        let planes =
            other.draw(frame, Planes::new(size[0], size[1], &[PlaneKind::Intensity, PlaneKind::Overload]))?;
        let [intensity, losses] =
            [PlaneKind::Intensity, PlaneKind::Overload].map(|kind| planes.get(kind).unwrap_or_default());
        let transfer = Transfer::new(view.display.white as f32, view.display.gamma as f32)?;
        let grey = Encoder::new(transfer, Depth::Eight).encode(intensity, size[0], size[1])?;
        let losses: Vec<u8> = losses.iter().map(|bits| *bits as u8).collect();
        let codes = grey.codes().iter().zip(&losses);
        let codes = codes.flat_map(|(grey, bits)| painted(u32::from(*grey), *bits)).collect();
        let pixels = LAYERS
            .iter()
            .map(|(loss, _)| (*loss, losses.iter().filter(|bits| **bits & loss.bit() != 0).count()));
        let picture = Picture::new(size[0], size[1], Depth::Eight, codes)?;
        Ok(Self { picture, pixels: pixels.collect() })
    }

    /// Pixels with each loss, as text.
    pub fn text(&self) -> String {
        let rows = self.pixels.iter().map(|(loss, count)| vec![loss.name().to_owned(), count.to_string()]);
        let head = vec!["loss".to_owned(), "pixels".to_owned()];
        format!("\n{}", text::table(&[head].into_iter().chain(rows).collect::<Vec<_>>()))
    }
}

/// A pixel of a grey level under the uppermost of its losses.
fn painted(grey: u32, bits: u8) -> [u16; 3] {
    let uppermost = LAYERS.iter().rev().find(|(loss, _)| bits & loss.bit() != 0);
    let colour = uppermost.map_or([0; 3], |(_, colour)| *colour);
    colour.map(|part| ((grey * DIMMED + part * (100 - DIMMED)) / 100) as u16)
}

#[cfg(test)]
mod tests {
    use generator::Loss;

    use super::{LAYERS, painted};

    #[test]
    fn every_loss_has_a_colour_of_its_own_and_the_smaller_lies_on_the_larger() {
        assert!(Loss::ALL.iter().all(|loss| LAYERS.iter().any(|(known, _)| known == loss)));
        let alone = LAYERS.map(|(loss, _)| painted(100, loss.bit()));
        assert!((0..4).all(|one| (0..one).all(|other| alone[one] != alone[other])));
        assert_eq!(painted(100, Loss::Late.bit() | Loss::Stack.bit()), painted(100, Loss::Stack.bit()));
        assert_eq!(painted(100, 0), [40; 3]);
    }
}
