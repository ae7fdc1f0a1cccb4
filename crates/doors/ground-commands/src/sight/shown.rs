//! Ground as a generator with levels of detail draws it in a frame.

use std::path::Path;
use std::sync::Arc;

use clap::Args;
use generator::DrawnPosts;
use landscape::Landscape;
use sight::Posts;

use command_line::loading::{StageArgs, StageOptions, levelled};
use command_line::output::warn;
use command_line::{Failure, values};

/// Share of the distance of posts by which a place may be off a regular grid. Chosen: far above rounding, far below what is seen.
const REGULAR: f64 = 1e-6;

/// Which frame of which generator shows the ground.
#[derive(Debug, Args)]
pub struct ShownArgs {
    /// Frame whose ground is meant, with --surface shown; the first one if left out.
    #[arg(long, value_name = "N")]
    pub frame: Option<u64>,
    /// Generator whose ground is meant, with --surface shown; that of the scenario if left out.
    #[arg(short, long, value_name = "GENERATOR")]
    pub machine: Option<String>,
    /// A key of the scenario or of the generator, with --surface shown; may be given several times.
    #[arg(long, value_name = "PART.KEY=VALUE", value_parser = values::setting)]
    pub set: Vec<(String, String)>,
}

impl ShownArgs {
    /// The first option that needs `--surface shown`, if one is given.
    pub fn given(&self) -> Option<&'static str> {
        match self {
            Self { frame: Some(_), .. } => Some("--frame"),
            Self { machine: Some(_), .. } => Some("--machine"),
            Self { set, .. } => (!set.is_empty()).then_some("--set"),
        }
    }

    /// The drawn ground of a scenario's frame, as posts from the north; the landscape behind it, and the title.
    pub fn posts(&self, scenario: &Path) -> Result<(Posts, Arc<Landscape>, String), Failure> {
        let options = StageOptions { set: self.set.clone(), ..StageOptions::default() };
        let stage = StageArgs { machine: self.machine.clone(), options, ..StageArgs::of(scenario) };
        let opened = stage.load()?;
        let row = levelled(&opened)?;
        let frame = self.frame.unwrap_or(0);
        if frame >= opened.frames() {
            let last = opened.frames() - 1;
            return Err(Failure::usage(format!(
                "--frame {frame}: expected a frame of the scenario, 0 to {last}"
            )));
        }
        let stage = opened.stage()?;
        let table = opened.poses(&stage, frame..frame + 1).map_err(Failure::input)?;
        let landscape = Arc::clone(&stage.landscape);
        let session = opened.generator.prepare(stage).map_err(Failure::input)?;
        let detailed = session.detailed();
        let detailed =
            detailed.ok_or_else(|| Failure::usage(format!("{}: no levels of detail", row.name)))?;
        let drawn = detailed.drawn_posts(frame, &table.rows()[0].pose).map_err(Failure::input)?;
        Ok((regular(&drawn)?, landscape, opened.scenario.title.clone()))
    }
}

/// The regular part of drawn ground from its south-western post.
fn regular(drawn: &DrawnPosts) -> Result<Posts, Failure> {
    let DrawnPosts { north, east, heights } = drawn;
    let spacing = north[1] - north[0];
    let whole = |places: &[f64]| {
        let is_off = |(index, place): (usize, &f64)| {
            (place - places[0] - index as f64 * spacing).abs() > REGULAR * spacing
        };
        places.iter().enumerate().position(is_off).unwrap_or(places.len())
    };
    let [rows, columns] = [north, east].map(|places| whole(places));
    if [rows, columns] != [north.len(), east.len()] {
        let left_out = [north.len() - rows, east.len() - columns];
        warn(&format!(
            "posts of the last tiles stand closer: {} rows in the north and {} columns in the east are left out",
            left_out[0], left_out[1]
        ));
    }
    let row = |row: usize| heights[row * east.len()..][..columns].iter().copied();
    let southwards = (0..rows).rev().flat_map(row).collect();
    let corner = [north[0] + (rows - 1) as f64 * spacing, east[0]];
    Posts::new([rows, columns], corner, spacing, southwards).map_err(Failure::usage)
}

#[cfg(test)]
mod tests {
    use generator::DrawnPosts;

    use super::regular;

    #[test]
    fn rows_are_turned_and_closer_posts_are_left_out() {
        let drawn = DrawnPosts {
            north: vec![10.0, 12.0, 14.0],
            east: vec![0.0, 2.0, 4.0, 5.0],
            heights: (0..12).map(f64::from).collect(),
        };
        let posts = regular(&drawn).unwrap();
        assert_eq!((posts.size(), posts.corner(), posts.spacing()), ([3, 3], [14.0, 0.0], 2.0));
        assert_eq!([posts.post(0, 0), posts.post(0, 2), posts.post(2, 1)], [8.0, 10.0, 1.0]);
        let apart = DrawnPosts { east: vec![0.0, 1.0, 2.0, 3.0], ..drawn };
        assert!(regular(&apart).is_err(), "a single column is no ground");
    }
}
