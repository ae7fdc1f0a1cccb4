//! Draws by counter: each is a function of seed, sample, attempt and the name of the quantity alone.

/// What stands before every message that is hashed, so that no other hash of the program repeats a draw.
const DOMAIN: &[u8] = b"lunoid.dataset/1 draw\0";

/// The number of a draw: which sample of which plan, and which attempt at it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counter {
    /// Seed of the plan.
    pub seed: u64,
    /// Number of the sample.
    pub sample: u64,
    /// Attempt at a pose, from 0; draws that are not repeated have 0.
    pub attempt: u32,
}

impl Counter {
    /// A word of 64 bits: the first 8 bytes, lowest first, of the BLAKE3 of the domain, seed, sample and attempt (little-endian), and `name`.
    pub fn word(self, name: &str) -> u64 {
        let mut hasher = blake3::Hasher::new();
        hasher.update(DOMAIN);
        hasher.update(&self.seed.to_le_bytes());
        hasher.update(&self.sample.to_le_bytes());
        hasher.update(&self.attempt.to_le_bytes());
        hasher.update(name.as_bytes());
        first_word(&hasher.finalize())
    }

    /// A number from 0 to 1, without 1: the upper 53 bits of the word.
    pub fn share(self, name: &str) -> f64 {
        share(self.word(name))
    }
}

/// A number from 0 to 1, without 1, of the upper 53 bits of `word`.
pub(crate) fn share(word: u64) -> f64 {
    (word >> 11) as f64 / (1_u64 << 53) as f64
}

/// The first 8 bytes of a hash, lowest first.
pub(crate) fn first_word(hash: &blake3::Hash) -> u64 {
    let bytes = hash.as_bytes().first_chunk::<8>().copied();
    u64::from_le_bytes(bytes.unwrap_or_default())
}

/// Values that a quantity is drawn from, each as likely.
#[derive(Debug, Clone, PartialEq)]
pub enum Draw {
    /// Numbers between a least and a largest one.
    Number([f64; 2]),
    /// Whole numbers from the first to the last.
    Whole([u64; 2]),
    /// Values of a list, as `--set` takes them.
    OneOf(Vec<String>),
}

impl Draw {
    /// The value of the quantity `name`, as TOML. Of whole numbers and lists the bias is below their count over 2^64.
    pub fn value(&self, counter: Counter, name: &str) -> String {
        match self {
            Self::Number(ends) => format!("{:?}", between(*ends, counter.share(name))),
            Self::Whole([first, last]) => (first + below(last - first + 1, counter.word(name))).to_string(),
            Self::OneOf(values) => values[below(values.len() as u64, counter.word(name)) as usize].clone(),
        }
    }

    /// The values at both ends, as TOML; of a list all of them.
    pub fn ends(&self) -> Vec<String> {
        match self {
            Self::Number(ends) => ends.iter().map(|end| format!("{end:?}")).collect(),
            Self::Whole(ends) => ends.iter().map(u64::to_string).collect(),
            Self::OneOf(values) => values.clone(),
        }
    }

    /// What is drawn, in words.
    pub fn words(&self) -> String {
        match self {
            Self::Number([low, high]) => format!("{low} to {high}"),
            Self::Whole([first, last]) => format!("whole, {first} to {last}"),
            Self::OneOf(values) => format!("one of {}", values.join(", ")),
        }
    }
}

/// The number at `share` of the way between two.
pub(crate) fn between([low, high]: [f64; 2], share: f64) -> f64 {
    low + (high - low) * share
}

/// A whole number below `count`, which is above 0.
pub(crate) fn below(count: u64, word: u64) -> u64 {
    ((u128::from(word) * u128::from(count)) >> 64) as u64
}
