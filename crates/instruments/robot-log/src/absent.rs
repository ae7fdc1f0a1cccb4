//! What a build without the feature says.

#[cfg(not(feature = "exr"))]
pub use exr::write_exr;
#[cfg(not(feature = "mcap"))]
pub use mcap::{expect_own_log, write_mcap};

#[cfg(not(feature = "mcap"))]
mod mcap {
    use std::path::Path;

    use replay::Control;

    use crate::{FinishedRun, Form, LateWords, LogError, Outcome};

    /// Refuses every file: this build writes no robot logs.
    ///
    /// # Errors
    /// [`LogError::NotInThisBuild`] always.
    pub fn expect_own_log(_file: &Path) -> Result<(), LogError> {
        Err(LogError::NotInThisBuild(Form::Mcap))
    }

    /// Refuses to write: this build writes no robot logs.
    ///
    /// # Errors
    /// [`LogError::NotInThisBuild`] always.
    pub fn write_mcap(
        _run: &FinishedRun,
        _late: Option<&LateWords>,
        _file: &Path,
        _control: &Control,
    ) -> Result<Outcome, LogError> {
        Err(LogError::NotInThisBuild(Form::Mcap))
    }
}

#[cfg(not(feature = "exr"))]
mod exr {
    use replay::Control;

    use crate::{FinishedRun, Form, LogError, Outcome};

    /// Refuses to write: this build writes no OpenEXR files.
    ///
    /// # Errors
    /// [`LogError::NotInThisBuild`] always.
    pub fn write_exr(_run: &FinishedRun, _control: &Control) -> Result<Outcome, LogError> {
        Err(LogError::NotInThisBuild(Form::Exr))
    }
}
