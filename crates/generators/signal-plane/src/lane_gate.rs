//! A gate over one sweep on the sweep clock: of remote shadow, or of the presence of features.

use mixing_unit::{Toggle, ToggleList};
use parts::GateEdge;
use signal::{LANES, Real};

/// The gate of one lane.
#[derive(Debug, Clone, Default)]
pub struct LaneGate<S> {
    open_at_start: bool,
    toggles: Vec<Toggle<S>>,
}

impl<S: Real> LaneGate<S> {
    /// A gate that is `open` under the eye and changes at `edges`, ascending; samples are at `ranges` (m).
    pub fn follow(&mut self, open: bool, edges: &[GateEdge], ranges: &[f64]) {
        let passed = edges.partition_point(|edge| edge.range <= ranges[0]);
        self.open_at_start = open ^ (passed % 2 == 1);
        self.toggles.clear();
        self.toggles.extend(edges[passed..].iter().map_while(|edge| toggle_at(ranges, edge)));
    }

    /// Closes the gate for the whole sweep.
    pub fn close(&mut self) {
        self.open_at_start = false;
        self.toggles.clear();
    }

    /// The gate as the mixing unit takes it.
    pub fn list(&self) -> ToggleList<'_, S> {
        ToggleList { open_at_start: self.open_at_start, toggles: &self.toggles }
    }

    /// The gates of a group as the mixing unit takes them.
    pub fn lists(gates: &[Self; LANES]) -> [ToggleList<'_, S>; LANES] {
        gates.each_ref().map(Self::list)
    }
}

/// A range as a place between two samples; `None` beyond the last.
fn toggle_at<S: Real>(ranges: &[f64], edge: &GateEdge) -> Option<Toggle<S>> {
    let sample = ranges.partition_point(|&z| z < edge.range);
    let (near, far) = (ranges[sample.checked_sub(1)?], *ranges.get(sample)?);
    let share = S::from_f64((edge.range - near) / (far - near));
    Some(Toggle { sample, share, slope: edge.slope * (far - near) })
}
