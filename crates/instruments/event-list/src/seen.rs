//! What there is to be listed.

use std::collections::BTreeSet;

use machine::DigitalEvent;

/// Events that were looked at, listed or not.
#[derive(Debug, Default)]
pub struct Seen {
    /// Number of events looked at.
    pub count: u64,
    /// Ticks of the first and of the last.
    pub ticks: Option<[u64; 2]>,
    units: BTreeSet<String>,
}

impl Seen {
    /// Looks at one more.
    pub fn look(&mut self, event: &DigitalEvent) {
        let tick = event.tick.0;
        let [first, last] = self.ticks.unwrap_or([tick; 2]);
        self.ticks = Some([first.min(tick), last.max(tick)]);
        self.count += 1;
        self.units.insert(event.unit.to_string());
    }

    /// Names of the units, in alphabetical order.
    pub fn units(&self) -> String {
        self.units.iter().map(String::as_str).collect::<Vec<_>>().join(", ")
    }
}
