//! `lunoid augment`: the vehicle's shadow, and its tracks, in an existing picture sequence.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use landscape::Sun;
use quantities::radians;
use rayon::ThreadPool;
use replay::Progress;
use scenario::Vehicle;
use serde_json::{Value, json};
use timing::{Comparison, Tolerance, compare};
use vehicle_shadow::{
    AugmentError, Augmentation, Camera, DAC_BITS, FrameWork, GroundLaw, Method, OutlineRule, SUN_POINTS,
    ScanConverter, Sequence, Shape, TrueGround, USUAL_TRACKS, timing_record, tracks_along,
};

use crate::cli::COMMIT;
use crate::interrupt;
use crate::loading::{StageArgs, Threads};
use crate::output::{expect_writable, print, print_json, tell};
use crate::progress::Saying;
use crate::{Failure, Verdict, values};

/// What was done, beside the pictures.
const RECORD: &str = "augment.json";
/// Stands beside the poses of a run.
const CAMERA: &str = "camera.json";
/// Differences from a baseline that are told one by one.
const TOLD: usize = 60;
/// The ground that is no scenario.
const FLAT: &str = "flat";

const AFTER: &str = "Examples:
  lunoid augment runs/tracks/frames runs/tracks/poses.csv --vehicle rover --sun 268,19 --out shadowed
  lunoid augment FRAMES POSES --vehicle rover --sun 268,19 --out shadowed --method scan-converter --penumbra
  lunoid augment FRAMES POSES --vehicle rover --ground scenarios/tracks.toml --tracks --out shadowed
  lunoid augment FRAMES POSES --vehicle rover --sun 268,19 --out shadowed --baseline augment-timing.json

docs/blocks/vehicle-shadow.md has the formats of poses and camera.";

/// Put the vehicle's shadow, and its tracks, into an existing picture sequence.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Augment {
    /// Folder of grey PNG files whose names end in the number of their frame.
    frames: PathBuf,
    /// CSV file of their poses, as a run's poses.csv.
    poses: PathBuf,
    /// What casts the shadow: lander, rover, flag, package, marker, or a Wavefront OBJ file of convex parts.
    #[arg(long, value_name = "SHAPE")]
    vehicle: String,
    /// Azimuth (clockwise from north) and elevation of the sun, in degrees. That of the scenario if left out, with
    /// --ground SCENARIO.
    #[arg(long, value_name = "AZ,EL", value_parser = values::pair, allow_hyphen_values = true)]
    sun: Option<[f64; 2]>,
    /// Folder for the new pictures and their record.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// How the shadow gets into the video.
    #[arg(long, value_enum, default_value = "synchronised")]
    method: MethodWord,
    /// What the ground is: `flat`, or the scenario file whose ground the pictures show.
    #[arg(long, value_name = "flat|SCENARIO", default_value = FLAT)]
    ground: String,
    /// How parts become outlines on flat ground.
    #[arg(long, value_enum, default_value = "parts")]
    outline: OutlineWord,
    /// The sun is a disc of half a degree.
    #[arg(long)]
    penumbra: bool,
    /// Tracks along the poses as well; they need --ground SCENARIO.
    #[arg(long)]
    tracks: bool,
    /// Height of the eye above the vehicle's foot point, and above the ground where the poses have no column height_m.
    #[arg(long, value_name = "METRES", value_parser = values::positive)]
    eye_height: Option<f64>,
    /// File of the camera; camera.json beside the poses if left out.
    #[arg(long, value_name = "JSON", conflicts_with = "field")]
    camera: Option<PathBuf>,
    /// Angles of view in degrees, of a camera that rolls with the vehicle.
    #[arg(long, value_name = "WIDTH,HEIGHT", value_parser = values::pair)]
    field: Option<[f64; 2]>,
    /// Bits of the D/A converters of the synchronised method, over the width of the picture.
    #[arg(long, default_value_t = DAC_BITS, value_parser = clap::value_parser!(u32).range(4..=24))]
    dac_bits: u32,
    /// Limiting resolution of the scan converter, television lines a picture height.
    #[arg(long, default_value_t = ScanConverter::default().tv_lines, value_parser = clap::value_parser!(u32).range(50..=4000))]
    tv_lines: u32,
    /// How far the scan converter's shadow lies off to the right and down, in percent of the picture's height.
    #[arg(long, value_name = "RIGHT,DOWN", value_parser = values::pair, allow_hyphen_values = true)]
    registration: Option<[f64; 2]>,
    /// Share of the video that a fully written scan converter takes away, 0 to 1.
    #[arg(long, default_value_t = ScanConverter::default().gain, value_parser = share)]
    gain: f64,
    /// Write the timing of the pictures as a baseline, in the format of `lunoid timing record`.
    #[arg(long, value_name = "FILE")]
    timing: Option<PathBuf>,
    /// Hold the timing of the pictures to a baseline: exit code 0 it is met, 1 it is not.
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    saying: Saying,
}

