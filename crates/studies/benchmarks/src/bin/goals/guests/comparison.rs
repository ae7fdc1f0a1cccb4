//! Comparisons of two sides, which draw in turns.

use std::fmt::Write as _;

use rayon::{ThreadPool, ThreadPoolBuilder};

use super::list::Against;
use super::osmesa::OsMesa;
use super::{Comparison, Guests, Side};
use benchmarks::peers::embree::{Embree, EyeMesh, Program, camera_sight, screen_mesh};
use benchmarks::peers::median;

/// Rays of a packet, and qualities of the structure: the fastest of each counts.
const PACKETS: [u32; 3] = [16, 8, 1];
const QUALITIES: [&str; 3] = ["low", "medium", "high"];
/// Mean difference of two pictures up to which they show the same (share of white). Chosen: a missing mesh has a hundred times as much.
const ALIKE: f64 = 0.01;

/// Medians of both sides (s), and a remark.
struct Medians {
    first: f64,
    second: f64,
    remark: String,
}

/// All comparisons whose quantity has `part` in it, as a table in Markdown.
///
/// # Errors
/// If a side cannot be drawn, or a program of other people shows another picture.
pub fn table(part: &str) -> Result<String, String> {
    let [one, two] = [1, 2].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build());
    let pools = [one.map_err(|error| error.to_string())?, two.map_err(|error| error.to_string())?];
    let mut text = "| issue | quantity | must | aim | measured | | ms | other, ms | |\n|---|---|---|---|---|---|---|---|---|\n".to_owned();
    for row in Guests::read()?.comparison.iter().filter(|row| row.quantity.contains(part)) {
        let Comparison { issue, quantity, must, aim, .. } = row;
        let found = medians(row, &pools).map_err(|error| format!("{quantity}: {error}"))?;
        let Medians { first, second, remark } = match found {
            Ok(medians) => medians,
            Err(skipped) => {
                let _ = writeln!(text, "| {issue} | {quantity} | {must} | {aim} | | {skipped} | | | |");
                continue;
            }
        };
        let (figure, is_met) = row.figure(first, second);
        let met = if is_met { "met" } else { "**not met**" };
        let _ = writeln!(
            text,
            "| {issue} | {quantity} | {must} | {aim} | {figure:.2} | {met} | {:.2} | {:.2} | {remark} |",
            first * 1e3,
            second * 1e3
        );
    }
    Ok(text)
}

/// Medians of a row; the inner error is a line that names the package that is missing here.
fn medians(row: &Comparison, [one, two]: &[ThreadPool; 2]) -> Result<Result<Medians, String>, String> {
    let mut first = Side::new(&row.first)?;
    match &row.against {
        Against::Side(other) => {
            let mut second = Side::new(other)?;
            let threads = if row.alone { one } else { two };
            in_turns(row.turns, || first.draw(threads), || second.draw(threads)).map(Ok)
        }
        Against::OneThread => {
            let mut second = Side::new(&row.first)?;
            in_turns(row.turns, || first.draw(two), || second.draw(one)).map(Ok)
        }
        Against::RealTime(rate) => in_turns(row.turns, || first.draw(two), || Ok(1.0 / rate)).map(Ok),
        Against::Embree { fineness, anew } => {
            let program = match Program::compile()? {
                Ok(program) => program,
                Err(skipped) => return Ok(Err(skipped)),
            };
            let Drawn { picture, mesh } = drawn(&mut first, two)?;
            let mut embree = program.start(&mesh, &camera_sight(&first.stage.view, *fineness))?;
            let (packet, quality) = fastest(&mut embree, *anew, Embree::show)?;
            let columns = first.stage.view.columns as usize;
            let difference = alike(&picture, &embree.picture()?, [columns, *fineness as usize])?;
            let found = in_turns(
                row.turns,
                || first.draw(two),
                || traced(&mut embree, packet, anew.then_some(quality)),
            )?;
            let remark = format!(
                "{} triangles, packets of {packet}, {quality}; pictures differ by {difference:.4}",
                mesh.faces.len()
            );
            Ok(Ok(Medians { remark, ..found }))
        }
        Against::Osmesa { anew } => {
            let Drawn { picture, mesh } = drawn(&mut first, two)?;
            let mut osmesa = match OsMesa::new(&mesh, &camera_sight(&first.stage.view, 1))? {
                Ok(osmesa) => osmesa,
                Err(skipped) => return Ok(Err(skipped)),
            };
            osmesa.show(*anew)?;
            let columns = first.stage.view.columns as usize;
            let difference = alike(&picture, &osmesa.picture()?, [columns, 1])?;
            let found = in_turns(row.turns, || first.draw(two), || osmesa.show(*anew))?;
            let remark = format!("{} triangles; pictures differ by {difference:.4}", mesh.faces.len());
            Ok(Ok(Medians { remark, ..found }))
        }
    }
}

