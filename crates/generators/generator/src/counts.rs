//! Work done: counters are results, the same for any number of threads.

use std::borrow::Cow;
use std::fmt;
use std::ops::Index;

use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// How a counter of a frame joins that of another frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Joined {
    /// Both counts are added together.
    Sum,
    /// The larger one stays.
    Largest,
}

/// A counter that a generator keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counter {
    /// Name of the counter in records.
    pub name: &'static str,
    /// How frames are joined.
    pub joined: Joined,
}

/// What a frame, or a run, took: counters by name, in the order of the generator's own list.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FrameCounts(Vec<(Cow<'static, str>, u64)>);

impl FrameCounts {
    /// Makes the counts of a frame from counters by name.
    pub fn of(named: impl IntoIterator<Item = (&'static str, u64)>) -> Self {
        Self(named.into_iter().map(|(name, count)| (Cow::Borrowed(name), count)).collect())
    }

    /// The counter called `name`; `None` if the generator keeps none of that name.
    pub fn get(&self, name: &str) -> Option<u64> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, count)| *count)
    }

    /// All counters with their names.
    pub fn named(&self) -> impl Iterator<Item = (&str, u64)> {
        self.0.iter().map(|(name, count)| (name.as_ref(), *count))
    }

    /// Joins the counters of another frame to these; a counter that `counters` does not list is added.
    pub fn join(&mut self, other: &Self, counters: &[Counter]) {
        for (name, count) in &other.0 {
            let joined = counters.iter().find(|counter| counter.name == name).map(|counter| counter.joined);
            match (self.0.iter_mut().find(|(known, _)| known == name), joined) {
                (Some((_, own)), Some(Joined::Largest)) => *own = (*own).max(*count),
                // A record that somebody changed may say anything.
                (Some((_, own)), _) => *own = own.saturating_add(*count),
                (None, _) => self.0.push((name.clone(), *count)),
            }
        }
    }
}

impl Index<&str> for FrameCounts {
    type Output = u64;

    /// The counter called `name`.
    ///
    /// # Panics
    /// If there is none.
    fn index(&self, name: &str) -> &u64 {
        let found = self.0.iter().find(|(known, _)| known == name);
        &found.unwrap_or_else(|| panic!("no counter `{name}`")).1
    }
}

impl Serialize for FrameCounts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.named())
    }
}

impl<'de> Deserialize<'de> for FrameCounts {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(CountsVisitor)
    }
}

/// Reads counters in the order in which they are written.
struct CountsVisitor;

impl<'de> Visitor<'de> for CountsVisitor {
    type Value = FrameCounts;

    fn expecting(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str("counters by name")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<FrameCounts, A::Error> {
        let mut named = Vec::new();
        while let Some((name, count)) = map.next_entry::<String, u64>()? {
            named.push((Cow::Owned(name), count));
        }
        Ok(FrameCounts(named))
    }
}

#[cfg(test)]
mod tests {
    use super::{Counter, FrameCounts, Joined};

    const COUNTERS: [Counter; 2] =
        [Counter { name: "rays", joined: Joined::Sum }, Counter { name: "step", joined: Joined::Largest }];

    #[test]
    fn sums_are_added_and_the_largest_stays() {
        let mut total = FrameCounts::default();
        for (rays, step) in [(3, 7), (4, 5)] {
            total.join(&FrameCounts::of([("rays", rays), ("step", step)]), &COUNTERS);
        }
        assert_eq!((total["rays"], total["step"], total.get("sweeps")), (7, 7, None));
    }

    #[test]
    fn the_record_keeps_names_and_order() {
        let counts = FrameCounts::of([("rays", 3), ("bodies", 0)]);
        let text = serde_json::to_string(&counts).unwrap();
        assert_eq!(text, r#"{"rays":3,"bodies":0}"#);
        assert_eq!(serde_json::from_str::<FrameCounts>(&text).unwrap(), counts);
    }
}
