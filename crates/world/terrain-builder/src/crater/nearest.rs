//! The crater of the hybrid machine that is nearest to a crater of the builder.

use features::{Crater as Machine, Shape};

use super::Crater;

/// Places outside the wall's foot at which two profiles are compared.
const PLACES: usize = 512;
/// Outer radii that are tried in each round, and rounds: each round is 8 times as fine.
const TRIED: usize = 16;
const ROUNDS: usize = 4;
/// How many times finer the largest difference is measured than the fit is.
const FINER: usize = 16;
/// Cuts of the range of rim heights by a third.
const HALVINGS: usize = 40;

/// A crater of type 2 and how far it is from the crater it stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Crater of type 2 with the same bowl.
    pub crater: Machine,
    /// Largest difference of height between the two, anywhere (m).
    pub largest_difference: f64,
}

/// Why a crater has no counterpart among the hybrid machine's craters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, thiserror::Error)]
pub enum NoNearest {
    /// An oblique impact: the hybrid machine knows symmetric craters only.
    #[error(
        "an oblique impact: the feature generator draws symmetric craters only; set `impact_elevation_deg = 90`"
    )]
    Oblique,
    /// No depth: a bowl of type 2 has a foot above radius 0.
    #[error("a crater without depth: a crater of type 2 has a bowl; set `depth_percent` above 0")]
    Flat,
    /// The crater reaches over the border of the landscape.
    #[error(
        "a crater over the border of the landscape: the feature generator draws craters that lie wholly inside"
    )]
    Border,
}

impl Crater {
    /// The crater of type 2 whose largest difference of height is least. Bowls agree exactly up to the foot of the wall, at
    /// `R sqrt(D / (D + W))`; the rim's height and outer foot are fitted.
    ///
    /// # Errors
    /// If the impact is oblique, or there is no depth.
    pub fn nearest(&self) -> Result<Nearest, NoNearest> {
        if self.oblique.is_some() {
            return Err(NoNearest::Oblique);
        }
        if self.depth <= 0.0 {
            return Err(NoNearest::Flat);
        }
        let foot = self.form.radius * (self.depth / (self.depth + self.wall)).sqrt();
        let wall = Wall::of(self, foot, PLACES);
        let (mut low, mut high) = (self.form.radius, self.form.radius * self.form.extent);
        let mut best = Fit { outer: high, rim: 0.0, difference: f64::INFINITY };
        for _ in 0..ROUNDS {
            let step = (high - low) / TRIED as f64;
            let tried = (1..=TRIED).map(|number| wall.fitted(low + step * number as f64));
            best = tried.fold(best, |best, fit| if fit.difference < best.difference { fit } else { best });
            (low, high) = ((best.outer - step).max(self.form.radius), best.outer + step);
        }
        let shape = Shape::RimmedBowl { r1: foot, r2: best.outer };
        let crater = Machine::new(self.form.centre, shape, self.depth, best.rim);
        let crater = crater.expect("radii ascend and heights are in range, as those of the crater are");
        let measured = Wall::of(self, foot, FINER * PLACES).difference(best.outer, best.rim);
        Ok(Nearest { crater, largest_difference: measured })
    }
}

/// Heights of the wall outside the foot.
struct Wall {
    foot: f64,
    places: Vec<[f64; 2]>,
    highest: f64,
}

#[derive(Clone, Copy)]
struct Fit {
    outer: f64,
    rim: f64,
    difference: f64,
}

impl Wall {
    /// Places are even between foot, crest and extent, so that the crest is one of them.
    fn of(crater: &Crater, foot: f64, count: usize) -> Self {
        let (radius, extent) = (crater.form.radius, crater.reach());
        let between =
            |low: f64, high: f64| (0..count).map(move |k| low + (high - low) * k as f64 / count as f64);
        let places = between(foot, radius).chain(between(radius, extent));
        let height = |rho: f64| [rho, crater.profile(rho / radius, crater.wall)];
        Self { foot, places: places.map(height).collect(), highest: crater.wall }
    }

    /// The best rim for an outer radius: the largest difference is a convex function of its height.
    fn fitted(&self, outer: f64) -> Fit {
        let (mut low, mut high) = (0.0, 2.0 * self.highest);
        for _ in 0..HALVINGS {
            let third = (high - low) / 3.0;
            if self.difference(outer, low + third) <= self.difference(outer, high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        let rim = 0.5 * (low + high);
        Fit { outer, rim, difference: self.difference(outer, rim) }
    }

    fn difference(&self, outer: f64, rim: f64) -> f64 {
        let apart = |[rho, height]: &[f64; 2]| {
            let place = (2.0 * rho - self.foot - outer) / (outer - self.foot);
            let ring = if *rho < outer { rim * (1.0 - place * place) } else { 0.0 };
            (height - ring).abs()
        };
        self.places.iter().map(apart).fold(0.0, f64::max)
    }
}
