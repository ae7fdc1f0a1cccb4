//! Folds that find all their words: nothing can be late, and nobody is told.

use landscape::Level;
use sweep_program::{PreloadRegister, Served, Step};

use crate::Pointers;
use crate::crossing::TimedFold;

/// Adds folds to `steps` with the words that they ask for, which come in the same instant: what a fold does is a matter of
/// its pointers alone.
///
/// Never inlined: within its caller, as the compiler now and then has it, the loop is short of registers (7 % of first light).
#[inline(never)]
pub(crate) fn serve_at_once(
    level: &Level,
    mut pointers: Pointers,
    folds: impl Iterator<Item = TimedFold>,
    steps: &mut Vec<Step>,
) {
    for TimedFold { time, range, fold } in folds {
        pointers.follow(fold);
        let corner = |colour, register| {
            let [m, n] = pointers.ahead(colour, register);
            level.clamped_index(m, n) as u32
        };
        let ([first, second], x, y) = (fold.colours(), PreloadRegister::XFirst, PreloadRegister::YFirst);
        let corners = [corner(first, x), corner(first, y), corner(second, x), corner(second, y)];
        steps.push(Step::new(time, range, Served { fold, corners }));
    }
}
