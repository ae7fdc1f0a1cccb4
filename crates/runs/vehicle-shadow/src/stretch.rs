//! What a stretch of a television line sees, and where it is dark.

use glam::DVec3;

use crate::gate::Gate;
use crate::prism::{Prism, Reach};

/// Neighbouring places whose distances differ by more than this share do not see the same slope: something nearer
/// ends between them (our choice).
const JUMP: f64 = 0.1;

/// What a ray meets.
#[derive(Debug, Clone, Copy)]
pub struct Spot {
    /// North, east, up (m).
    pub place: DVec3,
    /// Distance ahead along the camera's axis (m).
    pub ahead: f64,
    /// 0 for the ground, else a number of the body.
    pub of: usize,
}

impl Spot {
    fn joins(&self, other: &Self) -> bool {
        self.of == other.of && (self.ahead - other.ahead).abs() <= JUMP * self.ahead.min(other.ahead)
    }
}

/// A line between two neighbouring places.
#[derive(Debug, Clone, Copy)]
pub struct Stretch {
    /// What each place sees; `None` where it sees nothing.
    pub spots: [Option<Spot>; 2],
    /// Their X on the view-plane.
    pub ends: [f64; 2],
}

impl Stretch {
    /// Both places, if they see one surface.
    pub fn chord(&self) -> Option<[Spot; 2]> {
        let [a, b] = self.spots;
        a.zip(b).filter(|(a, b)| a.joins(b)).map(|(a, b)| [a, b])
    }

    /// Whether it may show anything within `reach`.
    pub fn may_meet(&self, reach: &Reach) -> bool {
        match self.chord() {
            Some([a, b]) => reach.may_hold(a.place, b.place),
            None => self.spots.iter().flatten().any(|spot| reach.may_hold(spot.place, spot.place)),
        }
    }

    /// Adds where `prism` darkens it. If its ends do not see one surface each counts for its half.
    pub fn darken(&self, prism: &Prism, gate: &mut Gate) {
        let [from, to] = self.ends;
        if let Some([a, b]) = self.chord() {
            let Some(shares) = prism.clip(a.place, b.place) else { return };
            // Equal ways on the ground are no equal ways on the view-plane: perspective weighs them by distance.
            let at = |share: f64| match share {
                // The ends themselves, so that stretches of one shadow touch.
                0.0 => from,
                1.0 => to,
                _ => {
                    let (near, far) = (a.ahead * (1.0 - share), b.ahead * share);
                    (from * near + to * far) / (near + far)
                }
            };
            return gate.add(shares.map(at));
        }
        let middle = 0.5 * (from + to);
        for (spot, half) in self.spots.into_iter().zip([[from, middle], [middle, to]]) {
            if spot.is_some_and(|spot| prism.holds(spot.place)) {
                gate.add(half);
            }
        }
    }
}
