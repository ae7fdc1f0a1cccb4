//! The shadow of one vehicle in one picture after the other.

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use generator::check_eye;
use glam::DVec3;
use landscape::Sun;
use photographs::{CURVE, PhotographFileError};
use picture::{GreyPicture, Limits, PictureFileError, encode_png};
use scenario::{Pose, TrackPatch};

use crate::blanking::Blanking;
use crate::flat_ground::{OutlineRule, flat_gates, shadow_outlines};
use crate::frame_work::FrameWork;
use crate::gate::PictureGates;
use crate::insertion::Method;
use crate::kept::{kept, stamp};
use crate::probed::{Lines, Look};
use crate::sequence::{Sequence, SequenceFrame};
use crate::shadow::Shadow;
use crate::suns::suns;
use crate::true_ground::TrueGround;
use crate::view_lines::LineCounts;
use crate::work::Work;
use crate::{AugmentError, ShadowFolder, Shape, Shot};

/// What the ground is taken for.
#[derive(Debug, Clone)]
pub enum GroundLaw {
    /// Flat and level, `eye_height` under the eye: the report's law.
    Flat(OutlineRule),
    /// As a scenario has it.
    True {
        /// Its ground and what stands on it.
        ground: Box<TrueGround>,
        /// Tracks of the vehicle, in the order in which they are laid; none if they are not wanted.
        tracks: Vec<TrackPatch>,
    },
}

/// What is put into pictures, and how.
#[derive(Debug, Clone)]
pub struct Augmentation {
    /// Shape of the vehicle that casts the shadow.
    pub shape: Shape,
    /// Height of its eye above its foot point, and above the ground where the poses do not tell (m).
    pub eye_height: f64,
    /// The sun; that of the scenario at the time of the frame if open.
    pub sun: Option<Sun>,
    /// Whether the sun is a disc.
    pub penumbra: bool,
    /// What the ground is.
    pub ground: GroundLaw,
    /// How the shadow gets into the video.
    pub method: Method,
    /// Hash of program, vehicle, sun, ground and method: a picture that was made from the same is made once.
    pub inputs: String,
}

impl Augmentation {
    /// The shadow in a picture of `size` (columns, lines).
    ///
    /// # Errors
    /// If the sun does not stand above the horizontal, or the eye not above the ground.
    pub fn shade(&self, frame: u64, shot: &Shot, size: [usize; 2]) -> Result<Shadow, AugmentError> {
        let sun = self.sun(shot.time);
        let suns = suns(&sun, self.penumbra).map_err(|source| AugmentError::Sun { frame, source })?;
        let raster = self.method.raster(size);
        let (gates, lines) = match &self.ground {
            GroundLaw::Flat(rule) => self.flat(shot, &suns, *rule, raster[1]),
            GroundLaw::True { ground, tracks } => {
                let pose = Pose { time: shot.time, eye: shot.eye, attitude: shot.camera, yoke: 0.0 };
                check_eye(&ground.stage().landscape, frame, &pose)?;
                let laid = &tracks[..tracks.partition_point(|patch| patch.laid <= shot.time)];
                (ground.gates(&self.shape, shot, &suns, laid, raster), LineCounts::default())
            }
        };
        let half_width = shot.field.tan_half_width;
        let shade = self.method.shade(&gates.suns, half_width, size);
        let work = Work {
            points: (self.shape.function().vertices() * suns.len()) as u64,
            lines,
            intersections: gates.suns.iter().map(|gates| gates.crossings).sum(),
            line_generators: gates.suns.iter().map(|gates| gates.line_generators).sum(),
            dark: shade.shares().iter().sum::<f64>() / shade.shares().len() as f64,
        };
        let blanking = Blanking::of(&self.method, &gates.suns, half_width);
        Ok(Shadow { gates, half_width, shade, work, blanking })
    }

    fn sun(&self, time: f64) -> Sun {
        match (&self.sun, &self.ground) {
            (Some(sun), _) => *sun,
            (None, GroundLaw::True { ground, .. }) => ground.stage().scenery.sun(time),
            // Refused by `suns` as standing on the horizon.
            (None, GroundLaw::Flat(_)) => Sun { azimuth: 0.0, elevation: 0.0 },
        }
    }

    fn flat(
        &self,
        shot: &Shot,
        suns: &[DVec3],
        rule: OutlineRule,
        lines: usize,
    ) -> (PictureGates, LineCounts) {
        let mut counts = LineCounts::default();
        let of_sun = |&sun: &DVec3| {
            let (outlines, types) = shadow_outlines(self.shape.function(), shot, sun, rule);
            counts += types;
            flat_gates(&outlines, shot, lines)
        };
        let suns = suns.iter().map(of_sun).collect();
        (PictureGates { suns, tracks: Vec::new() }, counts)
    }

