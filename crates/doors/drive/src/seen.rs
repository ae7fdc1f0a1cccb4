//! A picture, with what it is of.

use generator::{FrameCounts, PlaneKind, Planes, Session, Stage};
use picture::{AnyPicture, Depth, Encoder, PictureError, Transfer};
use scenario::Pose;
use signal::Probe;

use crate::{DriveError, EyePose};

/// A drawn frame with its pose.
#[derive(Debug, Clone)]
pub struct Seen {
    /// Number of the frame, counted at the update rate.
    pub frame: u64,
    /// Where the vehicle was.
    pub pose: EyePose,
    /// The picture as a run keeps it: 8 bits a code.
    pub picture: AnyPicture,
    /// Linear light that the picture was made of: intensity, or red, green and blue.
    pub light: Planes,
    /// Counters of the generator, as `run.json` has them.
    pub counts: FrameCounts,
}

impl Seen {
    /// Hash of the pixels, as `run.json` has it.
    pub fn hash(&self) -> String {
        self.picture.pixel_hash()
    }

    /// Whether a code of the picture is a byte.
    pub fn has_bytes(&self) -> bool {
        self.picture.depth() == Depth::Eight
    }

    /// The bytes of a PNG.
    ///
    /// # Errors
    /// If the picture cannot be packed.
    pub fn png(&self) -> Result<Vec<u8>, DriveError> {
        self.picture.encode_png(&[]).map_err(|error| DriveError::of("picture", &error))
    }
}

/// How pictures of a stage are drawn.
pub(crate) struct Drawing {
    kinds: &'static [PlaneKind],
    raster: [usize; 2],
    encoder: Encoder,
}

impl Drawing {
    /// Pictures of `stage`, in colour if `colour`.
    pub fn new(stage: &Stage, colour: bool) -> Result<Self, PictureError> {
        let display = &stage.view.display;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32)?;
        Ok(Self {
            kinds: if colour { &PlaneKind::COLOUR } else { &[PlaneKind::Intensity] },
            raster: [stage.view.columns as usize, stage.view.lines as usize],
            encoder: Encoder::new(transfer, Depth::Eight),
        })
    }

    /// Frame `frame` from `pose`, by the threads of the current pool; errors are told of `file`.
    pub fn draw(
        &self,
        session: &dyn Session,
        (frame, pose): (u64, &Pose),
        file: &str,
    ) -> Result<(AnyPicture, Planes, FrameCounts), DriveError> {
        let [columns, lines] = self.raster;
        let mut planes = Planes::new(columns, lines, self.kinds);
        let counts = session.frame(frame, pose, &mut planes, &mut Probe::off());
        let counts = counts.map_err(|error| DriveError::of(file, &error))?;
        let picture = self.encode(&planes).map_err(|error| DriveError::of(file, &error))?;
        Ok((picture, planes, counts))
    }

    fn encode(&self, planes: &Planes) -> Result<AnyPicture, PictureError> {
        let [columns, lines] = self.raster;
        match planes.colour() {
            Some(colour) => Ok(self.encoder.encode_colour(colour, columns, lines)?.into()),
            None => {
                let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
                Ok(self.encoder.encode(intensity, columns, lines)?.into())
            }
        }
    }
}
