//! `lunoid augment`: the vehicle's shadow, and its tracks, in an existing picture sequence.

mod probing;
mod told;

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use landscape::Sun;
use quantities::radians;
use rayon::ThreadPool;
use replay::Progress;
use scenario::Vehicle;
use timing::{Tolerance, compare};
use vehicle_shadow::{
    AugmentError, Augmentation, Camera, DAC_BITS, GroundLaw, Look, MadeFrom, Method, OutlineRule,
    ScanConverter, Sequence, ShadowFolder, Shape, TrueGround, USUAL_TRACKS, timing_record, tracks_along,
};

use command_line::interrupt;
use command_line::loading::{StageArgs, Threads};
use command_line::output::{Place, expect_outputs, tell, warn};
use command_line::program::COMMIT;
use command_line::progress::Saying;
use command_line::{Failure, Verdict, values};

use probing::{Probing, Recording};

/// Stands beside the poses of a run.
const CAMERA: &str = "camera.json";
/// The ground that is no scenario.
const FLAT: &str = "flat";

const AFTER: &str = "Examples:
  lunoid augment runs/tracks/frames runs/tracks/poses.csv --vehicle rover --sun 268,19 \\
    --out shadowed
  lunoid augment FRAMES POSES --vehicle rover --sun 268,19 --out shadowed \\
    --method scan-converter --penumbra
  lunoid augment FRAMES POSES --vehicle rover --ground scenarios/tracks.toml --tracks \\
    --out shadowed
  lunoid augment FRAMES POSES --vehicle rover --sun 268,19 --out shadowed \\
    --baseline augment-timing.json
  lunoid augment FRAMES POSES --vehicle rover --sun 268,19 --out shadowed \\
    --probe 33:400..402 --waveforms lines.csv

`lunoid signals 'vs.*'` lists what can be probed: a line of a picture stands for a sweep, a
column for a sample. docs/blocks/vehicle-shadow.md has the formats of poses and camera.";

/// Put the vehicle's shadow, and its tracks, into an existing picture sequence.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Augment {
    /// Folder of pictures (PNG, JPEG, TIFF) whose names end in the number of their frame; colour becomes grey.
    frames: PathBuf,
    /// CSV file of their poses, as a run's poses.csv.
    poses: PathBuf,
    /// What casts the shadow: lander, rover, flag, package, marker, or a shape file (.obj, .stl, .ply, .gltf, .glb).
    #[arg(long, value_name = "SHAPE")]
    vehicle: String,
    /// Azimuth (clockwise from north) and elevation of the sun, in degrees. That of the scenario if left out, with
    /// --ground SCENARIO.
    #[arg(long, value_name = "AZ,EL", value_parser = values::pair)]
    sun: Option<[f64; 2]>,
    /// Folder for the new pictures and their record.
    #[arg(short, long, value_name = "FOLDER")]
    out: PathBuf,
    /// Remove the pictures that an earlier augmentation left in the folder, and nothing else, and start anew.
    #[arg(long)]
    fresh: bool,
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
    #[arg(long, value_name = "METRES", value_parser = values::metres)]
    eye_height: Option<f64>,
    /// File of the camera; camera.json beside the poses if left out.
    #[arg(long, value_name = "JSON", conflicts_with = "field")]
    camera: Option<PathBuf>,
    /// Angles of view in degrees, of a camera that rolls with the vehicle.
    #[arg(long, value_name = "WIDTH,HEIGHT", value_parser = values::pair)]
    field: Option<[f64; 2]>,
    /// Bits of the D/A converters of the synchronised method, over the width of the picture.
    #[arg(long, default_value_t = DAC_BITS, value_parser = values::whole(4..=24_u32))]
    dac_bits: u32,
    /// Limiting resolution of the scan converter, television lines a picture height.
    #[arg(long, default_value_t = ScanConverter::default().tv_lines, value_parser = values::whole(50..=4000_u32))]
    tv_lines: u32,
    /// How far the scan converter's shadow lies off to the right and down, in percent of the picture's height.
    #[arg(long, value_name = "RIGHT,DOWN", value_parser = values::pair)]
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
    probing: Probing,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    saying: Saying,
}

