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
    use super::counted_table;

    #[test]
    fn more_instructions_than_allowed_are_told() {
        let mut turn = 0;
        let cells: Vec<u64> = vec![1000, 10];
        let turns = std::cell::RefCell::new(&mut turn);
        let text = counted_table(|_| {
            let mut turn = turns.borrow_mut();
            **turn += 1;
            Ok(cells[(**turn - 1) % 2])
        });
        let text = text.unwrap();
        assert!(text.lines().skip(2).all(|line| line.contains("| 100.000 | **not met** | 1000 | 10 |")));
        assert!(
            counted_table(|_| Ok(7)).unwrap().lines().skip(2).all(|line| line.contains("| 1.000 | met |"))
        );
    }
}
