//! Direction of light, and the laws of reflection in terrain axes and in those of a sweep (section 7).
//!
//! For light the map is taken flat: sun and sight are straight over it, and the curvature of the lunoid turns
//! neither (15.4).

use quantities::sin_cos;
use signal::{LANES, Lanes, Number, Real};

use crate::Photometry;
use crate::places::Places;

/// The sun as a direction; a point source, the same over the problem area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sun {
    /// Clockwise from north (rad).
    pub azimuth: f64,
    /// Above the horizontal (rad).
    pub elevation: f64,
}

impl Sun {
    /// Unit vector to the sun: north, east, up.
    pub fn direction(&self) -> [f64; 3] {
        let (sin_e, cos_e) = sin_cos(self.elevation);
        let (sin_a, cos_a) = sin_cos(self.azimuth);
        [cos_e * cos_a, cos_e * sin_a, sin_e]
    }

    /// Lambert's factor `max(n.s, 0)` for ground of slopes `[hx, hy]`; 0 is local shadow.
    pub fn reflectivity(&self, slopes: [f64; 2]) -> f64 {
        reflectivity(self.direction(), slopes)
    }

    /// What ground of slopes `[hx, hy]` and albedo 1 sends along `to_eye`, the unit vector from it to the eye (north,
    /// east, up), under `photometry`; 0 is local shadow.
    pub fn shade(&self, slopes: [f64; 2], to_eye: [f64; 3], photometry: Photometry) -> f64 {
        shade(self.direction(), slopes, to_eye, photometry)
    }
}

/// [`Sun::shade`] by the sun's unit vector, for whoever shades many places under one sun.
pub fn shade(sun: [f64; 3], [hx, hy]: [f64; 2], to_eye: [f64; 3], photometry: Photometry) -> f64 {
    let mu0 = reflectivity(sun, [hx, hy]);
    // Lambert's law does not ask from where the ground is seen.
    if photometry == Photometry::Lambert {
        return mu0;
    }
    let mu = (to_eye[2] - hx * to_eye[0] - hy * to_eye[1]) / (1.0 + hx * hx + hy * hy).sqrt();
    let cos_g = sun[0] * to_eye[0] + sun[1] * to_eye[1] + sun[2] * to_eye[2];
    mu0 * photometry.factor(mu0, mu, cos_g)
}

fn reflectivity([north, east, up]: [f64; 3], [hx, hy]: [f64; 2]) -> f64 {
    ((up - hx * north - hy * east) / (1.0 + hx * hx + hy * hy).sqrt()).max(0.0)
}

/// Light in the axes of one sweep: the sun vector scaled by the albedo, so that Lambert's law needs no further
/// product.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepLight {
    /// Sun vector along the sweep, times albedo.
    pub along: f64,
    /// Across it, to the right, times albedo.
    pub across: f64,
    /// Component of the sun vector upwards, times albedo.
    pub up: f64,
    /// Share of the light that is returned, 0..=1.
    pub albedo: f64,
    /// Law by which the ground reflects light.
    pub photometry: Photometry,
}

impl SweepLight {
    /// Light of `sun` for a sweep along `direction` (cosine, sine of azimuth against north).
    pub fn new(sun: &Sun, albedo: f64, photometry: Photometry, [cos, sin]: [f64; 2]) -> Self {
        let [north, east, up] = sun.direction().map(|component| component * albedo);
        Self { along: north * cos + east * sin, across: east * cos - north * sin, up, albedo, photometry }
    }

    /// Reflectivity with its sign, -2..=2 (Lambert: -1..=1) times albedo, below 0 in local shadow, of ground of slopes
    /// `along` and `across` the sweep. `sight` is the tangent of the elevation under which the eye sees it: height
    /// above the eye over ground range, finite, without the drop of the lunoid. Lambert's law ignores it.
    pub fn at<S: Real>(&self, along: S, across: S, sight: S) -> S {
        let sun = [self.along, self.across, self.up, one_over(self.albedo)].map(S::from_f64);
        reflected(self.photometry, sun, [along, across], sight)
    }
}

/// What ground of slopes `along` and `across` sends to an eye that sees it under `sight`; the sun along, across and up times
/// albedo, and 1 / albedo. Of one place, or of several side by side.
#[inline(always)]
fn reflected<T: Number>(law: Photometry, sun: [T; 4], [along, across]: [T; 2], sight: T) -> T {
    lit(law, sun, lambert(sun, [along, across]), [along, across], sight)
}

