//! Television lines as waveforms: what comes, what darkens it, what goes.

use picture::{Depth, GreyPicture};
use quantities::{Rate, Timebase};
use signal::{Kind, Probe, Signal, Unit, Waveform, Wire};

use crate::augmentation::{Augmentation, GroundLaw};
use crate::insertion::{Method, converted, unit};
use crate::shadow::Shadow;
use crate::timing_record::{MASTER_HZ, ticks};

/// What can be looked at; a line of a picture stands for a sweep, its columns for samples, from the left.
pub const SIGNALS: [Signal; 6] = [
    Signal::ground("vs.video.in", Unit::Number, "code of the picture that comes", "figures 34, 35"),
    Signal::digital(
        "vs.gate",
        Unit::Number,
        Kind::Analog,
        "share of the sun's points for which the line is in shadow or on a track: changes where the line crosses outlines; of a scan \
         converter, on its written line at the same height",
        "figures 34, 35",
    ),
    Signal::digital(
        "vs.tracks",
        Unit::Gate,
        Kind::Gate,
        "high on tracks, which vs.gate holds too",
        "figures 34, 35",
    ),
    Signal::digital(
        "vs.blank",
        Unit::Number,
        Kind::Analog,
        "vs.gate at the places of the D/A converters",
        "figure 34",
    ),
    Signal::ground(
        "vs.dark",
        Unit::Number,
        "share of the video that is taken out of a pixel",
        "figures 34, 35",
    ),
    Signal::ground(
        "vs.video.out",
        Unit::Number,
        "video of the new picture, in codes, before it is rounded to one",
        "figures 34, 35",
    ),
];

/// Longest time between two pictures that parts into lines (s): its picoseconds fit into 64 bits many times.
const LONGEST_S: f64 = 86_400.0;

/// Lines of one frame that are looked at.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Look {
    /// Number of the frame.
    pub frame: u64,
    /// Which lines of it, and what of them.
    pub probe: Probe,
}

impl Look {
    /// Nothing is looked at.
    pub fn off() -> Self {
        Self::default()
    }

    pub(crate) fn wants(&self, frame: u64) -> bool {
        self.frame == frame && self.probe.is_on()
    }
}

/// Clocks of `lines` lines of `columns` columns, which part the `period` of pictures (s) evenly, in whole microseconds (our choice: how
/// long a camera takes from line to line is not known); `None` if pictures come less than once a day.
pub fn line_timebase(period: f64, [columns, lines]: [u32; 2]) -> Option<Timebase> {
    if period.is_nan() || period > LONGEST_S {
        return None;
    }
    let master = Rate::new(MASTER_HZ as u64, 1)?;
    let update = Rate::new(MASTER_HZ as u64, ticks(period).max(1))?;
    Timebase::new(master, update, lines, columns, 0).ok()
}

impl Augmentation {
    /// The wires that its ground and its method have, for pictures of `depth`. Codes and shares have no voltage.
    pub fn wires(&self, depth: Depth) -> Vec<Wire> {
        let has_tracks = matches!(&self.ground, GroundLaw::True { tracks, .. } if !tracks.is_empty());
        let has_converters = matches!(self.method, Method::Synchronised { .. });
        let is_there = |signal: &&Signal| match signal.name {
            "vs.tracks" => has_tracks,
            "vs.blank" => has_converters,
            _ => true,
        };
        let wire = |signal: &Signal| {
            let is_video = signal.name.starts_with("vs.video");
            let full_scale = if is_video { f64::from(depth.white()) } else { 1.0 };
            Wire { signal: *signal, full_scale, volts: 0.0, datum: 0.0 }
        };
        SIGNALS.iter().filter(is_there).map(wire).collect()
    }
}

/// The lines of one picture.
pub(crate) struct Lines<'a> {
    pub augmentation: &'a Augmentation,
    pub picture: &'a GreyPicture,
    pub shadow: &'a Shadow,
}

