//! The posts of an elevation file.

use std::ops::Range;
use std::path::Path;

use sight::Posts;
use survey::{Frame, Opened, ReadOptions, Window};

use command_line::Failure;

/// Share by which the spacings to the north and to the east may differ. Chosen: rounding of files.
const SQUARE: f64 = 1e-6;

/// Posts of an elevation file on a plane, its frame and its title. Only the part over `hull` (south, west, north, east, m) is read,
/// all of the file without one.
pub fn posts(
    path: &Path,
    options: &ReadOptions,
    hull: Option<[f64; 4]>,
) -> Result<(Posts, Frame, String), Failure> {
    let file = survey::open(path, options)?;
    let frame = file.frame();
    expect_plane(path, &file)?;
    let window = hull.map_or_else(|| whole(&file), |hull| part(&file, hull));
    let elevation = file.window(&window)?;
    elevation.notes.iter().for_each(|note| command_line::output::tell(&format!("note: {note}\n")));
    let is_turned = elevation.affine.step[0] > 0.0;
    let [rows, columns] = [elevation.lines, elevation.columns];
    let line = |row: usize| if is_turned { rows - 1 - row } else { row };
    let height = |at: usize| elevation.height(line(at / columns), at % columns).unwrap_or(f64::NAN);
    let heights = (0..rows * columns).map(height).collect();
    let corner = elevation.place(line(0), 0);
    let posts = Posts::new([rows, columns], corner, elevation.affine.step[1], heights);
    let posts = posts.map_err(|error| Failure::input(format!("{}: {error}", path.display())))?;
    Ok((posts, frame, elevation.title.clone()))
}

/// Refuses degrees, and posts that stand farther apart along one axis.
fn expect_plane(path: &Path, file: &Opened) -> Result<(), Failure> {
    let [north, east] = file.affine().step.map(f64::abs);
    let path = path.display();
    if let Frame::Geographic { .. } = file.frame() {
        return Err(Failure::input(format!(
            "{path}: places in degrees; expected metres of a plane; make a bank of it with `lunoid survey` (--centre, --size-m) and \
             name the bank here"
        )));
    }
    if (north - east).abs() > SQUARE * east {
        return Err(Failure::input(format!(
            "{path}: posts stand {north} m apart to the north and {east} m to the east; expected one spacing; lay the file on \
             square cells with gdalwarp -tr, or make a bank of it with `lunoid survey`"
        )));
    }
    Ok(())
}

fn whole(file: &Opened) -> Window {
    let [lines, columns] = file.size();
    Window { lines: 0..lines, columns: 0..columns }
}

/// The part of a file over a hull, one post wider all around, and two posts wide at least.
fn part(file: &Opened, [south, west, north, east]: [f64; 4]) -> Window {
    let affine = file.affine();
    let span = |axis: usize, ends: [f64; 2]| -> Range<usize> {
        let last = file.size()[axis] - 1;
        let at = ends.map(|end| (end - affine.first[axis]) / affine.step[axis]);
        let first = (at[0].min(at[1]).floor() - 1.0).clamp(0.0, last.saturating_sub(1) as f64) as usize;
        let end = (at[0].max(at[1]).ceil() + 1.0).clamp(0.0, last as f64) as usize;
        first..end.max(first + 1) + 1
    };
    Window { lines: span(0, [south, north]), columns: span(1, [west, east]) }
}
