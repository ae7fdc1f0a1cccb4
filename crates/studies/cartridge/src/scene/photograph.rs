//! A photograph that stands in its cartridge: levels by a formula or one by one, and its camera file as a table.

use photograph::{PhotoFile, Photograph, read_photo_file};
use picture::{Depth, GreyPicture};
use serde::Deserialize;
use toml::Table;

use super::within;

/// A photograph of the ground, in 16 bits.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct InlinePhotograph {
    /// Levels of its pixels.
    pub levels: Levels,
    /// Its camera file or map file: the keys that docs/photo.md lists.
    #[cfg_attr(test, schemars(with = "serde_json::Map<String, serde_json::Value>"))]
    pub camera: Table,
}

/// Levels of pixels, 0 to 1, line by line from the top.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Levels {
    /// Each pixel by itself.
    Rows {
        /// Lines from the top, each from the left.
        rows: Vec<Vec<f64>>,
    },
    /// `first + across I + down J` at the middles of pixels, where I is 0.5 in the first column and J is 0.5 in the first line.
    Ramp {
        /// Columns and lines of the picture.
        size: [usize; 2],
        /// Level at the upper left corner of the picture.
        first: f64,
        /// Level from one column to the next.
        across: f64,
        /// Level from one line to the next.
        down: f64,
    },
    /// Dark and bright squares in turn, the upper left one dark.
    Checker {
        /// Columns and lines of the picture.
        size: [usize; 2],
        /// Side of a square (pixels).
        square: usize,
        /// Level of the dark squares.
        dark: f64,
        /// Level of the bright squares.
        bright: f64,
    },
}

/// Columns and lines at most.
const MOST_SIDE: usize = 1024;

impl InlinePhotograph {
    /// The photograph that its levels and camera make.
    pub(super) fn made(&self) -> Result<Photograph, String> {
        let text = serde_json::to_string(&self.camera).map_err(|error| error.to_string())?;
        let file = read_photo_file("photograph.camera", &text)
            .map_err(|problem| format!("{}: {}", problem.file, problem.title))?;
        let PhotoFile { placement, light } = file;
        Photograph::new(self.levels.picture()?, placement, light)
            .map_err(|error| format!("photograph.camera: {error}"))
    }
}

impl Levels {
    fn picture(&self) -> Result<GreyPicture, String> {
        let [columns, lines] = self.size()?;
        let white = f64::from(Depth::Sixteen.white());
        let code = |pixel: usize| {
            let level = self.at([pixel % columns, pixel / columns]);
            within("photograph.levels", level, 0.0, 1.0).map(|()| (level * white).round() as u16)
        };
        let codes = (0..columns * lines).map(code).collect::<Result<Vec<u16>, String>>()?;
        GreyPicture::new(columns, lines, Depth::Sixteen, codes).map_err(|error| error.to_string())
    }

    /// Columns and lines, if they make a picture.
    fn size(&self) -> Result<[usize; 2], String> {
        let size = match self {
            Self::Rows { rows } => {
                let columns = rows.first().map_or(0, Vec::len);
                if let Some(line) = rows.iter().position(|row| row.len() != columns) {
                    let found = rows[line].len();
                    return Err(format!(
                        "photograph.levels.rows: row {line} has {found} levels: expected {columns}, as row 0 has"
                    ));
                }
                [columns, rows.len()]
            }
            Self::Ramp { size, .. } | Self::Checker { size, .. } => *size,
        };
        if let Self::Checker { square: 0, .. } = self {
            return Err("photograph.levels.square = 0: expected 1 or more".into());
        }
        match size.iter().all(|side| (1..=MOST_SIDE).contains(side)) {
            true => Ok(size),
            false => {
                Err(format!("photograph.levels: {size:?} columns and lines: expected 1 to {MOST_SIDE} each"))
            }
        }
    }

    /// Level of a pixel of the picture.
    fn at(&self, [column, line]: [usize; 2]) -> f64 {
        match self {
            Self::Rows { rows } => rows[line][column],
            Self::Ramp { first, across, down, .. } => {
                first + across * (column as f64 + 0.5) + down * (line as f64 + 0.5)
            }
            Self::Checker { square, dark, bright, .. } => {
                if (column / square + line / square).is_multiple_of(2) { *dark } else { *bright }
            }
        }
    }
}
