//! The photographs of `scenarios/moffett`, made of the constants of the listing, and pictures of the three observers.
//!
//! `cargo run -p panel-program --example moffett -- scenarios/moffett runs/moffett-views` writes both folders, which exist.

#![allow(dead_code, reason = "the tests use the rest of the block")]

#[path = "../tests/panel_program/block.rs"]
mod block;

use std::error::Error;
use std::path::{Path, PathBuf};

use files::write_atomic;
use panel_program::{Fill, Program, Restrictions, Settings};
use photograph::Photograph;
use picture::{Depth, GreyPicture, write_png};

use block::{FRAME, camera_file, lie, observer, photograph, picture};

/// Seconds of arc by which the block of figure 3.9 stands farther north.
const SHIFT: f64 = 30.0;

/// Corner of the frame over the moved block: 29.55 lines a second of latitude.
fn moved_frame() -> [f64; 2] {
    [FRAME[0], FRAME[1] + (29.55 * SHIFT).round()]
}

fn write_frame(folder: &Path, name: &str, frame: [f64; 2], shift: f64) -> Result<(), Box<dyn Error>> {
    write_png(folder.join(format!("{name}.png")), &picture(frame, shift), &[])?;
    let text = camera_file(frame).write();
    write_atomic(folder.join(format!("{name}.json")), |out| out.write_all(text.as_bytes()))?;
    Ok(())
}

fn write_view(
    path: &Path,
    photograph: &Photograph,
    shift: f64,
    number: usize,
    restrictions: Restrictions,
) -> Result<(), Box<dyn Error>> {
    let settings = Settings {
        restrictions,
        fill: Fill::EdgeBuffer,
        outside: 0.0,
        marks_voids: false,
        blends_borders: false,
    };
    let program = Program::new(&block::block(shift), lie(), photograph, settings)?;
    let drawn = program.draw(&observer(number))?;
    let codes = drawn.light.iter().map(|light| (255.0 * light).round() as u16).collect();
    println!("{}: {:?}", path.display(), drawn.counts);
    write_png(path, &GreyPicture::new(512, 512, Depth::Eight, codes)?, &[])?;
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let folders: Vec<PathBuf> = std::env::args().skip(1).map(PathBuf::from).collect();
    let [frames, views] = &folders[..] else { return Err("name two folders: of frames, of views".into()) };
    write_frame(frames, "frame", FRAME, 0.0)?;
    write_frame(frames, "moved", moved_frame(), SHIFT)?;
    let (still, moved) = (photograph(FRAME, 0.0), photograph(moved_frame(), SHIFT));
    let quadrant = Restrictions { quadrant: true, ..Restrictions::default() };
    for (word, restrictions) in [("written", Restrictions::as_written()), ("repaired", quadrant)] {
        for number in 1..=3 {
            write_view(&views.join(format!("{number}-{word}.png")), &still, 0.0, number, restrictions)?;
        }
        write_view(&views.join(format!("moved-{word}.png")), &moved, SHIFT, 3, restrictions)?;
    }
    Ok(())
}
