//! One folded ramp between two limit stops (sections 6.2, 6.4, 6.5).

/// A triangular sweep voltage.
#[derive(Debug, Clone, PartialEq)]
pub struct Ramp {
    /// Where the sweep begins, in regions from the origin of the level.
    place: f64,
    /// Regions a metre of ground range, with the sign of the way.
    speed: f64,
    /// Polarity flip-flop: +1 where the ramp runs with the ground, -1 where it is mirrored.
    pub polarity: f64,
    /// Region that the sweep is in, along this axis.
    pub region: i64,
    /// +1 or -1: the way the sweep goes over the ground; +1 for a sweep that stands.
    pub heading: i64,
    /// Whether it goes towards 1.
    pub rising: bool,
}

impl Ramp {
    /// The start rule of 6.5 for a foot at `place` (in regions) and a sweep of direction cosine `cosine`.
    pub fn at_start(place: f64, cosine: f64, region_size: f64) -> Self {
        let mut region = place.floor() as i64;
        let on_boundary = place == place.floor();
        if on_boundary && cosine < 0.0 {
            region -= 1;
        }
        let even = region.rem_euclid(2) == 0;
        let northward = cosine >= 0.0;
        Self {
            place,
            speed: cosine / region_size,
            polarity: if even { 1.0 } else { -1.0 },
            region,
            heading: if northward { 1 } else { -1 },
            rising: northward == even,
        }
    }

    /// Whether it moves at all.
    pub fn moves(&self) -> bool {
        self.speed != 0.0
    }

    /// Voltage at ground range `range` (m) within the present region, 0..=1.
    pub fn value(&self, range: f64) -> f64 {
        let u = (self.place - self.region as f64) + self.speed * range;
        if self.polarity > 0.0 { u } else { 1.0 - u }
    }

    /// Ground range of the stop ahead (m); a ramp that stands never arrives.
    pub fn stop(&self) -> f64 {
        if !self.moves() {
            return f64::INFINITY;
        }
        let boundary = if self.heading > 0 { self.region + 1 } else { self.region };
        (boundary as f64 - self.place) / self.speed
    }

    /// The stop ahead is met: turn back, flip, count the region. Returns whether it was the stop at 1.
    pub fn fold(&mut self) -> bool {
        let at_one = self.rising;
        self.rising = !self.rising;
        self.polarity = -self.polarity;
        self.region += self.heading;
        at_one
    }
}
