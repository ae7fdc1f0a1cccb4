//! Whether what a scene has beside ground and bodies is grey.

use quantities::is_grey;
use scenario::{DiscFace, Effects};

/// Whether a light point, a sheet, an overlay or a disc of the sky has channels that differ.
pub fn has_colour(effects: &Effects) -> bool {
    let Effects { lights, sheets, overlays, discs } = effects;
    let lights = lights.iter().map(|light| light.colour);
    let sheets = sheets.iter().map(|sheet| sheet.colour);
    let overlays = overlays.iter().map(|overlay| overlay.colour);
    let discs = discs.iter().map(|disc| face(&disc.face));
    lights.chain(sheets).chain(overlays).chain(discs).any(|colour| !is_grey(colour))
}

/// Light or albedo of a face (linear red, green, blue).
fn face(face: &DiscFace) -> [f64; 3] {
    match *face {
        DiscFace::Sun { colour } => colour,
        DiscFace::Ball { albedo, .. } => albedo,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenario::Overlay;

    #[test]
    fn one_coloured_thing_is_enough() {
        let overlay = |colour| Overlay { id: 0, corners: vec![[0.0; 2]; 3], colour, share: 0.5, priority: 0 };
        let of = |colours: &[[f64; 3]]| Effects {
            overlays: colours.iter().map(|colour| overlay(*colour)).collect(),
            ..Effects::default()
        };
        assert!(!has_colour(&of(&[])) && !has_colour(&of(&[[0.25; 3], [1.0; 3]])));
        assert!(has_colour(&of(&[[0.25; 3], [1.0, 0.9, 0.8]])));
    }
}
