//! Draws frame 60 of a scenario again and again, and prints the seconds of each: what Python is held against.

use std::io::{self, BufRead};
use std::path::Path;
use std::time::Instant;

use drive::{Drive, Wishes};

fn main() {
    let opened = Drive::open(Path::new("scenarios/first-light.toml"), &Wishes::default(), 1);
    let opened = opened.unwrap_or_else(|error| panic!("{error}"));
    // One frame a line of input, so that both sides can take turns.
    for line in io::stdin().lock().lines() {
        let frame = line.ok().and_then(|line| line.trim().parse().ok()).expect("a number of a frame");
        let begin = Instant::now();
        let seen = opened.frame(frame).unwrap_or_else(|error| panic!("{error}"));
        println!("{} {}", begin.elapsed().as_secs_f64(), seen.hash());
    }
}
