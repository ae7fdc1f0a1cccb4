//! Fits 10^7 synthetic samples and prints the figures: `cargo run --release -p survey --example ten-million -- [REGION_SIZE] [HOLES]`.
//! Time is for people only; nothing is written.

use std::time::Instant;

use survey::{Affine, Elevation, Frame, SurveyOptions, survey};

const SIDE: usize = 3163;

fn main() -> Result<(), survey::SurveyError> {
    let mut arguments = std::env::args().skip(1).filter_map(|text| text.parse().ok());
    let (size, holes) = (arguments.next().unwrap_or(8.0), arguments.next().unwrap_or(0.0));
    let heights = (0..SIDE * SIDE).map(|index| height(index / SIDE, index % SIDE, holes)).collect();
    let affine = Affine { first: [0.0; 2], step: [1.0; 2] };
    let elevation = Elevation::new(SIDE, SIDE, heights, affine, Frame::Plane(None));
    let start = Instant::now();
    let survey = survey(&elevation, &SurveyOptions::new(size), &mut |step| {
        if step.iteration % 10 == 0 {
            eprintln!("{step:?}")
        }
    })?;
    println!("{:#?}", survey.report);
    println!("{:.2} s", start.elapsed().as_secs_f64());
    Ok(())
}

/// Waves of many lengths and some noise; `holes` discs of 30 m radius without data on a side.
fn height(line: usize, column: usize, holes: f64) -> f64 {
    let (x, y) = (line as f64, column as f64);
    if holes > 0.0 {
        let pitch = SIDE as f64 / holes;
        let (a, b) = (x % pitch - 0.5 * pitch, y % pitch - 0.5 * pitch);
        if a * a + b * b < 900.0 {
            return f64::NAN;
        }
    }
    let wave = |k: i32| {
        let (length, turn) = (40.0 * libm::pow(1.9, f64::from(k)), 0.7 * f64::from(k));
        let along = x * libm::cos(turn) + y * libm::sin(turn);
        0.02 * length * libm::sin(along * std::f64::consts::TAU / length + turn)
    };
    let noise = quantities::unit_interval(1, &[line as u64, column as u64]) - 0.5;
    (0..6).map(wave).sum::<f64>() + 0.1 * noise
}
