//! Splits that share no ground: blocks of ground, each of one split.

use serde::{Deserialize, Serialize};

use crate::draws::{first_word, share};

/// What stands before every message whose hash decides the split of a block.
const DOMAIN: &[u8] = b"lunoid.dataset/1 block\0";

/// What a sample is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Split {
    /// Samples that a method learns from.
    Train,
    /// Samples by which a method is chosen.
    Validation,
    /// Samples on which the chosen method is measured.
    Test,
}

impl Split {
    /// All splits, in the order of [`Splits::shares`].
    pub const ALL: [Self; 3] = [Self::Train, Self::Validation, Self::Test];

    /// Name, which its folder has too.
    pub fn name(self) -> &'static str {
        match self {
            Self::Train => "train",
            Self::Validation => "validation",
            Self::Test => "test",
        }
    }
}

/// Blocks of ground and the shares of the splits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Splits {
    /// Side of a block (m). Blocks are squares whose sides run north and east, one with a corner at the origin.
    pub block_m: f64,
    /// Distance around the vehicle within which all ground is of the split of the sample (m).
    pub reach_m: f64,
    /// Shares of training, validation and test; they sum up to 1.
    pub shares: [f64; 3],
}

impl Splits {
    /// The split whose share of 0..1 holds `share`.
    pub fn of_share(&self, share: f64) -> Split {
        let [train, validation, test] = self.shares;
        // Rounding of the sums leaves no sample to a split without a share.
        if share < train || (validation == 0.0 && test == 0.0) {
            Split::Train
        } else if share < train + validation || test == 0.0 {
            Split::Validation
        } else {
            Split::Test
        }
    }

    /// The split of the ground at a place (north, east; m), under the seed of the plan: whatever scenario it is of.
    pub fn of_place(&self, seed: u64, at: [f64; 2]) -> Split {
        self.of_block(seed, at.map(|along| self.block(along)))
    }

    /// Whether all ground within the reach of a place (north, east; m) is of `split`.
    pub fn is_clear(&self, seed: u64, at: [f64; 2], split: Split) -> bool {
        let ends = |along: f64| self.block(along - self.reach_m)..=self.block(along + self.reach_m);
        let near = |block: [i64; 2]| self.distance(at, block) <= self.reach_m;
        let [north, east] = at.map(ends);
        let mut blocks = north.flat_map(|north| east.clone().map(move |east| [north, east]));
        blocks.all(|block| !near(block) || self.of_block(seed, block) == split)
    }

    fn of_block(&self, seed: u64, block: [i64; 2]) -> Split {
        let mut hasher = blake3::Hasher::new();
        hasher.update(DOMAIN);
        hasher.update(&seed.to_le_bytes());
        block.iter().for_each(|number| {
            hasher.update(&number.to_le_bytes());
        });
        self.of_share(share(first_word(&hasher.finalize())))
    }

    fn block(&self, along: f64) -> i64 {
        (along / self.block_m).floor() as i64
    }

    /// Distance (m) of a place from the nearest place of a block.
    fn distance(&self, at: [f64; 2], block: [i64; 2]) -> f64 {
        let beside = |along: f64, number: i64| {
            let (low, high) = (number as f64 * self.block_m, (number + 1) as f64 * self.block_m);
            (low - along).max(along - high).max(0.0)
        };
        let [north, east] = [beside(at[0], block[0]), beside(at[1], block[1])];
        (north * north + east * east).sqrt()
    }
}
