//! Where the eye was, how it looked, and where the light came from, frame by frame.

use std::fmt::Write;

use generator::Stage;
use landscape::{Attitude, Sun};
use quantities::degrees;
use scenario::{Pose, PoseRow};
use serde_json::{Value, json};

use crate::camera::camera;

/// Name of the schema of `poses.json`.
const SCHEMA: &str = "lunoid.truth-poses/1";

/// One frame in numbers.
struct Row {
    frame: u64,
    pose: Pose,
    /// Rows of the matrix from vehicle axes, as the picture is drawn, to terrain axes.
    rotation: [[f64; 3]; 3],
    sun: Sun,
}

impl Row {
    fn new(stage: &Stage, row: &PoseRow) -> Self {
        let pose = row.pose;
        // The picture turns with the yoke, not with the vehicle.
        let drawn = Attitude { roll: pose.yoke, ..pose.attitude };
        let matrix = drawn.to_terrain();
        let rotation = std::array::from_fn(|i| std::array::from_fn(|j| matrix.col(j)[i]));
        Self { frame: row.frame, pose, rotation, sun: stage.scenery.sun(pose.time) }
    }

    /// Heading, pitch, roll, yoke (deg).
    fn angles(&self) -> [f64; 4] {
        let Attitude { roll, pitch, heading } = self.pose.attitude;
        [heading, pitch, roll, self.pose.yoke].map(degrees)
    }

    fn document(&self) -> Value {
        let [heading, pitch, roll, yoke] = self.angles();
        json!({
            "frame": self.frame,
            "time_s": self.pose.time,
            "eye_m": self.pose.eye,
            "heading_deg": heading,
            "pitch_deg": pitch,
            "roll_deg": roll,
            "yoke_deg": yoke,
            "rotation": self.rotation,
            "sun": {
                "azimuth_deg": degrees(self.sun.azimuth),
                "elevation_deg": degrees(self.sun.elevation),
                "direction": self.sun.direction(),
            },
        })
    }

    fn line(&self) -> String {
        let sun = [self.sun.azimuth, self.sun.elevation].map(degrees);
        let numbers = [self.pose.time].into_iter().chain(self.pose.eye).chain(self.angles());
        let numbers = numbers.chain(self.rotation.into_iter().flatten());
        let numbers = numbers.chain(sun).chain(self.sun.direction());
        let mut line = self.frame.to_string();
        for number in numbers {
            write!(line, ",{number}").expect("a String takes everything");
        }
        line
    }
}

/// The columns of `poses.csv`.
const COLUMNS: &str = "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,yoke_deg,\
    r11,r12,r13,r21,r22,r23,r31,r32,r33,\
    sun_azimuth_deg,sun_elevation_deg,sun_north,sun_east,sun_up";

/// All frames as a table.
pub(super) fn csv(stage: &Stage, rows: &[PoseRow]) -> String {
    let lines = rows.iter().map(|row| Row::new(stage, row).line() + "\n");
    format!("{COLUMNS}\n{}", lines.collect::<String>())
}

/// All frames, with the camera and what the numbers mean.
pub(super) fn document(stage: &Stage, rows: &[PoseRow]) -> Value {
    json!({
        "schema": SCHEMA,
        "camera": camera(stage),
        "eye_words": "north, east, height above the lunoid's tangent plane (m)",
        "rotation_words":
            "rows of the matrix from vehicle axes, turned by heading, pitch and the yoke's angle as the picture is \
             drawn, to north, east, down",
        "sun_words": "direction is the unit vector to the sun: north, east, up",
        "frames": rows.iter().map(|row| Row::new(stage, row).document()).collect::<Vec<_>>(),
    })
}
