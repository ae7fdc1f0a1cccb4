//! Folds that find all their words: nothing can be late, and nobody is told.

use landscape::Level;
use sweep_program::{Served, Step};

use crate::home::{Pointers, moved};
use crate::unit::TimedFold;

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
    let share = |line, axis| share(level, &pointers, axis, line);
    // By line first: two that lay side by side would be read as one, and that waits until both are written.
    let mut shares = [[share(0, 0), share(0, 1)], [share(1, 0), share(1, 1)]];
    for Step { time, range, sample, kind: fold } in folds {
        let [axis, line] = moved(fold);
        pointers.follow(fold);
        let ahead = level.line_index(axis, pointers.line_ahead(axis, line)) as u64;
        let shift = 32 * axis;
        let here = shares[line][axis].rotate_left(32) & !(0xffff_ffff << shift);
        let own = here | ahead << shift;
        shares[line][axis] = own;
        let [first, second] = [own + shares[0][1 - axis], own + shares[1][1 - axis]];
        let corners = [first as u32, (first >> 32) as u32, second as u32, (second >> 32) as u32];
        steps.push(Step { time, range, sample, kind: Served { fold, corners }.into() });
    }
}

/// What a line on which colours stand adds to the indices of the corners that their registers take: to that for XFIRST in the
/// lower half, to that for YFIRST in the upper, so that both are added at once.
fn share(level: &Level, pointers: &Pointers, axis: usize, line: usize) -> u64 {
    let here = level.line_index(axis, pointers.line(axis, line)) as u64;
    let ahead = level.line_index(axis, pointers.line_ahead(axis, line)) as u64;
    if axis == 0 { ahead | here << 32 } else { here | ahead << 32 }
}