/// What is under the vehicle.
struct Grounded {
    law: GroundLaw,
    vehicle: Vehicle,
    /// What decides it.
    inputs: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum MethodWord {
    /// Blanking where television lines cross outlines.
    Synchronised,
    /// An area written into a storage tube and mixed with the video.
    ScanConverter,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum OutlineWord {
    /// Every convex part by itself.
    Parts,
    /// The report's walk around all of them; holes are lost.
    Walk,
}

fn share(text: &str) -> Result<f64, String> {
    values::finite(text).and_then(|share| match (0.0..=1.0).contains(&share) {
        true => Ok(share),
        false => Err("expected 0 to 1".into()),
    })
}

impl Augment {
    /// Augments.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.expect_ground()?;
        self.timing.as_deref().map_or(Ok(()), expect_writable)?;
        let baseline = self.baseline.as_deref().map(timing::read).transpose()?;
        let pool = self.threads.pool()?;
        let sequence = Sequence::read(&self.frames, &self.poses, self.camera()?)?;
        let Grounded { law: ground, vehicle, inputs } = self.ground(&sequence, &pool)?;
        let eye_height = self.eye_height.unwrap_or(vehicle.eye_height);
        let shape = Shape::find(&self.vehicle, eye_height)?;
        let decided = self.decided(&shape, eye_height, &inputs);
        let augmentation = Augmentation {
            inputs: hash(&format!("{:?} {decided}", (env!("CARGO_PKG_VERSION"), COMMIT))),
            shape,
            eye_height,
            sun: self
                .sun
                .map(|[azimuth, elevation]| Sun { azimuth: radians(azimuth), elevation: radians(elevation) }),
            penumbra: self.penumbra,
            ground,
            method: self.method(),
        };
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let frames = sequence.frames().len() as u64;
        display.hear(Progress::Begins { what: "frames", frames, kept: 0 });
        let hear = |done| display.hear(Progress::Frame { done });
        let made = pool.install(|| augmentation.run(&sequence, &self.out, cancel, &hear));
        display.end();
        let made = made?;
        if (made.len() as u64) < frames {
            let done = made.len();
            tell(&format!(
                "interrupted: {done} of {frames} frames are whole; the same command again makes the rest\n"
            ));
            return Ok(Verdict::Interrupted);
        }
        let record = self.record(&augmentation, &sequence, &made);
        files::write_atomic(self.out.join(RECORD), |out| writeln!(out, "{record:#}"))?;
        let poses: Vec<_> = sequence.frames().iter().map(|frame| frame.pose).collect();
        let timing = timing_record(
            &self.vehicle,
            hash(&format!("{decided} {:?} {poses:?}", sequence.camera())),
            &augmentation.method,
            sequence.period(),
            &made,
        );
        if let Some(path) = &self.timing {
            timing::write(path, &timing)?;
        }
        let check = baseline.map(|baseline| compare(&baseline, &timing, &Tolerance::default()));
        self.print(record, check.as_ref())?;
        Ok(if check.is_none_or(|check| check.is_met()) { Verdict::Yes } else { Verdict::No })
    }

    /// What flat ground cannot give.
    fn expect_ground(&self) -> Result<(), Failure> {
        if self.ground != FLAT {
            return Ok(());
        }
        if self.tracks {
            return Err(Failure::usage(AugmentError::TracksWithoutGround));
        }
        match self.sun {
            Some(_) => Ok(()),
            None => Err(Failure::usage(
                "flat ground has no sun of its own; expected --sun AZIMUTH,ELEVATION in degrees",
            )),
        }
    }

    fn camera(&self) -> Result<Camera, Failure> {
        let beside = || self.poses.parent().unwrap_or(Path::new("")).join(CAMERA);
        match self.field {
            None => Ok(Camera::read(&self.camera.clone().unwrap_or_else(beside))?),
            Some([width, height]) => Camera::of_field([width, height]).ok_or_else(|| {
                Failure::usage(format!(
                    "--field {width},{height}: expected two angles above 0 and below 170 degrees"
                ))
            }),
        }
    }

    /// All that decides every picture of the sequence but the program, the camera and the pictures.
    fn decided(&self, shape: &Shape, eye_height: f64, ground: &str) -> String {
        let words = (self.sun, self.penumbra, self.method(), ground);
        format!("{shape:?} {eye_height:?} {words:?}")
    }

    /// The ground, and the vehicle that drives on it.
    fn ground(&self, sequence: &Sequence, pool: &ThreadPool) -> Result<Grounded, Failure> {
        if self.ground == FLAT {
            let rule = match self.outline {
                OutlineWord::Parts => OutlineRule::Parts,
                OutlineWord::Walk => OutlineRule::Walk,
            };
            let inputs = format!("{rule:?}");
            return Ok(Grounded { law: GroundLaw::Flat(rule), vehicle: Vehicle::default(), inputs });
        }
        let mut loaded = StageArgs::of(Path::new(&self.ground)).load()?;
        let stage = loaded.stage(pool)?;
        let vehicle = loaded.scenario.vehicle;
        let tracks = match self.tracks {
            true => {
                let tracks = loaded.scenario.tracks.unwrap_or(USUAL_TRACKS);
                tracks_along(sequence, &tracks, &vehicle, &stage.landscape)?
            }
            false => Vec::new(),
        };
        let inputs = format!("{:?} {:?} {tracks:?}", loaded.inputs.scenario, loaded.inputs.references);
        let ground = Box::new(pool.install(|| TrueGround::new(stage)));
        Ok(Grounded { law: GroundLaw::True { ground, tracks }, vehicle, inputs })
    }

    fn method(&self) -> Method {
        match self.method {
            MethodWord::Synchronised => Method::Synchronised { dac_bits: self.dac_bits },
            MethodWord::ScanConverter => {
                let usual = ScanConverter::default().registration;
                let registration = self.registration.map_or(usual, |percent| percent.map(|part| 0.01 * part));
                Method::ScanConverter(ScanConverter {
                    tv_lines: self.tv_lines,
                    registration,
                    gain: self.gain,
                })
            }
        }
    }

    fn record(&self, augmentation: &Augmentation, sequence: &Sequence, made: &[FrameWork]) -> Value {
        let function = augmentation.shape.function();
        let camera = sequence.camera();
        let most = |time: fn(&FrameWork) -> f64| made.iter().map(time).fold(0.0, f64::max);
        let largest = |count: fn(&FrameWork) -> u64| made.iter().map(count).max().unwrap_or(0);
        json!({
            "schema": "lunoid.augment/1",
            "program": { "name": "lunoid", "version": env!("CARGO_PKG_VERSION"), "commit": COMMIT },
            "frames_of": self.frames.display().to_string(),
            "poses": self.poses.display().to_string(),
            "camera": {
                "field_of_view_deg": camera.angles_of_view(),
                "roll_drawn": camera.rolls,
            },
            "vehicle": {
                "shape": self.vehicle,
                "eye_height_m": augmentation.eye_height,
                "figures": function.figures().len(),
                "string_points": function.points().len(),
                "points": function.vertices(),
            },
            "sun_deg": self.sun,
            "sun_points": if self.penumbra { SUN_POINTS } else { 1 },
            "ground": self.ground,
            "outline": matches!(augmentation.ground, GroundLaw::Flat(_)).then(|| word(&self.outline)),
            "track_patches": match &augmentation.ground {
                GroundLaw::Flat(_) => 0,
                GroundLaw::True { tracks, .. } => tracks.len(),
            },
            "method": method_record(&augmentation.method, word(&self.method)),
            "timing": {
                "picture_period_s": sequence.period(),
                "largest_setup_s": most(|frame| frame.times.setup_s),
                "largest_write_s": most(|frame| frame.times.write_s),
                "most_pictures": largest(|frame| frame.times.pictures),
                "most_line_generators": largest(|frame| frame.work.line_generators),
            },
            "frames": made,
        })
    }

    fn print(&self, mut record: Value, check: Option<&Comparison>) -> Result<(), Failure> {
        match (self.saying.json, self.saying.quiet) {
            (true, _) => {
                if let Some(check) = check {
                    record["timing_check"] = check.json();
                }
                print_json(&record)
            }
            (_, true) => Ok(()),
            _ => print(&(self.text(&record) + &check.map(|check| check.text(TOLD)).unwrap_or_default())),
        }
    }

    fn text(&self, record: &Value) -> String {
        let timing = &record["timing"];
        let ms = |key: &str| 1e3 * timing[key].as_f64().unwrap_or(0.0);
        let frames = record["frames"].as_array().map_or(0, Vec::len);
        format!(
            "{}: {frames} frames with the shadow of {}\n  gear of 1969: set-up {:.1} ms and writing {:.1} ms of a picture of \
             {:.1} ms, so a new shadow every {} pictures; {} line generators\n",
            self.out.display(),
            self.vehicle,
            ms("largest_setup_s"),
            ms("largest_write_s"),
            ms("picture_period_s"),
            timing["most_pictures"],
            timing["most_line_generators"],
        )
    }
}

fn hash(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex().to_string()
}

/// The word of the command line.
fn word(value: &impl ValueEnum) -> String {
    value.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

fn method_record(method: &Method, name: String) -> Value {
    match method {
        Method::Synchronised { dac_bits } => json!({ "name": name, "dac_bits": dac_bits }),
        Method::ScanConverter(ScanConverter { tv_lines, registration, gain }) => {
            json!({ "name": name, "tv_lines": tv_lines, "registration_share": registration, "gain": gain })
        }
    }
}

impl From<AugmentError> for Failure {
    fn from(error: AugmentError) -> Self {
        match error {
            AugmentError::File(error) => error.into(),
            AugmentError::Picture(error) => error.into(),
            AugmentError::Folder { doing: "list this folder", .. } => Self::input(error),
            AugmentError::Folder { .. } => Self::output(error),
            AugmentError::SameFolder { .. }
            | AugmentError::Sun { .. }
            | AugmentError::TracksWithoutGround => Self::usage(error),
            other => Self::input(other),
        }
    }
}
