//! Windows of real lunar files from the folder `shared/data` beside the repository, if it is there.

use std::path::Path;

use sight::{Curvature, Point, Posts};
use tiff::decoder::{Decoder, DecodingResult};

use crate::second_evaluator::{Counts, hold};

/// A square window from the middle of a file, or a loud line that it was left out.
fn window(name: &str, side: usize, spacing: f64) -> Option<Posts> {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let found = folders.map(|folder| folder.join("shared/data/lunar").join(name)).find(|path| path.is_file());
    let Some(path) = found else {
        println!("SKIPPED: shared/data/lunar/{name} is not there");
        return None;
    };
    let mut decoder = Decoder::new(std::fs::File::open(path).unwrap()).unwrap();
    let [width, height] = <[u32; 2]>::from(decoder.dimensions().unwrap()).map(|count| count as usize);
    let heights: Vec<f64> = match decoder.read_image().unwrap() {
        DecodingResult::F32(heights) => heights.into_iter().map(f64::from).collect(),
        DecodingResult::I16(heights) => heights.into_iter().map(f64::from).collect(),
        _ => panic!("{name}: another kind of sample"),
    };
    let [top, left] = [height, width].map(|count| (count - side) / 2);
    let at = |post: usize| heights[(top + post / side) * width + left + post % side];
    let known = |height: f64| if height.abs() < 1e5 { height } else { f64::NAN };
    let window = (0..side * side).map(|post| known(at(post))).collect();
    Some(Posts::new([side, side], [0.0, 0.0], spacing, window).unwrap())
}

#[test]
fn two_real_landscapes_agree_with_all_triangles() {
    for (name, spacing) in [("kepler_lola_48m.tif", 48.0), ("nac_southpole_stereo_dem_1m.tif", 1.0)] {
        let Some(ground) = window(name, 65, spacing) else { continue };
        let mut counts = Counts::default();
        for (share, height) in [(0.5, 0.001), (0.3, 2.0), (0.71, 50.0), (0.5, 1e6)] {
            let place = [-share * 64.0 * spacing, 0.4 * 64.0 * spacing];
            let eye = Point::above_ground(place, height);
            hold(&ground, &eye, 0.0, (Curvature::FLAT, f64::INFINITY, 1), 5, &mut counts);
        }
        println!("{name}: {counts:?}");
        assert!(counts.visible > 500 && counts.hidden > 500, "{counts:?}");
    }
}
