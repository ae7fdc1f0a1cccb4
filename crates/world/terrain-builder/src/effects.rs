//! What each switch changes, in metres.

use crate::base::Base;
use crate::description::Description;
use crate::ground::{Ground, GroundError};
use crate::switches::Switch;

/// Effect of turning one switch over while the others stay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// Switch that was turned over.
    pub switch: Switch,
    /// Largest change of the height of a post (m).
    pub heights: f64,
    /// Largest change of the height of a boulder's middle (m); 0 where boulders lie elsewhere.
    pub boulders: f64,
    /// Largest way that an item of a distribution moves (m).
    pub moved: f64,
}

/// The effect of every switch on a landscape, in the order of [`Switch::ALL`].
///
/// # Errors
/// If a number of a feature is out of range.
pub fn effects(description: &Description, base: &Base) -> Result<Vec<Effect>, GroundError> {
    let usual = Ground::new(description.clone(), base.clone())?;
    let heights = usual.heights();
    let effect = |switch: Switch| {
        let reported = description.reported.turned(switch);
        let turned = Ground::new(Description { reported, ..description.clone() }, base.clone())?;
        let [boulders, moved] = boulders(&usual, &turned);
        let moved = moved.max(craters(&usual, &turned));
        let heights = heights.largest_difference(&turned.heights());
        Ok(Effect { switch, heights, boulders, moved })
    };
    Switch::ALL.iter().map(|(_, switch)| effect(*switch)).collect()
}

/// Largest change of height of a boulder that stays where it is, and the longest way of one that does not.
fn boulders(usual: &Ground, turned: &Ground) -> [f64; 2] {
    let pairs = usual.boulders().iter().zip(turned.boulders());
    pairs.fold([0.0; 2], |[height, moved]: [f64; 2], (a, b)| match way(a.boulder.at(), b.boulder.at()) {
        0.0 => [height.max((a.middle - b.middle).abs()), moved],
        way => [height, moved.max(way)],
    })
}

fn craters(usual: &Ground, turned: &Ground) -> f64 {
    let pairs = usual.craters().zip(turned.craters());
    pairs.map(|((_, a), (_, b))| way(a.form().centre, b.form().centre)).fold(0.0, f64::max)
}

fn way(from: [f64; 2], to: [f64; 2]) -> f64 {
    let [north, east] = [0, 1].map(|axis| to[axis] - from[axis]);
    (north * north + east * east).sqrt()
}
