//! The machine of a mission, which states are of.

use std::path::Path;

use event_list::DigitalFrame;
use generator::{PlaneKind, Planes};
use machine::{ControlPlane, MachineStage, Memory, Resumes, Sizes, prepare_resumes};
use run_record::Program;
use scenario::{PoseRow, PoseTable, Scenario};
use signal::Probe;

use crate::container::{Block, BlockHeader, BlockKind, Head};
use crate::digital::{Digital, expect};
use crate::{Clock, Fault, Identity, Place, State, StateError};

/// What a bench is made for.
pub struct Mission<'a> {
    /// The program that draws.
    pub program: Program,
    /// Name of the hardware model.
    pub machine: &'a str,
    /// Scenario and options, as a command line has them.
    pub words: Vec<String>,
    /// The scenario, with the wishes.
    pub scenario: &'a Scenario,
    /// Ground, scenery and settings of the machine.
    pub stage: &'a MachineStage,
    /// The digital side of the machine on the stage.
    pub control: &'a ControlPlane,
}

/// The machine of a mission, stopped and gone on at will.
pub struct Bench<'a> {
    mission: Mission<'a>,
    identity: Identity,
    clock: Clock,
    machine: Box<dyn Resumes>,
}

impl<'a> Bench<'a> {
    /// Elaborates the machine of `mission`.
    pub fn new(mission: Mission<'a>) -> Self {
        let Mission { program, machine, scenario, stage, .. } = &mission;
        let settings = &stage.settings;
        let identity = Identity::new(program.clone(), machine, scenario, (&stage.stage(), settings));
        let clock = Clock::new(settings.timebase, scenario.frames(settings.timebase.update));
        let machine = prepare_resumes((*stage).clone());
        Self { identity, clock, machine, mission }
    }

    /// The clock of the mission.
    pub fn clock(&self) -> &Clock {
        &self.clock
    }

    /// How much the machine remembers.
    pub fn sizes(&self) -> Sizes {
        self.machine.sizes()
    }

    /// The program that draws.
    pub fn program(&self) -> &Program {
        &self.mission.program
    }

    /// The machine at `place`, drawn as far as that takes.
    ///
    /// # Errors
    /// If the mission has no such place, or a frame cannot be drawn.
    pub fn save(&self, place: Place) -> Result<State, StateError> {
        self.state(place, &[])
    }

    /// Puts what a state holds into the machine: what needs earlier stores and pictures takes them from now on. `file` is what
    /// errors call it.
    ///
    /// # Errors
    /// If the state is that of another machine, mission or program, or holds something else than the machine does there.
    pub fn restore(&self, state: &State, file: &Path) -> Result<(), StateError> {
        self.expect(state).map_err(|fault| fault.of(file))?;
        let digital = self.digital(state.head.place)?;
        expect(&state.digital, &digital).map_err(|fault| fault.of(file))?;
        self.machine.remember(&state.memory());
        Ok(())
    }

    /// The state at `place`, from a state that was restored: rows, stores and pictures that both have are taken over.
    ///
    /// # Errors
    /// If the mission has no such place, or a frame cannot be drawn.
    pub fn moved(&self, state: &State, place: Place) -> Result<State, StateError> {
        self.clock.expect(place)?;
        let from = state.head.place;
        if (from.frame, from.sweep) == (place.frame, place.sweep) {
            return Ok(State { head: self.head(place), ..state.clone() });
        }
        let Memory { rows, stores, .. } = state.memory();
        let remembered = self.machine.remembered(place.frame);
        if from.frame != place.frame && remembered.iter().any(|frames| frames.contains(&from.frame)) {
            self.go_on(state)?;
        }
        if from.frame == place.frame {
            return self.state(place, &rows);
        }
        let store = stores.iter().find(|(frame, _)| *frame == place.frame);
        self.state(place, store.map_or(&[], |(_, store)| store))
    }

