//! One hash of everything that decides what a frame takes.

use std::fmt::Debug;

use blake3::Hasher;
use landscape::{Landscape, bank_file};
use scenario::{Scenario, Scenery};

/// A hash in the making. The order of what is added counts.
#[derive(Debug)]
pub struct InputsHash(Hasher);

impl InputsHash {
    /// A hash of nothing yet. `context` says whose inputs they are, and in which format.
    pub fn new(context: &str) -> Self {
        Self(Hasher::new_derive_key(context))
    }

    /// Adds a value under a name. Debug text names all fields, and floats in it read back the same.
    pub fn add(&mut self, name: &str, value: &impl Debug) {
        self.add_bytes(format!("{name} {value:?}\n").as_bytes());
    }

    /// Adds bytes without a name.
    pub fn add_bytes(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Adds the bank of a landscape.
    pub fn add_bank(&mut self, landscape: &Landscape) {
        self.add_bytes(&bank_file::content_hash(landscape.bank()));
    }

    /// Adds the craters of a landscape.
    pub fn add_craters(&mut self, landscape: &Landscape) {
        landscape.features().craters().iter().for_each(|crater| self.add("crater", &crater));
    }

    /// Adds where the bodies of a scenery stand and when, and its guests.
    pub fn add_bodies(&mut self, scenery: &Scenery) {
        for standing in scenery.standing() {
            let body = &standing.body;
            let placed = (body.kind, body.priority, body.foot, body.vertices().collect::<Vec<_>>());
            self.add("body", &(standing.from, standing.until, placed));
        }
        scenery.all_guests().iter().for_each(|guest| self.add("guest", guest));
    }

    /// Adds the path of a scenario, its vehicle, and the channel that is looked through.
    pub fn add_way(&mut self, scenario: &Scenario) {
        self.add("path", &(scenario.way().waypoints(), &scenario.vehicle));
        scenario.channel.iter().for_each(|channel| self.add("channel", channel));
    }

    /// The hash as hexadecimal digits.
    pub fn finish(&self) -> String {
        self.0.finalize().to_hex().to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_values_and_their_order_count() {
        let of = |parts: &[(&str, f64)]| {
            let mut hash = InputsHash::new("a test");
            parts.iter().for_each(|(name, value)| hash.add(name, value));
            hash.finish()
        };
        let mut plain = Hasher::new_derive_key("a test");
        plain.update(b"a 0.1\nb -0.0\n");
        assert_eq!(of(&[("a", 0.1), ("b", -0.0)]), plain.finalize().to_hex().as_str());
        let all = [
            of(&[("a", 0.1), ("b", -0.0)]),
            of(&[("b", -0.0), ("a", 0.1)]),
            of(&[("a", 0.1), ("b", 0.0)]),
            of(&[("a", 0.1), ("c", -0.0)]),
            of(&[("a", 0.1 + f64::EPSILON / 8.0), ("b", -0.0)]),
        ];
        assert!((1..all.len()).all(|at| !all[..at].contains(&all[at])), "{all:?}");
    }
}
