//! Instructions of guests, each side in a process of its own.

use std::fmt::Write as _;

use benchmarks::counted;
use rayon::ThreadPoolBuilder;

use super::list::CountedRow;
use super::{Guests, Side, SideChoice};

/// Draws two frames of a side on the thread that asks, the second within the function that callgrind knows.
///
/// # Errors
/// If it cannot be drawn.
pub fn draw_counted(choice: &SideChoice) -> Result<(), String> {
    let pool = ThreadPoolBuilder::new().num_threads(1).use_current_thread().build();
    let pool = pool.map_err(|error| error.to_string())?;
    let mut side = pool.install(|| Side::new(choice))?;
    side.draw(&pool)?;
    let mut drawn = Ok(0.0);
    counted(&mut || drawn = side.draw(&pool));
    drawn.map(drop)
}

/// All rows of counts as a table in Markdown; `apart` tells the instructions of the second frame of a side in a process of its own.
///
/// # Errors
/// If a side cannot be counted.
pub fn counted_table(apart: impl Fn(&SideChoice) -> Result<u64, String>) -> Result<String, String> {
    let mut text =
        "| issue | instructions of a frame | must | aim | times the other's | | ours | other |\n|---|---|---|---|---|---|---|---|\n"
            .to_owned();
    for CountedRow { issue, quantity, must, aim, first, against } in &Guests::read()?.counted {
        let [ours, other] = [apart(first)?, apart(against)?];
        let times = ours as f64 / other as f64;
        let met = if times <= *must { "met" } else { "**not met**" };
        let _ = writeln!(
            text,
            "| {issue} | {quantity} | {must} | {aim} | {times:.3} | {met} | {ours} | {other} |"
        );
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::counted_table;

    #[test]
    fn more_instructions_than_allowed_are_told() {
        let turn = Cell::new(0);
        let dear = counted_table(|_| {
            turn.set(turn.get() + 1);
            Ok([10, 1000][turn.get() % 2])
        });
        let rows = |text: &str, end: &str| text.lines().skip(2).all(|line| line.contains(end));
        assert!(rows(&dear.unwrap(), "| 100.000 | **not met** | 1000 | 10 |"));
        assert!(rows(&counted_table(|_| Ok(7)).unwrap(), "| 1.000 | met | 7 | 7 |"));
    }
}
