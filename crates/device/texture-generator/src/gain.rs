//! What the feature generator adds to the gain of texture: a multiplier behind the sum of the layers.

use signal::{Lanes, Real};

/// Multiplies the `texture` of a group by a gain of 1 and what craters add to it (`grain`, fg.grain), which is never below 0. Samples
/// beyond the end of `grain` keep their texture.
pub fn scale<S: Real>(grain: &[Lanes<S>], texture: &mut [Lanes<S>]) {
    for (texture, grain) in texture.iter_mut().zip(grain) {
        let gain = grain.map(|added| (S::ONE + added).at_least(S::ZERO));
        *texture = *texture * gain;
    }
}

#[cfg(test)]
mod tests {
    use signal::Lanes;

    use super::scale;

    #[test]
    fn the_gain_is_never_negative_and_ends_with_the_craters() {
        let mut texture = vec![Lanes::splat(0.1_f64); 4];
        scale(&[Lanes::splat(2.0), Lanes::splat(-0.5), Lanes::splat(-1.5)], &mut texture);
        let expected = [0.1 * 3.0, 0.1 * 0.5, 0.0, 0.1].map(Lanes::splat);
        assert_eq!(texture, expected);
    }
}