/// The same where Lambert's law gives `lambert`.
#[inline(always)]
fn lit<T: Number>(law: Photometry, sun: [T; 4], lambert: T, [along, across]: [T; 2], sight: T) -> T {
    let [sun_along, _, sun_up, unit] = sun;
    let one = along.like(1.0);
    let slant = (one + sight * sight).root();
    let mu = (along - sight) / (normal([along, across]) * slant);
    let cos_g = -(sun_along + sun_up * sight) * unit / slant;
    lambert * law.factor(lambert * unit, mu, cos_g)
}

/// `n.s` times albedo: Lambert's law.
#[inline(always)]
fn lambert<T: Number>([sun_along, sun_across, sun_up, _]: [T; 4], [along, across]: [T; 2]) -> T {
    (sun_up - along * sun_along - across * sun_across) / normal([along, across])
}

/// Length of the normal `(-along, -across, 1)`.
#[inline(always)]
fn normal<T: Number>([along, across]: [T; 2]) -> T {
    (along.like(1.0) + along * along + across * across).root()
}

/// Nothing is lit at albedo 0: there the scale is of no account, but must be finite.
fn one_over(albedo: f64) -> f64 {
    if albedo > 0.0 { 1.0 / albedo } else { 0.0 }
}

/// Light of a group of sweeps, lane n being sweep n: [`SweepLight::at`] for all lanes, to the bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupLight<S> {
    /// The sun along, across and up times albedo, and 1 / albedo.
    sun: [Lanes<S>; 4],
    photometry: Photometry,
}

impl<S: Real> GroupLight<S> {
    /// Light of a group; the law is that of the first lane.
    pub fn new(light: &[SweepLight; LANES]) -> Self {
        let lanes = |part: fn(&SweepLight) -> f64| Lanes::from_fn(|lane| S::from_f64(part(&light[lane])));
        Self {
            sun: [lanes(|l| l.along), lanes(|l| l.across), lanes(|l| l.up), lanes(|l| one_over(l.albedo))],
            photometry: light[0].photometry,
        }
    }

    /// [`SweepLight::at`] in every lane.
    #[inline(always)]
    pub fn reflectivity(&self, along: Lanes<S>, across: Lanes<S>, sight: Lanes<S>) -> Lanes<S> {
        let one = |lanes: &Lanes<S>| Places(lanes.0);
        let (sun, slopes) = (self.sun.each_ref().map(one), [one(&along), one(&across)]);
        Lanes(match self.photometry {
            Photometry::Lambert => lambert(sun, slopes).0,
            law => reflected(law, sun, slopes, one(&sight)).0,
        })
    }

    /// The same where a circuit gives `lambert`, `n.s` times albedo.
    #[inline(always)]
    pub fn beyond_lambert(
        &self,
        lambert: Lanes<S>,
        [along, across]: [Lanes<S>; 2],
        sight: Lanes<S>,
    ) -> Lanes<S> {
        let one = |lanes: &Lanes<S>| Places(lanes.0);
        match self.photometry {
            Photometry::Lambert => lambert,
            law => {
                let (sun, slopes) = (self.sun.each_ref().map(one), [one(&along), one(&across)]);
                Lanes(lit(law, sun, one(&lambert), slopes, one(&sight)).0)
            }
        }
    }

    /// The same along a sweep whose samples lie at `ranges` (m), from height (m) and the slopes along and across, two samples at
    /// a time.
    #[inline(always)]
    pub fn reflect(&self, ground: [&[Lanes<S>]; 3], ranges: &[f64], out: &mut [Lanes<S>]) {
        let sun = self.sun.each_ref().map(|lanes| side_by_side([lanes, lanes]));
        let [height, along, across] = ground;
        let signals = along.chunks(2).zip(across.chunks(2)).zip(out.chunks_mut(2));
        // The law is asked once, not once a sample; Lambert's needs no sight.
        match self.photometry {
            Photometry::Lambert => {
                for ((along, across), out) in signals {
                    put(lambert(sun, [two(along), two(across)]), out);
                }
            }
            law => {
                for (((along, across), out), (height, ranges)) in
                    signals.zip(height.chunks(2).zip(ranges.chunks(2)))
                {
                    let near = ends(ranges).map(|range| Lanes::splat(S::from_f64(1.0 / range)));
                    let sight = two(height) * side_by_side(near.each_ref());
                    put(reflected(law, sun, [two(along), two(across)], sight), out);
                }
            }
        }
    }
}

