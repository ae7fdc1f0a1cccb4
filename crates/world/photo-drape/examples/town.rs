//! The ground of `scenarios/photo-town`: six by six buildings with streets between, and an albedo map over them.
//!
//! `cargo run -p photo-drape --example town -- scenarios/photo-town` writes `ground.bank` and `albedo.png` into a folder that exists.

use std::error::Error;
use std::path::PathBuf;

use landscape::{Bank, CornerWords, Level, bank_file};
use picture::{Depth, GreyPicture, write_png};

/// Side of the ground (m).
const SIDE: f64 = 200.0;
/// Distance of corners (m). Between a corner on a roof and one on the street the ground rises: so wide is a wall.
const REGION: f64 = 2.0;
/// Side of a texel of the albedo map (m).
const TEXEL: f64 = 0.5;
/// How many buildings stand either way.
const BUILDINGS: usize = 6;
/// From the begin of one roof to that of the next (m).
const PITCH: f64 = 28.0;
/// Side of a roof (m).
const ROOF: f64 = 16.0;
/// South and west end of the first roof (m).
const FIRST: f64 = (SIDE - (BUILDINGS as f64 - 1.0) * PITCH - ROOF) / 2.0;

/// The building whose roof, or whose wall up to `wall` (m) around it, covers a place along an axis.
fn building(at: f64, wall: f64) -> Option<usize> {
    (0..BUILDINGS).find(|number| {
        let begin = FIRST + *number as f64 * PITCH;
        (begin - wall..=begin + ROOF + wall).contains(&at)
    })
}

/// The building over a place (north, east; m).
fn over(place: [f64; 2], wall: f64) -> Option<[usize; 2]> {
    Some([building(place[0], wall)?, building(place[1], wall)?])
}

/// A number from 0 to 1 that follows from a building.
fn share([row, column]: [usize; 2]) -> f64 {
    ((5 * row + 7 * column + 3 * row * column * column) % 18) as f64 / 17.0
}

/// Height (m) of a roof: 8 to 25.
fn roof(building: [usize; 2]) -> f64 {
    8.0 + 17.0 * share(building)
}

/// Albedo of a place: roofs that differ, striped walls, dark streets with a bright line along their middle.
fn albedo(place: [f64; 2]) -> f64 {
    if let Some(building) = over(place, 0.0) {
        return 0.4 + 0.5 * share([building[1], building[0]]);
    }
    if over(place, REGION).is_some() {
        let is_bright = place.iter().map(|at| (at / 2.0).floor() as i64).sum::<i64>() % 2 == 0;
        return if is_bright { 0.65 } else { 0.5 };
    }
    let is_middle = |at: &f64| ((at - FIRST - ROOF).rem_euclid(PITCH) - (PITCH - ROOF) / 2.0).abs() < 0.5;
    if place.iter().any(is_middle) { 0.8 } else { 0.2 }
}

fn bank() -> Result<Bank, Box<dyn Error>> {
    let corners = (SIDE / REGION) as usize + 1;
    let words = |index: usize| -> CornerWords {
        let place = [index / corners, index % corners].map(|line| line as f64 * REGION);
        let height = over(place, 0.0).map_or(0.0, roof);
        std::array::from_fn(|word| if word == 0 { height } else { 0.0 })
    };
    let level = Level::new(REGION, [0.0; 2], [corners; 2], (0..corners * corners).map(words).collect())?;
    Ok(Bank::new("Town of six by six buildings", vec![level], None)?)
}

fn albedo_map() -> Result<GreyPicture, Box<dyn Error>> {
    let texels = (SIDE / TEXEL) as usize;
    let code = |index: usize| {
        let (line, column) = (index / texels, index % texels);
        let place = [texels - 1 - line, column].map(|texel| (texel as f64 + 0.5) * TEXEL);
        (255.0 * albedo(place)).round() as u16
    };
    let codes = (0..texels * texels).map(code).collect();
    Ok(GreyPicture::new(texels, texels, Depth::Eight, codes)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).map(PathBuf::from).ok_or("name the folder")?;
    bank_file::write(folder.join("ground.bank"), &bank()?)?;
    write_png(folder.join("albedo.png"), &albedo_map()?, &[])?;
    Ok(())
}
