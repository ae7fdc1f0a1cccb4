//! Luminance of linear colour.

/// Weights of linear red, green and blue in luminance, under the primaries and the white of ITU-R BT.709. Their sum is 1.
pub const LUMINANCE_WEIGHTS: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// The luminance of linear red, green and blue, in their unit.
pub fn luminance(colour: [f64; 3]) -> f64 {
    let [red, green, blue] = LUMINANCE_WEIGHTS;
    red * colour[0] + green * colour[1] + blue * colour[2]
}
