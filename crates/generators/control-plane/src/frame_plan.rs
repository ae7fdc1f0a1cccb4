//! The digital side of a frame: fan, start of every sweep, folds, sweep programs.

use std::f64::consts::PI;

use crate::late_words::{LateOf, LateWords};
use crate::refusal::Refusal;
use crate::stage::MachineStage;
use dpu::{CrossingService, Sector, Watch};
use generator::FrameError;
use landscape::{Level, Sun};
use quantities::{degrees, sin_cos, wrap_heading};
use scenario::{FieldOfView, LevelSwitch, Pose};
use sweep_generator::{RangeTable, TimedFolds, set_up};
use sweep_program::{Fan, SweepProgram};

/// What the control plane works out once a frame.
#[derive(Debug, Clone, Copy)]
pub struct FramePlan {
    /// Number of the frame, from 0.
    pub frame: u64,
    /// Azimuths of the sweeps.
    pub fan: Fan,
    /// Heading, clockwise from north (rad).
    pub heading: f64,
    /// Cosine and sine of the heading.
    turn: [f64; 2],
    /// Pitch of the eye (rad).
    pub pitch: f64,
    /// Roll of the vehicle (rad).
    pub roll: f64,
    /// Angle of the deflection yoke, which turns the picture counter-clockwise (rad); 0 without a yoke.
    pub yoke: f64,
    /// Eye: north, east, height (m).
    pub eye: [f64; 3],
    /// Direction of the sun in this frame.
    pub sun: Sun,
    /// Where the sweeps go over from the fine level to the coarse one, and how; never where there is one level.
    pub switch: LevelSwitch,
    /// Words that were late and are taken as if they had been on time; none in the machine as it is.
    on_time: Option<LateWords>,
}

/// One level is drawn however far it goes.
const NO_SWITCH: LevelSwitch = LevelSwitch { range: f64::INFINITY, blend: 0.0 };

/// By how much the heading has turned to starboard from one pose to another, by the short way (rad).
pub(crate) fn turned(before: &Pose, now: &Pose) -> f64 {
    let turn = wrap_heading(now.attitude.heading - before.attitude.heading);
    if turn > PI { turn - 2.0 * PI } else { turn }
}

impl FramePlan {
    /// Checks that the pose can be drawn and spreads the fan over `field`.
    pub fn new(
        frame: u64,
        pose: &Pose,
        stage: &MachineStage,
        field: &FieldOfView,
    ) -> Result<Self, FrameError> {
        let MachineStage { landscape, scenery, settings } = stage;
        let [x, y, height] = pose.eye;
        // The machine starts on its finest level; what only coarser levels store is far ground.
        let on_fine = landscape.level().locate(x, y).and_then(|_| landscape.height(x, y));
        let ground = on_fine.ok_or(FrameError::OutsideProblemArea { frame, x, y })?;
        let above = height > ground;
        if !above {
            return Err(FrameError::EyeUnderGround { frame, below: ground - height });
        }
        let pitch = pose.attitude.pitch;
        let fan = Fan::covering(settings.laws.projection, pitch, field, settings.raster.sweeps);
        let (sin, cos) = sin_cos(pose.attitude.heading);
        Ok(Self {
            frame,
            fan: fan.ok_or_else(|| pitch_error(frame, pitch))?,
            heading: pose.attitude.heading,
            turn: [cos, sin],
            pitch,
            roll: pose.attitude.roll,
            yoke: if settings.yoke.is_some() { pose.yoke } else { 0.0 },
            eye: pose.eye,
            sun: scenery.sun(pose.time),
            switch: settings.levels.map_or(NO_SWITCH, |switch| {
                let before = scenery.course().get((frame as usize).saturating_sub(1));
                let turn = before.map_or(0.0, |before| turned(before, pose));
                settings.level_turn.switch(switch, turn * settings.timebase.update.hertz())
            }),
            on_time: None,
        })
    }

