//! What a data set will take, measured on a few of its samples.

use std::collections::BTreeMap;
use std::ops::Range;
use std::time::Instant;

use files::NpyData;

use crate::DatasetError;
use crate::plan::Plan;
use crate::sample::{Made, Maker};

/// Most samples that are made to measure them (chosen).
const MEASURED: u64 = 8;

/// What the samples of a range will take.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Number of all samples.
    pub samples: u64,
    /// Samples of training, validation and test: exact, because the split is drawn first.
    pub splits: [u64; 3],
    /// Samples that were made, and not written.
    pub measured: u64,
    /// Wall time of a sample by one thread (s): mean of those measured.
    pub seconds: f64,
    /// Bytes of a sample: mean of those measured.
    pub bytes: f64,
    /// Poses of those measured that were drawn and not taken, by the reason.
    pub refused: BTreeMap<String, u32>,
}

impl Estimate {
    /// Makes a few of `samples`, evenly spread, and none of their files.
    ///
    /// # Errors
    /// If one of them cannot be made.
    pub fn measure(plan: &Plan, samples: &Range<u64>) -> Result<Self, DatasetError> {
        let count = samples.end.saturating_sub(samples.start);
        if count == 0 || samples.end > plan.samples() {
            let asked = format!("{}..{}", samples.start, samples.end);
            return Err(DatasetError::NoSamples { asked, of: plan.samples() });
        }
        let mut splits = [0; 3];
        samples.clone().for_each(|sample| splits[plan.split(sample) as usize] += 1);
        let measured = count.min(MEASURED);
        let maker = Maker::new(plan);
        let (began, mut bytes, mut refused) = (Instant::now(), 0, BTreeMap::new());
        for index in 0..measured {
            let sample =
                samples.start + (u128::from(index) * u128::from(count) / u128::from(measured)) as u64;
            let made = maker.make(sample)?;
            bytes += size(&made);
            for (reason, count) in made.row.refused {
                *refused.entry(reason).or_default() += count;
            }
        }
        let mean = |sum: f64| sum / measured as f64;
        Ok(Self {
            samples: count,
            splits,
            measured,
            seconds: mean(began.elapsed().as_secs_f64()),
            bytes: mean(bytes as f64),
            refused,
        })
    }
}

/// Bytes of the file and of the line of a sample, but for the heads of its arrays.
fn size(made: &Made) -> usize {
    let arrays: usize = made.arrays.iter().map(|(_, array)| array.data().len() * width(array.data())).sum();
    arrays + serde_json::to_string(&made.row).map_or(0, |line| line.len())
}

/// Bytes of a value. Samples have codes and numbers of single precision.
fn width(data: &NpyData) -> usize {
    match data {
        NpyData::U8(_) => 1,
        _ => 4,
    }
}
