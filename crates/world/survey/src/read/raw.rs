//! Samples that stand in a file one after the other, unpacked, in lines or in tiles.

use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::gate;
use super::kind::Kind;
use super::opened::Samples;
use super::refusal::check_raster;
use super::stretch::Window;
use crate::error::SurveyError;

/// Where the samples of one band stand in a file: block by block, from the first line down and from the first column on.
#[derive(Debug, Clone)]
pub struct Raw {
    /// File of the samples.
    pub path: PathBuf,
    /// Lines of the band.
    pub lines: usize,
    /// Samples of a line.
    pub columns: usize,
    /// How a sample is stored.
    pub kind: Kind,
    /// Lines and columns of a block: one line, or a tile. The last blocks are stored whole.
    pub block: [usize; 2],
    /// Byte of the first sample of the band.
    pub first: u64,
    /// Bytes from block to block.
    pub block_step: u64,
    /// Bytes from sample to sample of a block.
    pub sample_step: u64,
}

impl Raw {
    /// A band stored line by line without gaps, from byte `first` on.
    pub fn lines_of(path: &Path, [lines, columns]: [usize; 2], kind: Kind, first: u64) -> Self {
        let sample_step = kind.bytes as u64;
        let block_step = (columns as u64).saturating_mul(sample_step);
        Self { path: path.into(), lines, columns, kind, block: [1, columns], first, block_step, sample_step }
    }

    /// Refuses a raster that the file is too short for, before anything is allocated.
    ///
    /// # Errors
    /// If the file cannot be looked at, is no file, or has fewer bytes than the band needs.
    pub fn check(&self) -> Result<(), SurveyError> {
        check_raster(&self.path, self.lines as u64, self.columns as u64)?;
        let (_, found) = gate::open(&self.path)?;
        let blocks = (self.lines.div_ceil(self.block[0]) as u64).saturating_mul(self.across() as u64);
        let before = blocks.saturating_sub(1).saturating_mul(self.block_step);
        let expected = self.first.saturating_add(before).saturating_add(self.bytes());
        if found < expected {
            let place = format!(
                "{} lines of {} samples of {} bytes from byte {}",
                self.lines, self.columns, self.kind.bytes, self.first
            );
            return Err(SurveyError::Truncated { path: self.path.clone(), place, found, expected });
        }
        Ok(())
    }

    /// Blocks side by side.
    fn across(&self) -> usize {
        self.columns.div_ceil(self.block[1])
    }

    /// Bytes from the first sample of a block to the end of its last.
    fn bytes(&self) -> u64 {
        let samples = (self.block[0] as u64).saturating_mul(self.block[1] as u64);
        samples.saturating_sub(1).saturating_mul(self.sample_step).saturating_add(self.kind.bytes as u64)
    }
}

impl Samples for Raw {
    fn read(&mut self, window: &Window, _: &mut Vec<String>) -> Result<Vec<f64>, SurveyError> {
        let failed = |source| SurveyError::Read { path: self.path.clone(), source };
        let (mut file, _) = gate::open(&self.path)?;
        let mut block = vec![0; self.bytes() as usize];
        let mut samples = vec![f64::NAN; window.count()];
        for [down, across] in window.blocks(self.block) {
            let index = (down * self.across() + across) as u64;
            file.seek(SeekFrom::Start(self.first + index * self.block_step)).map_err(failed)?;
            file.read_exact(&mut block).map_err(failed)?;
            window.put(self.block, [down, across], &mut samples, |sample| {
                let at = sample * self.sample_step as usize;
                self.kind.number(&block[at..at + self.kind.bytes])
            });
        }
        Ok(samples)
    }
}
