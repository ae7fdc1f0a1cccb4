//! The robot log, read back.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use files::parse_npz;
use foxglove::Decode;
use foxglove::messages::{CameraCalibration, CompressedImage, FrameTransforms, Log, PosesInFrame, RawImage};
use glam::{DQuat, DVec3};
use landscape::LUNOID_RADIUS;
use mcap::{MessageStream, Summary};
use replay::HeldRun;
use robot_log::LateWord;

use crate::scene::{Made, Wish};

/// Messages of a topic with their times (ns).
type Topic<M> = Vec<(u64, M)>;

fn read<M: Decode>(log: &[u8], topic: &str) -> Topic<M>
where
    M::Error: std::fmt::Debug,
{
    let messages = MessageStream::new(log).expect("a log").map(|message| message.expect("a message"));
    let of_topic = messages.filter(|message| message.channel.topic == topic);
    of_topic.map(|message| (message.log_time, M::decode(&message.data[..]).expect("its schema"))).collect()
}

fn log_of(made: &Made) -> Vec<u8> {
    let file = made.beside("a.mcap");
    let outcome = made.write_log(&file).expect("a log");
    assert_eq!(outcome.done, outcome.frames);
    fs::read(file).expect("there")
}

/// Arrays of a frame of the truth.
fn truth(run: &Path, frame: usize) -> BTreeMap<String, Vec<f64>> {
    let bytes = fs::read(run.join(format!("truth/frame-{frame:06}.npz"))).expect("truth");
    let arrays = parse_npz(&bytes).expect("arrays").into_iter();
    arrays.map(|(name, array)| (name, array.data().to_f64())).collect()
}

#[test]
fn every_topic_has_its_messages_at_simulated_times() {
    let made = Made::new(Wish { refresh: true, ..Wish::default() });
    let log = log_of(&made);
    let summary = Summary::read(&log).expect("readable").expect("a summary");
    let schemas: BTreeMap<_, _> = summary
        .channels
        .values()
        .map(|channel| {
            let schema = channel.schema.as_ref().expect("a schema");
            assert_eq!(
                (schema.encoding.as_str(), channel.message_encoding.as_str()),
                ("protobuf", "protobuf")
            );
            (channel.topic.clone(), schema.name.clone())
        })
        .collect();
    let expected = [
        ("/camera/calibration", "foxglove.CameraCalibration"),
        ("/camera/depth", "foxglove.RawImage"),
        ("/camera/image", "foxglove.CompressedImage"),
        ("/camera/labels", "foxglove.RawImage"),
        ("/late_words", "foxglove.Log"),
        ("/path", "foxglove.PosesInFrame"),
        ("/tf", "foxglove.FrameTransforms"),
    ];
    assert_eq!(schemas, expected.map(|(topic, schema)| (topic.to_owned(), schema.to_owned())).into());
    let frames = [0, 66_666_667, 133_333_333];
    let depth: Topic<RawImage> = read(&log, "/camera/depth");
    assert_eq!(depth.iter().map(|(time, _)| *time).collect::<Vec<_>>(), frames);
    let stamps: Vec<_> =
        depth.iter().map(|(_, image)| image.timestamp.expect("a time").total_nanos()).collect();
    assert_eq!(stamps, frames);
    let pictures: Topic<CompressedImage> = read(&log, "/camera/image");
    let showings = [0, 33_333_333, 66_666_667, 100_000_000, 133_333_333, 166_666_667];
    assert_eq!(pictures.iter().map(|(time, _)| *time).collect::<Vec<_>>(), showings);
    for (index, (_, picture)) in pictures.iter().enumerate() {
        let png = fs::read(made.path().join(format!("frames/frame-{index:06}.png"))).expect("a picture");
        assert_eq!((picture.format.as_str(), &picture.data[..]), ("png", &png[..]), "{index}");
    }
    let path: Topic<PosesInFrame> = read(&log, "/path");
    assert_eq!((path.len(), path[0].1.poses.len(), path[0].1.frame_id.as_str()), (1, 3, "site"));
    assert_eq!(read::<Log>(&log, "/late_words").len(), 0);
}

