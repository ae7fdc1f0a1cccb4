//! GeoTIFF files that are written here come back as they were.

use quantities::radians;
use survey::{
    Affine, Frame, Method, PlacedRaster, Projection, RasterSamples, ReadOptions, read, write_geotiff,
};

const PLACE: Affine = Affine { first: [5_000.5, -300.25], step: [-2.5, 2.5] };

fn frames() -> Vec<(Affine, Frame)> {
    let projection = |method, latitude: f64| {
        let latitude = radians(latitude);
        let projection = Projection {
            method,
            latitude,
            longitude: radians(-12.5),
            radius: 1_737_400.0,
            offset: [70.0, -8.0],
        };
        (PLACE, Frame::Plane(Some(projection)))
    };
    let degrees = Affine { first: [radians(10.0), radians(-20.0)], step: [radians(-0.5), radians(0.25)] };
    vec![
        (PLACE, Frame::Plane(None)),
        projection(Method::Equirectangular { parallel: radians(15.0) }, 3.0),
        projection(Method::PolarStereographic { scale: 0.97 }, -90.0),
        projection(Method::PolarStereographic { scale: 1.0 }, 90.0),
        projection(Method::Orthographic, 33.0),
        (degrees, Frame::Geographic { radius: 3_390_000.0 }),
    ]
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs())
}

fn parts(frame: &Frame) -> (u8, [f64; 6]) {
    match frame {
        Frame::Plane(None) => (0, [0.0; 6]),
        Frame::Geographic { radius } => (1, [*radius, 0.0, 0.0, 0.0, 0.0, 0.0]),
        Frame::Plane(Some(p)) => {
            let (kind, figure) = match p.method {
                Method::Equirectangular { parallel } => (2, parallel),
                Method::PolarStereographic { scale } => (3, scale),
                Method::Orthographic => (4, 0.0),
            };
            (kind, [p.radius, p.latitude, p.longitude, p.offset[0], p.offset[1], figure])
        }
    }
}

#[test]
fn rasters_come_back_with_place_and_voids() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("written.tif");
    let numbers = RasterSamples::Numbers(vec![1.5, f64::NAN, -3.0, 0.1, 7.0, 1e-9]);
    let codes = RasterSamples::Codes(vec![0, 1, 255, 1, 1, 0]);
    for (affine, frame) in frames() {
        for samples in [&numbers, &codes] {
            let raster = PlacedRaster { size: [2, 3], affine, frame, samples: samples.clone() };
            write_geotiff(&path, &raster).unwrap();
            let found = read(&path, &ReadOptions::default()).unwrap();
            assert_eq!([found.lines, found.columns], [2, 3]);
            let expected: Vec<Option<f64>> = match samples {
                RasterSamples::Numbers(numbers) => {
                    numbers.iter().map(|n| Some(*n).filter(|n| !n.is_nan())).collect()
                }
                RasterSamples::Codes(codes) => {
                    codes.iter().map(|&c| Some(f64::from(c)).filter(|c| *c < 255.0)).collect()
                }
            };
            let heights: Vec<Option<f64>> = (0..6).map(|at| found.height(at / 3, at % 3)).collect();
            assert_eq!(heights, expected, "{frame:?}");
            let places = [(found.affine.first, affine.first), (found.affine.step, affine.step)];
            assert!(places.iter().all(|(a, b)| near(a[0], b[0]) && near(a[1], b[1])), "{:?}", found.affine);
            let ((kind, figures), (kind_back, back)) = (parts(&frame), parts(&found.frame));
            assert_eq!(kind, kind_back, "{frame:?} {:?}", found.frame);
            assert!(figures.iter().zip(back).all(|(a, b)| near(*a, b)), "{frame:?} {:?}", found.frame);
        }
    }
}

#[test]
fn rasters_without_their_samples_leave_the_old_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("written.tif");
    std::fs::write(&path, "old").unwrap();
    let samples = RasterSamples::Codes(vec![0, 1, 2]);
    let raster = PlacedRaster { size: [2, 3], affine: PLACE, frame: Frame::Plane(None), samples };
    let refused = write_geotiff(&path, &raster).unwrap_err().to_string();
    assert!(refused.contains("written.tif"), "{refused}");
    assert_eq!(std::fs::read(&path).unwrap(), b"old");
}
