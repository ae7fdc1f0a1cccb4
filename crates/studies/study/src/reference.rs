//! Pictures of `exact`, kept by what they depend on.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

use blake3::Hasher;
use exact::{Exact, ExactWithin, Fineness, LINE_MEAN_TOLERANCE, RIDGE_SHARE};
use files::{FileError, FolderError, Npy, NpyData, NpyError};
use generator::{Generator, PlaneKind, Planes, Stage};
use landscape::bank_file;
use scenario::{Pose, Scenario, View};
use serde::Serialize;
use signal::Probe;

use crate::StudyError;
use crate::figures::Sum;

/// More than any picture holds (bytes).
const MOST_BYTES: u64 = 1 << 31;

/// Why pictures cannot be kept.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// A picture cannot be written.
    #[error("pictures of exact cannot be kept: {0}; name a folder that can be written")]
    Write(#[from] FileError),
    /// The folder cannot be made, or is a link.
    #[error("pictures of exact cannot be kept: {0}; name a folder that can be written")]
    Folder(#[from] FolderError),
    /// A picture has no shape.
    #[error(transparent)]
    Shape(#[from] NpyError),
}

/// By how much `exact` itself may be off: its pictures against those with every limit of its quadrature halved twice.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SelfError {
    /// Root of the mean squared difference of linear intensity.
    pub rms: f64,
    /// Largest difference of linear intensity.
    pub max: f64,
    /// What an edge inside a line is published to shift its mean by, at most.
    pub edge: f64,
    /// Share of a line below which a ridge between equal shades is not looked for: it may shift the mean by that share of
    /// what is hidden.
    pub ridge: f64,
}

impl SelfError {
    /// The same in words.
    pub fn sentence(&self) -> String {
        let Self { rms, max, edge, ridge } = self;
        format!(
            "exact against itself with its limits halved twice: RMS {rms:.1e}, at most {max:.1e} of full intensity \
             (published: {edge:.0e} for an edge inside a line, {ridge} of its contrast for a ridge between equal shades)"
        )
    }
}

/// What a picture of `exact` shows, line by line from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct ExactPicture {
    /// Linear intensity of each pixel.
    pub intensity: Vec<f32>,
    /// Ground range of the pixels' centres (m); infinite in the sky.
    pub range: Vec<f32>,
}

/// Draws pictures of `exact`, each once: in this run from memory, in the next from the folder.
#[derive(Debug)]
pub struct ExactPictures {
    folder: Option<PathBuf>,
    /// Program, ground and scenario: what all pictures of a study depend on.
    common: blake3::Hash,
    held: HashMap<blake3::Hash, Arc<ExactPicture>>,
}

impl ExactPictures {
    /// Pictures over the ground of `stage`, kept in `folder` if there is one. `program` names the version that draws.
    ///
    /// # Errors
    /// If the folder cannot be made.
    pub fn new(
        program: &str,
        scenario: &Scenario,
        stage: &Stage,
        folder: Option<PathBuf>,
    ) -> Result<Self, ReferenceError> {
        if let Some(folder) = &folder {
            files::make_folder(folder)?;
        }
        let mut hasher = Hasher::new();
        hasher.update(program.as_bytes());
        hasher.update(&bank_file::content_hash(stage.landscape.bank()));
        hasher.update(format!("{scenario:?}").as_bytes());
        Ok(Self { folder, common: hasher.finalize(), held: HashMap::new() })
    }

    /// The picture of frame `frame` under the laws of `stage`, `columns` x `lines`.
    ///
    /// # Errors
    /// If it cannot be drawn or kept.
    pub fn picture(
        &mut self,
        stage: &Stage,
        (frame, pose): (u64, &Pose),
        [columns, lines]: [usize; 2],
    ) -> Result<Arc<ExactPicture>, StudyError> {
        let key = self.key(stage, pose, [columns, lines]);
        if let Some(held) = self.held.get(&key) {
            return Ok(held.clone());
        }
        let file = self.folder.as_ref().map(|folder| folder.join(format!("{}.npy", key.to_hex())));
        let read = file.as_ref().and_then(|file| read(file, columns * lines));
        let picture = match read {
            Some(picture) => picture,
            None => {
                let drawn = picture(&Exact, stage, (frame, pose), [columns, lines])?;
                if let Some(file) = &file {
                    write(file, &drawn, [columns, lines])?;
                }
                drawn
            }
        };
        let picture = Arc::new(picture);
        self.held.insert(key, picture.clone());
        Ok(picture)
    }

    /// By how much the pictures of `frames` at the lines of `stage` may be off, over a quarter of its columns.
    ///
    /// # Errors
    /// If one cannot be drawn or kept.
    pub fn self_error(&mut self, stage: &Stage, frames: &[(u64, Pose)]) -> Result<SelfError, StudyError> {
        let View { columns, lines, .. } = stage.view;
        let size = [columns.div_ceil(4) as usize, lines as usize];
        let mut sum = Sum::default();
        for (frame, pose) in frames {
            let usual = self.picture(stage, (*frame, pose), size)?;
            let finer = ExactWithin(Fineness::USUAL.halved(2));
            let finer = picture(&finer, stage, (*frame, pose), size)?;
            let pairs = usual.intensity.iter().zip(&finer.intensity);
            pairs.for_each(|(usual, finer)| sum.add(f64::from(*usual) - f64::from(*finer)));
        }
        Ok(SelfError { rms: sum.rms(), max: sum.max(), edge: 2.0 * LINE_MEAN_TOLERANCE, ridge: RIDGE_SHARE })
    }

    /// What a picture of `exact` depends on: laws, first and last range, levels, shadow, view and pose.
    fn key(&self, stage: &Stage, pose: &Pose, size: [usize; 2]) -> blake3::Hash {
        let View { laws, ranges: [first, end], levels, shadows, field, .. } = &stage.view;
        let settled =
            format!("{laws:?} {first:?} {end:?} {levels:?} {shadows:?} {field:?} {pose:?} {size:?}");
        let mut hasher = Hasher::new();
        hasher.update(self.common.as_bytes());
        hasher.update(settled.as_bytes());
        hasher.finalize()
    }
}

/// A frame of a generator on a raster of its own.
///
/// # Errors
/// If it cannot be drawn.
pub(crate) fn picture(
    generator: &dyn Generator,
    stage: &Stage,
    (frame, pose): (u64, &Pose),
    [columns, lines]: [usize; 2],
) -> Result<ExactPicture, StudyError> {
    let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity, PlaneKind::Range]);
    generator.prepare(stage.clone())?.frame(frame, pose, &mut planes, &mut Probe::off())?;
    let plane = |kind| planes.get(kind).unwrap_or_default().to_vec();
    Ok(ExactPicture { intensity: plane(PlaneKind::Intensity), range: plane(PlaneKind::Range) })
}

/// A kept picture; what is damaged or of another size is drawn again.
fn read(file: &PathBuf, pixels: usize) -> Option<ExactPicture> {
    let NpyData::F32(values) = files::read_npy(file, MOST_BYTES).ok()?.into_parts().1 else { return None };
    (values.len() == 2 * pixels).then(|| {
        let (intensity, range) = values.split_at(pixels);
        ExactPicture { intensity: intensity.to_vec(), range: range.to_vec() }
    })
}

fn write(file: &PathBuf, picture: &ExactPicture, [columns, lines]: [usize; 2]) -> Result<(), ReferenceError> {
    let values = [picture.intensity.as_slice(), &picture.range].concat();
    Ok(files::write_npy(file, &Npy::new(vec![2, lines, columns], NpyData::F32(values))?)?)
}
