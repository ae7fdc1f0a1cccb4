//! How bodies stand under a sun: found once a sun and a body, before it is drawn first (section 12).

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use landscape::Sun;
use remote_shadow::{Segment, ShadowBank};
use solids::Body;

/// A body under a sun.
#[derive(Debug, Default)]
pub(crate) struct Footing {
    /// Whether its foot point is in the remote shadow of the ground.
    pub dark: bool,
    /// Outline of the shadow that it casts.
    pub shadow: Vec<Segment>,
}

/// Footings under one sun, by the body's place in the list of the mission.
type Shelf = Arc<[OnceLock<Footing>]>;

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
            let footings: Shelf = (0..bodies).map(|_| OnceLock::new()).collect();
            suns.truncate(SUNS - 1);
            suns.insert(0, (sun, Arc::clone(&footings)));
            footings
        });
        UnderSun { sun, bank, footings }
    }
}

impl UnderSun<'_> {
    /// How body number `index` stands.
    pub fn of(&self, index: usize, body: &Body) -> &Footing {
        self.footings[index].get_or_init(|| Footing {
            dark: self.bank.is_dark(&self.sun, [body.foot.x, body.foot.y]),
            shadow: self.bank.cast_by_body(body, &self.sun),
        })
    }
}
