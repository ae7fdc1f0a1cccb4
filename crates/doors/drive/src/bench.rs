//! A stage with the generator that draws it, and what else is made on it when somebody asks.

use std::sync::{Arc, OnceLock};

use exact::Columns;
use generator::{Session, Stage};
use machine::{ControlPlane, MachineStage};
use rayon::ThreadPool;
use scenario::{Course, PixelRule, Pose};

use crate::DriveError;

/// One stage, and everything that looks at it.
pub(crate) struct Bench {
    /// The stage with the settings of the hybrid machine.
    pub machine: MachineStage,
    /// The same stage for any generator.
    pub stage: Stage,
    /// The generator, made ready.
    pub session: Box<dyn Session>,
    judge: OnceLock<Box<dyn Session>>,
    control: OnceLock<ControlPlane>,
    exact: OnceLock<Columns>,
}

impl Bench {
    /// The generator of `opened` made ready on `machine`, by the threads of `pool`.
    pub fn new(
        opened: &front_door::Opened,
        pool: &ThreadPool,
        machine: MachineStage,
    ) -> Result<Self, DriveError> {
        let stage = machine.stage();
        let session = pool.install(|| opened.generator.prepare(stage.clone()));
        let session = session.map_err(|error| DriveError::of(opened.scenario_file(), &error))?;
        let (judge, control, exact) = Default::default();
        Ok(Self { machine, stage, session, judge, control, exact })
    }

    /// The same stage on another course: `first` is the pose of frame 0, and `course` has the poses that are remembered, also those that are added
    /// to it later.
    pub fn machine_on(&self, first: Pose, course: Course) -> MachineStage {
        let scenery = (*self.machine.scenery).clone().with_course(course);
        let scenery = scenery.with_start(Some(Pose { yoke: 0.0, ..first }));
        MachineStage { scenery: Arc::new(scenery), ..self.machine.clone() }
    }

    /// The judge on the same stage: planes at the centres of pixels. Errors are told of `file`.
    pub fn judge(&self, pool: &ThreadPool, file: &str) -> Result<&dyn Session, DriveError> {
        if let Some(judge) = self.judge.get() {
            return Ok(&**judge);
        }
        let mut stage = self.stage.clone();
        stage.view.laws.pixel_rule = PixelRule::Centre;
        let judge = pool.install(|| registry::judge_on(stage));
        let judge = judge.map_err(|error| DriveError::of(file, &error))?;
        Ok(&**self.judge.get_or_init(|| judge))
    }

    /// The digital side of the hybrid machine.
    pub fn control(&self) -> &ControlPlane {
        self.control.get_or_init(|| ControlPlane::new(self.machine.clone()))
    }

    /// Columns by closed form.
    pub fn exact(&self) -> &Columns {
        self.exact.get_or_init(|| Columns::new(self.stage.clone()))
    }
}
