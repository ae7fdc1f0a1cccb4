//! Laws of reflection (section 7, specular factor; the report invites other functions): of the ground, and of man-made things of their own.

use signal::Number;

/// How much light the ground sends to the eye: `albedo * mu0 * factor`.
///
/// `mu0 = n.s` and `mu = n.v` are the cosines of incidence and emission, `cos_g = s.v` that of the phase angle g. The
/// diffuse laws are scaled so that level ground lit and seen from the zenith has factor 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Photometry {
    /// The same from all directions: factor 1. As reported, and the default of every scene.
    Lambert,
    /// `2 mu0 / (mu0 + mu)`: single scattering in dark powder. The full Moon is a flat disc under it.
    LommelSeeliger,
    /// `L 2 mu0 / (mu0 + mu) + (1 - L) mu0`, L falling with the phase angle: the Moon as measured (McEwen 1996, Lunar
    /// and Planetary Science XXVII, 841). The rise of brightness towards full phase is not in it.
    LunarLambert,
    /// Lambert's law and a highlight: factor `1 + strength (r.v)^exponent`, r the mirrored sun, `r.v = 2 mu0 mu -
    /// cos_g`. It comes on top: the factor at the zenith is `1 + strength`.
    Specular {
        /// Height of the highlight, at least 0.
        strength: f64,
        /// Its sharpness, 1..=128: a whole number, so that it is made of multipliers.
        exponent: u32,
    },
}

/// Smallest `mu0 + mu` that is divided by: reached only where light and sight both graze.
const GRAZING: f64 = 1e-6;

/// L as a polynomial in `sin(g/2)`, ascending powers. McEwen's `1 - 0.019 g + 2.42e-4 g^2 - 1.46e-6 g^3` (g in degrees)
/// falls to 0 at 103.9 degrees; up to there this is within 9e-4 of it, and below 0 beyond (minimax, L(0) = 1 kept).
/// `sin(g/2)` takes a square root and no arc cosine; a polynomial in cos g needs a far higher degree, since L falls
/// linearly from g = 0.
const LUNAR: [f64; 6] =
    [1.0, -2.2210139902647366, 3.840379366714423, -5.6989020576452685, 6.983089757032966, -5.063234815652837];

impl Photometry {
    /// Factor to Lambert's `mu0`; 1 for Lambert. Finite and at least 0 for all finite numbers. A negative mu counts as
    /// 0. A negative mu0 (local shadow) counts by its amount, so that `mu0 * factor` runs smoothly through 0 and stays
    /// within 2 either way under the diffuse laws.
    #[inline(always)]
    pub fn factor<T: Number>(&self, mu0: T, mu: T, cos_g: T) -> T {
        let one = mu0.like(1.0);
        match *self {
            Self::Lambert => one,
            Self::LommelSeeliger => lommel_seeliger(mu0, mu),
            Self::LunarLambert => lunar_lambert(mu0, mu, cos_g),
            Self::Specular { strength, exponent } => {
                one + one.like(strength) * power(mirrored(mu0, mu, cos_g), one, exponent)
            }
        }
    }

    /// Share of the light that a face of this `albedo` sends to the eye, 0..=1: `albedo * max(mu0, 0) * factor`, at most 1. To the bit
    /// `max(mu0, 0) * albedo` for Lambert.
    #[inline(always)]
    pub fn returned<T: Number>(&self, albedo: T, [mu0, mu, cos_g]: [T; 3]) -> T {
        let lit = mu0.at_least(mu0.like(0.0)) * albedo;
        match self {
            Self::Lambert => lit,
            _ => within_one(lit * self.factor(mu0, mu, cos_g)),
        }
    }
}

/// `2 / (mu0 + mu)`.
#[inline(always)]
fn lommel_seeliger<T: Number>(mu0: T, mu: T) -> T {
    let sum = mu0.at_least(-mu0) + mu.at_least(mu.like(0.0));
    mu.like(2.0) / sum.at_least(mu.like(GRAZING))
}

#[inline(always)]
fn lunar_lambert<T: Number>(mu0: T, mu: T, cos_g: T) -> T {
    let share = lunar_share(cos_g);
    share * lommel_seeliger(mu0, mu) + (share.like(1.0) - share)
}

/// Share of Lommel and Seeliger's law in the Moon's light, L, 0..=1.
#[inline(always)]
fn lunar_share<T: Number>(cos_g: T) -> T {
    let number = |value: f64| cos_g.like(value);
    let half_angle = within_one(number(0.5) * (number(1.0) - cos_g)).root();
    let mut share = number(LUNAR[5]);
    for k in (0..5).rev() {
        share = share * half_angle + number(LUNAR[k]);
    }
    share.at_least(number(0.0))
}

/// Cosine between the mirrored sun and the eye, 0..=1.
#[inline(always)]
fn mirrored<T: Number>(mu0: T, mu: T, cos_g: T) -> T {
    let (mu0, mu) = (mu0.at_least(mu0.like(0.0)), mu.at_least(mu.like(0.0)));
    within_one(mu.like(2.0) * mu0 * mu - cos_g)
}

/// `value` held to 0..=1.
#[inline(always)]
fn within_one<T: Number>(value: T) -> T {
    let (zero, one) = (value.like(0.0), value.like(1.0));
    -(-value.at_least(zero)).at_least(-one)
}

