//! What a page reads of the record of a run.

use std::ops::Deref;
use std::path::Path;

use diagnostics::{ProblemList, Problems};
use hardware_model::MachineRecord;
use picture::Curve;
use replay::{HeldRun, picture_name};
use run_record::{FrameRecord, RunRecord};
use serde::Deserialize;
use tables::{Column, Form, Row, Table, decode};

use crate::ReportError;

const POSES: &str = "poses.csv";
/// Name of the hybrid machine in a record.
const HYBRID: &str = "hybrid";
const MAX_BYTES: u64 = 1 << 30;

/// A run as its record says.
#[derive(Debug)]
pub(crate) struct Run {
    record: RunRecord,
    /// Settings of the hybrid machine, where it drew.
    pub machine: Option<MachineRecord>,
    /// Time, eye and attitude of its frames.
    pub poses: Vec<[f64; 7]>,
}

impl Deref for Run {
    type Target = RunRecord;

    fn deref(&self) -> &RunRecord {
        &self.record
    }
}

impl Run {
    /// The curve of its display, by which colours of its frames become grey.
    pub fn curve(&self) -> Curve {
        Curve::Power(self.view.display.gamma)
    }

    /// The run in `folder`.
    pub fn read(folder: &Path) -> Result<Self, ReportError> {
        let held = HeldRun::read(folder)?;
        let path = folder.join(replay::RUN_RECORD);
        let refused = |reason: String| ReportError::Content { path: path.clone(), reason };
        let record = held.into_record();
        if record.frames.is_empty() || record.frames[0].files.is_empty() || record.view.columns == 0 {
            return Err(refused("it lists no frame, expected at least one".into()));
        }
        let machine = match record.generator.as_str() {
            HYBRID => Some(MachineRecord::deserialize(&record.settings)),
            _ => None,
        };
        let machine = machine.transpose().map_err(|error| refused(error.to_string()))?;
        let poses = poses(folder, &record.frames)?;
        let run = Self { record, machine, poses };
        let expected = (run.first_picture()..).map(picture_name);
        let found = run.frames.iter().flat_map(|frame| &frame.files).map(|file| &file.file);
        match expected.zip(found).find(|(expected, found)| expected != *found) {
            Some((expected, found)) => {
                Err(refused(format!("it lists the picture `{found}`, expected `{expected}`")))
            }
            None => Ok(run),
        }
    }

    /// Pictures of a frame: more than one if there is one for each that the tube shows.
    pub fn showings(&self) -> u64 {
        self.frames[0].files.len() as u64
    }

    /// Index of the first picture of the run.
    pub fn first_picture(&self) -> u64 {
        self.frames[0].frame * self.showings()
    }

    /// Pictures of the run.
    pub fn pictures(&self) -> u64 {
        self.frames.len() as u64 * self.showings()
    }

    /// Returns the rate at which pictures are shown (Hz).
    pub fn picture_rate(&self) -> f64 {
        let view = &self.view;
        let clock = if self.pictures.one_file_for_each == "refresh" { &view.refresh } else { &view.update };
        hertz(clock).unwrap_or(30.0)
    }

    /// The options of a replay that draws the same pictures, each after a space.
    pub fn picture_words(&self) -> String {
        let depth = if self.pictures.depth == 8 {
            String::new()
        } else {
            format!(" --depth {}", self.pictures.depth)
        };
        let refresh = if self.pictures.one_file_for_each == "refresh" { " --refresh" } else { "" };
        depth + refresh
    }

    /// Width of the screen over its height.
    pub fn aspect(&self) -> f64 {
        let [width, height] = self.view.field_of_view_deg.map(tangent_of_half);
        let aspect = width / height;
        if aspect.is_finite() && aspect > 0.0 { aspect } else { 1.0 }
    }

    /// Whether the hybrid machine drew it, with sweeps and signals.
    pub fn has_sweeps(&self) -> bool {
        self.machine.is_some()
    }
}

