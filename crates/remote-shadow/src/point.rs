//! Whether one point is in remote shadow.

use landscape::Sun;

use crate::bank::ShadowBank;
use crate::caster::Upstream;
use crate::ground::LitGround;

impl ShadowBank {
    /// Whether the ground at a place (north, east; m) is in the shadow of ground between it and `sun`; false where there
    /// is no ground. Looked for at the same places as the casters of tiles: a caster nearer than the finest spacing is
    /// not seen.
    pub fn is_dark(&self, sun: &Sun, place: [f64; 2]) -> bool {
        let lit = LitGround::new(self.ground(), sun, self.resolution().finest);
        let [p, q] = lit.axes.from_ground(place);
        // A top is looked for up to one step beside its lattice point: it must not lie beyond the place.
        let before = (q / lit.lattice).ceil() as i64 - 2;
        let (Some(own), true) = (lit.spot(p, q), lit.axes.cos > 0.0) else { return false };
        Upstream::new(lit, p, before).highest(None).is_some_and(|(highest, _)| highest > own.g)
    }
}