/// What is under the vehicle.
struct Grounded {
    law: GroundLaw,
    vehicle: Vehicle,
    /// Everything that decides this ground, as text for the hash of the inputs.
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
    /// Draws shadow and tracks into the pictures, and writes the record.
    pub fn run(&self) -> Result<Verdict, Failure> {
        self.expect_ground()?;
        expect_outputs(&self.outputs(), &self.sources())?;
        let baseline = self.baseline.as_deref().map(timing::read).transpose()?;
        let pool = self.threads.pool()?;
        let sequence = Sequence::read(&self.frames, &self.poses, || self.camera())?;
        sequence.notes().iter().for_each(|note| warn(note));
        let Grounded { law: ground, vehicle, inputs } = self.ground(&sequence, &pool)?;
        let eye_height = self.eye_height.unwrap_or(vehicle.eye_height);
        let shape = Shape::find(&self.vehicle, eye_height)?;
        shape.notes().iter().for_each(|note| warn(note));
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
        let mut recording = self.probing.recording(&augmentation, &sequence, self.provenance())?;
        let from =
            MadeFrom { inputs: augmentation.inputs.clone(), keys: self.decides(&augmentation, &sequence) };
        let folder = ShadowFolder::claim(&self.out, &sequence, &from, self.fresh)?;
        let mut nothing = Look::off();
        let look = recording.as_mut().map_or(&mut nothing, |recording| &mut recording.look);
        let cancel = interrupt::listen();
        let display = self.saying.display();
        let frames = sequence.frames().len() as u64;
        display.hear(Progress::Begins { what: "frames", frames, kept: 0 });
        let hear = |done| display.hear(Progress::Frame { done });
        let made = pool.install(|| augmentation.run(&sequence, &folder, cancel, &hear, look));
        display.end();
        let made = made?;
        if (made.len() as u64) < frames {
            let done = made.len();
            tell(&format!(
                "interrupted: {done} of {frames} frames are whole; the same command again makes the rest\n"
            ));
            return Ok(Verdict::Interrupted);
        }
        let mut record = self.record(from.keys.clone(), &sequence, &made);
        folder.finish(&mut record, &from)?;
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
        let probed = recording.map(Recording::write).transpose()?;
        let check = baseline.map(|baseline| compare(&baseline, &timing, &Tolerance::default()));
        self.print(record, probed.as_ref(), check.as_ref())?;
        Ok(if check.is_none_or(|check| check.is_met()) { Verdict::Yes } else { Verdict::No })
    }

    /// Files and folders that the command writes.
    fn outputs(&self) -> Vec<Place> {
        let made = Place::folder("--out", &self.out, |name| name == "augment.json" || is_picture(name));
        let timing = Place::given([("--timing", &self.timing)]);
        [made].into_iter().chain(timing).chain(self.probing.outputs()).collect()
    }

    /// Files and folders that the command reads.
    fn sources(&self) -> Vec<Place> {
        let pictures = Place::folder("the pictures in", &self.frames, is_picture);
        let mut sources = vec![pictures, Place::file("the poses", &self.poses)];
        sources.push(Place::file("--vehicle", &self.vehicle));
        sources.extend(self.field.is_none().then(|| Place::file("the camera", self.camera_file())));
        sources.extend(Place::given([("--baseline", &self.baseline)]));
        if self.ground != FLAT {
            sources.extend(StageArgs::of(Path::new(&self.ground)).sources());
        }
        sources
    }

    /// Where waveforms come from.
    fn provenance(&self) -> Vec<(String, String)> {
        let keys = [
            ("program", format!("lunoid {}", env!("CARGO_PKG_VERSION"))),
            ("commit", COMMIT.to_owned()),
            ("pictures", self.frames.display().to_string()),
            ("poses", self.poses.display().to_string()),
            ("vehicle", self.vehicle.clone()),
            ("ground", self.ground.clone()),
            ("method", told::word(&self.method)),
        ];
        keys.into_iter().map(|(key, words)| (key.to_owned(), words)).collect()
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

    fn camera_file(&self) -> PathBuf {
        let beside = || self.poses.parent().unwrap_or(Path::new("")).join(CAMERA);
        self.camera.clone().unwrap_or_else(beside)
    }

    fn camera(&self) -> Result<Camera, Failure> {
        match self.field {
            None => Ok(Camera::read(&self.camera_file())?),
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
        let opened = StageArgs::of(Path::new(&self.ground)).load()?;
        let stage = pool.install(|| opened.stage())?;
        let vehicle = opened.scenario.vehicle;
        let tracks = match self.tracks {
            true => {
                let tracks = opened.scenario.tracks.unwrap_or(USUAL_TRACKS);
                tracks_along(sequence, &tracks, &vehicle, &stage.landscape)?
            }
            false => Vec::new(),
        };
        let inputs = format!("{:?} {:?} {tracks:?}", opened.inputs.scenario, opened.inputs.references);
        let ground = Box::new(pool.install(|| TrueGround::new(stage))?);
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
}

/// Whether a name in a folder of pictures is that of one.
fn is_picture(name: &str) -> bool {
    !name.contains('/') && [".png", ".jpg", ".jpeg", ".tif", ".tiff"].iter().any(|end| name.ends_with(end))
}

fn hash(text: &str) -> String {
    blake3::hash(text.as_bytes()).to_hex().to_string()
}
