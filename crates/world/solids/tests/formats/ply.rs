//! What PLY says beside places, and what it may say wrongly.

use solids::shape_files::ALBEDO;

use crate::made::{ply, read, refused, rows};

#[test]
fn ply_with_colours_and_normals() {
    let head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    let face = "element face 4\nproperty list uchar int vertex_indices\n";
    let rows = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    let coded = format!(
        "{head}property uchar red\nproperty uchar green\nproperty uchar blue\n{face}end_header\n\
         0 0 0 255 128 0\n1 0 0 255 128 0\n0 1 0 255 128 0\n0 0 1 255 128 0\n{rows}"
    );
    let solid = &read("a.ply", coded).unwrap().solids[0];
    // The curve of sRGB has 0.21586 at code 128.
    let expected = [ALBEDO, ALBEDO * 0.215_860_5, 0.0];
    assert!(
        solid.albedo(0).iter().zip(expected).all(|(found, own)| (found - own).abs() < 1e-7),
        "{:?}",
        solid.albedo(0)
    );
    let of_faces = format!(
        "{head}{face}property float red\nproperty float green\nproperty float blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{}",
        rows.replace('\n', " 0.5 0 1\n")
    );
    assert_eq!(read("a.ply", of_faces).unwrap().solids[0].albedo(2), [0.5 * ALBEDO, 0.0, ALBEDO]);
    let smooth = format!(
        "{head}property float nx\nproperty float ny\nproperty float nz\n{face}end_header\n\
         0 0 0 -1 -1 -1\n1 0 0 1 -0.1 -0.1\n0 1 0 -0.1 1 -0.1\n0 0 1 -0.1 -0.1 1\n{rows}"
    );
    assert!(read("a.ply", smooth).unwrap().solids[0].is_smooth());
}

#[test]
fn ply_that_is_damaged_or_says_more() {
    let text = String::from_utf8(ply("ascii", &rows())).unwrap();
    for (from, to, said) in [
        ("end_header\n", "", "the header does not end"),
        ("format ascii 1.0", "format ascii 2.0", "this format is not read"),
        ("property uchar flags", "property uchar glow", "property `glow` of element `vertex` is not read"),
        ("property float x", "property half x", "unknown type"),
        ("property float x\n", "", "element `vertex` has no properties x, y and z"),
        ("element face 12", "element tristrips 12", "export faces instead of strips"),
        ("element face 12", "element edge 12", "delete loose edges"),
        ("element face 12", "element vertex 12", "this element stands twice"),
        ("element face 12", "element face 13", "face 13 of 13: the file ends before it"),
        ("element face 12", "element face 11", "bytes are left behind the last element"),
        ("element face 12", "element face 99999999999999999999", "this count is no whole number"),
        (
            "element vertex 8",
            "element void 18446744073709551615\nelement vertex 8",
            "element `void` has no properties",
        ),
        ("1 3 0 3 2", "1 3 0 3 8", "face 1 of 12: corner 8 names no vertex: there are 8, counted from 0"),
        ("1 3 0 3 2", "1 3 0 3 1.5", "corner 1.5 names no vertex"),
        ("1 3 0 3 2", "1 4 0 3 2", "the line is too short"),
        ("1 3 0 3 2", "1 3 0 3 2 2", "the line is too long"),
        ("1 3 0 3 2", "1 -3 0 3 2", "a list of -3 numbers"),
        ("0 7 -0.5 -1", "0 7 inf -1", "vertex 1 of 8: a coordinate is not finite"),
        ("0 7 -0.5 -1", "0 7 x -1", "`x` is no number"),
        (
            "property list uchar uint vertex_index",
            "property uint vertex_index",
            "element `face` has no list of vertices",
        ),
    ] {
        let wrong = text.replacen(from, to, 1);
        assert_ne!(wrong, text, "{from}");
        assert!(refused("a.ply", &wrong).contains(said), "{said}: {}", refused("a.ply", &wrong));
    }
    let whole = ply("binary_big_endian", &rows());
    assert!(refused("a.ply", &whole[..whole.len() - 1]).contains("face 12 of 12: the file ends before it"));
    assert!(refused("a.ply", [&whole[..], &[0]].concat()).contains("1 bytes are left"));
}