/// Returns `base^exponent`, by repeated squaring; `one` is the number 1 of that type.
#[inline(always)]
fn power<T: Number>(base: T, one: T, exponent: u32) -> T {
    let (mut result, mut square, mut left) = (one, base, exponent);
    while left > 0 {
        if left & 1 == 1 {
            result = result * square;
        }
        square = square * square;
        left >>= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    use super::Photometry;
    use proptest::prelude::{prop_assert, proptest};
    use quantities::{radians, sin_cos};

    const LAWS: [Photometry; 4] = [
        Photometry::Lambert,
        Photometry::LommelSeeliger,
        Photometry::LunarLambert,
        Photometry::Specular { strength: 0.7, exponent: 37 },
    ];

    #[test]
    fn level_ground_under_the_zenith_has_factor_one() {
        for law in &LAWS[..3] {
            assert!((law.factor(1.0f64, 1.0, 1.0) - 1.0).abs() < 1e-15, "{law:?}");
        }
        assert_eq!(LAWS[3].factor(1.0, 1.0, 1.0), 1.7);
    }

    #[test]
    fn closed_forms() {
        assert_eq!(Photometry::LommelSeeliger.factor(0.5, 0.3, 0.1), 2.5);
        assert_eq!(Photometry::LunarLambert.factor(0.5, 0.3, 1.0), 2.5);
        // Beyond 104 degrees of phase the Moon is Lambert's.
        assert_eq!(Photometry::LunarLambert.factor(0.5, 0.3, -0.3), 1.0);
        // 60 degrees of incidence, eye 15 degrees off the mirrored sun in its plane.
        let ((_, mu0), (_, mu), (_, cos_g)) =
            (sin_cos(radians(60.0)), sin_cos(radians(45.0)), sin_cos(radians(105.0)));
        let expected = 1.0 + 0.7 * libm::pow(sin_cos(radians(15.0)).1, 37.0);
        assert!((LAWS[3].factor(mu0, mu, cos_g) - expected).abs() < 1e-14);
    }

    #[test]
    fn a_face_returns_no_more_than_it_is_given() {
        let gloss = Photometry::Specular { strength: 3.0, exponent: 9 };
        // Seen from the mirrored sun: a highlight of full height.
        let cosines = [0.5f64, 0.5, -0.5];
        assert_eq!(Photometry::Lambert.returned(0.2, cosines), 0.1);
        assert!((gloss.returned(0.2, cosines) - 0.4).abs() < 1e-15);
        assert_eq!(gloss.returned(0.9, cosines), 1.0);
        for law in LAWS {
            assert_eq!(law.returned(0.9, [-0.1, 0.5, -0.5]), 0.0, "{law:?}");
        }
    }

    /// McEwen's cubic, held to 0..=1.
    #[test]
    fn lunar_share_keeps_its_stated_error() {
        let mut worst: f64 = 0.0;
        for step in 0..=18_000 {
            let g = f64::from(step) * 0.01;
            let cubic = (1.0 + g * (-0.019 + g * (2.42e-4 - 1.46e-6 * g))).clamp(0.0, 1.0);
            worst = worst.max((super::lunar_share(libm::cos(radians(g))) - cubic).abs());
        }
        assert!(worst < 9e-4, "{worst}");
        assert!(worst > 8e-4, "{worst}: state the better figure");
    }

    /// At full phase mu = mu0 all over the disc: it is as bright at its limb as in its middle.
    #[test]
    fn the_full_moon_is_flat() {
        for mu0 in [1.0f64, 0.5, 0.1, 1e-3] {
            for law in [Photometry::LommelSeeliger, Photometry::LunarLambert] {
                assert!((mu0 * law.factor(mu0, mu0, 1.0) - 1.0).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn a_highlight_is_sharp_to_the_stated_power() {
        for exponent in 1..=128 {
            let law = Photometry::Specular { strength: 1.0, exponent };
            let factor = law.factor(0.98, 0.97, 2.0 * 0.98 * 0.97 - 0.95);
            assert!((factor - 1.0 - libm::pow(0.95, f64::from(exponent))).abs() < 1e-13, "{exponent}");
        }
    }

    proptest! {
        #[test]
        fn finite_bounded_and_continuous(mu0 in -1.0..=1.0f64, mu in -1.0..=1.0f64, cos_g in -1.0..=1.0f64) {
            for law in LAWS {
                for (mu0, mu) in [(mu0, mu), (0.0, mu), (mu0, 0.0), (0.0, 0.0), (mu0 * 1e-9, mu * 1e-9)] {
                    let factor = law.factor(mu0, mu, cos_g);
                    prop_assert!(factor.is_finite() && factor >= 0.0);
                    prop_assert!((mu0 * factor).abs() <= 2.0 * (1.0 + 1e-15), "{law:?}: {mu0} {mu} {cos_g}");
                }
                // Through 0 of mu0: no jump.
                let near = |mu0: f64| mu0 * law.factor(mu0, mu, cos_g);
                prop_assert!((near(1e-12) - near(-1e-12)).abs() <= 1e-11 / mu.max(1e-6));
            }
        }

        #[test]
        fn light_and_sight_may_change_places(mu0 in 0.0..=1.0f64, mu in 0.0..=1.0f64, cos_g in -1.0..=1.0f64) {
            for law in LAWS {
                let (there, back) = (law.factor(mu0, mu, cos_g), law.factor(mu, mu0, cos_g));
                prop_assert!((there - back).abs() <= 1e-15 * there);
            }
        }

        #[test]
        fn f32_follows_f64(mu0 in 0.0..=1.0f64, mu in 0.01..=1.0f64, cos_g in -1.0..=1.0f64) {
            for law in LAWS {
                let wide = mu0 * law.factor(mu0, mu, cos_g);
                let narrow = f64::from(mu0 as f32 * law.factor(mu0 as f32, mu as f32, cos_g as f32));
                // Near full phase half the angle is the root of a difference.
                let bound = 1e-4 + if cos_g > 0.9999 { 2e-3 } else { 0.0 };
                prop_assert!((wide - narrow).abs() < bound, "{law:?}: {wide} {narrow}");
            }
        }
    }
}