    /// The same frame, with the late words that `late` names on time and nothing else changed. The words of a shadow boundary are
    /// those of the sweep whose set-up has them.
    #[must_use]
    pub fn with_words_on_time(self, late: LateWords) -> Self {
        Self { on_time: Some(late), ..self }
    }

    /// Which late words of `sweep` are to be on time, if any are.
    pub(crate) fn late_of(&self, sweep: u32) -> Option<LateOf> {
        self.on_time.filter(|late| (late.frame, late.sweep) == (self.frame, sweep)).map(|late| late.of)
    }

    /// Regions that the frame can show, out to `range` (m).
    pub fn visible_regions(&self, level: &Level, range: f64) -> usize {
        let [x, y, _] = self.eye;
        let edges = Some(self.edges());
        let range = range / level.region_size();
        Sector { foot: level.in_regions(x, y), edges, range }.regions(level).count()
    }

    /// Unit vector of a sweep over the ground: north, east.
    #[inline]
    pub fn direction(&self, sweep: u32) -> [f64; 2] {
        self.fan.direction(sweep, self.turn)
    }

    /// First and last sweep that may meet a circle of radius `outer` about `centre` (north, east; m); `None` if none does.
    pub fn sweeps_of(&self, centre: [f64; 2], outer: f64) -> Option<[u32; 2]> {
        let ([cos, sin], last) = (self.turn, f64::from(self.fan.sweeps - 1));
        let [north, east] = [0, 1].map(|axis| centre[axis] - self.eye[axis]);
        let (ahead, right) = (north * cos + east * sin, east * cos - north * sin);
        if ahead <= outer {
            return (ahead > -outer).then_some([0, self.fan.sweeps - 1]);
        }
        // Tangents of the square around the circle.
        let [left, right] = [right - outer, right + outer];
        let first = self.fan.position(left / if left < 0.0 { ahead - outer } else { ahead + outer });
        let beyond = self.fan.position(right / if right > 0.0 { ahead - outer } else { ahead + outer });
        // Sweeps stand between the edges that rounding leaves.
        let (first, beyond) = ((first - SLACK).ceil().max(0.0), (beyond + SLACK).floor().min(last));
        (first <= beyond).then_some([first as u32, beyond as u32])
    }

    /// Ground range at which sweep `sweep` leaves the area that `level` stores (m).
    #[inline]
    pub fn way_to_edge(&self, sweep: u32, level: &Level) -> f64 {
        let [x, y, _] = self.eye;
        way_to_edge(level, level.in_regions(x, y), self.direction(sweep))
    }

    /// Directions of both edges of the fan.
    #[inline]
    pub fn edges(&self) -> [[f64; 2]; 2] {
        [0, self.fan.sweeps - 1].map(|sweep| self.direction(sweep))
    }

    /// The same, `margin` (rad) farther out; none where they are half a turn or more apart then.
    pub fn edges_beside(&self, margin: f64) -> Option<[[f64; 2]; 2]> {
        let (sin, cos) = sin_cos(margin);
        let turned = |[north, east]: [f64; 2], sin: f64| [cos * north - sin * east, sin * north + cos * east];
        let [left, right] = self.edges();
        let width = libm::atan(self.fan.tangent(self.fan.sweeps - 1)) - libm::atan(self.fan.tangent(0));
        (width + 2.0 * margin < PI).then_some([turned(left, -sin), turned(right, sin)])
    }

    /// Writes the program by which one terrain generator draws sweep `sweep` with the set-up of sweep `drawn`, up to
    /// `end` (m), into `program`.
    pub fn write_program(
        &self,
        [drawn, sweep]: [u32; 2],
        service: &CrossingService<'_>,
        table: &RangeTable,
        end: f64,
        program: &mut SweepProgram,
        watch: &mut impl Watch,
    ) {
        let [x, y, _] = self.eye;
        let level = service.level;
        let start = set_up(level.in_regions(x, y), self.direction(drawn));
        let folds = TimedFolds::new(&start, level.region_size(), table, end);
        let range_at = |time| table.range_at(time);
        service.write_program((self.frame, sweep), start, folds, end, range_at, program, watch);
    }
}

