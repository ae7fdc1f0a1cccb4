//! The table `[lod]`, and what is wrong with it.

use std::sync::Arc;

use diagnostics::{Layers, ProblemList, Problems, TomlFile};
use generator::Generator;
use lod_mesh::ROW;

/// The generator of a table `[lod]` on the computer that ships, with overlays.
pub fn configured(table: &str, overlay: Option<&str>) -> Result<Arc<dyn Generator>, ProblemList> {
    let problems = Problems::new();
    let table = format!("[lod]\n{table}\n");
    let layers = [ROW.gear.unwrap().text, &table].into_iter().chain(overlay);
    let files = layers.filter_map(|text| TomlFile::parse("mine.toml", text, &problems));
    let configured = (ROW.configure)(&Layers::new(files).root(&problems));
    problems.resolve(configured)
}

fn fault(table: &str) -> String {
    configured(table, None).err().unwrap().to_string()
}

#[test]
fn faults_are_told_with_what_is_expected() {
    for (table, told) in [
        ("order = 13", ["order", "12"]),
        ("spacing_m = 0", ["spacing_m", "0.01"]),
        ("levels = 7", ["7 levels", "at most 6"]),
        ("ranges_m = [100, 100, 300]\nlevels = 3", ["level 1 ends at 100 m", "rise"]),
        ("ranges_m = [100, 200]", ["2 ranges for 6 levels", "as many ends"]),
        ("morph_percent = [101]", ["morph_percent", "100"]),
        ("morph_percent = [10, 20]", ["2 shares for 6 levels", "one for each"]),
        ("transition = \"jump\"", ["transition", "switch"]),
        ("pattern = \"5\"", ["pattern", "lattice32"]),
        ("light_level = 6", ["level 6 of tiles of order 5", "at most 5"]),
        ("light_level = 1\nlight = \"live\"", ["level 1, where light is live", "light = \"map\""]),
        ("light_level = 1\nlight = \"stored\"", ["level 1, where light is stored", "light = \"map\""]),
        ("percent_bits = 25", ["percent_bits", "24"]),
        ("slots = \"many\"", ["slots", "share"]),
        ("clock = \"fast\"", ["clock", "real-time"]),
        ("boulder_px = -1", ["boulder_px", "10000"]),
        ("boulders = \"air\"", ["boulders", "mean-radius"]),
    ] {
        let fault = fault(table);
        assert!(told.iter().all(|word| fault.contains(word)), "{table}: {fault}");
    }
}

#[test]
fn a_whole_table_is_read() {
    let text = "order = 4\nlevels = 2\nranges_m = [100, 250]\nmorph_percent = [50, 0]\nstitch = \"none\"\nlight = \"live\"\n";
    let generator = configured(text, None).unwrap();
    let record = generator.record();
    assert_eq!(record["ranges_m"], serde_json::json!([100.0, 250.0]));
    assert_eq!(record["morph_percent"], serde_json::json!([50.0, 0.0]));
    assert_eq!((record["stitch"].as_str(), record["light"].as_str()), (Some("none"), Some("live")));
}
