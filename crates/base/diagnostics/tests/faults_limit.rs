//! A file with a fault in every line is listed up to a limit. A test program of its own: limits are the process's.

use diagnostics::{Problem, Problems};

#[test]
fn faults_beyond_the_limit_are_counted() {
    limits::raise("faults=3").expect("a limit");
    let problems = Problems::new();
    (0..10).for_each(|number| problems.push(Problem::of_file("t.toml", format!("fault {number}"))));
    assert_eq!(problems.len(), 10);
    let shown = problems.into_result().expect_err("ten faults").render(false);
    assert!(shown.contains("fault 2") && !shown.contains("fault 3"), "{shown}");
    assert!(shown.contains("7 more faults are not listed"), "{shown}");
    assert!(shown.contains("--raise faults=N allows more"), "{shown}");
}
