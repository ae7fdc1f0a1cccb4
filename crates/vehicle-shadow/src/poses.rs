//! Poses of a picture sequence: `poses.csv` of a run, or of anybody else.

use std::collections::BTreeMap;
use std::path::Path;

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
    /// Of the vehicle.
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
    let reading = Reading { path, expected: format!("a header, and lines with {}", COLUMNS.join(", ")) };
    let text = String::from_utf8(bytes).map_err(|_| reading.fault(None, "bytes that are no text".into()))?;
    let mut lines =
        (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    let (first, header) = lines.next().ok_or_else(|| reading.fault(None, "nothing".into()))?;
    let header: Vec<&str> = header.split(',').map(str::trim).collect();
    let place = |name: &str| header.iter().position(|column| *column == name);
    if let Some(name) = COLUMNS.iter().find(|name| place(name).is_none()) {
        return Err(reading.fault(Some(first), format!("no column `{name}`")));
    }
    let columns = Columns {
        needed: COLUMNS.map(|name| place(name).unwrap_or_default()),
        yoke: place(YOKE),
        height: place(HEIGHT),
    };
    let mut poses = BTreeMap::new();
    for (line, words) in lines {
        let words: Vec<&str> = words.split(',').map(str::trim).collect();
        if words.len() != header.len() {
            return Err(
                reading.fault(Some(line), format!("{} values under {} columns", words.len(), header.len()))
            );
        }
        let (frame, pose) = Row { reading: &reading, words, line }.pose(&columns)?;
        if poses.insert(frame, pose).is_some() {
            return Err(reading.fault(Some(line), format!("frame {frame} a second time")));
        }
    }
    if poses.is_empty() {
        return Err(reading.fault(None, "no poses".into()));
    }
    let times: Vec<(&u64, &FramePose)> = poses.iter().collect();
    match times.windows(2).find(|pair| pair[1].1.time <= pair[0].1.time) {
        None => Ok(poses),
        Some(pair) => {
            let what =
                format!("frame {} at {} s is not after frame {}", pair[1].0, pair[1].1.time, pair[0].0);
            Err(reading.fault(None, what))
        }
    }
}

/// Where the columns stand.
struct Columns {
    needed: [usize; 8],
    yoke: Option<usize>,
    height: Option<usize>,
}

struct Reading<'a> {
    path: &'a Path,
    expected: String,
}

impl Reading<'_> {
    fn fault(&self, line: Option<u64>, what: String) -> AugmentError {
        AugmentError::Content { path: self.path.to_owned(), line, what, expected: self.expected.clone() }
    }
}

struct Row<'a> {
    reading: &'a Reading<'a>,
    words: Vec<&'a str>,
    line: u64,
}

impl Row<'_> {
    fn fault(&self, what: String) -> AugmentError {
        self.reading.fault(Some(self.line), what)
    }

    fn number(&self, place: usize) -> Result<f64, AugmentError> {
        let word = self.words[place];
        let number = word.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| self.fault(format!("`{word}` is no finite number")))
    }

    fn pose(&self, columns: &Columns) -> Result<(u64, FramePose), AugmentError> {
        let word = self.words[columns.needed[0]];
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
