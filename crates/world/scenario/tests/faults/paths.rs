//! Faults of path files.

use std::fs;

use crate::GOOD;
use scenario::Scenario;

/// Messages about a path file of this name and text.
pub fn path_faults(name: &str, text: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), text).unwrap();
    let start = GOOD.find("keyframes").unwrap();
    let end = GOOD.find("[raster]").unwrap();
    let scenario = format!("{}file = '{name}'\n{}", &GOOD[..start], &GOOD[end..]);
    match Scenario::parse(folder.path().join("s.toml").to_str().unwrap(), &scenario) {
        Ok(_) => Vec::new(),
        Err(list) => {
            let records = list.iter().map(diagnostics::Problem::record);
            let place = |line: Option<usize>, column: Option<usize>| {
                line.zip(column).map_or(String::new(), |(line, column)| format!("{line}:{column} "))
            };
            records.map(|record| place(record.line, record.column) + &record.title).collect()
        }
    }
}

#[test]
fn good_path_files() {
    assert_eq!(path_faults("p.csv", "\u{feff}y_m,\"x_m\",t_s\r\n1,2,0\r\n\r\n# halt\r\n1,2,5\r\n"), [""; 0]);
    assert_eq!(path_faults("p.csv", "frame,t_s,x_m,y_m,z_m\n0,0,1,2,\n1,1e0,1,2,\n"), [""; 0]);
    assert_eq!(path_faults("p.tum", "# c\n5 1 2 -3 0 0 0 1\n6\t1 2 -3  0 0 0 1\n"), [""; 0]);
}

#[test]
fn faults_of_path_files_have_line_and_column() {
    let header = "t_s,x_m,y_m,heading_deg\n";
    let csv = |rows: &str| path_faults("p.csv", &format!("{header}{rows}"));
    assert_eq!(
        csv("0,1,2,3\n1,nan,2,3\n"),
        ["3:3 `x_m` must be a number from -10000000 to 10000000, not nan"]
    );
    assert_eq!(csv("0,1,2,inf\n"), ["2:7 `heading_deg` must be a number from -36000 to 36000, not inf"]);
    assert_eq!(
        csv("0,1,,3\n1,x,2,3\n"),
        [
            "2:5 `y_m` must be a number from -10000000 to 10000000, not nothing",
            "3:3 `x_m` must be a number from -10000000 to 10000000, not x",
        ]
    );
    assert_eq!(csv("0,1e8,2,3\n").len(), 1);
    assert_eq!(
        csv("1e300,1,2,3\n"),
        [
            "2:1 `t_s` must be a number of seconds below 1e11; t_ms, t_us and t_ns are columns of smaller units, not 1e300"
        ]
    );
    assert_eq!(csv("0,1,2,3\n0,1,2,4\n"), ["3:1 t = 0 s after t = 0 s: times must ascend"]);
    assert_eq!(csv("0,1,2\n"), ["2:1 a row of 3 cells under a header of 4"]);
    assert_eq!(csv(""), ["1:1 a path file without rows"]);
    assert_eq!(path_faults("p.csv", ""), ["1:1 an empty path file"]);
    assert_eq!(
        path_faults("p.csv", "t_s,x_m,speed\n0,1,2\n"),
        ["1:1 missing column `y_m`", "1:9 unknown column `speed`",]
    );
    assert_eq!(path_faults("p.csv", "t_s,x_m,y_m,x_m\n0,1,2,3\n"), ["1:13 column `x_m` stands twice"]);
    assert_eq!(
        path_faults("p.csv", "t_s,x_m,y_m,z_m\n0,1,2,3\n1,1,2,\n"),
        ["2:1 z_m is given for some waypoints only; expected for all or for none",]
    );
    assert_eq!(path_faults("p.tum", "0 1 2 3 0 0 0 2\n"), ["1:1 a quaternion of length 2"]);
    assert_eq!(path_faults("p.tum", "0 1 2 3\n"), ["1:1 a row of 4 numbers"]);
    assert_eq!(
        path_faults("p.tum", "0 1 2 3 0 0 0 1\n1 1 2 NaN 0 0 0 1\n"),
        ["2:7 `tz` must be a number from -10000000 to 10000000, not NaN",]
    );
    assert!(path_faults("p.txt", "")[0].contains("of a kind that is not known"));
}

#[test]
fn a_table_full_of_faults_is_reported_by_its_first() {
    let rows = "0,nan,2\n".repeat(1000);
    let found = path_faults("p.csv", &format!("t_s,x_m,y_m\n{rows}"));
    assert_eq!(found.len(), 21);
    assert_eq!(found[20], "980 more faults of this file are not listed");
    let falling: String = (0..50).map(|row| format!("{},0,0\n", 50 - row)).collect();
    let found = path_faults("p.csv", &format!("t_s,x_m,y_m\n{falling}"));
    assert_eq!(found[20], "29 more faults of this file are not listed", "of times that fall too");
}

#[test]
fn a_path_file_that_is_missing_or_no_text() {
    let folder = tempfile::tempdir().unwrap();
    let text = GOOD.replace("keyframes = [", "file = 'no.csv'\nunused = [");
    let name = folder.path().join("s.toml");
    let list = Scenario::parse(name.to_str().unwrap(), &text).unwrap_err().to_string();
    assert!(list.contains("no such file") && list.contains("unknown key `path.unused`"), "{list}");
    fs::write(folder.path().join("no.csv"), [0xff, 0xfe]).unwrap();
    let list = Scenario::parse(name.to_str().unwrap(), &text).unwrap_err().to_string();
    assert!(list.contains("the file is UTF-16 text"), "{list}");
}
