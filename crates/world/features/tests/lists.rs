//! Lists of craters: what is read, and what is said about what is wrong.

use features::list::read;
use features::{Crater, Shape};
use proptest::prelude::{ProptestConfig, any, proptest};

fn file(text: impl AsRef<[u8]>) -> tempfile::NamedTempFile {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    file
}

/// Line and title of every fault.
fn faults(text: &str) -> Vec<(usize, String)> {
    let list = read(file(text).path()).expect_err("it has faults");
    list.iter().map(|problem| (problem.record().line.unwrap_or(0), problem.title.clone())).collect()
}

#[test]
fn the_three_types() {
    let text = "\u{feff}# survey of 1969\r\nx_m, y_m,radius_m,depth_m,rim_m,type,outer_m,\"floor_m\"\r\n\
        1,2,100,20,0,1,,\r\n\r\n-3.5,4e2,100,20,6,2,,\r\n5,6,100,20,6,3,140,40\r\n7,8,100,20,6,3,,\r\n";
    let expected = [
        ([1.0, 2.0], Shape::Bowl { r1: 100.0 }, 0.0),
        ([-3.5, 400.0], Shape::RimmedBowl { r1: 100.0, r2: 140.0 }, 6.0),
        ([5.0, 6.0], Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 }, 6.0),
        ([7.0, 8.0], Shape::FlatFloor { r1: 40.0, r2: 100.0, r3: 140.0 }, 6.0),
    ];
    let expected = expected.map(|(centre, shape, rim)| Crater::new(centre, shape, 20.0, rim).unwrap());
    assert_eq!(read(file(text).path()).unwrap(), expected.into_iter().collect());
    let told = expected.map(|crater| (crater.type_number(), crater.shape(), crater.depth()));
    assert_eq!(told[1], (2, Shape::RimmedBowl { r1: 100.0, r2: 140.0 }, 20.0));
    assert_eq!(told.map(|(number, _, _)| number), [1, 2, 3, 3]);
}

#[test]
fn quoted_cells_are_the_same_list() {
    let plain = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m\n150,205,14,2.6,0,1,,\n";
    let expected = read(file(plain).path()).unwrap();
    let quote = |row: &str| row.split(',').map(|cell| format!("\"{cell}\"")).collect::<Vec<_>>().join(",");
    let quoted: Vec<String> = plain.lines().map(quote).collect();
    for ends in ["\n", "\r\n", "\r"] {
        assert_eq!(
            read(file("\u{feff}".to_owned() + &quoted.join(ends)).path()).unwrap(),
            expected,
            "{ends:?}"
        );
    }
}

#[test]
fn a_quote_that_is_not_closed_swallows_no_row() {
    let header = "x_m,y_m,radius_m,depth_m,rim_m,type\n";
    for rows in ["1,2,3,1,0,\"1\n4,5,3,1,0,1\n", "4,5,3,1,0,1\n1,2,3,1,0,\"1"] {
        let found = faults(&(header.to_owned() + rows));
        assert_eq!(found.len(), 1, "{found:?}");
        assert_eq!(found[0].1, "a quote that is not closed");
    }
}

#[test]
fn columns_stand_in_any_order() {
    let text = "type,rim_m,depth_m,radius_m,y_m,x_m\n2,1,2,3,4,5\n";
    let expected = Crater::new([5.0, 4.0], Shape::RimmedBowl { r1: 3.0, r2: 1.4 * 3.0 }, 2.0, 1.0).unwrap();
    assert_eq!(read(file(text).path()).unwrap(), [expected].into_iter().collect());
}

#[test]
fn every_fault_is_listed() {
    let text = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m\n\
        nan,2,3,1,0,1,,\n\
        1,2,0,1,0,1,,\n\
        1,2,-3,1,0,1,,\n\
        1,2,3,-1,0,1,,\n\
        1,2,3,1,inf,2,,\n\
        1,2,3,1,0.5,1,,\n\
        1,2,3,1,0,4,,\n\
        1,2,3,1,0,2,2.9,\n\
        1,2,3,1,0,3,,3\n\
        1,2,3,1,0,1,4,\n\
        1,2,3,1,0,2,,1\n\
        1,2,3,1,0,2\n\
        1,2e9,,1,0,2,,\n";
    let expected = [
        (2, "`x_m` must be a number from -1000000000 to 1000000000 m, not nan"),
        (3, "`radius_m` must be a number above 0 to 100000000 m, not 0"),
        (4, "`radius_m` must be a number above 0 to 100000000 m, not -3"),
        (5, "`depth_m` must be a number from 0 to 100000 m, not -1"),
        (6, "`rim_m` must be a number from 0 to 100000 m, not inf"),
        (7, "`rim_m` must be 0: type 1 has no rim, not 0.5"),
        (8, "`type` must be 1, 2 or 3, not 4"),
        (9, "`outer_m` must be a number above radius_m = 3 to 100000000 m, not 2.9"),
        (10, "`floor_m` must be a number above 0 and below radius_m = 3 m, not 3"),
        (11, "`outer_m` must be nothing: type 1 has no rim, not 4"),
        (12, "`floor_m` must be nothing: only type 3 has a flat floor, not 1"),
        (13, "a row of 6 cells under a header of 8"),
        (14, "`y_m` must be a number from -1000000000 to 1000000000 m, not 2e9"),
        (14, "`radius_m` must be a number above 0 to 100000000 m, not nothing"),
    ];
    assert_eq!(faults(text), expected.map(|(line, title)| (line, title.to_owned())));
}