/// Depth, camera matrix and transforms of the log lead each pixel back to the range and the height of the truth. A plane that is
/// transposed, or a quaternion in another order, leads elsewhere.
#[test]
fn pixel_depth_and_transforms_lead_back_to_the_truth() {
    let made = Made::new(Wish::default());
    let log = log_of(&made);
    let depth: Topic<RawImage> = read(&log, "/camera/depth");
    let labels: Topic<RawImage> = read(&log, "/camera/labels");
    let cameras: Topic<CameraCalibration> = read(&log, "/camera/calibration");
    let transforms: Topic<FrameTransforms> = read(&log, "/tf");
    let mut seen = [0, 0];
    for frame in 0..3 {
        let (image, label, camera) = (&depth[frame].1, &labels[frame].1, &cameras[frame].1);
        let truth = truth(&made.path(), frame);
        let (columns, lines) = (image.width as usize, image.height as usize);
        assert_ne!(columns, lines, "a square hides a transposed plane");
        assert_eq!(
            (image.encoding.as_str(), image.step as usize, image.data.len()),
            ("32FC1", 4 * columns, 4 * columns * lines)
        );
        assert_eq!(
            (label.encoding.as_str(), label.step as usize, label.data.len()),
            ("8UC1", columns, columns * lines)
        );
        let metres: Vec<f32> = image
            .data
            .chunks_exact(4)
            .map(|four| f32::from_le_bytes(four.try_into().expect("four")))
            .collect();
        let [to_site, to_vehicle] = [0, 1].map(|index| {
            let link = &transforms[frame].1.transforms[index];
            let (origin, turn) = (link.translation.expect("a place"), link.rotation.expect("a rotation"));
            (DVec3::new(origin.x, origin.y, origin.z), DQuat::from_xyzw(turn.x, turn.y, turn.z, turn.w))
        });
        let names: Vec<_> = transforms[frame]
            .1
            .transforms
            .iter()
            .map(|link| (link.parent_frame_id.as_str(), link.child_frame_id.as_str()))
            .collect();
        assert_eq!(names, [("site", "vehicle"), ("vehicle", "camera")]);
        for pixel in 0..columns * lines {
            assert_eq!(f64::from(label.data[pixel]), truth["label"][pixel], "{pixel}");
            if label.data[pixel] == 0 {
                assert_eq!(metres[pixel], f32::INFINITY, "sky at {pixel}");
                seen[0] += 1;
                continue;
            }
            let (u, v, z) = ((pixel % columns) as f64, (pixel / columns) as f64, f64::from(metres[pixel]));
            let in_camera =
                DVec3::new((u - camera.k[2]) / camera.k[0], (v - camera.k[5]) / camera.k[4], 1.0) * z;
            let to = to_site.1 * (to_vehicle.1 * in_camera + to_vehicle.0);
            let (range, place) = (to.truncate().length(), to_site.0 + to);
            assert!((range - truth["range"][pixel]).abs() < 1e-6 * range, "{range} m at {pixel}");
            let height = place.z + range * range / (2.0 * LUNOID_RADIUS);
            assert!((height - truth["height"][pixel]).abs() < 1e-3, "{height} m at {pixel}");
            seen[1] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
}

/// The log has a message for each sweep with late words, at the time of the first, and the words are as many as the run counts.
#[test]
fn late_words_come_at_their_time_with_the_words_of_the_listing() {
    let set = vec![("loader.access_ns", "40000")];
    let made = Made::new(Wish { machine: "pra-nominal", set, ..Wish::default() });
    let messages: Topic<Log> = read(&log_of(&made), "/late_words");
    let run = HeldRun::read(&made.path()).expect("a run");
    let (mut told, mut shortened) = (messages.iter(), 0);
    for (record, words) in run.frames.iter().zip(made.late_words()) {
        let count = |word: &LateWord| {
            let count = word.text.split("words ").nth(1).and_then(|rest| rest.split(',').next());
            count.and_then(|count| count.parse::<u64>().ok()).expect("a number of words")
        };
        let of_terrain = words.iter().filter(|word| word.text.contains(": registers late "));
        assert_eq!(Some(of_terrain.map(count).sum()), record.counts.get("late_words"));
        let (begin, end) = (record.frame * 1_000_000_000 / 15, (record.frame + 1) * 1_000_000_000 / 15 + 1);
        for words in words.chunk_by(|one, next| one.sweep == next.sweep) {
            let (time, log) = told.next().expect("a message");
            assert!((begin..=end).contains(time) && *time == words[0].time, "{time}: {}", log.message);
            assert_eq!(log.timestamp.expect("a time").total_nanos(), *time);
            assert_eq!((log.level, &log.name), (3, &words[0].unit));
            let mut lines = log.message.lines();
            let head = format!("frame {}, sweep {}: {} late", record.frame, words[0].sweep, words.len());
            assert_eq!(lines.next(), Some(head.as_str()));
            words.iter().take(8).for_each(|word| assert_eq!(lines.next(), Some(word.text.as_str())));
            let more = (words.len() > 8).then(|| format!("and {} more: ", words.len() - 8));
            shortened += u32::from(more.is_some());
            assert_eq!(lines.next().map(|line| line.split('`').next().unwrap_or_default()), more.as_deref());
        }
    }
    assert!(told.next().is_none() && !messages.is_empty() && shortened > 0);
}

#[test]
fn the_bytes_depend_on_the_run_alone() {
    let logs = [1, 3].map(|threads| log_of(&Made::new(Wish { threads, ..Wish::default() })));
    assert!(logs[0] == logs[1]);
}
