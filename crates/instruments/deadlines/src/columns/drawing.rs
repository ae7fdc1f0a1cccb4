//! Both pictures, their difference, and what each column is.

use std::path::Path;

use ::plots::{Columns, columns_picture};
use compare::difference_picture;
use picture::GreyPicture;

use super::four::Four;
use super::verdict::{Class, Column};
use crate::DeadlineError;

/// Levels of the difference picture for one level of difference.
const FACTOR: u32 = 4;

/// Writes the picture under `title`, with `summary` below it.
pub fn write(
    four: &Four,
    columns: &[Column],
    [title, summary]: [&str; 2],
    path: &Path,
) -> Result<(), DeadlineError> {
    let difference = difference_picture(&four.machine, &four.ideal, FACTOR)?;
    let codes =
        |picture: &GreyPicture| -> Vec<u8> { picture.codes().iter().map(|&code| code as u8).collect() };
    let [machine, ideal, difference] = [&four.machine, &four.ideal, &difference].map(codes);
    let mut class_of = vec![None; four.machine.columns()];
    for column in columns {
        class_of[column.worst.column] = Some(number(column));
    }
    let picture = Columns {
        width: four.machine.columns(),
        pictures: vec![
            ("the machine", &machine),
            ("the ideal machine", &ideal),
            ("difference, 4 times, on grey", &difference),
        ],
        classes: vec!["timing", "parts", "both", "untraced"],
        class_of,
    };
    let drawing = columns_picture(&picture, title, &[summary.to_owned()]).map_err(DeadlineError::Asked)?;
    drawing.write(path).map_err(DeadlineError::Write)
}

fn number(column: &Column) -> usize {
    match (column.is_accounted_for(), column.class) {
        (false, _) => 3,
        (true, Class::Timing) => 0,
        (true, Class::Parts) => 1,
        (true, Class::Both) => 2,
    }
}
