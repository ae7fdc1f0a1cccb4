//! Laws and methods of `lunoid augment`: error against run time.
//!
//! **Law.** One factor at a time about a picture of true ground that a sun without width lights, through converters of
//! 24 bits. Every rung is held against it, pixel by pixel, by the share that is dark. What a penumbra or flat ground
//! changes is a difference of laws, all else an error of the method. Rungs take turns, as everywhere in these studies.

use std::time::Instant;

use control_plane::MachineStage;
use landscape::Attitude;
use scenario::PoseRow;
use serde::Serialize;
use vehicle_shadow::{
    AugmentError, Augmentation, GroundLaw, Method, OutlineRule, ScanConverter, Shape, Shot, TrueGround,
};

use crate::Effort;
use crate::figures::Sum;
use crate::work::spread;

/// Bits of converters that round nothing: a 16-millionth of the width.
const UNROUNDED: u32 = 24;
/// Bits of the converters that are tried.
const BITS: [u32; 3] = [10, 8, 6];
/// Limiting resolutions of the scan converters that are tried (television lines).
const TV_LINES: [u32; 2] = [650, 325];
/// A pixel is another one if its dark share is off by more than this.
const OTHER: f64 = 0.5;

/// What came of one law by one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LawOutcome {
    /// Law of the shadow: ground, outlines and sun.
    pub law: &'static str,
    /// How it gets into the video.
    pub method: String,
    /// Mean of the dark share of the pixels.
    pub dark: f64,
    /// Part of the pixels whose dark share is off by more than a half.
    pub differ: f64,
    /// Root mean square by which the dark share is off.
    pub rms: f64,
    /// Seconds a picture: median, least, most.
    pub time_s: [f64; 3],
}

struct Rung {
    law: &'static str,
    method: String,
    augmentation: Augmentation,
    times: Vec<f64>,
}

/// Every law and method over pictures of `size` (columns, lines) from the poses `rows`, at least one, over the ground of `stage`;
/// the vehicle is `shape`. The first outcome is what the others are held against.
///
/// # Errors
/// If the sun does not stand above the horizontal in one of the frames, or the eye not above the ground.
pub fn laws(
    stage: &MachineStage,
    rows: &[PoseRow],
    shape: &Shape,
    size: [usize; 2],
    effort: Effort,
) -> Result<Vec<LawOutcome>, AugmentError> {
    let shots: Vec<(u64, Shot)> = rows.iter().map(|row| (row.frame, shot(stage, row))).collect();
    let mut rungs = rungs(stage, shape)?;
    let mut shares = Vec::with_capacity(rungs.len());
    for rung in &mut rungs {
        shares.push(rung.draw(stage, &shots, size)?);
    }
    for _ in 0..effort.repetitions {
        for rung in &mut rungs {
            let start = Instant::now();
            rung.draw(stage, &shots, size)?;
            rung.times.push(start.elapsed().as_secs_f64() / shots.len() as f64);
        }
    }
    let outcomes = rungs.into_iter().zip(&shares).map(|(rung, found)| rung.outcome(found, &shares[0]));
    Ok(outcomes.collect())
}

/// The picture that a run of the scenario has there.
fn shot(stage: &MachineStage, row: &PoseRow) -> Shot {
    let pose = &row.pose;
    let [north, east, eye] = pose.eye;
    Shot {
        time: pose.time,
        eye: pose.eye,
        // An eye outside the ground is refused where true ground is drawn.
        height: eye - stage.landscape.height(north, east).unwrap_or(0.0),
        vehicle: pose.attitude,
        camera: Attitude { roll: pose.yoke, ..pose.attitude },
        field: stage.settings.raster.field,
    }
}

