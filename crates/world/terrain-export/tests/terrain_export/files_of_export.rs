//! What the files say, against the ground.

use terrain_builder::{Base, Description, Ground};
use terrain_database::Shape;
use terrain_export::{Exported, Wishes, shaded};

use crate::{LANDSCAPE, USUAL, bare, exported, ground};

#[test]
fn the_database_has_the_ground_at_every_post() {
    let (ground, exported) = exported(USUAL);
    let contents = exported.database.contents();
    let [columns, rows] = contents.places.each_ref().map(Vec::len);
    assert_eq!((exported.database.counts(), [rows, columns]), ([3, 3], ground.description().grid.size()));
    for (post, height) in contents.heights.iter().enumerate() {
        let [east, north] = [contents.places[0][post % columns], contents.places[1][post / columns]];
        assert_eq!(*height, ground.height([north, east]), "post {post}");
    }
    let [[south, west], _] = ground.description().grid.extent();
    assert_eq!(contents.frame.origin, [west, south]);
    assert_eq!(contents.frame.radius, 1_737_400.0);
}

#[test]
fn a_step_changes_heights_by_half_of_it_and_says_so() {
    let (ground, exported) = exported(Wishes { step: Some(0.25), ..USUAL });
    let contents = exported.database.contents();
    let heights = ground.heights();
    let changes =
        contents.heights.iter().zip(heights.values()).map(|(stored, height)| (stored - height).abs());
    let largest = changes.fold(0.0, f64::max);
    assert!(largest > 0.1 && largest <= 0.125, "{largest}");
    assert_eq!(exported.told["database"]["largest_change_m"], largest);
}

/// The landscape opens again from the database alone, to the bit.
#[test]
fn the_sidecar_builds_the_same_ground() {
    let (_, exported) = exported(USUAL);
    let again = ground(&exported.database.contents().sidecar);
    assert_eq!(again.heights().values(), exported.database.contents().heights);
}

#[test]
fn boulders_stand_where_the_builder_put_them() {
    let (ground, exported) = exported(USUAL);
    let boulders = &exported.database.contents().boulders;
    assert_eq!(boulders.len(), 2);
    assert_eq!([boulders[0].shape, boulders[1].shape], [Shape::Cube, Shape::Rock(14)]);
    for (boulder, placed) in boulders.iter().zip(ground.boulders()) {
        let [north, east] = placed.boulder.at();
        assert_eq!(boulder.centre, [east, north, placed.middle]);
        assert_eq!((boulder.yaw, boulder.burial), (placed.boulder.yaw(), 0.25));
    }
}

#[test]
fn light_is_that_of_the_map() {
    let (_, exported) = exported(USUAL);
    let (light, map) =
        (exported.database.contents().light.as_ref().unwrap(), exported.light.as_ref().unwrap());
    for (post, share) in map.shares().iter().enumerate() {
        assert!((light.share(post) - share).abs() <= 0.5 / 65535.0 + 1e-15);
    }
    let dark = map.shares().iter().filter(|share| **share == 0.0).count();
    assert!(dark > 0 && dark < map.shares().len() / 2, "{dark}");
}

/// Bank and listed craters together are the ground, within the errors that the export states.
#[test]
fn errors_of_craters_and_regions_are_stated() {
    let (_, exported) = exported(USUAL);
    let craters = &exported.told["craters"];
    assert_eq!(craters["listed"].as_array().map(Vec::len), Some(1));
    assert_eq!(craters["listed"][0]["feature"], "round");
    let stated = craters["listed"][0]["largest_difference_m"].as_f64().unwrap();
    assert_eq!(stated, exported.craters.largest_difference());
    assert!(stated > 0.0 && stated < 10.0, "less than the wall of 10 m: {stated}");
    assert_eq!(craters["kept_in_bank"][0]["feature"], "slanted");
    let regions = exported.told["bank"]["region_residuals_m"].as_array().unwrap();
    let largest =
        regions.iter().flat_map(|row| row.as_array().unwrap()).map(|residual| residual.as_f64().unwrap());
    assert_eq!(largest.fold(0.0, f64::max), exported.told["bank"]["largest_residual_m"].as_f64().unwrap());
    assert!(regions.len() >= 6, "{}", regions.len());
}

#[test]
fn threads_change_no_byte() {
    let told = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let (_, exported) = exported(USUAL);
            (exported.database.bytes(), exported.told.to_string(), exported.scenario)
        })
    };
    assert!(told(1) == told(3));
}

#[test]
fn tiles_of_one_cell_are_refused() {
    let text = LANDSCAPE.replace("tile_exponent = 3", "tile_exponent = 0");
    let ground = ground(&text);
    let error = Exported::new(&ground, &bare(), &text, USUAL, &mut |_| {}).expect_err("no tiles");
    assert_eq!(error.to_string(), "terrain database: order is 0: expected a whole number from 1 to 12");
}

/// Ground that rises to the north is brighter under a sun in the south; level ground has the sine of the elevation.
#[test]
fn the_picture_is_shaded_by_slopes() {
    let crater = ground(LANDSCAPE);
    let picture = shaded(&crater, &bare(), [0.0, -0.8, 0.6], 60).unwrap();
    assert_eq!(picture.columns().max(picture.lines()), 60);
    assert_eq!(picture.pixel(0, 0), [153], "level ground");
    let middle = picture.lines() / 2;
    let row: Vec<u16> = (0..picture.columns()).map(|column| picture.pixel(column, middle)[0]).collect();
    let brightest = row.iter().enumerate().max_by_key(|(_, code)| **code).map(|(column, _)| column);
    assert!(brightest > Some(picture.columns() / 2), "the eastern wall looks west, at the sun: {row:?}");
}

/// The feature generator refuses craters over the border: they stay in the bank.
#[test]
fn a_crater_over_the_border_stays_in_the_bank() {
    let text = LANDSCAPE.replace("longitude_deg = 3.02\n", "longitude_deg = 3.002\n");
    let exported = Exported::new(&ground(&text), &bare(), &text, USUAL, &mut |_| {}).unwrap();
    let kept = exported.told["craters"]["kept_in_bank"][0].clone();
    assert!(exported.craters.craters.is_empty() && kept["feature"] == "round", "{kept}");
    assert!(kept["reason"].as_str().unwrap().starts_with("a crater over the border"), "{kept}");
}

#[test]
fn an_empty_landscape_has_no_craters_to_list() {
    let text = LANDSCAPE.split("[[feature]]").next().unwrap();
    let description = Description::parse("ground.toml", text, std::path::Path::new("")).unwrap();
    let ground = Ground::new(description, Base::Level(7.0)).unwrap();
    let exported = Exported::new(&ground, &bare(), text, USUAL, &mut |_| {}).unwrap();
    assert!(!exported.scenario.contains("[features]") && !exported.scenario.contains("[[object]]"));
    assert!(exported.survey.report.levels[0].rms < 1e-6);
}
