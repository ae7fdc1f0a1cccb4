//! Numbers as a variable of the program stores them.

use glam::DVec3;

/// How many bits a stored number has: 24 in a REAL variable, 53 otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Real {
    is_single: bool,
}

impl Real {
    pub fn new(is_single: bool) -> Self {
        Self { is_single }
    }

    /// A number after it was stored.
    pub fn of(self, number: f64) -> f64 {
        // REAL of the VAX has 24 bits, as f32 has; its range is never reached.
        if self.is_single { f64::from(number as f32) } else { number }
    }

    /// A vector after its components were stored.
    pub fn vector(self, vector: DVec3) -> DVec3 {
        DVec3::from_array(vector.to_array().map(|number| self.of(number)))
    }
}