fn rungs(stage: &MachineStage, shape: &Shape) -> Result<Vec<Rung>, AugmentError> {
    let ground = TrueGround::new(stage.stage())?;
    let on_true = || GroundLaw::True { ground: Box::new(ground.clone()), tracks: Vec::new() };
    let rung = |law, method, ground, penumbra| Rung {
        law,
        method: words(&method),
        augmentation: Augmentation {
            shape: shape.clone(),
            eye_height: shape.eye_height(),
            sun: None,
            penumbra,
            ground,
            method,
            inputs: String::new(),
        },
        times: Vec::new(),
    };
    let bits = |dac_bits| Method::Synchronised { dac_bits };
    let tube = |tv_lines, registration| {
        Method::ScanConverter(ScanConverter { tv_lines, registration, ..ScanConverter::default() })
    };
    let usual = ScanConverter::default();
    let mut rungs = vec![rung("true ground", bits(UNROUNDED), on_true(), false)];
    rungs.extend(BITS.map(|dac_bits| rung("true ground", bits(dac_bits), on_true(), false)));
    rungs
        .extend(TV_LINES.map(|lines| rung("true ground", tube(lines, usual.registration), on_true(), false)));
    rungs.push(rung("true ground", tube(usual.tv_lines, [0.0; 2]), on_true(), false));
    rungs.push(rung("true ground, penumbra", bits(UNROUNDED), on_true(), true));
    rungs.push(rung("flat ground, parts", bits(UNROUNDED), GroundLaw::Flat(OutlineRule::Parts), false));
    rungs.push(rung("flat ground, walk", bits(UNROUNDED), GroundLaw::Flat(OutlineRule::Walk), false));
    rungs.push(rung("flat ground, penumbra", bits(UNROUNDED), GroundLaw::Flat(OutlineRule::Parts), true));
    Ok(rungs)
}

fn words(method: &Method) -> String {
    match method {
        Method::Synchronised { dac_bits: UNROUNDED } => "not rounded".to_owned(),
        Method::Synchronised { dac_bits } => format!("converters of {dac_bits} bits"),
        Method::ScanConverter(tube) if tube.registration == [0.0; 2] => {
            format!("scan converter, {} lines, in register", tube.tv_lines)
        }
        Method::ScanConverter(tube) => format!("scan converter, {} lines", tube.tv_lines),
    }
}

impl Rung {
    /// Dark shares of all pixels, picture after picture.
    fn draw(
        &mut self,
        stage: &MachineStage,
        shots: &[(u64, Shot)],
        size: [usize; 2],
    ) -> Result<Vec<f64>, AugmentError> {
        let mut shares = Vec::with_capacity(shots.len() * size[0] * size[1]);
        for (frame, shot) in shots {
            self.augmentation.sun = Some(stage.scenery.sun(shot.time));
            shares.extend_from_slice(self.augmentation.shade(*frame, shot, size)?.shade.shares());
        }
        Ok(shares)
    }

    fn outcome(self, found: &[f64], reference: &[f64]) -> LawOutcome {
        let mut sum = Sum::default();
        let off = || found.iter().zip(reference).map(|(found, expected)| found - expected);
        off().for_each(|off| sum.add(off));
        let share = |count: f64| count / found.len() as f64;
        LawOutcome {
            law: self.law,
            method: self.method,
            dark: share(found.iter().sum()),
            differ: share(off().filter(|off| off.abs() > OTHER).count() as f64),
            rms: sum.rms(),
            time_s: spread(&self.times),
        }
    }
}

/// Rows of the outcomes for a reader, the first with the names of the columns.
pub fn laws_table(outcomes: &[LawOutcome]) -> Vec<Vec<String>> {
    let head = ["law", "method", "dark", "differs", "rms of the dark share", "ms a picture", "least", "most"];
    let row = |outcome: &LawOutcome| {
        let [dark, differ] = [outcome.dark, outcome.differ].map(|share| format!("{:.3} %", 100.0 * share));
        let [median, least, most] = outcome.time_s.map(|time| format!("{:.2}", 1e3 * time));
        let rms = format!("{:.5}", outcome.rms);
        vec![outcome.law.to_owned(), outcome.method.clone(), dark, differ, rms, median, least, most]
    };
    [head.map(str::to_owned).into()].into_iter().chain(outcomes.iter().map(row)).collect()
}
