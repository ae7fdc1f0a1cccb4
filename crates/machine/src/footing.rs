//! How bodies stand under a sun: found once a sun and a body, before it is drawn first (section 12).

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use landscape::Sun;
use remote_shadow::{Outlines, ShadowBank};
use solids::Body;

/// A body under a sun; what nobody asks for is not there.
#[derive(Debug, Default)]
struct Footing {
    /// Whether its foot point is in the remote shadow of the ground.
    dark: OnceLock<bool>,
    shadow: OnceLock<Box<CastShadow>>,
}

/// The shadow that a body casts.
#[derive(Debug)]
pub(crate) struct CastShadow {
    pub outline: Outlines,
    /// Centre (north, east; m) and radius (m) of a circle around it.
    pub around: ([f64; 2], f64),
}

/// Footings under one sun, by the body's place in the list of the mission.
type Shelf = Arc<[Footing]>;

/// Footings of all bodies of a mission under the last few suns.
#[derive(Debug, Default)]
pub(crate) struct Footings(Mutex<Vec<(Sun, Shelf)>>);

/// Suns that are remembered.
const SUNS: usize = 3;

/// How the bodies of a mission stand under one sun.
pub(crate) struct UnderSun<'a> {
    sun: Sun,
    bank: &'a ShadowBank,
    footings: Shelf,
}

impl Footings {
    /// Footings of `bodies` bodies under `sun`.
    pub fn under<'a>(&self, sun: Sun, bodies: usize, bank: &'a ShadowBank) -> UnderSun<'a> {
        let mut suns = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let known = suns.iter().find(|(known, _)| *known == sun).map(|(_, footings)| Arc::clone(footings));
        let footings = known.unwrap_or_else(|| {
            let footings: Shelf = (0..bodies).map(|_| Footing::default()).collect();
            suns.truncate(SUNS - 1);
            suns.insert(0, (sun, Arc::clone(&footings)));
            footings
        });
        UnderSun { sun, bank, footings }
    }
}

impl UnderSun<'_> {
    /// Whether the foot point of body number `index` is in the remote shadow of the ground.
    pub fn is_dark(&self, index: usize, body: &Body) -> bool {
        let dark = || self.bank.is_dark(&self.sun, [body.foot.x, body.foot.y]);
        *self.footings[index].dark.get_or_init(dark)
    }

    /// The shadow that body number `index` casts.
    pub fn shadow(&self, index: usize, body: &Body) -> &CastShadow {
        self.footings[index].shadow.get_or_init(|| {
            let outline = self.bank.cast_by_body(body, &self.sun);
            Box::new(CastShadow { around: circle_around(outline.corners()), outline })
        })
    }
}

/// Centre and radius of a circle around an outline; it may well be smaller.
fn circle_around(corners: &[[f64; 2]]) -> ([f64; 2], f64) {
    let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for corner in corners {
        for axis in 0..2 {
            low[axis] = low[axis].min(corner[axis]);
            high[axis] = high[axis].max(corner[axis]);
        }
    }
    let [north, east] = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
    ([0, 1].map(|axis| 0.5 * (low[axis] + high[axis])), (north * north + east * east).sqrt())
}

#[cfg(test)]
mod tests {
    use super::circle_around;
    use proptest::prelude::{prop_assert, proptest};

    proptest! {
        #[test]
        fn the_circle_holds_the_outline(
            corners in proptest::collection::vec(proptest::array::uniform2(-1e4..1e4f64), 3..20),
        ) {
            let ([north, east], radius) = circle_around(&corners);
            for corner in corners {
                let way = [corner[0] - north, corner[1] - east];
                prop_assert!((way[0] * way[0] + way[1] * way[1]).sqrt() <= radius + 1e-9, "{corner:?}");
            }
        }
    }
}
