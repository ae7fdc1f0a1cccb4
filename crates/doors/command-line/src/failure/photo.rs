//! Errors of photographs as failures of a command.

use photo_check::GroundError;
use photo_make::{MakeError, WriteError};
use photograph::PhotoError;

use crate::Failure;

impl From<MakeError> for Failure {
    fn from(error: MakeError) -> Self {
        match error {
            MakeError::Wish { .. }
            | MakeError::Centre { .. }
            | MakeError::UnderGround { .. }
            | MakeError::NoGround { .. } => Self::usage(error),
            other => Self::input(other),
        }
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        match error {
            WriteError::Folder(error) => error.into(),
            WriteError::File(error) => error.into(),
            WriteError::Picture(error) => error.into(),
        }
    }
}

impl From<PhotoError> for Failure {
    fn from(error: PhotoError) -> Self {
        match error {
            PhotoError::File(error) => error.into(),
            PhotoError::Picture(error) => error.into(),
            other => Self::input(other),
        }
    }
}

impl From<GroundError> for Failure {
    fn from(error: GroundError) -> Self {
        Self::input(error)
    }
}
