//! A fingerprint of the ordered list of digital events.

use blake3::{Hash, Hasher, OUT_LEN};

/// Context strings of BLAKE3's key derivation: they part events of a sweep, sweeps of a frame, and all other hashes.
const OF_EVENTS: &str = "lunoid timing, ordered digital events, format 1";
const OF_PARTS: &str = "lunoid timing, parts in order, format 1";

/// Bytes that are hashed at once.
const PIECE: usize = 16 << 10;

/// Hash of digital events in their order. Sweeps are hashed apart, in parallel, and [joined](Self::join) in order.
#[derive(Debug, Clone)]
pub struct EventHash {
    hasher: Hasher,
    /// What is not hashed yet: the hasher takes large pieces many times faster than single words.
    pending: Vec<u8>,
    count: u64,
}

impl EventHash {
    /// Makes the hash of an empty list.
    pub fn new() -> Self {
        Self { hasher: Hasher::new_derive_key(OF_EVENTS), pending: Vec::new(), count: 0 }
    }

    /// Adds the next event: when (master ticks), which unit, what it did, and the words concerned.
    pub fn push(&mut self, tick: u64, unit: &str, what: &str, words: &[u64]) {
        self.count += 1;
        self.number(tick);
        for text in [unit, what] {
            self.number(text.len() as u64);
            self.pending.extend_from_slice(text.as_bytes());
        }
        self.number(words.len() as u64);
        for &word in words {
            self.number(word);
        }
        if self.pending.len() >= PIECE {
            self.hasher.update(&self.pending);
            self.pending.clear();
        }
    }

    fn number(&mut self, number: u64) {
        self.pending.extend_from_slice(&number.to_le_bytes());
    }

    fn hash(&self) -> Hash {
        self.hasher.clone().update(&self.pending).finalize()
    }

    /// Events and their hash, to be joined.
    pub fn part(&self) -> (u64, [u8; OUT_LEN]) {
        (self.count, *self.hash().as_bytes())
    }

    /// Events and their hash as 64 hexadecimal digits.
    pub fn finish(&self) -> (u64, String) {
        (self.count, self.hash().to_hex().to_string())
    }

    /// Events and hash of `parts` in their order; where one part ends and the next begins counts.
    pub fn join(parts: impl Iterator<Item = (u64, [u8; OUT_LEN])>) -> (u64, String) {
        let mut hasher = Hasher::new_derive_key(OF_PARTS);
        let mut total = 0u64;
        for (count, hash) in parts {
            total = total.saturating_add(count);
            hasher.update(&count.to_le_bytes()).update(&hash);
        }
        (total, hasher.finalize().to_hex().to_string())
    }
}

impl Default for EventHash {
    fn default() -> Self {
        Self::new()
    }
}
