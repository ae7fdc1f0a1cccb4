//! Repeatable random numbers of a population, each addressed by its purpose.

use quantities::unit_interval;

use super::{Kind, Population};

/// What a draw decides. The numbers never change: populations are named by their seed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Purpose {
    Size = 0,
    North = 1,
    East = 2,
    Type = 3,
    Depth = 4,
    Floor = 5,
    Group = 6,
    Along = 7,
    Across = 8,
    Primary = 9,
    Azimuth = 10,
    Distance = 11,
    Form = 12,
}

/// All draws of one crater or one group of a population.
pub(super) struct Draw {
    seed: u64,
    kind: u64,
    number: u64,
}

impl Draw {
    pub fn new(population: &Population, number: u64) -> Self {
        let kind = match population.kind {
            Kind::Fresh => 1,
            Kind::Degraded => 2,
            Kind::FlatFloored => 3,
            Kind::Secondaries(_) => 4,
        };
        Self { seed: population.seed, kind, number }
    }

    /// Returns a number in `[0, 1)`, always the same for one purpose.
    pub fn unit(&self, purpose: Purpose) -> f64 {
        self.again(purpose, 0)
    }

    /// Another, for the attempt of a number.
    pub fn again(&self, purpose: Purpose, attempt: u64) -> f64 {
        unit_interval(self.seed, &[self.kind, self.number, purpose as u64, attempt])
    }

    /// Returns a number from `low` up to `high`, spread evenly.
    pub fn between(&self, purpose: Purpose, low: f64, high: f64) -> f64 {
        low + self.unit(purpose) * (high - low)
    }
}