/// A picture, and the faces that it was drawn from.
struct Drawn {
    picture: Vec<f32>,
    mesh: EyeMesh,
}

/// The next picture of a side, with its faces before the camera.
fn drawn(side: &mut Side, pool: &ThreadPool) -> Result<Drawn, String> {
    side.draw(pool)?;
    let (picture, frame, pose) = side.picture()?;
    let faces = side.session().faces(frame, &pose).map_err(|error| error.to_string())?;
    let mesh = screen_mesh(&faces.ok_or("the generator has no faces")?, &side.stage.view);
    Ok(Drawn { picture, mesh })
}

/// Mean difference of two pictures; see [`difference`].
///
/// # Errors
/// If they do not show the same scene.
fn alike(picture: &[f32], other: &[f32], size: [usize; 2]) -> Result<f64, String> {
    let difference = difference(picture, other, size);
    if difference > ALIKE {
        return Err(format!("the pictures differ by {difference:.4} in the mean: expected the same scene"));
    }
    Ok(difference)
}

/// A frame by Embree (s), with its structure if that is made anew.
fn traced(embree: &mut Embree, packet: u32, quality: Option<&str>) -> Result<f64, String> {
    let divided = quality.map_or(Ok(0.0), |quality| embree.divide(quality))?;
    Ok(divided + embree.show(packet)?)
}

/// The fastest packet and quality of the structure for what `show` asks of it. Making the structure counts if each frame makes it.
///
/// # Errors
/// If it does not answer.
pub fn fastest(
    embree: &mut Embree,
    anew: bool,
    show: impl Fn(&mut Embree, u32) -> Result<f64, String>,
) -> Result<(u32, &'static str), String> {
    let mut best: Option<(f64, u32, &str)> = None;
    for quality in QUALITIES {
        let divided = embree.divide(quality)?;
        for packet in PACKETS {
            show(embree, packet)?;
            let seconds = show(embree, packet)? + if anew { divided } else { 0.0 };
            if best.is_none_or(|(least, ..)| seconds < least) {
                best = Some((seconds, packet, quality));
            }
        }
    }
    let (_, packet, quality) = best.ok_or("no packet was tried")?;
    embree.divide(quality)?;
    show(embree, packet)?;
    Ok((packet, quality))
}

/// Mean difference of a picture and one of more rays a pixel, whose means are taken.
fn difference(picture: &[f32], rays: &[f32], [columns, fineness]: [usize; 2]) -> f64 {
    let mean = |pixel: usize| {
        let (column, line) = (pixel % columns, pixel / columns);
        let ray = |k: usize| {
            rays[(line * fineness + k / fineness) * columns * fineness + column * fineness + k % fineness]
        };
        (0..fineness * fineness).map(|k| f64::from(ray(k))).sum::<f64>() / (fineness * fineness) as f64
    };
    let sum: f64 =
        picture.iter().enumerate().map(|(pixel, &found)| (f64::from(found) - mean(pixel)).abs()).sum();
    sum / picture.len().max(1) as f64
}

/// Medians of two sides in turns, each after a frame that is not timed.
fn in_turns(
    turns: usize,
    mut first: impl FnMut() -> Result<f64, String>,
    mut second: impl FnMut() -> Result<f64, String>,
) -> Result<Medians, String> {
    first()?;
    second()?;
    let (mut of_first, mut of_second) = (Vec::new(), Vec::new());
    for _ in 0..turns.max(1) {
        of_first.push(first()?);
        of_second.push(second()?);
    }
    Ok(Medians { first: median(of_first), second: median(of_second), remark: String::new() })
}

#[cfg(test)]
mod tests {
    use super::{difference, in_turns};

    #[test]
    fn four_rays_make_a_pixel() {
        let rays = [0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 1.0];
        assert_eq!(difference(&[0.75, 0.75], &rays, [2, 2]), 0.0);
        assert_eq!(difference(&[0.75, 1.0], &rays, [2, 2]), 0.125);
    }

    #[test]
    fn the_first_frame_of_each_side_is_not_timed() {
        let (mut slow, mut fast) = (9.0, 5.0);
        let found =
            in_turns(3, || Ok(std::mem::replace(&mut slow, 2.0)), || Ok(std::mem::replace(&mut fast, 1.0)));
        let found = found.unwrap();
        assert_eq!((found.first, found.second), (2.0, 1.0));
    }
}