impl Lines<'_> {
    /// Records what `probe` wants.
    pub fn record(&self, frame: u64, probe: &mut Probe) {
        let mut wires = self.augmentation.wires(self.picture.depth());
        wires.retain(|wire| probe.wants(&wire.signal));
        let mut lines: Vec<usize> = (0..self.picture.lines()).collect();
        lines.retain(|&line| probe.wants_sweep(line as u32));
        for line in lines {
            for Wire { signal, .. } in &wires {
                let (times, values) = self.read(signal.name, line);
                probe.waveforms.push(Waveform { signal: *signal, frame, sweep: line as u32, times, values });
            }
        }
    }

    /// Instants (columns; none of what has a value a column) and values of a signal on a line.
    fn read(&self, name: &str, line: usize) -> (Vec<f64>, Vec<f64>) {
        let Self { picture, shadow: Shadow { gates, half_width, shade, .. }, .. } = *self;
        let columns = picture.columns();
        let method = self.augmentation.method;
        let written = method.raster_line(line, picture.lines());
        let of_suns = || gates.suns.iter().map(|sun| &sun.lines[written]);
        let sampled = |values| (Vec::new(), values);
        match (name, method) {
            ("vs.video.in", _) => sampled(picture.line(line).iter().map(|&code| f64::from(code)).collect()),
            ("vs.gate", _) => changes(of_suns().map(|gate| unit(gate, *half_width)), columns),
            ("vs.tracks", _) => changes([unit(&gates.tracks[written], *half_width)].into_iter(), columns),
            ("vs.blank", Method::Synchronised { dac_bits }) => {
                changes(of_suns().map(|gate| converted(gate, *half_width, dac_bits)), columns)
            }
            ("vs.dark", _) => sampled(shade.shares()[line * columns..][..columns].to_vec()),
            ("vs.video.out", _) => sampled(shade.video(picture).skip(line * columns).take(columns).collect()),
            _ => unreachable!("{name} is no wire of this method"),
        }
    }
}

/// Share of the `suns` whose stretches (shares of the width) hold a place: where it changes, in columns, and to what, from
/// 0 on. What is dark up to the end of the line ends with it.
fn changes(suns: impl ExactSizeIterator<Item = Vec<[f64; 2]>>, columns: usize) -> (Vec<f64>, Vec<f64>) {
    let all = suns.len() as f64;
    let ends = suns.flatten().flat_map(|[from, to]| [(from, 1), (to, -1)]);
    let mut ends: Vec<(f64, i32)> = ends.map(|(share, by)| (share * columns as f64, by)).collect();
    ends.retain(|(at, _)| *at < columns as f64);
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut times, mut values) = (vec![0.0], vec![0.0]);
    let mut dark = 0;
    for together in ends.chunk_by(|a, b| a.0 == b.0) {
        let before = dark;
        dark += together.iter().map(|(_, by)| by).sum::<i32>();
        let (at, share) = (together[0].0, f64::from(dark) / all);
        if at == 0.0 {
            values[0] = share;
        } else if dark != before {
            times.push(at);
            values.push(share);
        }
    }
    (times, values)
}

#[cfg(test)]
mod tests {
    use super::{changes, line_timebase};

    #[test]
    fn shares_of_several_suns_change_where_any_does() {
        let suns = [vec![[0.0, 0.25], [0.5, 1.0]], vec![[0.125, 0.5]], vec![]];
        let found = changes(suns.into_iter(), 8);
        assert_eq!(found.0, [0.0, 1.0, 2.0]);
        assert_eq!(found.1, [1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0]);
        // What one begins where the other ends changes nothing; what is dark to the end ends with the line.
        assert_eq!(changes([vec![]].into_iter(), 8), (vec![0.0], vec![0.0]));
        assert_eq!(changes([vec![[0.5, 0.5], [0.75, 1.0]]].into_iter(), 8), (vec![0.0, 6.0], vec![0.0, 1.0]));
    }

    #[test]
    fn lines_part_the_time_between_pictures() {
        let clocks = line_timebase(0.1, [100, 60]).unwrap();
        assert_eq!(clocks.sample_rate().fraction(), [60_000, 1]);
        assert_eq!((clocks.sweeps, clocks.active_samples, clocks.retrace_samples), (60, 100, 0));
        for wrong in [f64::NAN, f64::INFINITY, 1e9] {
            assert_eq!(line_timebase(wrong, [100, 60]), None);
        }
    }
}
