//! Photographs of the ground, read.

use std::sync::Arc;

use photograph::Photograph;
use scenario::PhotographWish;

use crate::StageError;

/// The photographs that a scenario names, in its order.
///
/// # Errors
/// If one of their files cannot be read.
pub(crate) fn photographs(wishes: &[PhotographWish]) -> Result<Arc<[Photograph]>, StageError> {
    let read = |wish: &PhotographWish| {
        Photograph::read(&wish.file, &wish.camera)
            .map_err(|error| StageError::Photograph { file: wish.file.clone(), error: Box::new(error) })
    };
    wishes.iter().map(read).collect()
}