/// What rounding may do to the place of a sweep in its fan (sweeps).
const SLACK: f64 = 1e-6;

/// Ground range at which a straight sweep leaves the stored area (m).
fn way_to_edge(level: &Level, foot: [f64; 2], direction: [f64; 2]) -> f64 {
    let corners = level.corners();
    let regions = (0..2).map(|axis| {
        let last = (corners[axis] - 1) as f64;
        match direction[axis] {
            cosine if cosine > 0.0 => (last - foot[axis]) / cosine,
            cosine if cosine < 0.0 => -foot[axis] / cosine,
            _ => f64::INFINITY,
        }
    });
    regions.fold(f64::INFINITY, f64::min) * level.region_size()
}

fn pitch_error(frame: u64, pitch: f64) -> FrameError {
    Refusal::Pitch { pitch_deg: degrees(pitch), limit_deg: degrees(Fan::steepest()) }.of(frame)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use hardware_model::{HardwareModel, LevelTurn, Settings};
    use landscape::{Attitude, Bank, Landscape, Level, Sun};
    use quantities::radians;
    use scenario::{Display, FieldOfView, LawWishes, LevelSwitch, Pose, RasterWishes, Scalar, Scenery};

    use super::FramePlan;
    use crate::stage::MachineStage;

    const FIELD: FieldOfView = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
    const SWITCH: LevelSwitch = LevelSwitch { range: 1000.0, blend: 200.0 };

    fn pose(heading: f64) -> Pose {
        let attitude = Attitude { roll: 0.0, pitch: 0.0, heading: radians(heading) };
        Pose { time: 0.0, eye: [10.0, 10.0, 2.0], attitude, yoke: 0.0 }
    }

    /// A stage whose heading is so many degrees in each frame.
    fn stage(headings: &[f64], level_turn: LevelTurn) -> MachineStage {
        let settings = Settings::resolve(
            &HardwareModel::ideal(),
            FIELD,
            RasterWishes::default(),
            None,
            LawWishes::default(),
            Scalar::F32,
            Display { white: 1.0, gamma: 1.0 },
        );
        let settings =
            Settings { levels: Some(SWITCH), level_turn, ..settings.expect("the ideal model is consistent") };
        let level = Level::new(10.0, [0.0; 2], [3, 3], vec![[0.0; 9]; 9]).expect("a level");
        let course: Vec<Pose> = headings.iter().map(|heading| pose(*heading)).collect();
        MachineStage {
            landscape: Arc::new(Landscape::new(Bank::new("test", vec![level], None).expect("a bank"), 0.5)),
            scenery: Arc::new(Scenery::still(Sun { azimuth: 0.3, elevation: 0.6 }).with_course(course)),
            settings,
        }
    }

    /// At 30 frames a second half a degree a frame is 15 degrees a second.
    #[test]
    fn the_coarse_level_begins_nearer_while_the_heading_turns_fast() {
        let headings = [0.0, 0.3, 0.8, 0.3, 0.1, 359.5];
        let turning = stage(&headings, LevelTurn { rate: radians(10.0), share: 0.25 });
        assert_eq!(turning.settings.timebase.update.hertz(), 30.0);
        let near = LevelSwitch { range: 250.0, blend: 50.0 };
        for (frame, expected) in (0..).zip([SWITCH, SWITCH, near, near, SWITCH, near]) {
            let plan =
                FramePlan::new(frame, &pose(headings[frame as usize]), &turning, &FIELD).expect("a plan");
            assert_eq!(plan.switch, expected, "frame {frame}");
        }
        let never = stage(&headings, LevelTurn::NEVER);
        let plan = FramePlan::new(2, &pose(headings[2]), &never, &FIELD).expect("a plan");
        assert_eq!(plan.switch, SWITCH);
    }
}
