//! What can be made of a finished run, and whether this build can make it.

use crate::LogError;

/// Whether this build writes robot logs.
pub const MCAP_IN_THIS_BUILD: bool = cfg!(feature = "mcap");
/// Whether this build writes OpenEXR files.
pub const EXR_IN_THIS_BUILD: bool = cfg!(feature = "exr");

/// What can be made of a finished run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// One robot log in MCAP.
    Mcap,
    /// One OpenEXR file a frame.
    Exr,
}

impl Form {
    /// Returns the option of `lunoid replay` that asks for it.
    pub fn option(self) -> &'static str {
        match self {
            Self::Mcap => "--mcap",
            Self::Exr => "--exr",
        }
    }

    /// Returns the cargo feature that brings it in.
    pub fn feature(self) -> &'static str {
        match self {
            Self::Mcap => "mcap",
            Self::Exr => "exr",
        }
    }

    /// Refuses what this build cannot make.
    ///
    /// # Errors
    /// [`LogError::NotInThisBuild`].
    pub fn expect_built(self) -> Result<(), LogError> {
        let is_built = match self {
            Self::Mcap => MCAP_IN_THIS_BUILD,
            Self::Exr => EXR_IN_THIS_BUILD,
        };
        if is_built { Ok(()) } else { Err(LogError::NotInThisBuild(self)) }
    }
}

#[cfg(test)]
mod tests {
    use super::Form;

    #[test]
    fn what_is_not_in_this_build_is_refused_by_name() {
        let built = [(Form::Mcap, cfg!(feature = "mcap")), (Form::Exr, cfg!(feature = "exr"))];
        for (form, is_built) in built {
            let said = form.expect_built().map_err(|error| error.to_string());
            match said {
                Ok(()) => assert!(is_built),
                Err(said) => {
                    assert!(!is_built && said.contains(form.option()), "{said}");
                    assert!(said.contains(&format!("--features {}", form.feature())), "{said}");
                }
            }
        }
    }
}
