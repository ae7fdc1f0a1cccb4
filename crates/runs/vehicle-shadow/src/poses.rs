//! Poses of a picture sequence: `poses.csv` of a run, or of anybody else.

use std::collections::BTreeMap;
use std::path::Path;

use diagnostics::{CsvRow, CsvRows};
use files::read_all;
use landscape::Attitude;
use limits::Limit;
use quantities::radians;

use crate::{AugmentError, Camera, Shot};

/// Columns that must be there.
const COLUMNS: [&str; 8] = ["frame", "t_s", "x_m", "y_m", "z_m", "heading_deg", "pitch_deg", "roll_deg"];
/// Angle of the picture, where it is not the vehicle's roll.
const YOKE: &str = "yoke_deg";
/// Height of the eye above the ground, where the vehicle does not stand.
const HEIGHT: &str = "height_m";

/// Where the eye was in one frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FramePose {
    /// Seconds since the start of the mission.
    pub time: f64,
    /// North, east, height above the tangent plane (m).
    pub eye: [f64; 3],
    /// Roll, pitch and heading of the vehicle.
    pub attitude: Attitude,
    /// Angle by which the picture is turned (rad), if the file says it.
    pub yoke: Option<f64>,
    /// Height of the eye above the ground (m), if the file says it.
    pub height: Option<f64>,
}

impl FramePose {
    /// The shot of `camera` there; a vehicle whose height is not told stands with its eye `eye_height` (m) up.
    pub fn shot(&self, camera: &Camera, eye_height: f64) -> Shot {
        let drawn = if camera.rolls { self.attitude.roll } else { 0.0 };
        Shot {
            time: self.time,
            eye: self.eye,
            height: self.height.unwrap_or(eye_height),
            vehicle: self.attitude,
            camera: Attitude { roll: self.yoke.unwrap_or(drawn), ..self.attitude },
            field: camera.field,
        }
    }
}

/// Reads poses by frame: a CSV file with a header, columns `frame, t_s, x_m, y_m, z_m, heading_deg, pitch_deg, roll_deg`
/// in any order, and if they are there `yoke_deg` and `height_m`; others are not looked at. Lines that begin with `#` are
/// skipped.
///
/// # Errors
/// The first fault, with its line.
pub fn read_poses(path: &Path) -> Result<BTreeMap<u64, FramePose>, AugmentError> {
    let bytes = read_all(path, Limit::ListBytes)?;
    let expected = format!("a header, and lines with {}", COLUMNS.join(", "));
    let text = match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(_) => {
            return Err(Reading { path, expected, text: "" }.fault(None, "bytes that are no text".into()));
        }
    };
    let reading = Reading { path, expected, text: &text };
    let mut rows = CsvRows::new(&text);
    let header = rows.next_row().ok_or_else(|| reading.fault(None, "nothing".into()))?;
    reading.expect_closed(&header)?;
    let (columns, width) = (Columns::of(&reading, &header)?, header.width());
    let mut poses = BTreeMap::new();
    while let Some(row) = rows.next_row() {
        let row = Row { reading: &reading, row };
        if !Limit::Rows.allows(poses.len() as u64 + 1) {
            let expected = format!("at most {} rows; {}", Limit::Rows.value(), Limit::Rows);
            return Err(Reading { expected, ..reading }.fault(Some(&row.row), "one row more".into()));
        }
        let (frame, pose) = row.pose(&columns, width)?;
        if poses.insert(frame, pose).is_some() {
            return Err(row.fault(format!("frame {frame} a second time")));
        }
    }
    reading.expect_ascending(&poses)?;
    Ok(poses)
}

/// Where the columns stand.
struct Columns {
    needed: [usize; 8],
    yoke: Option<usize>,
    height: Option<usize>,
}

impl Columns {
    fn of(reading: &Reading, header: &CsvRow) -> Result<Self, AugmentError> {
        let place = |name: &str| header.texts().position(|column| column == name);
        if let Some(name) = COLUMNS.iter().find(|name| place(name).is_none()) {
            return Err(reading.fault(Some(header), format!("no column `{name}`")));
        }
        Ok(Self {
            needed: COLUMNS.map(|name| place(name).unwrap_or_default()),
            yoke: place(YOKE),
            height: place(HEIGHT),
        })
    }
}

struct Reading<'a> {
    path: &'a Path,
    expected: String,
    text: &'a str,
}

impl Reading<'_> {
    fn fault(&self, row: Option<&CsvRow>, what: String) -> AugmentError {
        let line = |row: &CsvRow| self.text[..row.whole().start].matches('\n').count() as u64 + 1;
        let (path, line) = (self.path.to_owned(), row.map(line));
        AugmentError::Content { path, line, what, expected: self.expected.clone() }
    }

    fn expect_closed(&self, row: &CsvRow) -> Result<(), AugmentError> {
        match row.open_quote() {
            Some(_) => Err(self.fault(Some(row), "a quote that is not closed".into())),
            None => Ok(()),
        }
    }

    /// There are poses, and they are later from frame to frame.
    fn expect_ascending(&self, poses: &BTreeMap<u64, FramePose>) -> Result<(), AugmentError> {
        if poses.is_empty() {
            return Err(self.fault(None, "no poses".into()));
        }
        let later = |((_, a), (_, b)): &((&u64, &FramePose), (&u64, &FramePose))| b.time > a.time;
        match poses.iter().zip(poses.iter().skip(1)).find(|pair| !later(pair)) {
            None => Ok(()),
            Some(((before, _), (frame, pose))) => {
                let what = format!("frame {frame} at {} s is not after frame {before}", pose.time);
                Err(self.fault(None, what))
            }
        }
    }
}

struct Row<'a> {
    reading: &'a Reading<'a>,
    row: CsvRow<'a>,
}

impl Row<'_> {
    fn fault(&self, what: String) -> AugmentError {
        self.reading.fault(Some(&self.row), what)
    }

    fn number(&self, place: usize) -> Result<f64, AugmentError> {
        let word = self.row.text(place);
        let number = word.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| self.fault(format!("`{word}` is no finite number")))
    }

    fn pose(&self, columns: &Columns, width: usize) -> Result<(u64, FramePose), AugmentError> {
        self.reading.expect_closed(&self.row)?;
        if self.row.width() != width {
            return Err(self.fault(format!("{} values under {width} columns", self.row.width())));
        }
        let word = self.row.text(columns.needed[0]);
        let frame = word.parse().map_err(|_| self.fault(format!("`{word}` is no frame number")))?;
        let mut numbers = [0.0; 7];
        for (number, &place) in numbers.iter_mut().zip(&columns.needed[1..]) {
            *number = self.number(place)?;
        }
        let [time, x, y, z, heading, pitch, roll] = numbers;
        let [heading, pitch, roll] = [heading, pitch, roll].map(radians);
        let height = columns.height.map(|place| self.number(place)).transpose()?;
        if let Some(height) = height.filter(|height| *height <= 0.0) {
            return Err(self.fault(format!("the eye {height} m above the ground")));
        }
        let yoke = columns.yoke.map(|place| self.number(place)).transpose()?.map(radians);
        Ok((
            frame,
            FramePose { time, eye: [x, y, z], attitude: Attitude { roll, pitch, heading }, yoke, height },
        ))
    }
}
