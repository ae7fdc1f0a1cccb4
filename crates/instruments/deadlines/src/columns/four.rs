//! One frame by four machines: as it is, ideal, and with one side alone ideal.

use generator::{PlaneKind, Planes};
use hardware_model::{Settings, Side};
use machine::{MachineStage, Prepare};
use picture::{Depth, Encoder, GreyPicture, Transfer};
use scenario::{Pose, PoseTable};
use signal::{Probe, Waveform};

use crate::{DeadlineError, Rehearsal};

/// What a sweep of the ideal machine is asked for: where its beam is, what of it bodies and their shadows change.
const LOOKED_AT: [&str; 3] = [BEAM, BODIES, GATE];
/// Line position of the beam, by sample.
pub const BEAM: &str = "dpp.y";
/// Whether a body is seen, by line.
pub const BODIES: &str = "pg.present";
/// Remote shadow, by sample.
pub const GATE: &str = "sc.gate";

/// One frame, in codes of 8 bits as it is displayed.
pub struct Four {
    /// By the machine as it is.
    pub machine: GreyPicture,
    /// By the ideal machine.
    pub ideal: GreyPicture,
    /// With the digital side ideal: what is left is the work of the parts.
    pub parts_alone: GreyPicture,
    /// With the analog side ideal: what is left is the work of the timing.
    pub timing_alone: GreyPicture,
}

/// What the sweeps were seen to do.
pub struct Seen {
    /// By the ideal machine.
    pub ideal: Vec<Waveform>,
    /// With the analog side alone ideal.
    pub timing_alone: Vec<Waveform>,
    /// Pose with the yoke of the machine, and with that of the ideal one.
    pub poses: [Pose; 2],
}

/// Draws frame `frame` by the four machines of `rehearsal`.
pub fn draw(rehearsal: &Rehearsal, frame: u64) -> Result<(Four, Seen), DeadlineError> {
    let own = &rehearsal.stage.settings;
    let digital = own.clone().with_ideal(Side::Digital);
    let analog = own.clone().with_ideal(Side::Analog);
    let ideal = digital.clone().with_ideal(Side::Analog);
    let poses = [pose(rehearsal, own, frame)?, pose(rehearsal, &ideal, frame)?];
    let by = |settings: &Settings, is_looked_at: bool| {
        let stage = MachineStage { settings: settings.clone(), ..rehearsal.stage.clone() };
        let is_own = settings.yoke == own.yoke;
        let drawing = Drawing { rehearsal, frame, pose: &poses[usize::from(!is_own)], is_looked_at };
        drawing.run(stage)
    };
    let (machine, _) = by(own, false)?;
    let (parts_alone, _) = by(&digital, false)?;
    let (timing_alone, of_timing) = by(&analog, true)?;
    let (ideal, of_ideal) = by(&ideal, true)?;
    let seen = Seen { ideal: of_ideal, timing_alone: of_timing, poses };
    Ok((Four { machine, ideal, parts_alone, timing_alone }, seen))
}

/// Where the vehicle is in `frame`, under the yoke of `settings`.
pub fn pose(rehearsal: &Rehearsal, settings: &Settings, frame: u64) -> Result<Pose, DeadlineError> {
    let (update, yoke) = (settings.timebase.update, settings.yoke);
    let Rehearsal { scenario, stage, .. } = rehearsal;
    let table = PoseTable::resolve(scenario, &stage.landscape, update, yoke, frame..frame + 1)?;
    Ok(table.rows()[0].pose)
}

struct Drawing<'a> {
    rehearsal: &'a Rehearsal,
    frame: u64,
    pose: &'a Pose,
    is_looked_at: bool,
}

impl Drawing<'_> {
    fn run(&self, stage: MachineStage) -> Result<(GreyPicture, Vec<Waveform>), DeadlineError> {
        let (raster, display) = (stage.settings.raster, stage.settings.display);
        let (columns, lines) = (raster.columns as usize, raster.lines as usize);
        let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
        let looked_at = if self.is_looked_at { LOOKED_AT.map(String::from).into() } else { Vec::new() };
        let mut probe = Probe::new(looked_at, 0..raster.sweeps);
        let session = stage.prepare();
        let draw = || session.frame(self.frame, self.pose, &mut planes, &mut probe);
        self.rehearsal.pool.install(draw)?;
        let transfer = Transfer::new(display.white as f32, display.gamma as f32)?;
        let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
        let picture = Encoder::new(transfer, Depth::Eight).encode(intensity, columns, lines)?;
        Ok((picture, probe.waveforms))
    }
}
