//! What to say of words that were not late: which were.

use control_plane::{FrameSweeps, LateOf, LateWords, LoadMiss};
use sweep_program::SweepProgram;

use crate::late::LEVELS;

/// What was asked for, as a person writes it.
pub(crate) fn place_of(late: LateWords) -> String {
    let sweep = late.sweep;
    match late.of {
        LateOf::Crossing { crossing, .. } => format!("{sweep}:{crossing}"),
        LateOf::Crater(number) => format!("{sweep}:crater.{number}"),
        LateOf::Boundary(number) => format!("{sweep}:boundary.{number}"),
    }
}

/// What to say of a crater or a shadow boundary whose words were not late: those of the sweep that were, in `misses`.
pub(crate) fn no_late_load(misses: &[LoadMiss], late: LateWords) -> String {
    let LateWords { frame, sweep, of } = late;
    let number = |miss: &LoadMiss| match (of, miss.of) {
        (LateOf::Crater(_), LateOf::Crater(number)) | (LateOf::Boundary(_), LateOf::Boundary(number)) => {
            Some(number)
        }
        _ => None,
    };
    let numbers: Vec<u32> = misses.iter().filter_map(number).collect();
    let (one, all) = match of {
        LateOf::Crater(_) => ("no word of this crater", "craters"),
        _ => ("no word of this shadow boundary", "shadow boundaries"),
    };
    match numbers.as_slice() {
        [] => format!(
            "{one} was late, nor of any other in sweep {sweep} of frame {frame}; lunoid trace --event \
             crater-late,crater-dropped,segment-late,segment-dropped lists those of the frame"
        ),
        late => format!("{one} was late; late in sweep {sweep} of frame {frame} are {all} {}", some_of(late)),
    }
}

/// What to say of a crossing of a level whose words were not late: late ones of the sweep, or else of `count` sweeps those that have some.
pub(crate) fn no_late_word(
    sweeps: &FrameSweeps<'_>,
    late: LateWords,
    (level, crossing): (usize, u32),
    count: u32,
) -> String {
    let LateWords { frame, sweep, .. } = late;
    let programs = sweeps.programs(sweep);
    let folds = programs[level].steps.iter().filter(|step| step.kind.fold().is_some()).count();
    let there = match crossing < folds as u32 {
        true => "no word was missing at this crossing (the key `loader.delay` names the one that asked for it, which is earlier)".to_owned(),
        false => format!("the {} level has crossings 0..{folds} in sweep {sweep}", LEVELS[level]),
    };
    let of_level = programs.iter().zip(LEVELS).map(|(program, level)| (program.late_crossings(), level));
    let of_sweep: Vec<String> = of_level
        .filter(|(late, _)| !late.is_empty())
        .map(|(late, level)| format!("{} ({level} level)", some_of(&late)))
        .collect();
    if !of_sweep.is_empty() {
        return format!(
            "{there}; late in sweep {sweep} of frame {frame} are crossings {}",
            of_sweep.join("; ")
        );
    }
    let is_late = |program: &SweepProgram| !program.late_crossings().is_empty();
    let found: Vec<u32> = (0..count).filter(|&sweep| sweeps.programs(sweep).iter().any(is_late)).collect();
    match found.as_slice() {
        [] => format!(
            "{there}, and none of frame {frame}; choose a model whose loader takes time, or another frame"
        ),
        sweeps => format!(
            "{there}, and none of sweep {sweep}; sweeps with late words in frame {frame} are {}",
            some_of(sweeps)
        ),
    }
}

/// Numbers, and how many more there are.
fn some_of(numbers: &[u32]) -> String {
    const MOST: usize = 20;
    let told: Vec<String> = numbers.iter().take(MOST).map(u32::to_string).collect();
    match numbers.len().saturating_sub(MOST) {
        0 => told.join(", "),
        more => format!("{} and {more} more", told.join(", ")),
    }
}
