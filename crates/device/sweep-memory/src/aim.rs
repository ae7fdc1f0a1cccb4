//! Where the beams of a group are, what drives them, and what they leave where they are slow: in vectors.

use fearless_simd::prelude::SimdBase;
use fearless_simd::{Level, Simd, dispatch, f32x8};
use signal::{LANES, Lanes, Real};

use crate::deflection::Deflection;
use crate::exposure::Target;

/// The beams of a group, one [`Lanes`] a sample.
#[derive(Debug, Clone, Default)]
pub(crate) struct Aim {
    /// Line positions of the beams, from the top of the picture.
    pub places: Vec<Lanes<f32>>,
    /// What drives the beams ([`Target::drive`]).
    pub drives: Vec<Lanes<f32>>,
    /// What the whole steps from the samples before leave; of the first sample nothing that counts.
    pub dots: Vec<Dots>,
}

/// What whole steps of a group leave that touch at most two lines each, as nearly all of far ground do.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Dots {
    /// The upper lines; beyond all pictures for a step that is to be looked at closely.
    pub lines: [u32; LANES],
    /// In the upper line and the one below it.
    pub charges: [[f32; LANES]; 2],
}

impl Dots {
    /// None that could be told.
    pub const NONE: Self = Self { lines: [u32::MAX; LANES], charges: [[0.0; LANES]; 2] };
}

impl Aim {
    /// Aims at `position` through `deflection`, driven by `intensity`; behind the last intensity the beam is black.
    pub fn take<S: Real>(
        &mut self,
        (position, intensity): (&[Lanes<S>], &[Lanes<S>]),
        deflection: Option<&Deflection<S>>,
        (target, lines): (&impl Target, usize),
    ) {
        self.places.resize(position.len(), Lanes::default());
        self.drives.clear();
        self.drives.resize(position.len(), Lanes::default());
        self.dots.resize(position.len(), Dots::NONE);
        dispatch!(Level::new(), simd => {
            match deflection {
                Some(deflection) => deflection.run_wide(simd, position, &mut self.places),
                None => singles(simd, position, &mut self.places),
            }
            singles(simd, intensity, &mut self.drives);
            self.drive(simd, target);
            self.leave_dots(simd, target, lines);
        });
    }

    #[inline(always)]
    fn drive<L: Simd>(&mut self, simd: L, target: &impl Target) {
        for drive in &mut self.drives {
            target.drive(f32x8::from_slice(simd, &drive.0)).store_slice(&mut drive.0);
        }
    }

    #[inline(always)]
    fn leave_dots<L: Simd>(&mut self, simd: L, target: &impl Target, lines: usize) {
        let (mut place, mut drive) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 0.0));
        for (dots, (places, drives)) in self.dots.iter_mut().zip(self.places.iter().zip(&self.drives)) {
            let [place_before, drive_before] = [place, drive];
            (place, drive) = (f32x8::from_slice(simd, &places.0), f32x8::from_slice(simd, &drives.0));
            *dots = target.dots(simd, [place_before, place], [drive_before, drive], lines as f32);
        }
    }
}

/// Signals as numbers of single precision, as far as `out` goes.
#[inline(always)]
fn singles<L: Simd, S: Real>(simd: L, signal: &[Lanes<S>], out: &mut [Lanes<f32>]) {
    for (value, out) in signal.iter().zip(out) {
        single::<L, S>(simd, S::Vector::from_slice(simd, &value.0)).store_slice(&mut out.0);
    }
}

#[inline(always)]
pub(crate) fn single<L: Simd, S: Real>(simd: L, values: S::Vector<L>) -> f32x8<L> {
    let mut singles = [0.0; LANES];
    for lane in 0..LANES {
        singles[lane] = values[lane].to_f64() as f32;
    }
    f32x8::from_slice(simd, &singles)
}
