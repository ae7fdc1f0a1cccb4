//! What a frame of the machine, or a part of one, takes.

use control_plane::Delivery;
use generator::{Counter, FrameCounts, Joined};
use sweep_program::{Event, Served, StepKind, SweepProgram};

macro_rules! counters {
    ($($(#[$doc:meta])* $name:ident,)*; largest $($(#[$high_doc:meta])* $high:ident,)*) => {
        /// What a frame, or a part of one, takes.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub(crate) struct MachineCounts {
            $($(#[$doc])* pub $name: u64,)*
            $($(#[$high_doc])* pub $high: u64,)*
        }

        impl MachineCounts {
            /// All counters, in the order of the record.
            const ALL: &'static [Counter] = &[
                $(Counter { name: stringify!($name), joined: Joined::Sum },)*
                $(Counter { name: stringify!($high), joined: Joined::Largest }),*
            ];

            /// Adds another part's work; of what is a largest value, the larger stays.
            pub fn add(&mut self, other: &Self) {
                $(self.$name += other.$name;)*
                $(self.$high = self.$high.max(other.$high);)*
            }
        }

        impl From<MachineCounts> for FrameCounts {
            fn from(counts: MachineCounts) -> Self {
                Self::of([$((stringify!($name), counts.$name),)* $((stringify!($high), counts.$high)),*])
            }
        }
    };
}

counters! {
    /// Number of sweeps drawn.
    sweeps,
    /// Samples of all sweeps.
    samples,
    /// Stored regions that the frame can show: what a data bank must have ready.
    regions,
    /// Number of crossings of region boundaries.
    folds,
    /// Sets of words that arrived at registers.
    loads,
    /// Words that came after the fold that needed them.
    late_words,
    /// Features drawn, summed over the sweeps.
    features,
    /// Features that found no sub-generator, summed over the sweeps.
    dropped_features,
    /// Changes of the shadow gate, summed over the sweeps.
    shadow_toggles,
    /// Boundary segments that found no line generator, summed over the sweeps.
    dropped_segments,
    /// Number of bodies drawn.
    bodies,
    /// Spans of sweeps that bodies cover.
    spans,
    /// Words that the ramps of smooth light over these spans take.
    ramp_words,
    /// Bodies that were too small to be drawn.
    bodies_left_out,
    /// Craters that looked too small to be drawn, at most: squares of the map beyond their sight are counted whole.
    craters_left_out,
    /// Pixels that these would cover at most, rounded up frame by frame: what they change in the picture is no more
    /// than so many pixels of full scale.
    pixels_left_out,
    ; largest
    /// Largest step from the fine terrain level to the coarse one at the switch (mm).
    level_step_mm,
}

/// The counters that a frame of the machine has, in the order of the record.
pub const COUNTERS: &[Counter] = MachineCounts::ALL;

/// Work that one level of a sweep was.
pub(crate) fn terrain_counts(program: &SweepProgram) -> MachineCounts {
    let [mut folds, mut loads] = [0; 2];
    for step in &program.steps {
        folds += u64::from(step.kind.fold().is_some());
        loads += match step.kind {
            StepKind::Event(Event::Fold(_) | Event::BareFold(_)) => 0,
            StepKind::Event(Event::Load(_)) => 1,
            StepKind::Served(Served { corners, .. }) => corners.len() as u64,
        };
    }
    let late = program.misses.iter().map(|miss| u64::from(miss.words.0.count_ones())).sum();
    MachineCounts { folds, loads, late_words: late, ..MachineCounts::default() }
}

/// Work that the whole frame was, beside its sweeps.
pub(crate) fn delivery_counts(delivery: &Delivery) -> MachineCounts {
    let gates = || delivery.gates.iter();
    MachineCounts {
        shadow_toggles: gates().map(|gate| gate.toggles.len() as u64).sum(),
        dropped_segments: gates().map(|gate| u64::from(gate.dropped)).sum(),
        bodies: delivery.census.drawn,
        spans: delivery.census.spans,
        ramp_words: delivery.census.ramp_words,
        bodies_left_out: delivery.left_out.bodies,
        craters_left_out: delivery.craters.left_out.craters,
        pixels_left_out: [delivery.left_out.cells, delivery.craters.left_out.cells]
            .map(|cells| cells.ceil() as u64)
            .into_iter()
            .sum(),
        ..MachineCounts::default()
    }
}
