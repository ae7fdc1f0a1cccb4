//! OpenEXR files, read back.

use std::collections::BTreeMap;
use std::fs;

use exr::prelude::{AttributeValue, FlatSamples, ReadChannels, ReadLayers, read};
use files::parse_npz;
use picture::{Limits, Transfer, read_png};

use crate::scene::{Made, Wish};

/// Channels of a file by name, and its attribute.
fn channels(path: &std::path::Path) -> (BTreeMap<String, FlatSamples>, String) {
    let image = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().from_file(path).expect("a file");
    let layer = image.layer_data;
    let about = match layer.attributes.other.get(&b"lunoid"[..]) {
        Some(AttributeValue::Text(text)) => text.to_string(),
        other => panic!("{other:?}, expected a text"),
    };
    let list = layer.channel_data.list.into_iter();
    (list.map(|channel| (channel.name.to_string(), channel.sample_data)).collect(), about)
}

fn numbers(samples: &FlatSamples) -> Vec<f32> {
    samples.values_as_f32().collect()
}

/// Every layer is the array of the truth, to the bit; sky stays infinite; normals are in the axes of the site.
#[test]
fn every_layer_is_what_the_run_has() {
    let made = Made::new(Wish::default());
    let outcome = made.exr().expect("written");
    assert_eq!((outcome.frames, outcome.done), (3, 3));
    for frame in 0..3 {
        let (layers, about) = channels(&made.path().join(format!("exr/frame-{frame:06}.exr")));
        let names: Vec<&str> = layers.keys().map(String::as_str).collect();
        let expected = [
            "Y",
            "depth.Z",
            "distance",
            "height",
            "label",
            "normal.X",
            "normal.Y",
            "normal.Z",
            "range",
            "reflectivity",
            "shadow",
        ];
        assert_eq!(names, expected);
        assert!(about.contains("lunoid.exr/1") && about.contains(&format!("\"frame\":{frame},")), "{about}");
        let bytes = fs::read(made.path().join(format!("truth/frame-{frame:06}.npz"))).expect("truth");
        for (name, array) in parse_npz(&bytes).expect("arrays") {
            let values: Vec<f32> = array.data().to_f64().into_iter().map(|value| value as f32).collect();
            match name.as_str() {
                "normal" => {
                    for (part, at) in [("normal.X", 1), ("normal.Y", 0), ("normal.Z", 2)] {
                        let expected: Vec<f32> = values.iter().skip(at).step_by(3).copied().collect();
                        assert_eq!(numbers(&layers[part]), expected, "{part}");
                    }
                }
                name => {
                    assert_eq!(numbers(&layers[name]), values, "{name}");
                    let is_code = matches!(layers[name], FlatSamples::U32(_));
                    assert_eq!(is_code, ["label", "shadow"].contains(&name), "{name}");
                }
            }
        }
        let (depth, distance) = (numbers(&layers["depth.Z"]), numbers(&layers["distance"]));
        for (depth, distance) in depth.iter().zip(&distance) {
            assert_eq!(depth.is_infinite(), distance.is_infinite());
            assert!(depth <= distance && *depth > 0.0, "{depth} m of {distance} m");
        }
        assert!(depth.contains(&f32::INFINITY));
        let picture = read_png(made.path().join(format!("frames/frame-{frame:06}.png")), &Limits::default())
            .expect("a picture");
        let transfer = Transfer::new(0.75, 2.2).expect("a display");
        let light: Vec<f32> =
            picture.codes().iter().map(|code| transfer.intensity(*code, picture.depth())).collect();
        assert_eq!(numbers(&layers["Y"]), light);
    }
}

#[test]
fn the_bytes_depend_on_the_run_alone_and_stay() {
    let runs = [1, 3].map(|threads| Made::new(Wish { threads, ..Wish::default() }));
    let bytes = runs.each_ref().map(|made| {
        made.exr().expect("written");
        [0, 1, 2].map(|frame| fs::read(made.path().join(format!("exr/frame-{frame:06}.exr"))).expect("there"))
    });
    assert!(bytes[0] == bytes[1]);
    let file = runs[0].path().join("exr/frame-000001.exr");
    let written = fs::metadata(&file).and_then(|found| found.modified()).expect("a time");
    runs[0].exr().expect("written again");
    assert_eq!(fs::metadata(&file).and_then(|found| found.modified()).expect("a time"), written);
}