#[test]
fn headers_are_checked() {
    let titles = |text: &str| faults(text).into_iter().map(|(_, title)| title).collect::<Vec<_>>();
    assert_eq!(titles(""), ["an empty list of craters"]);
    assert_eq!(titles("x_m,y_m,radius_m,depth_m,rim_m,type\n# none\n"), ["a list of craters without rows"]);
    let found = titles("x_m,x_m,radius_m,depth_m,rim_m,colour\n1,2,3,4,5,6\n");
    let expected = [
        "missing column `y_m`",
        "missing column `type`",
        "column `x_m` stands twice",
        "unknown column `colour`",
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_long_list_of_faults_is_cut() {
    let text = "x_m,y_m,radius_m,depth_m,rim_m,type\n".to_owned() + &"1,2,0,1,0,1\n".repeat(1000);
    let found = faults(&text);
    assert_eq!(found.len(), 21);
    assert_eq!(found[20].1, "980 more faults of this file are not listed");
}

#[test]
fn what_is_no_list_is_refused() {
    assert!(read("no such file.csv").is_err());
    assert!(read(file(b"x_m\xff").path()).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    /// Damaged text is refused or read, and nothing else happens.
    #[test]
    fn any_text_comes_to_an_end(text in "[-0-9a-z_,.\"#\n ]{0,80}", rows in "[-0-9e,.\" ]{0,40}", bytes in any::<Vec<u8>>()) {
        let header = "x_m,y_m,radius_m,depth_m,rim_m,type\n";
        for text in [text.clone().into_bytes(), (header.to_owned() + &rows).into_bytes(), bytes] {
            let _ = read(file(text).path()).map_err(|list| list.render(false));
        }
    }
}

/// The file of an array of rows.
fn array(folder: &tempfile::TempDir, width: usize, rows: &[f64]) -> std::path::PathBuf {
    let path = folder.path().join("craters.npy");
    let array = files::Npy::new(vec![rows.len() / width, width], rows.to_vec()).unwrap();
    files::write_npy(&path, &array).unwrap();
    path
}

#[test]
fn an_array_is_the_same_list() {
    let nan = f64::NAN;
    let rows = [
        [1.0, 2.0, 100.0, 20.0, 0.0, 1.0, nan, nan],
        [-3.5, 400.0, 100.0, 20.0, 6.0, 2.0, nan, nan],
        [5.0, 6.0, 100.0, 20.0, 6.0, 3.0, 140.0, 40.0],
        [7.0, 8.0, 100.0, 20.0, 6.0, 3.0, nan, nan],
    ];
    let text = "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m\n1,2,100,20,0,1,,\n-3.5,4e2,100,20,6,2,,\n\
        5,6,100,20,6,3,140,40\n7,8,100,20,6,3,,\n";
    let folder = tempfile::tempdir().unwrap();
    let expected = read(file(text).path()).unwrap();
    assert_eq!(read(array(&folder, 8, rows.as_flattened())).unwrap(), expected);
    let narrow: Vec<f64> = rows[..2].iter().flat_map(|row| row[..6].to_vec()).collect();
    assert_eq!(read(array(&folder, 6, &narrow)).unwrap(), expected.iter().take(2).collect());
}

#[test]
fn rows_of_an_array_that_are_no_craters_are_named() {
    let good = [1.0, 2.0, 100.0, 20.0, 0.0, 1.0, f64::NAN, f64::NAN];
    let with = |column: usize, value: f64| {
        let mut row = good;
        row[column] = value;
        row
    };
    let folder = tempfile::tempdir().unwrap();
    let rows = [good, with(2, f64::NAN), with(5, 1.5), with(6, 140.0), with(3, -1.0), with(0, f64::INFINITY)];
    let faults = read(array(&folder, 8, rows.as_flattened())).unwrap_err();
    let titles: Vec<&str> = faults.iter().map(|problem| problem.title.as_str()).collect();
    assert_eq!(titles.len(), 5, "{titles:?}");
    for (row, title) in (1..).zip(&titles) {
        assert!(title.starts_with(&format!("row {row} (from 0)")), "{title}");
    }
    assert!(titles[1].contains("type is 1.5") && titles[2].contains("outer_m is 140"), "{titles:?}");
    let many: Vec<f64> = (0..50).flat_map(|_| with(2, 0.0)).collect();
    assert_eq!(read(array(&folder, 8, &many)).unwrap_err().len(), 21);
    let single = files::Npy::new(vec![1, 6], vec![1.0_f32; 6]).unwrap();
    files::write_npy(folder.path().join("single.npy"), &single).unwrap();
    let refused = read(folder.path().join("single.npy")).unwrap_err().render(false);
    assert!(refused.contains("not float64") && refused.contains("save it as float64"), "{refused}");
    for (width, rows) in [(7, vec![0.0; 14]), (8, vec![])] {
        assert_eq!(read(array(&folder, width, &rows)).unwrap_err().len(), 1);
    }
}
