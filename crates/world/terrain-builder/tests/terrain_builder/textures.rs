//! Pictures over the ground: which texel lies where, and what is refused.

use std::path::Path;

use picture::{Depth, GreyPicture, Picture, write_png};
use tempfile::TempDir;
use terrain_builder::{Description, Textures};

use crate::{FEATURES, HEAD, built, near};

/// A folder with two pictures: `steps.png` of 2 x 2 greys, `red.png` of one colour.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    // The upper line first: 0.8 and 1.0 of white above, 0.2 and 0.4 below.
    let steps = GreyPicture::new(2, 2, Depth::Eight, vec![204, 255, 51, 102]).unwrap();
    write_png(folder.path().join("steps.png"), &steps, &[]).unwrap();
    let red = Picture::<3>::new(1, 1, Depth::Eight, vec![255, 51, 0]).unwrap();
    write_png(folder.path().join("red.png"), &red, &[]).unwrap();
    folder
}

fn read(folder: &Path, features: &str) -> Result<Description, String> {
    Description::parse("ground.toml", &format!("{HEAD}{features}"), folder).map_err(|error| error.to_string())
}

fn textures(features: &str) -> Textures {
    let folder = folder();
    let description = read(folder.path(), features).unwrap_or_else(|problems| panic!("{problems}"));
    Textures::open(&description).unwrap()
}

fn texture(id: &str, keys: &str) -> String {
    format!("\n[[feature]]\nid = \"{id}\"\nkind = \"texture\"\ncurve = \"linear\"\n{keys}\n")
}

const STEPS: &str = "file = \"steps.png\"\n";

/// The place at a share of the way from the south-western to the north-eastern corner of the posts.
fn place(share: [f64; 2]) -> [f64; 2] {
    let description = read(Path::new(""), "").unwrap();
    let [low, high] = description.grid.extent();
    [0, 1].map(|axis| low[axis] + share[axis] * (high[axis] - low[axis]))
}

fn grey(textures: &Textures, share: [f64; 2]) -> f64 {
    let [red, green, blue] = textures.at(place(share)).unwrap();
    assert_eq!((red, red), (green, blue));
    red
}

#[test]
fn the_upper_line_of_a_picture_lies_in_the_north() {
    let textures = textures(&texture("soil", STEPS));
    for (share, albedo) in
        [([0.25, 0.25], 0.2), ([0.25, 0.75], 0.4), ([0.75, 0.25], 0.8), ([0.75, 0.75], 1.0)]
    {
        near(grey(&textures, share), albedo, 1e-6);
    }
    near(grey(&textures, [0.5, 0.5]), 0.6, 1e-6);
    let corners = [([0.0, 0.0], 0.2), ([0.0, 1.0], 0.4), ([1.0, 0.0], 0.8), ([1.0, 1.0], 1.0)];
    corners.iter().for_each(|(share, albedo)| near(grey(&textures, *share), *albedo, 1e-6));
    let [north, east] = place([1.0, 1.0]);
    assert_eq!(textures.at([north + 0.1, east]), None, "no ground, no texture");
    assert_eq!(textures.at([f64::NAN, east]), None);
    assert!(!textures.is_colourful());
}

#[test]
fn start_and_end_mirror_and_repeat_a_picture() {
    let mirrored = textures(&texture("soil", &format!("{STEPS}u = [1, 0]\n")));
    near(grey(&mirrored, [0.25, 0.25]), 0.4, 1e-6);
    // Twice across: the western half holds a whole picture.
    let twice = textures(&texture("soil", &format!("{STEPS}u = [0, 2]\n")));
    let thirds = [0.125, 0.375, 0.625, 0.875].map(|east| grey(&twice, [0.25, east]));
    thirds.iter().zip([0.2, 0.4, 0.2, 0.4]).for_each(|(found, albedo)| near(*found, albedo, 1e-6));
    // The smallest texel is a quarter of the ground wide.
    let [low, high] = [place([0.0; 2]), place([1.0; 2])];
    near(twice.finest_texel().unwrap(), (high[1] - low[1]) / 4.0, 1e-9);
}

#[test]
fn black_and_white_have_the_albedo_that_is_asked_for() {
    let textures = textures(&texture("soil", &format!("{STEPS}black = 0.1\nwhite = 0.3\n")));
    near(grey(&textures, [0.75, 0.75]), 0.3, 1e-6);
    near(grey(&textures, [0.25, 0.25]), 0.1 + 0.2 * 0.2, 1e-6);
}

#[test]
fn codes_are_light_by_the_usual_curve_unless_they_are_linear() {
    let keys = "\n[[feature]]\nid = \"soil\"\nkind = \"texture\"\nfile = \"steps.png\"\n";
    // 51 of 255 is 0.2 of the code, and ((0.2 + 0.055) / 1.055)^2.4 of the light.
    near(grey(&textures(keys), [0.25, 0.25]), 0.033_104_766_570_885_06, 1e-6);
}

