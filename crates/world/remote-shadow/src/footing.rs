//! How bodies stand under a sun: found once a sun and a body, before it is drawn first (section 12).

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use landscape::Sun;
use solids::Body;

use crate::{Outlines, ShadowBank};

/// A body under a sun; what nobody asks for is not there.
#[derive(Debug, Default)]
struct Footing {
    /// Whether its foot point is in the remote shadow of the ground.
    dark: OnceLock<bool>,
    shadow: OnceLock<Box<CastShadow>>,
}

/// The shadow that a body casts.
#[derive(Debug)]
struct CastShadow {
    /// Centre (north, east; m) and radius (m) of a circle around it.
    around: Circle,
    /// Not there before a sweep can meet it.
    outline: OnceLock<Outlines>,
}

/// Centre (north, east; m) and radius (m).
pub type Circle = ([f64; 2], f64);

/// Footings under one sun, by the body's place in the list of the mission.
type Shelf = Arc<[Footing]>;

/// Footings of all bodies of a mission under the last few suns.
#[derive(Debug, Default)]
pub struct Footings(Mutex<Vec<(Sun, Shelf)>>);

/// Suns that are remembered.
const SUNS: usize = 3;

/// How the bodies of a mission stand under one sun.
#[derive(Debug)]
pub struct UnderSun<'a> {
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
    /// Whether the foot point of body `number` is in the remote shadow of the ground.
    pub fn is_dark(&self, number: u32, body: &Body) -> bool {
        let dark = || self.bank.is_dark(&self.sun, [body.foot.x, body.foot.y]);
        *self.footings[number as usize].dark.get_or_init(dark)
    }

    /// Outline of the shadow that body `number` casts, if `meets` has it for the circle around it.
    pub fn shadow(&self, number: u32, body: &Body, meets: impl Fn(Circle) -> bool) -> Option<&Outlines> {
        let cast = || self.bank.cast_by_body(body, &self.sun);
        let shadow = self.footings[number as usize].shadow.get_or_init(|| {
            let outline = cast();
            let around = circle_around(outline.corners().iter());
            let outline = if meets(around) { OnceLock::from(outline) } else { OnceLock::new() };
            Box::new(CastShadow { around, outline })
        });
        meets(shadow.around).then(|| shadow.outline.get_or_init(cast))
    }
}

/// Centre and radius of a circle around an outline; it may well be smaller.
fn circle_around(corners: impl Iterator<Item = [f64; 2]>) -> Circle {
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
    use super::{Footings, circle_around};
    use crate::{Resolution, ShadowBank};
    use glam::{DMat3, DVec3};
    use landscape::{Bank, Landscape, Level, Sun};
    use proptest::prelude::{prop_assert, proptest};
    use solids::{Body, Kind, Solid};
    use std::sync::Arc;

    proptest! {
        #[test]
        fn the_circle_holds_the_outline(
            corners in proptest::collection::vec(proptest::array::uniform2(-1e4..1e4f64), 3..20),
        ) {
            let ([north, east], radius) = circle_around(corners.iter().copied());
            for corner in corners {
                let way = [corner[0] - north, corner[1] - east];
                prop_assert!((way[0] * way[0] + way[1] * way[1]).sqrt() <= radius + 1e-9, "{corner:?}");
            }
        }
    }

    /// A body is asked for before and after a sweep can meet its shadow.
    #[test]
    fn a_shadow_that_no_sweep_meets_is_found_when_one_does() {
        let level = Level::new(40.0, [0.0; 2], [3, 3], vec![[0.0; 9]; 9]).unwrap();
        let landscape = Landscape::new(Bank::new("flat", vec![level], None).unwrap(), 1.0);
        let bank = ShadowBank::new(Arc::new(landscape), Resolution { finest: 0.5, angle: 1e-3 });
        let solid = Solid::boxed(DVec3::new(-1.0, -0.5, 0.0), DVec3::new(1.0, 0.5, 2.0), 0.5).unwrap();
        let foot = DVec3::new(40.0, 40.0, 0.0);
        let body = Body::place(0, Kind::Rock, &Arc::new(solid), foot, &DMat3::IDENTITY, 1.0);
        let sun = Sun { azimuth: 0.3, elevation: 0.4 };
        let (footings, expected) = (Footings::default(), bank.cast_by_body(&body, &sun));
        assert!(!expected.is_empty());
        let under_sun = footings.under(sun, 1, &bank);
        for meets in [false, true, false, true] {
            assert_eq!(under_sun.shadow(0, &body, |_| meets), meets.then_some(&expected));
        }
        let around = circle_around(expected.corners().iter());
        assert!(under_sun.shadow(0, &body, |circle| circle == around).is_some());
    }
}
