//! What was left out of a run.

use generator::{Omission, Weight};
use serde::{Deserialize, Serialize};

/// Something that was left out, with weight and reason.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OmissionRecord {
    /// Block that it belongs to, by crate name.
    pub block: String,
    /// What was left out.
    pub what: String,
    /// Why it cannot touch the picture, or by how little.
    pub why: String,
    /// What it does to the picture.
    pub weight: WeightRecord,
}

/// What leaving something out does to the picture.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum WeightRecord {
    /// The picture is the same to the bit.
    #[serde(rename = "lossless")]
    Lossless,
    /// The picture would be another: the generator does not have it.
    #[serde(rename = "not modelled")]
    NotModelled,
    /// The picture changes by at most this many grey levels of 255 in any pixel.
    #[serde(rename = "bounded_grey_levels_of_255")]
    Bounded(f64),
}

impl From<&Omission> for OmissionRecord {
    fn from(omission: &Omission) -> Self {
        Self {
            block: omission.block.into(),
            what: omission.what.clone(),
            why: omission.why.clone(),
            weight: match omission.weight {
                Weight::Lossless => WeightRecord::Lossless,
                Weight::NotModelled => WeightRecord::NotModelled,
                Weight::Bounded(levels) => WeightRecord::Bounded(levels),
            },
        }
    }
}