    /// The picture of the frame that a state is in, drawn on from its rows: linear intensity.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn go_on(&self, state: &State) -> Result<Planes, StateError> {
        let frame = state.head.place.frame;
        Ok(self.machine.go_on(frame, &self.row(frame)?.pose, &state.memory().rows)?)
    }

    /// The picture of a frame behind the one that was gone on with.
    ///
    /// # Errors
    /// If the mission has no such frame, or its pose cannot be drawn.
    pub fn frame(&self, frame: u64) -> Result<Planes, StateError> {
        let [columns, lines] = self.sizes().pixels;
        let mut planes = Planes::new(columns, lines, &[PlaneKind::Intensity]);
        self.machine.frame(frame, &self.row(frame)?.pose, &mut planes, &mut Probe::off())?;
        Ok(planes)
    }

    /// Where the vehicle is in a frame.
    ///
    /// # Errors
    /// If the mission has no such frame, or the path cannot be driven.
    pub fn row(&self, frame: u64) -> Result<PoseRow, StateError> {
        self.clock.expect(Place::start(frame, 0))?;
        let Mission { scenario, stage, .. } = &self.mission;
        let (update, yoke) = (stage.settings.timebase.update, stage.settings.yoke);
        Ok(PoseTable::resolve(scenario, &stage.landscape, update, yoke, frame..frame + 1)?.rows()[0])
    }

    /// The digital side of a frame, with its shadow gates if `gates`.
    pub(crate) fn digital_frame(&self, frame: u64, gates: bool) -> Result<DigitalFrame<'a>, StateError> {
        let Mission { control, stage, .. } = self.mission;
        Ok(DigitalFrame::new(control, stage, (frame, &self.row(frame)?.pose), gates)?)
    }

    /// Records signals of one sweep.
    pub(crate) fn probe(&self, place: Place, names: &[&str]) -> Result<Probe, StateError> {
        let names = names.iter().map(|name| (*name).to_owned()).collect();
        let mut probe = Probe::new(names, place.sweep..place.sweep + 1);
        let [columns, lines] = self.sizes().pixels;
        let pose = self.row(place.frame)?.pose;
        self.machine.frame(place.frame, &pose, &mut Planes::new(columns, lines, &[]), &mut probe)?;
        Ok(probe)
    }

    /// The state at `place`; `known` has rows of the frame.
    fn state(&self, place: Place, known: &[f32]) -> Result<State, StateError> {
        self.clock.expect(place)?;
        let pose = self.row(place.frame)?.pose;
        let memory = self.machine.memory((place.frame, place.sweep), &pose, known)?;
        let blocks = State::blocks_of(memory, place, self.sizes());
        Ok(State { head: self.head(place), digital: self.digital(place)?, blocks })
    }

    fn head(&self, place: Place) -> Head {
        Head {
            identity: self.identity.clone(),
            words: self.mission.words.clone(),
            place,
            tick: self.clock.tick(place).0,
            time_s: self.clock.seconds(place),
        }
    }

    fn digital(&self, place: Place) -> Result<String, StateError> {
        let Mission { control, stage, .. } = self.mission;
        let Place { frame, sweep, .. } = place;
        let tick = self.clock.tick(Place::start(frame, sweep));
        Ok(Digital { control, stage, frame, sweep, tick }.text(&self.row(frame)?.pose)?)
    }

    /// Whether head and blocks are those of this machine.
    fn expect(&self, state: &State) -> Result<(), Fault> {
        let Head { identity, words, place, tick, time_s } = &state.head;
        self.identity.expect(identity, words)?;
        self.clock.expect(*place).map_err(Fault::Place)?;
        let here = self.head(*place);
        let at = |tick: u64, time_s: f64| format!("tick {tick}, {time_s} s");
        let [found, expected] = [at(*tick, *time_s), at(here.tick, here.time_s)];
        if found != expected {
            return Err(Fault::Value { part: "header, tick and time_s".into(), found, expected });
        }
        self.expect_blocks(state)
    }

    fn expect_blocks(&self, state: &State) -> Result<(), Fault> {
        let found: Vec<BlockHeader> = state.blocks.iter().map(Block::header).collect();
        let expected = self.headers(state.head.place);
        let mut places = 0..found.len().max(expected.len());
        let Some(place) = places.find(|&at| found.get(at) != expected.get(at)) else { return Ok(()) };
        let told = |of: &[BlockHeader]| of.get(place).map_or("no more blocks".into(), BlockHeader::to_string);
        Err(Fault::Value {
            part: format!("header, block {place}"),
            found: told(&found),
            expected: told(&expected),
        })
    }

    /// The blocks of a state at `place`.
    fn headers(&self, Place { frame, sweep, .. }: Place) -> Vec<BlockHeader> {
        let Sizes { sweeps, cells, pixels: [columns, lines] } = self.sizes();
        let header = |kind, frame, rows: u32, values: usize| BlockHeader {
            kind,
            frame,
            rows: rows.into(),
            values_a_row: values as u64,
        };
        let [stores, pictures] = self.machine.remembered(frame);
        let rows = header(BlockKind::Rows, frame, sweep, cells);
        let stores = stores.map(|frame| header(BlockKind::Store, frame, sweeps, cells));
        let pictures = pictures.map(|frame| header(BlockKind::Picture, frame, lines as u32, columns));
        [rows].into_iter().chain(stores).chain(pictures).collect()
    }
}
