//! The text file of a landscape.

mod distributions;
mod features;
mod growth;
mod named;
mod texture;

use std::collections::BTreeMap;
use std::path::Path;

use diagnostics::{Problem, ProblemList, Problems, Reader, TomlFile};
use files::read_all;
use limits::Limit;
use quantities::radians;

use crate::description::{BaseWish, Description, Feature};
use crate::frame::{Frame, MOON_RADIUS};
use crate::grid::Grid;
use crate::refused::Refused;
use crate::sunlight::Light;
use crate::switches::{Reported, Switch};

/// Format of the file that is read.
pub const FORMAT: u64 = 1;

impl Description {
    /// Reads a landscape file.
    ///
    /// # Errors
    /// Every fault of the file, by line and column.
    pub fn read(path: &Path) -> Result<Self, ProblemList> {
        let name = path.display().to_string();
        let folder = path.parent().unwrap_or(Path::new(""));
        match read_all(path, Limit::TextBytes) {
            Ok(bytes) => parse(folder, |problems| TomlFile::parse_bytes(&name, &bytes, problems)),
            Err(error) => Err(Problem::of_file(&name, error.to_string()).into()),
        }
    }

    /// Reads the text of a landscape file. `name` is for messages; files that the text names lie in `folder`.
    ///
    /// # Errors
    /// Every fault of the text, by line and column.
    pub fn parse(name: &str, text: &str, folder: &Path) -> Result<Self, ProblemList> {
        parse(folder, |problems| TomlFile::parse(name, text, problems))
    }
}

fn parse(
    folder: &Path,
    file: impl FnOnce(&Problems) -> Option<TomlFile>,
) -> Result<Description, ProblemList> {
    let problems = Problems::new();
    let file = file(&problems);
    let description = file.as_ref().and_then(|file| described(&file.root(&problems), folder));
    problems
        .resolve(description)
        .map_err(|faults| file.map_or(faults.clone(), |file| named::named(faults, &file)))
}

fn described(root: &Reader, folder: &Path) -> Option<Description> {
    if !root.format_version(FORMAT) {
        return None;
    }
    let title = root.string("title").default("Untitled".into());
    let place = root.table("area").and_then(|area| area_of(&area));
    let base = base(&root.table_or_empty("base"), folder);
    let reported = reported(root);
    let light = root.optional_table("light").map(|light| light_of(&light));
    // Features lie in the frame: without one, theirs are not judged.
    let features = match &place {
        Some((frame, grid)) => features(root, frame, grid, folder),
        None => {
            root.know("feature");
            root.tables("feature").iter().for_each(Reader::ignore_rest);
            None
        }
    };
    root.finish();
    let ((frame, grid), light) = (place?, written(light)?);
    Some(Description {
        title: title?,
        frame,
        grid,
        base: base?,
        features: features?,
        reported: reported?,
        light,
    })
}

/// A table that is not there, or its value; nothing where it has a fault.
fn written<T>(table: Option<Option<T>>) -> Option<Option<T>> {
    table.map_or(Some(None), |value| value.map(Some))
}

/// What a check says, or a problem at the key that it names.
fn checked<T>(table: &Reader, result: Result<T, Refused>) -> Option<T> {
    result
        .map_err(|refused| {
            let title =
                format!("`{}` is {}: expected {}", table.path(refused.key), refused.found, refused.expected);
            table.report(table.problem(refused.key, title).found(refused.found).expected(refused.expected));
        })
        .ok()
}

/// A range of two angles in degrees.
fn range(table: &Reader, key: &str) -> Option<[f64; 2]> {
    table.f64_array::<2>(key).between(-360.0, 360.0).map(|range| range.map(radians)).required()
}

fn area_of(area: &Reader) -> Option<(Frame, Grid)> {
    let radius = area.f64("radius_m").default(MOON_RADIUS);
    let (longitude, latitude) = (range(area, "longitude_deg"), range(area, "latitude_deg"));
    let resolution = area.f64("resolution_m").required();
    let exponent = area.u32("tile_exponent").default(5);
    let frame = checked(area, Frame::new(radius?, longitude?, latitude?))?;
    let grid = checked(area, Grid::new(&frame, resolution?, exponent?))?;
    Some((frame, grid))
}

fn base(table: &Reader, folder: &Path) -> Option<BaseWish> {
    let height = table.f64("height_m").between(-1e6, 1e6).optional();
    let (file, band) = (table.string("file").optional(), table.usize("band").between(1, 10_000).optional());
    match (table.has("file"), table.has("height_m")) {
        (true, true) => {
            let title = format!("`{}` beside `{}`", table.path("height_m"), table.path("file"));
            table.report(table.problem("height_m", title).expected("a level, or a file, and not both"));
            None
        }
        (true, false) if !table.has("band") || band.is_some() => {
            Some(BaseWish::File { path: folder.join(file?), band })
        }
        (true, false) => None,
        (false, true) => height.map(BaseWish::Level),
        (false, false) => Some(BaseWish::Level(0.0)),
    }
}

fn reported(root: &Reader) -> Option<Reported> {
    let words = root.string_list("as_reported").default(Vec::new())?;
    let switch = |word: &String| {
        let found = Switch::ALL.iter().find(|(name, _)| name == word);
        if found.is_none() {
            let known = Switch::ALL.map(|(name, _)| name);
            let problem =
                root.problem("as_reported", format!("`as_reported` has {word:?}, which is no switch"));
            let problem = problem.found(word.as_str()).expected(format!("some of {}", known.join(", ")));
            let alike = diagnostics::nearest(word, &known).map(|word| format!("did you mean {word:?}?"));
            root.report(Problem { help: alike, ..problem });
        }
        found.map(|(_, switch)| *switch)
    };
    words.iter().map(switch).collect::<Vec<_>>().into_iter().collect()
}

fn light_of(table: &Reader) -> Option<Light> {
    let colour = |key, usual: [f64; 3]| table.f64_array::<3>(key).between(0.0, 1.0).default(usual);
    let sub_solar = table.f64_array::<2>("sub_solar_deg").between(-360.0, 360.0).required();
    // Chosen: black shadows and a grey surface.
    let (ambient, diffuse) = (colour("ambient", [0.0; 3]), colour("diffuse", [1.0; 3]));
    Some(Light { sub_solar: sub_solar?.map(radians), ambient: ambient?, diffuse: diffuse? })
}

/// Features in the order of their names. Names differ.
fn features(root: &Reader, frame: &Frame, grid: &Grid, folder: &Path) -> Option<Vec<Feature>> {
    let mut found: BTreeMap<String, Feature> = BTreeMap::new();
    let tables = root.tables("feature");
    let count = tables.len();
    let mut covered = texture::Covered::default();
    for table in &tables {
        let Some(feature) = features::feature(table, frame, grid, folder) else { continue };
        if found.contains_key(&feature.id) {
            let title = format!("`{}`: a feature before it has the name {:?}", table.path("id"), feature.id);
            table.report(table.problem("id", title).expected("a name of its own"));
        } else if covered.take(table, &feature) {
            found.insert(feature.id.clone(), feature);
        }
    }
    (found.len() == count).then(|| found.into_values().collect())
}
