//! When the video is blanked and let through again: the digital events of the synchronised method.

use serde::{Deserialize, Serialize};
use timing::EventHash;

use crate::gate::Gates;
use crate::insertion::{Method, converted};

/// Blanking edges of one picture, in their order; of the scan converter, which has no such edges, none.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Blanking {
    /// Edges: the video goes off, or on again.
    pub events: u64,
    /// [`EventHash`] of their ordered list, by step of the converters from the start of the picture, unit `blanking`,
    /// `off` or `on`, point of the sun, and line.
    pub events_blake3: String,
}

impl Blanking {
    /// Where `method` blanks each line under gates of `half_width` (tangent), one for each point of the sun.
    pub(crate) fn of(method: &Method, suns: &[Gates], half_width: f64) -> Self {
        let mut events = EventHash::new();
        if let Method::Synchronised { dac_bits } = *method {
            let steps = 1u64 << dac_bits;
            for (sun, gates) in (0u64..).zip(suns) {
                for (line, gate) in (0u64..).zip(&gates.lines) {
                    for stretch in converted(gate, half_width, dac_bits) {
                        for (share, what) in stretch.into_iter().zip(["off", "on"]) {
                            let step = (share * steps as f64).round() as u64;
                            events.push(line * steps + step, "blanking", what, &[sun, line]);
                        }
                    }
                }
            }
        }
        let (events, events_blake3) = events.finish();
        Self { events, events_blake3 }
    }
}

#[cfg(test)]
mod tests {
    use timing::EventHash;

    use super::Blanking;
    use crate::gate::{Gate, Gates};
    use crate::insertion::{Method, ScanConverter};

    /// Two lines of 16 steps over tangents -1 to 1: dark from a quarter to a half, and from three quarters on.
    #[test]
    fn edges_stand_at_the_steps_of_the_converters() {
        let mut lines = vec![Gate::default(), Gate::default()];
        lines[0].add([-0.5, 0.01]);
        lines[1].add([0.5, 1.0]);
        let gates = [Gates { lines, ..Gates::default() }];
        let mut expected = EventHash::new();
        for (step, what, line) in [(4, "off", 0), (8, "on", 0), (16 + 12, "off", 1), (16 + 16, "on", 1)] {
            expected.push(step, "blanking", what, &[0, line]);
        }
        let (events, events_blake3) = expected.finish();
        let found = Blanking::of(&Method::Synchronised { dac_bits: 4 }, &gates, 1.0);
        assert_eq!(found, Blanking { events, events_blake3 });
        assert_eq!(Blanking::of(&Method::ScanConverter(ScanConverter::default()), &gates, 1.0).events, 0);
    }
}