fn tangent_of_half(degrees: f64) -> f64 {
    libm::tan(degrees.to_radians() / 2.0)
}

/// A clock as a record writes it: `30 Hz`, `30000/1001 Hz`.
fn hertz(clock: &str) -> Option<f64> {
    let number = clock.strip_suffix(" Hz")?;
    let (above, below) = number.split_once('/').unwrap_or((number, "1"));
    let rate = above.trim().parse::<f64>().ok()? / below.trim().parse::<f64>().ok()?;
    (rate.is_finite() && rate > 0.0).then_some(rate)
}

/// The table `poses.csv` of a run: a frame, its time, eye and attitude.
const POSES_FORM: Form = Form {
    what: "table of poses",
    columns: &[
        Column::needed("frame"),
        Column::needed("t_s"),
        Column::needed("x_m"),
        Column::needed("y_m"),
        Column::needed("z_m"),
        Column::needed("heading_deg"),
        Column::needed("pitch_deg"),
        Column::needed("roll_deg"),
    ],
    harmless: &["speed_m_s", "turn_deg_s", "slope_deg"],
};

/// Time, eye and attitude of `frames`: seven numbers each, in the order of the file.
fn poses(folder: &Path, frames: &[FrameRecord]) -> Result<Vec<[f64; 7]>, ReportError> {
    let path = folder.join(POSES);
    let bytes = files::read_all(&path, MAX_BYTES)?;
    let refused = |reason: String| ReportError::Content { path: path.clone(), reason };
    let poses = table(&path.display().to_string(), bytes).map_err(|list| refused(first(&list)))?;
    if poses.len() != frames.len() {
        let (found, expected) = (poses.len(), frames.len());
        return Err(refused(format!("{found} rows, expected one for each of {expected} frames")));
    }
    Ok(poses)
}

fn table(name: &str, bytes: Vec<u8>) -> Result<Vec<[f64; 7]>, ProblemList> {
    let problems = Problems::new();
    let read = decode(name, bytes, &problems).and_then(|source| {
        let mut table = Table::with_header(source, &POSES_FORM);
        let mut poses = Vec::new();
        while let Some(mut row) = table.next_row() {
            poses.extend(pose(&mut row));
        }
        table.finish(poses, &problems)
    });
    problems.resolve(read)
}

fn pose(row: &mut Row) -> Option<[f64; 7]> {
    let numbers: Vec<Option<f64>> =
        (1..POSES_FORM.columns.len()).map(|column| row.number(column, f64::MIN..=f64::MAX)).collect();
    numbers.into_iter().collect::<Option<Vec<f64>>>()?.try_into().ok()
}

/// The first fault with its line, in a sentence.
fn first(list: &ProblemList) -> String {
    let record = list.iter().next().map(diagnostics::Problem::record);
    record.map_or(String::new(), |record| {
        let line = record.line.map(|line| format!("line {line}: ")).unwrap_or_default();
        format!("{line}{}", record.title)
    })
}

#[cfg(test)]
mod tests {
    use super::{hertz, table};

    #[test]
    fn clocks_are_fractions() {
        assert_eq!(hertz("30 Hz"), Some(30.0));
        assert_eq!(hertz("30000/1001 Hz"), Some(30000.0 / 1001.0));
        for wrong in ["", "30", "0 Hz", "1/0 Hz", "x Hz", "-3 Hz"] {
            assert_eq!(hertz(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn rows_of_poses() {
        let header = "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,speed_m_s,turn_deg_s,slope_deg\n";
        let read = |row: &str| table("poses.csv", format!("{header}{row}\n").into_bytes());
        assert_eq!(read("3,0.5,1,2,3,4,5,6,7,8,9"), Ok(vec![[0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]]));
        for wrong in ["", "3,0.5,1,2", "3,0.5,1,2,x,4,5,6,7,8,9", "3,0.5,1,2,NaN,4,5,6,7,8,9"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
