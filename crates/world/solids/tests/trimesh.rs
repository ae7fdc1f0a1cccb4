//! Files that trimesh writes: volumes and sizes are those that trimesh tells.
//!
//! Needs a Python with trimesh: `python3 -m venv V && V/bin/pip install trimesh`, then
//! `LUNOID_TRIMESH_PYTHON=V/bin/python cargo test -p solids --test trimesh`. It is skipped loudly without.

use std::path::Path;
use std::process::Command;

use glam::DVec3;
use solids::shape_files::{Openness, read};
use solids::{Face, Solid};

fn volume(solid: &Solid) -> f64 {
    let place = |corner: u32| solid.vertices()[corner as usize];
    let of = |face: &Face| {
        let first = place(face.corners[0]);
        let edges = face.corners.windows(2);
        let area: DVec3 = edges.map(|edge| (place(edge[0]) - first).cross(place(edge[1]) - first)).sum();
        // Body axes are left-handed.
        -area.dot(first) / 6.0
    };
    solid.faces().iter().map(of).sum()
}

#[test]
fn files_are_read_as_trimesh_means_them() {
    let Some(python) = std::env::var_os("LUNOID_TRIMESH_PYTHON") else {
        println!("SKIPPED: LUNOID_TRIMESH_PYTHON does not name a Python with trimesh");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/written_by_trimesh.py");
    let done = Command::new(python).arg(script).arg(folder.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let list = std::fs::read(folder.path().join("list.json")).unwrap();
    let list: Vec<(String, f64, [f64; 3])> = serde_json::from_slice(&list).unwrap();
    assert_eq!(list.len(), 35, "five shapes, seven files each");
    for (file, expected, extents) in list {
        let solids = read(folder.path().join(&file), Openness::Closed)
            .unwrap_or_else(|error| panic!("{error}"))
            .solids;
        let found: f64 = solids.iter().map(volume).sum();
        assert!((found / expected - 1.0).abs() < 1e-5, "{file}: {found} m3 for {expected}");
        let places = || solids.iter().flat_map(Solid::vertices).copied();
        let low = places().fold(DVec3::INFINITY, DVec3::min);
        let high = places().fold(DVec3::NEG_INFINITY, DVec3::max);
        let mut size = (high - low).to_array();
        size.sort_by(f64::total_cmp);
        let differs = size.iter().zip(extents).any(|(found, expected)| (found - expected).abs() > 1e-5);
        assert!(!differs, "{file}: {size:?} m for {extents:?}");
        println!("{file}: {} parts", solids.len());
    }
}
