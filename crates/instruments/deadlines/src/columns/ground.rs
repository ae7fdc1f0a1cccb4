//! How far the ground reaches that a pixel of the ideal picture shows.

use signal::Waveform;
use sweep_generator::RangeTable;

use super::four::{BEAM, BODIES, GATE, Seen};

/// Samples beyond a line's upper edge that still shape it: the beam's curve goes through its neighbours.
const NEIGHBOURS: usize = 2;

/// Sweeps of the ideal machine, and what bodies changed with the analog side alone ideal.
pub struct GroundReach<'a> {
    table: &'a RangeTable,
    /// Line of the beam by sample, of each sweep.
    beams: Vec<&'a [f64]>,
    /// Of both machines, by sweep: whether a body is seen, by line; remote shadow, by sample.
    bodies: [Vec<&'a [f64]>; 2],
    gates: [Vec<&'a [f64]>; 2],
}

impl<'a> GroundReach<'a> {
    /// From what was seen of all sweeps.
    pub fn new(table: &'a RangeTable, seen: &'a Seen) -> Self {
        let of = |waveforms: &'a [Waveform], name: &str| -> Vec<&'a [f64]> {
            let ours = waveforms.iter().filter(|waveform| waveform.signal.name == name);
            ours.map(|waveform| waveform.values.as_slice()).collect()
        };
        let both = |name| [of(&seen.ideal, name), of(&seen.timing_alone, name)];
        Self { table, beams: of(&seen.ideal, BEAM), bodies: both(BODIES), gates: both(GATE) }
    }

    /// Cells of a sweep.
    pub fn cells(&self) -> usize {
        self.bodies[0].first().map_or(1, |cells| cells.len())
    }

    /// Ground range (m) up to which the profile of `sweep` decides what lies below the cell edge `top`: infinite where
    /// there is sky.
    pub fn reach(&self, sweep: u32, top: f64) -> f64 {
        let beam = self.beams[sweep as usize];
        let above = beam.partition_point(|&line| line > top);
        if above == beam.len() {
            return f64::INFINITY;
        }
        let ranges = self.table.ranges();
        ranges[(above + NEIGHBOURS).min(ranges.len() - 1)]
    }

    /// Whether bodies that are not ready, or their shadows, can show in `sweep`, its profile seen up to `reach` (m).
    pub fn lacks_bodies(&self, sweep: u32, reach: f64) -> bool {
        let differ = |[a, b]: &[Vec<&[f64]>; 2], end: usize| {
            let [a, b] = [a, b].map(|all| all[sweep as usize]);
            a.iter().zip(b).take(end).any(|(a, b)| a != b)
        };
        let samples = self.table.ranges().partition_point(|&range| range <= reach);
        differ(&self.bodies, usize::MAX) || differ(&self.gates, samples)
    }
}
