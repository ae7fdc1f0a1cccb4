//! Poses of a picture sequence: `poses.csv` of a run, or of anybody else.

use std::collections::BTreeMap;
use std::path::Path;

use diagnostics::{Placed, Problem, Problems};
use landscape::Attitude;
use quantities::radians;
use scenario::{Waypoint, other_unit};
use tables::{Clock, Column, Form, Row, Table, read_text};

use crate::{AugmentError, Camera, Shot};

const FRAME: usize = 0;
const T: usize = 1;
const PLACE: [usize; 3] = [2, 3, 4];
const ANGLES: [usize; 3] = [5, 6, 7];
/// Angle of the picture, where it is not the vehicle's roll.
const YOKE: usize = 8;
/// Height of the eye above the ground, where the vehicle does not stand.
const HEIGHT: usize = 9;

/// Degrees of a radian.
const DEGREES: f64 = 180.0 / std::f64::consts::PI;

/// The table of poses.
const FORM: Form = Form {
    what: "table of poses",
    columns: &[
        Column::needed("frame"),
        Column::needed("t_s"),
        Column::needed("x_m"),
        Column::needed("y_m"),
        Column::needed("z_m"),
        Column::needed("heading_deg").also(&[("heading_rad", DEGREES)]),
        Column::needed("pitch_deg").also(&[("pitch_rad", DEGREES)]),
        Column::needed("roll_deg").also(&[("roll_rad", DEGREES)]),
        Column::optional("yoke_deg").also(&[("yoke_rad", DEGREES)]),
        Column::optional("height_m"),
    ],
    // Columns of `poses.csv` and `truth/poses.csv` of a run that follow from the others.
    harmless: &[
        "speed_m_s",
        "turn_deg_s",
        "slope_deg",
        "r11",
        "r12",
        "r13",
        "r21",
        "r22",
        "r23",
        "r31",
        "r32",
        "r33",
        "sun_azimuth_deg",
        "sun_elevation_deg",
        "sun_north",
        "sun_east",
        "sun_up",
    ],
};

/// Largest place and height (m), and largest angle (degrees): a hundred turns.
const FARTHEST: f64 = 1e9;
const MOST_DEGREES: f64 = 36_000.0;

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
    /// Where the vehicle was, and whither it looked.
    fn waypoint(&self) -> Waypoint {
        let ([x, y, _], heading) = (self.eye, Some(self.attitude.heading));
        Waypoint { time: self.time, at: [x, y], heading, eye_height: None, pitch: None, roll: None }
    }

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

/// Poses of a sequence by frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Poses {
    /// The pose of each frame.
    pub by_frame: BTreeMap<u64, FramePose>,
    /// What the user should know of how they were read, in words.
    pub notes: Vec<String>,
}

/// Reads poses by frame: a table with a header, columns `frame, t_s, x_m, y_m, z_m, heading_deg, pitch_deg, roll_deg` in any
/// order, and if they are there `yoke_deg` and `height_m`. The crate `tables` says what else a table may look like.
///
/// # Errors
/// Every fault of the table, with its line: the first twenty of them in full.
pub fn read_poses(path: &Path) -> Result<Poses, AugmentError> {
    let problems = Problems::new();
    let by_frame = read_into(path, &problems);
    let notes = problems.take_notes();
    Ok(Poses { by_frame: problems.resolve(by_frame)?, notes })
}

fn read_into(path: &Path, problems: &Problems) -> Option<BTreeMap<u64, FramePose>> {
    let mut table = Table::with_header(read_text(path, problems)?, &FORM);
    let (mut clock, mut poses) = (Clock::from_zero(), BTreeMap::new());
    while let Some(mut row) = table.next_row() {
        let Some((frame, pose)) = pose(&mut row, &mut clock) else { continue };
        if poses.contains_key(&frame) {
            row.refuse(FRAME, "a frame that no row before has");
            continue;
        }
        poses.insert(frame, Placed { value: pose, place: row.place(T), key: "t_s".into() });
    }
    let column = table.name(ANGLES[0]);
    let poses = table.finish(poses, problems)?;
    let waypoints: Vec<Waypoint> = poses.values().map(|pose| pose.value.waypoint()).collect();
    let doubt = column.and_then(|column| other_unit(column, &waypoints));
    clock
        .note()
        .into_iter()
        .chain(doubt)
        .for_each(|note| problems.note(format!("{}: {note}", path.display())));
    let late = poses.values().zip(poses.values().skip(1)).find(|(a, b)| b.value.time <= a.value.time);
    if let Some((before, pose)) = late {
        let title =
            format!("t = {} s is not after the frame before, at {} s", pose.value.time, before.value.time);
        problems.push(Problem::of(pose, title).expected("times that ascend from frame to frame"));
        return None;
    }
    Some(poses.into_iter().map(|(frame, pose)| (frame, pose.value)).collect())
}

fn pose(row: &mut Row, clock: &mut Clock) -> Option<(u64, FramePose)> {
    let is_frame = |frame: f64| (0.0..=1e15).contains(&frame) && frame.fract() == 0.0;
    let frame = row.number_that(FRAME, is_frame, "a frame number, whole and from 0");
    let time = row.time(T, clock);
    let [x, y, z] = PLACE.map(|column| row.number(column, -FARTHEST..=FARTHEST));
    let [heading, pitch, roll] =
        ANGLES.map(|column| row.number(column, -MOST_DEGREES..=MOST_DEGREES).map(radians));
    let yoke = if row.has(YOKE) { Some(row.number(YOKE, -MOST_DEGREES..=MOST_DEGREES)?) } else { None };
    let is_up = |height: f64| height > 0.0 && height <= FARTHEST;
    let height =
        if row.has(HEIGHT) { Some(row.number_that(HEIGHT, is_up, "a height above 0 m")?) } else { None };
    let attitude = Attitude { roll: roll?, pitch: pitch?, heading: heading? };
    let pose = FramePose { time: time?, eye: [x?, y?, z?], attitude, yoke: yoke.map(radians), height };
    Some((frame? as u64, pose))
}
