//! How a sweep passes a circle on the ground: one text for one sweep and for eight side by side.

use signal::Number;

/// Half of what a sweep crosses of a circle about a centre that lies `side` beside it (m); 0 where it passes the circle by.
#[inline(always)]
pub(crate) fn half_chord<T: Number>(radius: f64, side: T) -> T {
    (side.like(radius * radius) - side * side).at_least(side.like(0.0)).root()
}

/// Where a sweep along the unit vector `[cos, sin]` passes a centre that lies north and east of the eye: the range, and the
/// distance of the centre to the right (m).
#[inline(always)]
pub(crate) fn foot<T: Number>([north, east]: [T; 2], [cos, sin]: [T; 2]) -> [T; 2] {
    [north * cos + east * sin, east * cos - north * sin]
}
