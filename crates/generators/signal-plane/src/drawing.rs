//! Instants at which the signals of a picture are evaluated, where they are more than the steps of the accumulators.

use display_projection_processor::Processor;
use polyhedron_generator::NearTable;
use scenario::Laws;
use signal::Real;
use sweep_generator::RangeTable;

/// Samples of a picture that is drawn straight from one to the next.
#[derive(Debug, Clone)]
pub struct Drawing<S> {
    /// Samples a step of the accumulators: 1 and more.
    pub instants: u32,
    /// Ground range of each.
    pub table: RangeTable,
    /// Inverse range of each (1/m).
    pub near: NearTable,
    /// The ideal projection processor on them.
    pub processor: Processor<S>,
}

impl<S: Real> Drawing<S> {
    /// `instants` samples a step of the sweep of `clock`, under these laws.
    pub fn new(clock: &RangeTable, instants: u32, laws: &Laws) -> Self {
        let table = clock.divided(instants);
        Self {
            instants,
            near: NearTable::new(table.ranges().iter().map(|range| (1.0 / range) as f32)),
            processor: Processor::new(laws.occlusion, laws.curvature, table.ranges()),
            table,
        }
    }
}
