//! Light of the features: what VS1 lays on the terrain, at the samples and at the kinks (sections 10, 14).

use std::array;

use fearless_simd::{Level, dispatch};
use feature_generator::FeatureProfile;
use landscape::{GroupLight, SweepLight};
use mixing_unit::Kink;
use scenario::FeatureLight;
use signal::{LANES, Lanes, Real};
use terrain_generator::Profile;

/// Features of a group as the mixing unit takes them.
#[derive(Debug, Clone, Default)]
pub struct Lit<S> {
    /// Reflectivity of the surface that features make, with its sign; 0 where there is none.
    pub reflectivity: Vec<Lanes<S>>,
    /// Kinks, lane by lane.
    pub kinks: [Vec<Kink<S>>; LANES],
}

/// The sun on the features of a group.
pub(crate) struct Lamp<'a> {
    pub law: FeatureLight,
    pub light: &'a [SweepLight; LANES],
    pub ranges: &'a [f64],
}

/// Terrain between two samples.
struct TerrainBetween<S> {
    height: S,
    slopes: [S; 2],
}

impl Lamp<'_> {
    /// Lights the features of a group into `out`; `lit` is 1 where they add to the surface.
    pub fn run<S: Real>(
        &self,
        terrain: &Profile<S>,
        features: &FeatureProfile<S>,
        lit: &[Lanes<S>],
        out: &mut Lit<S>,
    ) {
        dispatch!(Level::new(), _ => self.light_samples(terrain, features, lit, &mut out.reflectivity));
        for (lane, kinks) in out.kinks.iter_mut().enumerate() {
            kinks.clear();
            let light = GroupLight::new(&[self.light[lane]; LANES]);
            for some in features.kinks[lane].chunks(LANES) {
                self.light_kinks(&light, lane, terrain, some, kinks);
            }
        }
    }

    #[inline(always)]
    fn light_samples<S: Real>(
        &self,
        terrain: &Profile<S>,
        features: &FeatureProfile<S>,
        where_lit: &[Lanes<S>],
        out: &mut Vec<Lanes<S>>,
    ) {
        out.clear();
        out.resize(self.ranges.len(), Lanes::default());
        let light = GroupLight::new(self.light);
        let nothing = Lanes::default();
        for (sample, lit) in out.iter_mut().enumerate() {
            if where_lit[sample] == nothing {
                continue;
            }
            let (mut along, mut across) = (features.along[sample], features.across[sample]);
            if self.law == FeatureLight::Combined {
                along = along + terrain.along[sample];
                across = across + terrain.across[sample];
            }
            let range = Lanes::splat(S::from_f64(self.ranges[sample]));
            let sight = (terrain.height[sample] + features.height[sample]) / range;
            *lit = light.reflectivity(along, across, sight) * where_lit[sample];
        }
    }

    /// Up to [`LANES`] kinks of one sweep side by side; `light` is that of the sweep in every lane.
    fn light_kinks<S: Real>(
        &self,
        light: &GroupLight<S>,
        lane: usize,
        terrain: &Profile<S>,
        kinks: &[feature_generator::Kink<S>],
        out: &mut Vec<Kink<S>>,
    ) {
        // Places beyond the last kink repeat it.
        let kink = |k: usize| &kinks[k.min(kinks.len() - 1)];
        let ground: [TerrainBetween<S>; LANES] =
            array::from_fn(|k| self.ground(terrain, lane, kink(k).sample, kink(k).share));
        let height = Lanes::from_fn(|k| ground[k].height + kink(k).height);
        let sight = height / Lanes::from_fn(|k| S::from_f64(kink(k).range));
        let lit = |along: Lanes<S>, across: Lanes<S>| light.reflectivity(along, across, sight);
        let terrain = [0, 1].map(|axis| Lanes::from_fn(|k| ground[k].slopes[axis]));
        let surface = |slope: fn(&feature_generator::Kink<S>) -> &[S; 2]| {
            let [along, across] = [0, 1].map(|axis| Lanes::from_fn(|k| slope(kink(k))[axis]));
            match self.law {
                FeatureLight::AsReported => lit(along, across),
                FeatureLight::Combined => lit(along + terrain[0], across + terrain[1]),
            }
        };
        let feature = [surface(|kink| &kink.before), surface(|kink| &kink.after)];
        let terrain = lit(terrain[0], terrain[1]);
        out.extend(kinks.iter().enumerate().map(|(k, kink)| Kink {
            sample: kink.sample,
            share: kink.share,
            height: height[k],
            feature: feature.map(|light| light[k]),
            terrain: terrain[k],
            present: kink.present,
        }));
    }

    /// The terrain at a part of the step that ends at `sample`: the cubic of its heights and slopes.
    fn ground<S: Real>(&self, terrain: &Profile<S>, lane: usize, sample: usize, u: S) -> TerrainBetween<S> {
        let [near, far] = [sample - 1, sample];
        let step = S::from_f64(self.ranges[far] - self.ranges[near]);
        let (from, to) = (terrain.height[near][lane], terrain.height[far][lane]);
        let rate = [near, far].map(|k| terrain.along[k][lane] * step);
        let chord = to - from;
        let [two, three] = [2.0, 3.0].map(S::from_f64);
        // h(u) = from + rate0 u + c u^2 + d u^3 with the end's height and rate.
        let (c, d) = (three * chord - two * rate[0] - rate[1], rate[0] + rate[1] - two * chord);
        let height = from + u * (rate[0] + u * (c + u * d));
        let along = (rate[0] + u * (two * c + u * three * d)) / step;
        let across =
            terrain.across[near][lane] + u * (terrain.across[far][lane] - terrain.across[near][lane]);
        TerrainBetween { height, slopes: [along, across] }
    }
}