#[test]
fn the_texture_of_a_tile_comes_before_that_of_the_whole_ground() {
    let whole = texture("soil", STEPS);
    let tile = texture("red", "file = \"red.png\"\ntile = [1, 2]\n");
    for text in [format!("{whole}{tile}"), format!("{tile}{whole}")] {
        let textures = textures(&text);
        let grid = read(Path::new(""), "").unwrap().grid;
        let border = |axis: usize, tile: usize| [grid.north, grid.east][axis].place(16 * tile);
        let red = Some([1.0, 0.2, 0.0]).map(|colour: [f64; 3]| colour.map(|channel| channel as f32));
        let at = |place| textures.at(place).map(|colour| colour.map(|channel| channel as f32));
        let ([south, north], [west, east]) = ([border(0, 1), border(0, 2)], [border(1, 2), border(1, 3)]);
        assert_eq!([at([south, west]), at([north - 0.1, east - 0.1])], [red; 2], "both borders to it");
        assert!(
            [[south - 0.1, west], [south, west - 0.1], [north, west], [south, east]].iter().all(|place| at(
                *place
            )
                != red
                && at(*place).is_some())
        );
        assert!(textures.is_colourful());
    }
}

#[test]
fn without_a_texture_there_is_no_albedo() {
    let tile = textures(&texture("red", "file = \"red.png\"\ntile = [0, 0]\n"));
    assert_eq!(tile.at(place([0.9, 0.9])), None);
    assert!(tile.at(place([0.01, 0.01])).is_some());
    let none = textures(FEATURES[0]);
    assert!(none.is_empty() && none.finest_texel().is_none());
}

#[test]
fn a_texture_changes_no_height_and_is_told_by_its_share_of_the_posts() {
    let folder = folder();
    let plain = built(&format!("{HEAD}{}", FEATURES[0]));
    let text = format!("{}{}", FEATURES[0], texture("red", "file = \"red.png\"\ntile = [0, 0]\n"));
    let description = read(folder.path(), &text).unwrap();
    let ground = terrain_builder::Ground::new(description, terrain_builder::Base::Level(-100.0)).unwrap();
    assert_eq!(ground.heights(), plain.heights());
    let told = ground.told();
    let [rows, columns] = ground.description().grid.size();
    let red = told.iter().find(|feature| feature.id == "red").unwrap();
    near(red.share, 256.0 / (rows * columns) as f64, 1e-12);
    assert_eq!((red.kind, red.area, red.range), ("texture", None, [0.0; 2]));
}

#[test]
fn faults_are_named_with_their_place() {
    let folder = folder();
    let twice = format!("{}{}", texture("a", STEPS), texture("b", STEPS));
    let in_a_tile = "file = \"red.png\"\ntile = [1, 2]\n";
    let tiles = format!("{}{}", texture("a", in_a_tile), texture("b", in_a_tile));
    for (text, said) in [
        (texture("a", ""), "file"),
        (texture("a", &format!("{STEPS}u = [0.5, 0.5]\n")), "`feature[0].u` starts where it ends"),
        (texture("a", &format!("{STEPS}v = [0, nan]\n")), "`feature[0].v`"),
        (texture("a", &format!("{STEPS}u = [0, 10001]\n")), "`feature[0].u`"),
        (texture("a", &format!("{STEPS}tile = [0, 99]\n")), "below ["),
        (texture("a", &format!("{STEPS}tile = [0]\n")), "`feature[0].tile` is [0]"),
        (texture("a", &format!("{STEPS}tile = [-1, 0]\n")), "`feature[0].tile"),
        (texture("a", &format!("{STEPS}white = 1.5\n")), "`feature[0].white`"),
        (texture("a", &format!("{STEPS}curves = \"linear\"\n")), "curves"),
        (texture("a", &format!("{STEPS}[feature.roughness]\nseeds = [1]\nscale_m = 1\n")), "roughness"),
        (twice, "textures \"a\" and \"b\" both cover the whole ground"),
        (tiles, "textures \"a\" and \"b\" both cover tile [1, 2]"),
    ] {
        let refused = read(folder.path(), &text).expect_err(&text);
        assert!(refused.contains(said), "{said} in {refused}");
    }
    let off = texture("a", &format!("{STEPS}enabled = false\n")) + &texture("b", STEPS);
    assert!(read(folder.path(), &off).is_ok(), "one that is not built covers nothing");
}

#[test]
fn a_picture_that_is_missing_or_broken_is_named_with_its_feature() {
    let folder = folder();
    std::fs::write(folder.path().join("broken.png"), b"\x89PNG\r\n\x1a\nno picture").unwrap();
    for file in ["nowhere.png", "broken.png", "."] {
        let description = read(folder.path(), &texture("soil", &format!("file = \"{file}\"\n"))).unwrap();
        let said = Textures::open(&description).expect_err(file).to_string();
        assert!(said.starts_with("feature \"soil\": ") && said.contains(file), "{said}");
    }
    let off = texture("soil", "file = \"nowhere.png\"\nenabled = false\n");
    assert!(Textures::open(&read(folder.path(), &off).unwrap()).unwrap().is_empty());
}
