//! Work done: counters are results, the same for any number of threads.

use serde::{Deserialize, Serialize};

macro_rules! counters {
    ($($(#[$doc:meta])* $name:ident,)*; largest $($(#[$high_doc:meta])* $high:ident,)*) => {
        /// What a frame, or a run, took.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
        #[serde(default)]
        pub struct FrameCounts {
            $($(#[$doc])* pub $name: u64,)*
            $($(#[$high_doc])* pub $high: u64,)*
        }

        impl FrameCounts {
            /// Adds another part's work; of what is a largest value, the larger stays.
            pub fn add(&mut self, other: &Self) {
                $(self.$name += other.$name;)*
                $(self.$high = self.$high.max(other.$high);)*
            }

            /// All counters with their names, in the order of the record.
            pub fn named(&self) -> impl Iterator<Item = (&'static str, u64)> {
                [$((stringify!($name), self.$name),)* $((stringify!($high), self.$high)),*].into_iter()
            }
        }
    };
}

counters! {
    /// Sweeps drawn.
    sweeps,
    /// Samples of all sweeps, or rays of a generator without sweeps.
    samples,
    /// Stored regions that the frame can show: what a data bank must have ready.
    regions,
    /// Region crossings.
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
    /// Bodies drawn.
    bodies,
    /// Spans of sweeps that bodies cover.
    spans,
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
