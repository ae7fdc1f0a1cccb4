//! `page.json`: what a page shows that the record does not have.

use std::io::Write;
use std::path::Path;

use replay::scope_name;
use serde::{Deserialize, Serialize};

use crate::{ReportError, Sight, SweepWaves, TimingSummary};

/// Name of the file in the run folder.
pub const BESIDE: &str = replay::PAGE_DATA;

const SCHEMA: &str = "lunoid.page/1";
const MAX_BYTES: u64 = 1 << 28;

/// What a page shows that the record does not have. The same run by the same words gives the same file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Beside {
    schema: String,
    /// Fingerprint of the run that it belongs to.
    pub fingerprint: String,
    /// Words of a command line that choose this stage: the scenario, then options. For commands to copy.
    pub stage: Vec<String>,
    /// Where a pixel lies among the sweeps; none for a generator without sweeps.
    pub sight: Option<Sight>,
    /// Timing of some frames; none for a generator without clocks.
    pub timing: Option<TimingSummary>,
    /// Recorded sweeps, by frame and sweep.
    pub scopes: Vec<ScopePlot>,
    /// Their values, in the same order; none of a sweep that was recorded before they were kept.
    #[serde(default)]
    pub waves: Vec<SweepWaves>,
}

/// A recorded sweep whose plot the page shows.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct ScopePlot {
    /// Frame, counted at the update rate.
    pub frame: u64,
    /// Sweep of the frame, from 0 at the left.
    pub sweep: u32,
    /// Patterns of signals that were asked for.
    pub asked: Vec<String>,
    /// Signals that the plot shows.
    pub signals: Vec<String>,
    /// BLAKE3 of the plot, hexadecimal.
    pub blake3: String,
}

impl ScopePlot {
    /// The plot, from the run folder.
    pub fn file(&self) -> String {
        scope_name(self.frame, self.sweep)
    }
}

impl Beside {
    /// Nothing but whose it is.
    pub fn new(fingerprint: &str) -> Self {
        Self {
            schema: SCHEMA.into(),
            fingerprint: fingerprint.into(),
            stage: Vec::new(),
            sight: None,
            timing: None,
            scopes: Vec::new(),
            waves: Vec::new(),
        }
    }

    /// What `folder` has of the run of `fingerprint`: plots that are not there, or are others than those that were
    /// written, are left out. The rest is nothing if there is no file, or one of another run.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(folder: &Path, fingerprint: &str) -> Result<Self, ReportError> {
        let path = folder.join(BESIDE);
        if !path.exists() {
            return Ok(Self::new(fingerprint));
        }
        let refused = |reason: String| ReportError::Content { path: path.clone(), reason };
        let bytes = files::read_all(&path, MAX_BYTES)?;
        let mut found: Self = serde_json::from_slice(&bytes).map_err(|error| refused(error.to_string()))?;
        if found.schema != SCHEMA {
            return Err(refused(format!("schema {:?}, expected {SCHEMA:?}", found.schema)));
        }
        if found.fingerprint != fingerprint {
            return Ok(Self::new(fingerprint));
        }
        let is_whole = |plot: &ScopePlot| {
            run_record::file_hash(&folder.join(plot.file())).is_ok_and(|hash| hash == plot.blake3)
        };
        found.scopes.retain(is_whole);
        let Self { scopes, waves, .. } = &mut found;
        let is_plotted =
            |of: &SweepWaves| scopes.iter().any(|plot| (plot.frame, plot.sweep) == (of.frame, of.sweep));
        waves.retain(is_plotted);
        Ok(found)
    }

    /// Adds a plot and its values, if they were kept, in place of an earlier one of the same sweep.
    pub fn add(&mut self, plot: ScopePlot, waves: Option<SweepWaves>) {
        let place = (plot.frame, plot.sweep);
        self.scopes.retain(|known| (known.frame, known.sweep) != place);
        self.waves.retain(|known| (known.frame, known.sweep) != place);
        self.scopes.push(plot);
        self.waves.extend(waves);
        self.scopes.sort();
        self.waves.sort_by_key(|of| (of.frame, of.sweep));
    }

    /// Writes the file into `folder`.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), ReportError> {
        let text = serde_json::to_string(self).expect("records are plain values") + "\n";
        Ok(files::write_atomic(folder.join(BESIDE), |out: &mut dyn Write| out.write_all(text.as_bytes()))?)
    }
}
