//! The table `[lod]`, and what is wrong with it.

use diagnostics::{Problems, TomlFile};
use lod_mesh::ROW;

fn fault(table: &str) -> String {
    let problems = Problems::new();
    let file = TomlFile::parse("mine.toml", &format!("[lod]\n{table}\n"), &problems).unwrap();
    assert!((ROW.configure)(&file.root(&problems)).is_none(), "{table}");
    problems.into_result().unwrap_err().to_string()
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
    ] {
        let fault = fault(table);
        assert!(told.iter().all(|word| fault.contains(word)), "{table}: {fault}");
    }
}

#[test]
fn a_whole_table_is_read() {
    let problems = Problems::new();
    let text = "[lod]\norder = 4\nlevels = 2\nranges_m = [100, 250]\nmorph_percent = [50, 0]\nstitch = \"none\"\nlight = \"live\"\n";
    let file = TomlFile::parse("mine.toml", text, &problems).unwrap();
    let generator = (ROW.configure)(&file.root(&problems)).unwrap();
    let record = generator.record();
    assert_eq!(record["ranges_m"], serde_json::json!([100.0, 250.0]));
    assert_eq!(record["morph_percent"], serde_json::json!([50.0, 0.0]));
    assert_eq!((record["stitch"].as_str(), record["light"].as_str()), (Some("none"), Some("live")));
}
