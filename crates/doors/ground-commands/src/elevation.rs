//! What a command line says about an elevation file.

use std::path::Path;

use clap::Args;
use survey::{Elevation, ReadOptions};

use command_line::output::{Place, tell};
use command_line::values;

/// What the user knows better than an elevation file.
#[derive(Debug, Args)]
pub struct ElevationArgs {
    /// Metres a stored unit, in place of the file's own.
    #[arg(long, value_parser = values::of_heights, allow_hyphen_values = true)]
    scale: Option<f64>,
    /// Metres added after scaling, in place of the file's own.
    #[arg(long, value_name = "METRES", value_parser = values::of_heights, allow_hyphen_values = true)]
    offset: Option<f64>,
    /// Stored values that mark voids, in place of the file's own, as -9999 or -9999,0.
    #[arg(long, value_name = "VALUES", value_delimiter = ',', allow_hyphen_values = true)]
    no_data: Vec<f64>,
    /// A tag, key or keyword of the file that is not known and that changes neither heights nor their place. Repeat it for
    /// several.
    #[arg(long, value_name = "NAME")]
    ignore: Vec<String>,
    /// Band with the heights, from 1.
    #[arg(long, value_parser = values::at_least(0_usize))]
    band: Option<usize>,
    /// Metres between samples of a file that does not say: one number, or one to the north and one to the east.
    #[arg(long, value_name = "METRES[,METRES]", value_parser = spacing)]
    spacing_m: Option<[f64; 2]>,
    /// The first line of a file without a place is the southernmost.
    #[arg(long)]
    first_line_south: bool,
}

fn spacing(text: &str) -> Result<[f64; 2], String> {
    if text.contains(',') { values::two_metres(text) } else { values::metres(text).map(|one| [one; 2]) }
}

/// Endings of labels, headers, coordinate systems and of the samples beside them.
const BESIDE: [&str; 17] = [
    "lbl", "LBL", "img", "IMG", "xml", "XML", "dat", "DAT", "cub", "hdr", "prj", "bin", "raw", "bsq", "bil",
    "bip", "dem",
];

/// What is read of an elevation file: a label and its image are two files, whichever of them is named.
pub fn sources(elevation: &Path) -> Vec<Place> {
    let beside = BESIDE.map(|ending| elevation.with_extension(ending));
    let both =
        beside.into_iter().filter(|path| path.is_file()).map(|path| Place::file("the label or image", path));
    [Place::file("the elevation file", elevation)].into_iter().chain(both).collect()
}

impl ElevationArgs {
    /// The options as the readers take them.
    pub fn options(&self) -> ReadOptions {
        ReadOptions {
            band: self.band,
            scale: self.scale,
            offset: self.offset,
            no_data: self.no_data.clone(),
            spacing: self.spacing_m,
            first_line_south: self.first_line_south,
            ignore: self.ignore.clone(),
        }
    }

    /// The first of the options that is given.
    pub fn given(&self) -> Option<&'static str> {
        let options = [
            (self.scale.is_some(), "--scale"),
            (self.offset.is_some(), "--offset"),
            (!self.no_data.is_empty(), "--no-data"),
            (!self.ignore.is_empty(), "--ignore"),
            (self.band.is_some(), "--band"),
            (self.spacing_m.is_some(), "--spacing-m"),
            (self.first_line_south, "--first-line-south"),
        ];
        options.into_iter().find_map(|(is_given, name)| is_given.then_some(name))
    }

    /// Whole numbers are how files of another unit than the metre look when they do not name their scale.
    pub fn warn_of_unit(&self, elevation: &Elevation) {
        let is_flat = elevation.range().is_none_or(|[low, high]| low == high);
        if self.scale.is_none() && !is_flat && elevation.is_whole() {
            tell(
                "warning: every height is a whole number and no --scale was given: heights taken as metres; give \
                 --scale if they are not\n",
            );
        }
    }
}