    /// Puts the shadow into all pictures of `sequence` and writes them as PNG, under the same names, into the folder `out`. Each file is written whole or not at all; one
    /// that is there, made from the same by an earlier run, stays. Ends early, with whole pictures only, when `cancel` is set;
    /// `heard` hears how many are done. A picture whose lines `look` wants is made again if it is there.
    ///
    /// # Errors
    /// The first fault; pictures before it are written.
    pub fn run(
        &self,
        sequence: &Sequence,
        out: &ShadowFolder,
        cancel: &AtomicBool,
        heard: &dyn Fn(u64),
        look: &mut Look,
    ) -> Result<Vec<FrameWork>, AugmentError> {
        let out = out.path();
        let mut size = sequence.camera().size.map(|size| (size, "camera.json says".to_owned()));
        let mut done = Vec::with_capacity(sequence.frames().len());
        for frame in sequence.frames() {
            if cancel.load(Ordering::Relaxed) {
                break;
            }
            let source = Source::read(&frame.path)?;
            let picture = &source.picture;
            let found = [picture.columns(), picture.lines()];
            let (expected, of) = size.get_or_insert_with(|| (found, frame.path.display().to_string()));
            if found != *expected {
                let (path, expected, of) = (frame.path.clone(), *expected, of.clone());
                return Err(AugmentError::Size { path, found, expected, of });
            }
            done.push(self.frame(sequence, frame, &source, out, look)?);
            heard(done.len() as u64);
        }
        Ok(done)
    }

    fn frame(
        &self,
        sequence: &Sequence,
        frame: &SequenceFrame,
        source: &Source,
        out: &Path,
        look: &mut Look,
    ) -> Result<FrameWork, AugmentError> {
        let shot = frame.pose.shot(sequence.camera(), self.eye_height);
        let picture = &source.picture;
        let file = frame.made();
        let path = out.join(&file);
        let key = self.key(frame.frame, &shot, source);
        if !look.wants(frame.frame)
            && let Some(kept) = kept(&path, &key)
        {
            return Ok(kept);
        }
        let shadow = self.shade(frame.frame, &shot, [picture.columns(), picture.lines()])?;
        let Shadow { shade, work, blanking, .. } = &shadow;
        let refused = |source| PictureFileError::Picture { path: path.clone(), source };
        let new = GreyPicture::new(picture.columns(), picture.lines(), picture.depth(), shade.blank(picture))
            .map_err(refused)?;
        let work = FrameWork {
            frame: frame.frame,
            time_s: frame.pose.time,
            file: file.to_string_lossy().into_owned(),
            pixels_blake3: new.pixel_hash(),
            times: work.times(&self.method, sequence.period()),
            work: *work,
            blanking: blanking.clone(),
        };
        let texts = [
            ("Frame", frame.frame.to_string()),
            ("Time", format!("{} s", frame.pose.time)),
            stamp(&key, &self.inputs, &work),
        ];
        let bytes =
            encode_png(&new, &texts.each_ref().map(|(key, text)| (*key, text.as_str()))).map_err(refused)?;
        files::write_atomic(&path, |file| file.write_all(&bytes))?;
        if look.wants(frame.frame) {
            Lines { augmentation: self, picture, shadow: &shadow }.record(frame.frame, &mut look.probe);
        }
        Ok(work)
    }

    /// Hash of everything that a new picture is made from.
    fn key(&self, frame: u64, shot: &Shot, source: &Source) -> String {
        let mut hasher = blake3::Hasher::new();
        hasher.update(format!("{} {frame} {shot:?} ", self.inputs).as_bytes());
        hasher.update(&source.bytes);
        hasher.finalize().to_hex().to_string()
    }
}

/// A picture of the sequence.
struct Source {
    bytes: Vec<u8>,
    picture: GreyPicture,
}

impl Source {
    fn read(path: &Path) -> Result<Self, AugmentError> {
        let limits = Limits::default();
        let bytes = files::read_all(path, limits.file_bytes)?;
        let refused = |source| PhotographFileError::Picture { path: path.to_owned(), source };
        let picture = photographs::decode(&bytes, &limits).map_err(refused)?;
        // The report's television has no colour.
        Ok(Self { bytes, picture: picture.to_grey(CURVE) })
    }
}
