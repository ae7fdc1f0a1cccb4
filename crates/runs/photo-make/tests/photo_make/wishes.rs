//! Wishes that make no photograph are refused by the name of the figure.

use features::Features;
use photo_make::{MakeError, Reach, Wishes, make};

use crate::{plane, stage, wishes};

#[test]
fn figures_out_of_range_are_refused_by_name() {
    let stage = stage(plane(0.0, [0.0; 2]), Features::default());
    let good = wishes();
    for (wishes, told) in [
        (Wishes { ground_sample: 0.0, ..good.clone() }, "ground sample (m) is 0"),
        (Wishes { ground_sample: f64::NAN, ..good.clone() }, "ground sample (m) is NaN"),
        (Wishes { focal_length: -1.0, ..good.clone() }, "focal length (m) is -1"),
        (Wishes { reach: Reach::Height(0.0), ..good.clone() }, "height (m) is 0"),
        (Wishes { reach: Reach::Field(4.0), ..good.clone() }, "field of view (rad) is 4"),
        (Wishes { pitch: 0.0, ..good.clone() }, "pitch (rad) is 0"),
        (Wishes { pitch: -2.0, ..good.clone() }, "pitch (rad) is -2"),
        (Wishes { heading: f64::INFINITY, ..good.clone() }, "heading (rad) is inf"),
        (Wishes { noise: -0.1, ..good.clone() }, "noise is -0.1"),
        (Wishes { time: f64::NAN, ..good.clone() }, "time (s) is NaN"),
    ] {
        let error = make(&stage, &wishes).expect_err(told);
        assert!(matches!(error, MakeError::Wish { .. }) && error.to_string().starts_with(told), "{error}");
    }
}
