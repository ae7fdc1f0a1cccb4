//! How small files are, against the layout of the document.

use quantities::unit_interval;
use terrain_database::{Contents, Database, documented_bytes};

use crate::{FRAME, places};

/// Layout of the document by hand. Order 1, 2 x 2 cells: four corners of four vertices in three versions; 1 x 1 cell the same.
/// Order 2 adds 4 x 4 cells: an inner face of 3 x 3 vertices, and four sides of two rows of three.
#[test]
fn the_documents_layout_by_hand() {
    let corners = 12 * 4 * 4 * 3;
    assert_eq!(documented_bytes(1, 1), 2 * corners);
    assert_eq!(documented_bytes(2, 3), 3 * (3 * corners + 12 * (9 + 4 * 3 * 6)));
}

/// Hills with roughness of some centimetres, in steps of a millimetre.
#[test]
fn ground_in_millimetres_takes_less_than_a_fifth_of_the_documents_layout() {
    let order = 5;
    let side = 129;
    let height = |post: u64| {
        let [x, y] = [(post % side) as f64, (post / side) as f64].map(|at| at / 128.0 - 0.5);
        400.0 * (x * x - y * y * y) + 0.2 * unit_interval(5, &[post])
    };
    let heights: Vec<f64> = (0..side * side).map(height).collect();
    let contents = Contents::new(FRAME, order, [places(order, 4, 32), places(order, 4, 32)], heights);
    let coarse =
        Database::new(Contents { step: Some(0.001), ..contents.clone() }).unwrap().bytes().len() as u64;
    let documented = documented_bytes(order, 16);
    assert!(5 * coarse < documented, "{coarse} of {documented}");
    let exact = Database::new(contents).unwrap().bytes().len() as u64;
    assert!(exact < 8 * side * side, "{exact}");
}

#[test]
fn level_ground_takes_a_bit_a_post() {
    let contents =
        Contents::new(FRAME, 7, [places(7, 1, 128), places(7, 1, 128)], vec![-2718.281828; 129 * 129]);
    let bytes = Database::new(contents).unwrap().bytes().len();
    assert!(bytes < 129 * 129 / 8 + 129 * 3 + 2 * 129 * 8 + 500, "{bytes}");
}
