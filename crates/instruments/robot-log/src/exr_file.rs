//! Frames as OpenEXR: picture and truth in named layers, one file a frame.

use std::collections::HashMap;
use std::io::{Cursor, Write};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use exr::prelude::{
    AnyChannel, AnyChannels, AttributeValue, Encoding, FlatSamples, Image, Layer, LayerAttributes, Text,
    WritableImage,
};
use files::{Npy, NpyData};
use picture::{AnyPicture, Limits, SOFTWARE, Transfer, decode_any_png};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use replay::{Control, EXR, Pinhole, Progress, TruthItem, exr_name};
use scenario::PoseRow;
use serde_json::{Value, json};

use crate::{FinishedRun, FrameFiles, LogError, Outcome, camera_in_vehicle, depth, vehicle_in_site};

/// Name of the one attribute of ours. The library keeps other attributes in no order, so that two would make two files.
const ATTRIBUTE: &str = "lunoid";

/// Channels of a file with their names.
type Channels = Vec<AnyChannel<FlatSamples>>;

/// Writes a file for each frame of `run` into its folder, picture and truth in named layers. A file that is there and right stays.
///
/// # Errors
/// If a frame cannot be read, somebody else has a file of the name, or a file cannot be written.
pub fn write_exr(run: &FinishedRun, control: &Control) -> Result<Outcome, LogError> {
    let rows = run.rows();
    let display = &run.view().display;
    let transfer = Transfer::new(display.white as f32, display.gamma as f32).map_err(LogError::Display)?;
    run.folder().expect_own(rows.iter().map(|row| exr_name(row.frame)))?;
    run.folder().make(EXR)?;
    let (frames, done) = (rows.len() as u64, AtomicU64::new(0));
    (control.progress)(Progress::Begins { what: "OpenEXR files", frames, kept: 0 });
    let one = |row: &PoseRow| {
        if control.cancel.load(Ordering::Relaxed) {
            return Ok(());
        }
        let path = run.folder().path().join(exr_name(row.frame));
        let bytes = encode(run, row, &transfer, &path)?;
        if !files::holds(&path, &bytes) {
            files::write_atomic(&path, |out: &mut dyn Write| out.write_all(&bytes))?;
        }
        (control.progress)(Progress::Frame { done: done.fetch_add(1, Ordering::Relaxed) + 1 });
        Ok::<(), LogError>(())
    };
    control.pool.install(|| rows.par_iter().try_for_each(one))?;
    Ok(Outcome { frames, done: done.into_inner() })
}

/// The bytes of the file of a frame.
fn encode(run: &FinishedRun, row: &PoseRow, transfer: &Transfer, path: &Path) -> Result<Vec<u8>, LogError> {
    let files = run.frame(row.frame)?;
    let mut channels = light(&files, transfer)?;
    for (item, array) in &files.truth {
        channels.extend(layers(run, row, *item, array));
    }
    let size = (run.view().columns as usize, run.view().lines as usize);
    let attributes = LayerAttributes {
        software_name: Some(Text::from(SOFTWARE.1)),
        other: HashMap::from([(
            Text::from(ATTRIBUTE),
            AttributeValue::Text(about(run, row).to_string().as_str().into()),
        )]),
        ..LayerAttributes::default()
    };
    let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, AnyChannels::sort(channels.into()));
    let mut bytes = Cursor::new(Vec::new());
    let written = Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes);
    written.map_err(|error| LogError::Pack { path: path.to_owned(), reason: error.to_string() })?;
    Ok(bytes.into_inner())
}

/// Linear light of the last picture of the frame: `Y`, or `R`, `G` and `B`.
fn light(files: &FrameFiles, transfer: &Transfer) -> Result<Channels, LogError> {
    let Some((png, path)) = files.pictures.last().zip(files.paths.last()) else { return Ok(Vec::new()) };
    let read = decode_any_png(png, &Limits::default());
    let picture = read.map_err(|source| LogError::Picture { path: path.clone(), source })?;
    let depth = picture.depth();
    let intensity = |code: u16| transfer.intensity(code, depth);
    Ok(match &picture {
        AnyPicture::Grey(grey) => vec![numbers("Y", grey.codes().iter().map(|code| intensity(*code)))],
        AnyPicture::Colour(colour) => {
            let channel =
                |(at, name)| numbers(name, colour.pixels().iter().map(|pixel| intensity(pixel[at])));
            ["R", "G", "B"].into_iter().enumerate().map(channel).collect()
        }
    })
}

/// Layers of one array of the truth.
fn layers(run: &FinishedRun, row: &PoseRow, item: TruthItem, array: &Npy) -> Channels {
    match (item, array.data()) {
        (TruthItem::Distance, NpyData::F32(distance)) => {
            let metres = depth(run.view(), &row.pose, distance);
            vec![numbers("depth.Z", metres.into_iter()), numbers(item.name(), distance.iter().copied())]
        }
        (TruthItem::Normal, NpyData::F32(values)) => {
            // From north, east, up to the axes of the site.
            let part = |at: usize| values.iter().skip(at).step_by(3).copied();
            vec![numbers("normal.X", part(1)), numbers("normal.Y", part(0)), numbers("normal.Z", part(2))]
        }
        (_, NpyData::F32(values)) => vec![numbers(item.name(), values.iter().copied())],
        (_, NpyData::U8(codes)) => {
            let codes = codes.iter().map(|code| u32::from(*code)).collect();
            vec![AnyChannel::new(item.name(), FlatSamples::U32(codes))]
        }
        _ => Vec::new(),
    }
}

fn numbers(name: &str, values: impl Iterator<Item = f32>) -> AnyChannel<FlatSamples> {
    AnyChannel::new(name, FlatSamples::F32(values.collect()))
}

/// What the file is of, and what its numbers mean.
fn about(run: &FinishedRun, row: &PoseRow) -> Value {
    let [vehicle, camera] = [vehicle_in_site(&row.pose), camera_in_vehicle(&row.pose)];
    let place = |placement: crate::Placement| json!({ "origin_m": placement.origin.to_array(), "quaternion_xyzw": placement.xyzw() });
    json!({
        "schema": "lunoid.exr/1",
        "scenario": run.record().scenario.title,
        "generator": run.record().generator,
        "run_fingerprint": run.record().fingerprint,
        "truth_fingerprint": run.truth().map(|truth| &truth.fingerprint),
        "frame": row.frame,
        "time_s": row.pose.time,
        "vehicle_in_site": place(vehicle),
        "camera_in_vehicle": place(camera),
        "axes": "site: east, north, up; vehicle: forward, port, up, origin at the eye; camera: right, down, ahead",
        "camera_matrix": Pinhole::of(run.view()).matrix(),
        "projection": Pinhole::reach(run.view().laws.projection),
        "picture": "linear light of the codes of the picture: white (code / largest) ^ gamma",
        "white": run.view().display.white,
        "gamma": run.view().display.gamma,
        "depth.Z": "metres ahead along the axis of view; sky is infinity",
        "normal": "outward unit normal in the axes of the site; sky is 0, 0, 0",
        "truth": run.truth().map(|truth| &truth.planes),
    })
}
