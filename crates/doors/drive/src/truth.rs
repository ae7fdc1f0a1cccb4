//! What each pixel of a frame shows, by closed form.

use files::NpyData;
use generator::{PlaneKind, Planes};
use replay::{TRUTH_ERROR, TruthItem, TruthItems};
use signal::Probe;

use crate::{Drive, DriveError, Viewpoint};

/// Values of a plane.
#[derive(Debug, Clone, PartialEq)]
pub enum Codes {
    /// Numbers in the unit of the plane.
    Numbers(Vec<f32>),
    /// Codes, whose words are in [`TruthPlane::codes`].
    Codes(Vec<u8>),
}

/// One kind of truth.
#[derive(Debug, Clone, PartialEq)]
pub struct TruthPlane {
    /// Name, as in `truth/*.npz` of a run.
    pub name: &'static str,
    /// Unit of its values; 1 for plain numbers and codes.
    pub unit: &'static str,
    /// Lines, columns, and 3 behind them for a vector.
    pub shape: Vec<usize>,
    /// Values line by line from the top left.
    pub values: Codes,
    /// Words of the codes, in their order; none for numbers.
    pub codes: Vec<&'static str>,
    /// Largest error of a value, as a share of it; 0 for codes.
    pub bound: f64,
}

/// The truth of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Truth {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// What was asked for, in the order of the files.
    pub planes: Vec<TruthPlane>,
    /// How wrong the numbers may be, in words.
    pub error: &'static [&'static str],
}

impl Drive {
    /// Names of all planes of truth, in the order of the files.
    pub fn truth_names() -> Vec<&'static str> {
        let planes = TruthItem::ALL.into_iter().filter(|item| !item.kinds().is_empty());
        planes.map(TruthItem::name).collect()
    }

    /// The truth of frame `frame` of the path.
    ///
    /// # Errors
    /// If there is no such frame, or as [`Viewpoint::truth`].
    pub fn truth(&self, frame: u64, names: &str) -> Result<Truth, DriveError> {
        self.at(frame)?.truth(names)
    }
}

impl Viewpoint<'_> {
    /// The truth of the frame: `names` of [`TruthPlane`]s, joined by commas, or `all`.
    ///
    /// # Errors
    /// If there is no truth of a name, or it cannot be drawn.
    pub fn truth(&self, names: &str) -> Result<Truth, DriveError> {
        let Self { drive, bench, frame, pose } = self;
        let file = drive.file();
        let items: TruthItems = names.parse().map_err(|error| DriveError::of(file, &error))?;
        let (items, others): (Vec<TruthItem>, Vec<_>) =
            items.iter().partition(|item| !item.kinds().is_empty());
        let is_named = |item: &&TruthItem| names.split(',').any(|word| word.trim() == item.name());
        if let Some(other) = others.iter().find(is_named) {
            let title = format!("`{}` is no plane", other.name());
            return Err(DriveError::asked(
                file,
                title,
                format!("some of {}", Drive::truth_names().join(", ")),
            ));
        }
        let kinds: Vec<PlaneKind> = items.iter().flat_map(|item| item.kinds()).copied().collect();
        let view = &bench.stage.view;
        let mut planes = Planes::new(view.columns as usize, view.lines as usize, &kinds);
        let judge = bench.judge(&drive.pool, file)?;
        let drawn = drive.pool.install(|| judge.frame(*frame, pose, &mut planes, &mut Probe::off()));
        drawn.map_err(|error| DriveError::of(file, &error))?;
        let planes = items.into_iter().map(|item| plane(item, &planes));
        let planes = planes.collect::<Result<_, _>>().map_err(|error| DriveError::of(file, &error))?;
        Ok(Truth { frame: *frame, planes, error: &TRUTH_ERROR })
    }
}

fn plane(item: TruthItem, planes: &Planes) -> Result<TruthPlane, files::NpyError> {
    let (shape, data) = item.array(planes)?.into_parts();
    let values = match data {
        NpyData::U8(codes) => Codes::Codes(codes),
        NpyData::F32(numbers) => Codes::Numbers(numbers),
        other => Codes::Numbers(other.to_f64().into_iter().map(|value| value as f32).collect()),
    };
    Ok(TruthPlane {
        name: item.name(),
        unit: item.kinds().first().map_or("1", |kind| kind.unit()),
        shape,
        values,
        codes: item.words(),
        bound: item.bound(),
    })
}
