//! Rows of sub-areas as waveforms: what the sampler met in each sub-area.

use generator::Stage;
use quantities::Timebase;
use raster::Screen;
use scenario::View;
use scene_sampler::{Camera, Reading, SIDE};
use signal::{Probe, Signal, Unit, Waveform, Wire};

use crate::hardware::Hardware;
use crate::parameters::Parameters;
use crate::work::frame_ticks;

/// Place of a sub-area in its row.
pub(crate) const ACROSS: &str = "sampled.across";

/// Distance of the plane on which rows lie.
pub(crate) const AHEAD: &str = "sampled.ahead";

/// Value of [`AHEAD`] (m).
const PLANE: f64 = 1.0;

/// Ground range where a sub-area shows sky (m).
const NO_RANGE: f64 = -1.0;

/// What can be looked at; a row of sub-areas stands for a sweep, its sub-areas for samples, from the top left on.
pub(crate) static SIGNALS: [Signal; 8] = [
    Signal::ground(
        AHEAD,
        Unit::Metre,
        "distance of the plane on which rows of sub-areas lie: 1 m",
        "none: ours",
    ),
    Signal::ground(
        ACROSS,
        Unit::Metre,
        "middle of the sub-area on that plane, to the right of the view axis",
        "none: ours",
    ),
    Signal::ground(
        "sampled.range",
        Unit::Metre,
        "ground range of the surface in the middle pixel of the sub-area; -1 where there is sky",
        "EP-0611021, claim 3",
    ),
    Signal::ground(
        "sampled.list",
        Unit::Number,
        "entries of the list: triangles, raster points",
        "EP-0611021, abstract",
    ),
    Signal::ground("sampled.ticks", Unit::Number, "ticks of the sampler", "EP-0611021, abstract"),
    Signal::ground(
        "sampled.stack",
        Unit::Number,
        "features of the deepest sampling point",
        "EP-0611021, claim 3",
    ),
    Signal::ground(
        "sampled.rest",
        Unit::Reflectivity,
        "largest share of light that all features of a sampling point let through",
        "EP-0611021, claim 4",
    ),
    Signal::ground(
        "sampled.lights",
        Unit::Number,
        "light points whose discs meet the sub-area",
        "EP-0611021, claim 1",
    ),
];

/// Clocks for as many rows and columns of sub-areas as a raster has. Rows part a frame evenly: our choice, since their ticks
/// differ.
pub(crate) fn timebase(view: &View) -> Option<Timebase> {
    let [columns, rows] = [view.columns, view.lines].map(|pixels| pixels.div_ceil(SIDE as u32));
    Timebase::new(view.update, view.update, rows, columns, 0).ok()
}

/// The wires of a stage. Numbers of a sub-area have no voltage; full scale of entries and ticks is the mean of a full frame.
pub(crate) fn wires(stage: &Stage, screen: &Screen, run: &Parameters, hardware: &Hardware) -> Vec<Wire> {
    let mean = frame_ticks(hardware, stage.view.update) as f64 / screen.sub_areas() as f64;
    // A stack without limit is shown as deep as a list.
    let deepest = run
        .sampling
        .translucent
        .zip(run.sampling.lights)
        .map_or(mean, |(surfaces, lights)| f64::from(surfaces) + f64::from(lights) + 1.0);
    let scales =
        [PLANE, stage.view.field.tan_half_width, stage.view.ranges[1], mean, mean, deepest, 1.0, mean];
    let wire = |(signal, full_scale)| Wire { signal, full_scale, volts: 0.0, datum: 0.0 };
    SIGNALS.into_iter().zip(scales).map(wire).collect()
}

/// Rows of a frame, ready to be read off.
pub(crate) struct Rows<'a> {
    pub screen: &'a Screen,
    pub camera: &'a Camera,
    pub hardware: &'a Hardware,
    pub readings: &'a [Reading],
}

impl Rows<'_> {
    /// Records the rows that `probe` wants.
    pub fn record(&self, frame: u64, probe: &mut Probe) {
        let [columns, rows] = self.screen.counts();
        for row in 0..rows {
            if !probe.wants_sweep(row) {
                continue;
            }
            let areas = row * columns..(row + 1) * columns;
            for (place, signal) in SIGNALS.into_iter().enumerate() {
                if probe.wants(&signal) {
                    let values = areas.clone().map(|area| self.values(area as usize)[place]).collect();
                    probe.waveforms.push(Waveform { signal, frame, sweep: row, times: Vec::new(), values });
                }
            }
        }
    }

    /// Values of all signals at a sub-area, in the order of [`SIGNALS`].
    fn values(&self, number: usize) -> [f64; 8] {
        let (reading, middle) = (&self.readings[number], self.middle(number));
        [
            PLANE,
            self.camera.projection.ray(middle).x * PLANE,
            self.range(middle, reading.q),
            reading.entries() as f64,
            self.hardware.ticks(reading) as f64,
            f64::from(reading.depth),
            reading.rest,
            f64::from(reading.lights()),
        ]
    }

    /// Middle pixel of a sub-area (pixels on the screen).
    fn middle(&self, number: usize) -> [f64; 2] {
        let area = self.screen.sub_area(number);
        [area.columns(), area.rows()].map(|range| f64::from(range.start) + (range.len() / 2) as f64 + 0.5)
    }

    fn range(&self, middle: [f64; 2], q: f64) -> f64 {
        if q > 0.0 { self.camera.ray(middle).truncate().length() / q } else { NO_RANGE }
    }
}

#[cfg(test)]
mod tests {
    use generator::{Generator, Planes};

    use super::*;
    use crate::scenes;

    #[test]
    fn a_row_of_sub_areas_is_read_off() {
        let (generator, update) = scenes::slow(10);
        let stage = scenes::stage(scenes::pane_and_stars(), update);
        let scan = generator.scan(&stage.view).unwrap();
        assert_eq!((scan.timebase.sweeps, scan.timebase.active_samples), (2, 2));
        let session = generator.prepare(stage).unwrap();
        let mut probe = Probe::new(vec!["sampled.*".into()], 0..2);
        let mut planes = Planes::new(16, 16, &[]);
        session.frame(0, &scenes::pose(), &mut planes, &mut probe).unwrap();
        let read: Vec<_> = probe
            .waveforms
            .iter()
            .map(|waveform| (waveform.sweep, waveform.signal.name, waveform.values.as_slice()))
            .collect();
        let across = [-0.04375, 0.05625];
        let expected: [(u32, &str, &[f64]); 16] = [
            (0, AHEAD, &[1.0; 2]),
            (0, ACROSS, &across),
            (0, "sampled.range", &[-1.0, -1.0]),
            (0, "sampled.list", &[2.0, 1.0]),
            (0, "sampled.ticks", &[2.0, 1.0]),
            (0, "sampled.stack", &[1.0, 1.0]),
            (0, "sampled.rest", &[0.5, 1.0]),
            (0, "sampled.lights", &[0.0, 1.0]),
            (1, AHEAD, &[1.0; 2]),
            (1, ACROSS, &across),
            (1, "sampled.range", &[-1.0, -1.0]),
            (1, "sampled.list", &[2.0, 0.0]),
            (1, "sampled.ticks", &[2.0, 2.0]),
            (1, "sampled.stack", &[1.0, 0.0]),
            (1, "sampled.rest", &[0.5, 1.0]),
            (1, "sampled.lights", &[0.0, 1.0]),
        ];
        assert_eq!(read, expected);
        assert!(session.wires().iter().map(|wire| wire.signal).eq(SIGNALS));
    }
}
