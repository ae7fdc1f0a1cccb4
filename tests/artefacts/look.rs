//! What a run shows, and the clean run of the same scene beside it.

use std::collections::BTreeMap;

use control_plane::ControlPlane;
use generator::{PlaneKind, Planes};
use hardware_model::{HardwareModel, Settings};
use machine::Prepare;
use scenario::Pose;
use signal::Probe;
use sweep_program::Fan;
use timing::FrameTiming;

use crate::artefacts::scene::Scene;

/// One frame of a run.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Linear intensity as it is displayed, line by line from the top left.
    pub picture: Vec<f32>,
    pub timing: Option<FrameTiming>,
    /// Values; of a signal that is told when it changes its instants, then its values.
    waves: BTreeMap<(u32, &'static str), Vec<f64>>,
}

/// A scene as a machine made it.
#[derive(Debug, Clone)]
pub struct Run {
    pub settings: Settings,
    /// Those that the scene looks at.
    pub frames: Vec<Frame>,
    pub poses: Vec<Pose>,
}

impl Run {
    /// The scene by a machine.
    pub fn of(scene: &Scene, model: &HardwareModel) -> Self {
        let (stage, poses) = scene.stage(model);
        let settings = stage.settings.clone();
        let raster = settings.raster;
        let control = scene.timed.then(|| ControlPlane::new(stage.clone()));
        let session = scene.drawn.then(|| stage.prepare());
        let frame = |&number: &u64| {
            let pose = &poses[number as usize];
            let mut planes =
                Planes::new(raster.columns as usize, raster.lines as usize, &[PlaneKind::Intensity]);
            let patterns = scene.signals.iter().map(|&name| name.to_owned()).collect();
            let mut probe = Probe::new(patterns, 0..raster.sweeps);
            if let Some(session) = &session {
                session.frame(number, pose, &mut planes, &mut probe).expect("a pose that can be drawn");
            }
            let waves = probe.waveforms.into_iter();
            Frame {
                picture: planes.get(PlaneKind::Intensity).expect("asked for").to_vec(),
                timing: control.as_ref().map(|control| control.frame(number, pose).expect("a pose")),
                waves: waves
                    .map(|wave| ((wave.sweep, wave.signal.name), [wave.times, wave.values].concat()))
                    .collect(),
            }
        };
        let frames = scene.frames.iter().map(frame).collect();
        Self { frames, poses, settings }
    }

    /// A waveform of the first frame that is looked at.
    pub fn wave(&self, sweep: u32, name: &'static str) -> &[f64] {
        self.frames[0].waves.get(&(sweep, name)).unwrap_or_else(|| panic!("{name} of sweep {sweep}"))
    }

    /// Length of a sample (µs).
    pub fn sample(&self) -> f64 {
        1e6 / self.settings.timebase.sample_rate().hertz()
    }

    /// How often the display shows one picture.
    pub fn showings(&self) -> u64 {
        let refresh = self.settings.raster.refresh;
        refresh.whole_ratio(self.settings.timebase.update).expect("rates that divide")
    }
}

/// A scene by a machine with a fault, and by the ideal one.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    pub scene: &'a Scene,
    pub clean: &'a Run,
    pub run: &'a Run,
}

/// Where a sweep crosses a line of the lattice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Crossing {
    /// Samples from the first one.
    pub time: f64,
    /// 0: a line of constant north.
    pub axis: usize,
    /// Number of the line.
    pub line: i64,
}

impl Look<'_> {
    pub fn sweeps(&self) -> std::ops::Range<u32> {
        0..self.run.settings.raster.sweeps
    }

    /// Sweeps that were drawn along their own azimuth, so that their ramps fold when they should, all as far ahead of the beam as their
    /// parts are slow: the others are another artefact's.
    pub fn own(&self) -> impl Iterator<Item = u32> {
        self.sweeps().filter(|&sweep| {
            let instants = |wave: &[f64]| wave[..wave.len() / 2].to_vec();
            let folds =
                |run: &Run| ["sweep.fold.x", "sweep.fold.y"].map(|name| instants(run.wave(sweep, name)));
            let [found, right] = [self.run, self.clean].map(|run| folds(run).concat());
            let ahead: Vec<f64> = right.iter().zip(&found).map(|(right, found)| right - found).collect();
            let alike = |ahead: &[f64]| ahead.iter().all(|of| (of - ahead[0]).abs() < 1e-6);
            found.len() == right.len() && alike(&ahead)
        })
    }

    /// Height less that of the clean run (m).
    pub fn error(&self, sweep: u32) -> Vec<f64> {
        let pair = [self.run, self.clean].map(|run| run.wave(sweep, "tg.height"));
        pair[0].iter().zip(pair[1]).map(|(found, right)| found - right).collect()
    }

    /// Direction of a sweep (north, east).
    pub fn direction(&self, sweep: u32) -> [f64; 2] {
        let (settings, attitude) = (&self.clean.settings, self.clean.poses[0].attitude);
        let fan = Fan::covering(
            settings.laws.projection,
            attitude.pitch,
            &settings.raster.field,
            settings.raster.sweeps,
        );
        let (sin, cos) = quantities::sin_cos(attitude.heading);
        fan.expect("a pitch that a fan covers").direction(sweep, [cos, sin])
    }

    /// Ground range of a sample (m), and of places between samples.
    pub fn range_at(&self, time: f64) -> f64 {
        self.pace() * (time + 1.0)
    }

    /// Ground range of a sample (m), at the constant rate.
    pub fn pace(&self) -> f64 {
        self.clean.settings.range.end / f64::from(self.clean.settings.raster.samples)
    }

    /// Rate of ground range (m/µs).
    pub fn speed(&self) -> f64 {
        self.pace() / self.clean.sample()
    }

    /// Place of a sample of a sweep, in regions from the corner of the area.
    pub fn place(&self, sweep: u32, time: f64) -> [f64; 2] {
        let direction = self.direction(sweep);
        let range = self.range_at(time);
        std::array::from_fn(|axis| (self.scene.eye[axis] + range * direction[axis]) / self.scene.region())
    }

    /// Crossings of a sweep by geometry, in order.
    pub fn crossings(&self, sweep: u32) -> Vec<Crossing> {
        let last = f64::from(self.clean.settings.raster.samples - 1);
        let [from, to] = [self.place(sweep, -1.0), self.place(sweep, last)];
        let mut found = Vec::new();
        for axis in 0..2 {
            let (a, b) = (from[axis], to[axis]);
            let [low, high] = [a.min(b).ceil(), a.max(b).floor()].map(|line| line as i64);
            for line in low..=high {
                let time = (line as f64 - a) / (b - a) * (last + 1.0) - 1.0;
                found.push(Crossing { time, axis, line });
            }
        }
        found.sort_by(|a, b| a.time.total_cmp(&b.time));
        found
    }
}

/// Mean of some values; 0 of none.
pub fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / values.len() as f64 }
}

/// Middle one of some values; 0 of none.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(0.0)
}

/// Largest of some values; 0 if none is above.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, f64::max)
}

/// A waveform between its samples.
pub fn between(wave: &[f64], time: f64) -> f64 {
    let time = time.clamp(0.0, (wave.len() - 1) as f64);
    let before = (time as usize).min(wave.len() - 2);
    wave[before] + (wave[before + 1] - wave[before]) * (time - before as f64)
}