/// First and last of one or two: the last sample of an odd number stands beside itself.
#[inline(always)]
fn ends<T: Copy>(some: &[T]) -> [T; 2] {
    [some[0], some[some.len() - 1]]
}

/// One or two samples.
#[inline(always)]
fn two<S: Real>(samples: &[Lanes<S>]) -> Places<S, { 2 * LANES }> {
    side_by_side([&samples[0], &samples[samples.len() - 1]])
}

#[inline(always)]
fn side_by_side<S: Real>([first, second]: [&Lanes<S>; 2]) -> Places<S, { 2 * LANES }> {
    let mut places = [S::ZERO; 2 * LANES];
    for lane in 0..LANES {
        (places[lane], places[LANES + lane]) = (first.0[lane], second.0[lane]);
    }
    Places(places)
}

/// Back into one or two samples.
#[inline(always)]
fn put<S: Real>(places: Places<S, { 2 * LANES }>, samples: &mut [Lanes<S>]) {
    for (sample, places) in samples.iter_mut().zip(places.0.as_chunks().0) {
        sample.0 = *places;
    }
}

#[cfg(test)]
mod tests {
    use super::{GroupLight, Sun, SweepLight};
    use crate::Photometry;
    use proptest::prelude::{Strategy, prop_assert, prop_assert_eq, proptest};
    use quantities::{radians, sin_cos};
    use signal::{Lanes, Real};

    const LAWS: [Photometry; 4] = [
        Photometry::Lambert,
        Photometry::LommelSeeliger,
        Photometry::LunarLambert,
        Photometry::Specular { strength: 0.5, exponent: 12 },
    ];

    #[test]
    fn check_table_23_3() {
        let rows = [
            ([0.0, 0.0], 30.0, 77.0, 0.5),
            ([0.1, -0.2], 30.0, 40.0, 0.5318584010756228),
            ([0.5, 0.25], 5.0, 0.0, 0.0),
            ([-0.03, 0.04], 2.0, 290.0, 0.08261545308301832),
        ];
        for (slopes, elevation, azimuth, expected) in rows {
            let sun = Sun { azimuth: radians(azimuth), elevation: radians(elevation) };
            assert!((sun.reflectivity(slopes) - expected).abs() < 1e-14, "{slopes:?}");
            assert_eq!(sun.shade(slopes, [0.0, 0.0, 1.0], Photometry::Lambert), sun.reflectivity(slopes));
        }
    }

    /// Down-sun the powder is brightest, up-sun darkest; the highlight is the other way round.
    #[test]
    fn brightness_depends_on_the_side_of_the_sun() {
        let sun = Sun { azimuth: 0.0, elevation: radians(10.0) };
        let (sin, cos) = sin_cos(radians(10.0));
        let seen = |towards: f64, law| sun.shade([0.0; 2], [towards * cos, 0.0, sin], law);
        // An eye on the sun's side of the place has phase angle 0; one beyond it 160 degrees, in the mirrored sun.
        assert!(seen(1.0, Photometry::LunarLambert) > 5.0 * seen(-1.0, Photometry::LunarLambert));
        // The root of a difference: 1e-16 of cos g is 1e-8 of g.
        assert!((seen(1.0, Photometry::LunarLambert) - 1.0).abs() < 1e-7);
        let bright = Photometry::Specular { strength: 2.0, exponent: 30 };
        assert!((seen(-1.0, bright) - 3.0 * sin).abs() < 1e-13);
        assert!((seen(1.0, bright) - sin) < 1e-3);
    }

    fn anywhere() -> impl Strategy<Value = ([f64; 4], [f64; 3], f64)> {
        let angles = [0.0..6.3f64, 0.001..1.57, 0.0..6.3, -1.5..1.5].map(Strategy::boxed);
        (angles, proptest::array::uniform3(-2.0..2.0f64), 0.05..=1.0f64)
    }

    /// The sweep's axes and the terrain's tell the same light.
    fn in_terrain_axes(
        [azimuth, elevation, heading, depression]: [f64; 4],
        [hx, hy]: [f64; 2],
        law: Photometry,
    ) -> f64 {
        let ((sin, cos), (down, level)) = (sin_cos(heading), sin_cos(depression));
        Sun { azimuth, elevation }.shade([hx, hy], [-cos * level, -sin * level, down], law)
    }

