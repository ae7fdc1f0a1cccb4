//! What the user says about an elevation file.

use crate::elevation::Affine;
use crate::error::SurveyError;

/// What the user knows better than the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ReadOptions {
    /// Band with the heights, from 1; needed where a file has several.
    pub band: Option<usize>,
    /// Metres a stored unit; in place of the file's own scale.
    pub scale: Option<f64>,
    /// Metres added after scaling; in place of the file's own offset.
    pub offset: Option<f64>,
    /// Stored values that mark voids; in place of the file's own. Empty: the file's own.
    pub no_data: Vec<f64>,
    /// Metres from line to line and from column to column, for files without a place.
    pub spacing: Option<[f64; 2]>,
    /// Whether the first line is the southernmost, for files without a place. Default false: the northernmost.
    pub first_line_south: bool,
    /// Names of tags, keys and keywords that are not known here and that change neither heights nor their place:
    /// `KEYWORD` or `object:NAME` of a label, `tag:NUMBER`, `key:NUMBER` or `item:NAME` of a TIFF; `checksum` of a DTED
    /// cell.
    pub ignore: Vec<String>,
}

impl ReadOptions {
    /// Refuses numbers that no reader can use.
    pub fn check(&self) -> Result<(), SurveyError> {
        let refuse = |option, found: String, expected: &str| {
            Err(SurveyError::Option { option, found, expected: expected.to_string() })
        };
        if let Some(scale) = self.scale.filter(|scale| !scale.is_finite() || *scale == 0.0) {
            return refuse("scale", scale.to_string(), "a finite number other than 0");
        }
        if let Some(offset) = self.offset.filter(|offset| !offset.is_finite()) {
            return refuse("offset", offset.to_string(), "a finite number of metres");
        }
        let bad = |spacing: &[f64; 2]| !spacing.iter().all(|step| step.is_finite() && *step > 0.0);
        if let Some(spacing) = self.spacing.filter(bad) {
            return refuse("spacing", format!("{spacing:?}"), "two lengths above 0 m");
        }
        Ok(())
    }

    /// Refuses options for files without a place, of one that has it.
    pub fn expect_no_place(&self) -> Result<(), SurveyError> {
        let given = [
            ("spacing", self.spacing.map(|[north, east]| format!("{north},{east}"))),
            ("first line south", self.first_line_south.then(|| "true".to_owned())),
        ];
        let given = given.into_iter().find_map(|(option, found)| Some((option, found?)));
        given.map_or(Ok(()), |(option, found)| {
            let expected = "nothing: the file itself says where its samples lie".to_owned();
            Err(SurveyError::Option { option, found, expected })
        })
    }

    /// Place of the samples of a file that says nothing about it.
    pub fn own_place(&self, lines: usize) -> Option<Affine> {
        let [north, east] = self.spacing?;
        Some(if self.first_line_south {
            Affine { first: [0.0; 2], step: [north, east] }
        } else {
            Affine { first: [(lines - 1) as f64 * north, 0.0], step: [-north, east] }
        })
    }
}
