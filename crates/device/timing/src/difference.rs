//! What differs between two values, with its place.

use std::collections::BTreeMap;
use std::fmt::Display;

use serde::Serialize;

/// One value that is not as in the baseline.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// Keys down to the value: `sets.late`, `deadlines.transfer.least`, `miss (sweep 3, transfer).due`.
    pub place: String,
    /// In the baseline; none if it is not there.
    pub baseline: Option<String>,
    /// In the record that is held to it; none if it is not there.
    pub found: Option<String>,
}

/// Differences in the order in which they are met.
#[derive(Debug, Default)]
pub(crate) struct Differences(pub Vec<Difference>);

impl Differences {
    /// Values that must be the same.
    pub fn exact<T: PartialEq + Display>(&mut self, place: impl Display, baseline: T, found: T) {
        self.option(place, Some(baseline), Some(found));
    }

    /// Values that must be the same or both not there.
    pub fn option<T: PartialEq + Display>(
        &mut self,
        place: impl Display,
        baseline: Option<T>,
        found: Option<T>,
    ) {
        if baseline != found {
            self.tell(place, baseline, found);
        }
    }

    /// Numbers that may be `tolerance` apart, or both not there. No tolerance covers what is not a number.
    pub fn near(&mut self, place: impl Display, baseline: Option<f64>, found: Option<f64>, tolerance: f64) {
        let is_near = match (baseline, found) {
            (Some(baseline), Some(found)) => (found - baseline).abs() <= tolerance,
            (baseline, found) => baseline.is_none() && found.is_none(),
        };
        if !is_near {
            self.tell(place, baseline, found);
        }
    }

    /// Tells a difference without asking.
    pub fn tell<T: Display>(&mut self, place: impl Display, baseline: Option<T>, found: Option<T>) {
        let [baseline, found] = [baseline, found].map(|value| value.map(|value| value.to_string()));
        self.0.push(Difference { place: place.to_string(), baseline, found });
    }
}

/// What two lists hold under each key, keys rising. Things of one key are paired in their order, so that nothing is
/// lost where a key comes twice.
pub(crate) fn pairs<'a, K: Ord + Clone, V>(
    baseline: &'a [V],
    found: &'a [V],
    key: impl Fn(&'a V) -> K,
) -> Vec<(K, Option<&'a V>, Option<&'a V>)> {
    let mut by_key = BTreeMap::<K, (Vec<&V>, Vec<&V>)>::new();
    for value in baseline {
        by_key.entry(key(value)).or_default().0.push(value);
    }
    for value in found {
        by_key.entry(key(value)).or_default().1.push(value);
    }
    let pairs_of = |(key, (ours, theirs)): (K, (Vec<&'a V>, Vec<&'a V>))| {
        let many = ours.len().max(theirs.len());
        (0..many).map(move |nth| (key.clone(), ours.get(nth).copied(), theirs.get(nth).copied()))
    };
    by_key.into_iter().flat_map(pairs_of).collect()
}
