//! Light of the features: what VS1 lays on the terrain, at the samples and at the kinks (sections 10, 14).

use feature_generator::FeatureProfile;
use landscape::{GroupLight, SweepLight};
use mixing_unit::Kink;
use scenario::FeatureLight;
use signal::{LANES, Lanes, Real};
use terrain_generator::Profile;

/// Features of a group as the mixing unit takes them.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lit<S> {
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
struct Ground<S> {
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
        self.light_samples(terrain, features, lit, &mut out.reflectivity);
        for (lane, kinks) in out.kinks.iter_mut().enumerate() {
            kinks.clear();
            let lit = features.kinks[lane].iter().map(|kink| self.light_kink(lane, terrain, kink));
            kinks.extend(lit);
        }
    }

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

    fn light_kink<S: Real>(
        &self,
        lane: usize,
        terrain: &Profile<S>,
        kink: &feature_generator::Kink<S>,
    ) -> Kink<S> {
        let ground = self.ground(terrain, lane, kink.sample, kink.share);
        let height = ground.height + kink.height;
        let sight = height / S::from_f64(kink.range);
        let lit = |[along, across]: [S; 2]| self.light[lane].at(along, across, sight);
        let surface = |feature: [S; 2]| match self.law {
            FeatureLight::AsReported => lit(feature),
            FeatureLight::Combined => lit([feature[0] + ground.slopes[0], feature[1] + ground.slopes[1]]),
        };
        Kink {
            sample: kink.sample,
            share: kink.share,
            height,
            feature: [surface(kink.before), surface(kink.after)],
            terrain: lit(ground.slopes),
            present: kink.present,
        }
    }

    /// The terrain at a part of the step that ends at `sample`: the cubic of its heights and slopes.
    fn ground<S: Real>(&self, terrain: &Profile<S>, lane: usize, sample: usize, u: S) -> Ground<S> {
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
        Ground { height, slopes: [along, across] }
    }
}
