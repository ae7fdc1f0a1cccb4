//! Luminance of linear colour.

/// Weights of linear red, green and blue in luminance, under the primaries and the white of ITU-R BT.709. Their sum is 1.
pub const LUMINANCE_WEIGHTS: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// The luminance of linear red, green and blue, in their unit.
pub fn luminance(colour: [f64; 3]) -> f64 {
    let [red, green, blue] = LUMINANCE_WEIGHTS;
    red * colour[0] + green * colour[1] + blue * colour[2]
}

/// Whether three channels are equal: a grey.
pub fn is_grey([red, green, blue]: [f64; 3]) -> bool {
    red == green && green == blue
}

/// The luminance of a colour, and of a grey its channel to the bit: the weights would round it.
pub fn intensity(colour: [f64; 3]) -> f64 {
    if is_grey(colour) { colour[0] } else { luminance(colour) }
}

#[cfg(test)]
mod tests {
    use super::{intensity, is_grey, luminance};

    #[test]
    fn a_grey_keeps_its_bits() {
        for grey in [0.0, 0.1, 1.0 / 3.0, 0.7, 1.0] {
            assert!(is_grey([grey; 3]) && intensity([grey; 3]) == grey);
        }
        // The weights round: this is why greys are told apart.
        assert!((0..1000).map(|k| f64::from(k) / 999.0).any(|grey| luminance([grey; 3]) != grey));
        let colour = [0.5, 0.25, 0.125];
        assert!(!is_grey(colour) && intensity(colour) == luminance(colour));
    }
}
