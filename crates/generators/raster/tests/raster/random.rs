//! Random numbers that are the same in every run.

/// Splitmix64, a sequence of a seed.
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// Uniform from 0 to below 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number from 0 to below `end`.
    pub fn below(&mut self, end: u32) -> u32 {
        (self.unit() * f64::from(end)) as u32
    }

    /// Corners (pixels) of a triangle over a square of `size` pixels: wide, small, below a pixel, a sliver, or with corners
    /// that meet sampling points.
    pub fn triangle(&mut self, size: f64) -> [[f64; 2]; 3] {
        let mut corner = || [self.between(-4.0, size + 4.0), self.between(-4.0, size + 4.0)];
        let (p, q, r) = (corner(), corner(), corner());
        let near =
            |share: f64| [p, q, r].map(|[x, y]| [p[0] + (x - p[0]) * share, p[1] + (y - p[1]) * share]);
        match self.below(6) {
            0 => [p, q, r],
            1 => near(6.0 / size),
            2 => near(0.7 / size),
            3 => {
                let along = self.unit();
                let beside = [0, 1].map(|axis| p[axis] + (q[axis] - p[axis]) * along);
                [p, q, beside.map(|at| at + self.between(-0.02, 0.02))]
            }
            4 => [p, q, r].map(|corner| corner.map(|at| (at * 32.0).round() / 32.0)),
            _ => [p, q, r].map(|corner| corner.map(|at| (at * 2.0).round() / 2.0)),
        }
    }
}