    proptest! {
        #[test]
        fn sweep_axes_and_terrain_axes_agree((angles, [hx, hy, _], albedo) in anywhere()) {
            let (sin, cos) = sin_cos(angles[2]);
            let sight = -libm::tan(angles[3]);
            let sun = Sun { azimuth: angles[0], elevation: angles[1] };
            let (along, across) = (hx * cos + hy * sin, hy * cos - hx * sin);
            for law in LAWS {
                let light = SweepLight::new(&sun, albedo, law, [cos, sin]);
                let (found, expected) = (light.at(along, across, sight), in_terrain_axes(angles, [hx, hy], law));
                // Half the phase angle is the root of a difference: 1e-8 near full phase.
                prop_assert!((found.max(0.0) - albedo * expected).abs() < 1e-6, "{law:?}: {found} {expected}");
            }
        }

        #[test]
        fn a_group_is_its_sweeps((angles, slopes, albedo) in anywhere()) {
            let sun = Sun { azimuth: angles[0], elevation: angles[1] };
            for law in LAWS {
                let light = std::array::from_fn(|lane| {
                    let (sin, cos) = sin_cos(angles[2] + 0.01 * lane as f64);
                    SweepLight::new(&sun, albedo, law, [cos, sin])
                });
                prop_assert_eq!(of_group::<f64>(&light, slopes), of_sweeps::<f64>(&light, slopes));
                prop_assert_eq!(of_group::<f32>(&light, slopes), of_sweeps::<f32>(&light, slopes));
            }
        }
    }

    proptest! {
        /// Two samples at a time, an odd one last: what each is alone.
        #[test]
        fn a_run_is_its_samples((angles, slopes, albedo) in anywhere(), samples in 0..6usize) {
            let sun = Sun { azimuth: angles[0], elevation: angles[1] };
            let ranges: Vec<f64> = (1..=samples).map(|k| 7.3 * k as f64).collect();
            let signal = |slope: f64| -> Vec<Lanes<f32>> {
                let value = |k: usize, lane: usize| (slope * (1.0 + 0.1 * k as f64) - 0.03 * lane as f64) as f32;
                (0..samples).map(|k| Lanes::from_fn(|lane| value(k, lane))).collect()
            };
            let [height, along, across] = slopes.map(signal);
            for law in LAWS {
                let light = GroupLight::new(&[SweepLight::new(&sun, albedo, law, [0.8, 0.6]); 8]);
                let mut run = vec![Lanes::default(); samples];
                light.reflect([&height, &along, &across], &ranges, &mut run);
                for k in 0..samples {
                    let sight = height[k] * ((1.0 / ranges[k]) as f32);
                    prop_assert_eq!(run[k], light.reflectivity(along[k], across[k], sight), "{:?}", law);
                }
            }
        }
    }

    /// What a circuit of ideal parts gives is the law itself.
    #[test]
    fn light_beyond_lambert_is_that_of_the_law() {
        let sun = Sun { azimuth: 0.4, elevation: 0.3 };
        let [along, across, sight] = [0.2, -0.1, -0.05].map(Lanes::<f64>::splat);
        let light = |law| GroupLight::new(&[SweepLight::new(&sun, 0.7, law, [0.8, 0.6]); 8]);
        let lambert = light(Photometry::Lambert).reflectivity(along, across, sight);
        for law in LAWS {
            let found = light(law).beyond_lambert(lambert, [along, across], sight);
            assert_eq!(found, light(law).reflectivity(along, across, sight), "{law:?}");
        }
    }

    fn of_group<S: Real>(light: &[SweepLight; 8], slopes: [f64; 3]) -> Lanes<S> {
        let [along, across, sight] = slopes.map(|slope| Lanes::splat(S::from_f64(slope)));
        GroupLight::new(light).reflectivity(along, across, sight)
    }

    fn of_sweeps<S: Real>(light: &[SweepLight; 8], slopes: [f64; 3]) -> Lanes<S> {
        let [along, across, sight] = slopes.map(S::from_f64);
        Lanes(light.map(|light| light.at(along, across, sight)))
    }

    #[test]
    fn nothing_is_lit_at_albedo_zero() {
        let sun = Sun { azimuth: 0.3, elevation: 0.2 };
        for law in LAWS {
            let light = SweepLight::new(&sun, 0.0, law, [1.0, 0.0]);
            assert_eq!(light.at(0.1, -0.2, -0.01), 0.0);
            assert_eq!(light.at(0.0f32, 0.0, -1e9), 0.0);
        }
    }
}
