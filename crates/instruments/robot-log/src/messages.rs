//! Messages in Foxglove's schemas.

use foxglove::messages::{
    CameraCalibration, CompressedImage, FrameTransform, FrameTransforms, Log, Pose as LoggedPose,
    PosesInFrame, Quaternion, RawImage, Timestamp, Vector3, log::Level,
};
use replay::Pinhole;
use scenario::{Pose, View};

use crate::axes::{Placement, camera_in_vehicle, vehicle_in_site};
use crate::late::LateWord;

/// Axes of the ground: x east, y north, z up.
pub const SITE: &str = "site";
/// Axes of the vehicle: x forward, y to port, z up, with their origin at the eye.
pub const VEHICLE: &str = "vehicle";
/// Axes of the camera: x right, y down, z ahead.
pub const CAMERA: &str = "camera";

/// An instant (ns since the start of the mission) as messages have it; `None` beyond 136 years.
pub fn timestamp(time: u64) -> Option<Timestamp> {
    const SECOND: u64 = 1_000_000_000;
    Some(Timestamp::new(u32::try_from(time / SECOND).ok()?, (time % SECOND) as u32))
}

/// A picture as the run keeps it: the bytes of a PNG.
pub fn picture(time: Timestamp, png: Vec<u8>) -> CompressedImage {
    CompressedImage { timestamp: Some(time), frame_id: CAMERA.into(), data: png.into(), format: "png".into() }
}

/// Depth (m), row by row.
pub fn depth(time: Timestamp, view: &View, depth: &[f32]) -> RawImage {
    let data = depth.iter().flat_map(|metres| metres.to_le_bytes()).collect();
    raw(time, view, ("32FC1", 4), data)
}

/// Codes of what is seen, row by row.
pub fn labels(time: Timestamp, view: &View, codes: Vec<u8>) -> RawImage {
    raw(time, view, ("8UC1", 1), codes)
}

fn raw(time: Timestamp, view: &View, (encoding, bytes): (&str, u32), data: Vec<u8>) -> RawImage {
    RawImage {
        timestamp: Some(time),
        frame_id: CAMERA.into(),
        width: view.columns,
        height: view.lines,
        encoding: encoding.into(),
        step: view.columns * bytes,
        data: data.into(),
    }
}

/// The pinhole camera, without distortion.
pub fn calibration(time: Timestamp, view: &View) -> CameraCalibration {
    let rows = Pinhole::of(view).matrix();
    CameraCalibration {
        timestamp: Some(time),
        frame_id: CAMERA.into(),
        width: view.columns,
        height: view.lines,
        distortion_model: "plumb_bob".into(),
        d: vec![0.0; 5],
        k: rows.concat(),
        r: vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
        p: rows.iter().flat_map(|[x, y, z]| [*x, *y, *z, 0.0]).collect(),
    }
}

/// Site to vehicle, and vehicle to camera.
pub fn transforms(time: Timestamp, pose: &Pose) -> FrameTransforms {
    let link = |parent: &str, child: &str, placement: Placement| FrameTransform {
        timestamp: Some(time),
        parent_frame_id: parent.into(),
        child_frame_id: child.into(),
        translation: Some(vector(&placement)),
        rotation: Some(quaternion(&placement)),
    };
    let links = [link(SITE, VEHICLE, vehicle_in_site(pose)), link(VEHICLE, CAMERA, camera_in_vehicle(pose))];
    FrameTransforms { transforms: links.into() }
}

/// Where the vehicle is in all frames of the log.
pub fn path<'a>(time: Timestamp, poses: impl Iterator<Item = &'a Pose>) -> PosesInFrame {
    let pose = |pose| {
        let placement = vehicle_in_site(pose);
        LoggedPose { position: Some(vector(&placement)), orientation: Some(quaternion(&placement)) }
    };
    PosesInFrame { timestamp: Some(time), frame_id: SITE.into(), poses: poses.map(pose).collect() }
}

/// Late words of a sweep that a message lists one by one. Chosen: a screen of a viewer has them, and a log of a machine that is late
/// all the time stays small.
const MOST_LINES: usize = 8;

/// The late words of one sweep of frame `frame`, at least one, in the words that `lunoid trace` has.
pub fn late_words(time: Timestamp, frame: u64, words: &[LateWord]) -> Log {
    let first = &words[0];
    let mut message = format!("frame {frame}, sweep {}: {} late", first.sweep, words.len());
    words.iter().take(MOST_LINES).for_each(|word| message += &format!("\n{}", word.text));
    if words.len() > MOST_LINES {
        let (more, sweep) = (words.len() - MOST_LINES, first.sweep);
        message +=
            &format!("\nand {more} more: `lunoid trace` with --frame {frame} --sweep {sweep} lists them");
    }
    Log {
        timestamp: Some(time),
        level: Level::Warning as i32,
        message,
        name: first.unit.clone(),
        file: String::new(),
        line: 0,
    }
}

fn vector(placement: &Placement) -> Vector3 {
    let [x, y, z] = placement.origin.to_array();
    Vector3 { x, y, z }
}

fn quaternion(placement: &Placement) -> Quaternion {
    let [x, y, z, w] = placement.xyzw();
    Quaternion { x, y, z, w }
}
