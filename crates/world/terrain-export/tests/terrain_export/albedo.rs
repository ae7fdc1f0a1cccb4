//! Textures of a landscape as files of an export.

use picture::{AnyPicture, Depth, Picture, write_png};
use quantities::intensity;
use terrain_builder::{Description, Ground, Textures};
use terrain_database::{Database, Map};
use terrain_export::{Exported, write_folder};

use crate::{LANDSCAPE, USUAL, ground};

/// A texture over the whole ground and one over a tile, finer than the posts.
const TEXTURES: &str = r#"
[[feature]]
id = "soil"
kind = "texture"
file = "soil.png"
curve = "linear"

[[feature]]
id = "patch"
kind = "texture"
file = "soil.png"
tile = [1, 1]
u = [0, 3]
v = [1, 0]
black = 0.2
"#;

/// The export of `LANDSCAPE` under textures of a picture with as many columns as lines, colour or grey.
fn exported(side: usize, is_colour: bool) -> (Ground, Textures, Exported) {
    let folder = tempfile::tempdir().unwrap();
    let code = |at: usize| (at * 31 % 256) as u16;
    let path = folder.path().join("soil.png");
    if is_colour {
        let codes = (0..3 * side * side).map(code).collect();
        write_png(path, &Picture::<3>::new(side, side, Depth::Eight, codes).unwrap(), &[]).unwrap();
    } else {
        let codes = (0..side * side).map(code).collect();
        write_png(path, &Picture::<1>::new(side, side, Depth::Eight, codes).unwrap(), &[]).unwrap();
    }
    let text = format!("{LANDSCAPE}{TEXTURES}");
    let description = Description::parse("ground.toml", &text, folder.path()).unwrap();
    let textures = Textures::open(&description).unwrap();
    let ground = ground(&text);
    let exported = Exported::new(&ground, &textures, &text, USUAL, &mut |_| {}).unwrap();
    (ground, textures, exported)
}

#[test]
fn the_database_has_the_luminance_of_the_textures_on_every_post() {
    for is_colour in [false, true] {
        let (ground, textures, exported) = exported(40, is_colour);
        let grid = ground.description().grid;
        let [_, columns] = grid.size();
        let Some(Map::U16(codes)) = &exported.database.contents().albedo else { panic!("16 bits") };
        for (post, code) in codes.iter().enumerate() {
            let albedo = intensity(textures.at(grid.place(post / columns, post % columns)).unwrap());
            assert!((f64::from(*code) / 65535.0 - albedo).abs() < 0.6 / 65535.0, "post {post}");
        }
    }
}

/// Each pixel is the albedo in its middle. Pixels are as fine as the finest texel asks for.
#[test]
fn the_picture_has_the_textures_north_at_the_top() {
    let (ground, textures, exported) = exported(40, true);
    let Some(AnyPicture::Colour(picture)) = &exported.albedo else { panic!("colour") };
    let grid = ground.description().grid;
    let ([south, west], [north, _]) = grid.extent().into();
    let pixel = exported.told["albedo"]["pixel_m"].as_f64().unwrap();
    let texel = textures.finest_texel().unwrap();
    assert!(pixel <= texel || (pixel - 50.0 / 8.0).abs() < 1e-9, "pixels of {pixel} m, texels of {texel} m");
    assert!((picture.lines() as f64 * pixel - (north - south)).abs() < 1e-6);
    for (line, column) in
        [(0, 0), (7, 100), (picture.lines() - 1, 3), (90, picture.columns() - 1), (150, 160)]
    {
        let place = [north - (line as f64 + 0.5) * pixel, west + (column as f64 + 0.5) * pixel];
        let albedo = textures.at(place).unwrap();
        for (code, albedo) in picture.pixel(column, line).iter().zip(albedo) {
            assert!((f64::from(*code) / 65535.0 - albedo).abs() < 0.6 / 65535.0, "{line}, {column}");
        }
    }
}

#[test]
fn grey_textures_make_a_grey_picture() {
    let (_, _, exported) = exported(4, false);
    assert!(matches!(&exported.albedo, Some(AnyPicture::Grey(_))));
    assert_eq!(exported.told["albedo"]["colour"], false);
}

#[test]
fn the_files_are_written_and_the_scenario_names_the_picture() {
    let (_, _, exported) = exported(4, true);
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("built");
    write_folder(&exported, &out).unwrap();
    let picture = photographs::read(out.join("albedo.png")).unwrap();
    assert_eq!(Some(&picture), exported.albedo.as_ref());
    let again = Database::open(out.join("terrain.lod")).unwrap();
    assert_eq!(again.contents().albedo, exported.database.contents().albedo);
    let scenario = scenario::Scenario::read(out.join("scenario.toml")).unwrap();
    let map = scenario.albedo_map.as_ref().unwrap();
    assert_eq!((map.file.clone(), map.curve), (out.join("albedo.png"), scenario::MapCurve::Linear));
}

#[test]
fn without_textures_there_is_no_albedo() {
    let ground = ground(LANDSCAPE);
    let exported = Exported::new(&ground, &crate::bare(), LANDSCAPE, USUAL, &mut |_| {}).unwrap();
    assert!(exported.albedo.is_none() && exported.database.contents().albedo.is_none());
    assert!(exported.told["albedo"].is_null() && !exported.scenario.contains("albedo_map"));
}
