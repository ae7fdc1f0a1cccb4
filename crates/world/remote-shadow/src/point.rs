//! Whether one point is in remote shadow.

use landscape::Sun;

use crate::bank::ShadowBank;
use crate::caster::Upstream;
use crate::ground::LitGround;
use crate::profile::Walk;

/// Places between the last lattice point before a place and the place itself.
const SPOTS: usize = 8;

impl ShadowBank {
    /// Whether the ground at a place (north, east; m) is in local shadow or in the shadow of ground between it and
    /// `sun`; false where there is no ground. Casters are those of a tile that begins just before the place.
    pub fn is_dark(&self, sun: &Sun, place: [f64; 2]) -> bool {
        let lit = LitGround::new(self.ground(), sun, self.resolution().finest);
        let [p, q] = lit.axes.to_sun_axes(place);
        if lit.axes.cos <= 0.0 || lit.spot(p, q).is_none() {
            return false;
        }
        let before = (q / lit.lattice).ceil() as i64 - 1;
        let start = before as f64 * lit.lattice;
        let upstream = Upstream::new(lit, p, before);
        let top = upstream.top(upstream.best(None)).unwrap_or(f64::NEG_INFINITY);
        let spacing = (q - start) / SPOTS as f64;
        let dark = Walk::intervals(lit, p, start, spacing, SPOTS, top);
        dark.last().is_some_and(|&[_, end]| end >= start + SPOTS as f64 * spacing)
    }
}
