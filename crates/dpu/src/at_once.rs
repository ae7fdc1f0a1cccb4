//! Folds that find all their words: nothing can be late, and nobody is told.

use landscape::Level;
use sweep_program::{Load, PreloadRegister, Step, StepKind, Target, WordMask};

use crate::Pointers;
use crate::crossing::TimedFold;

/// Adds folds to `steps` with the words that they ask for, which come in the same instant: what a fold does is a matter of
/// its pointers alone.
pub(crate) fn serve_at_once(
    level: &Level,
    mut pointers: Pointers,
    folds: impl Iterator<Item = TimedFold>,
    steps: &mut Vec<Step>,
) {
    for TimedFold { time, range, fold } in folds {
        let step = Step::new(time, range, StepKind::Fold(fold));
        pointers.follow(fold);
        let load = |colour, register| {
            let [m, n] = pointers.ahead(colour, register);
            let corner = level.clamped_index(m, n) as u32;
            let load = Load { colour, target: Target::Preload(register), corner, words: WordMask::ALL };
            Step { kind: StepKind::Load(load), ..step }
        };
        let ([first, second], x, y) = (fold.colours(), PreloadRegister::XFirst, PreloadRegister::YFirst);
        steps.extend([step, load(first, x), load(first, y), load(second, x), load(second, y)]);
    }
}
