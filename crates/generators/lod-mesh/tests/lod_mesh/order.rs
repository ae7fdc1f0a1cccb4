//! Any order, any number of threads, any number of tiles in view.

use lod_mesh::{GroundLight, Parameters};
use rayon::ThreadPoolBuilder;

use crate::shots::{draw, pose, run, session, stage};

const PIXELS: usize = 48;

#[test]
fn any_order_and_any_number_of_threads_give_the_same_bits() {
    for light in [GroundLight::Map, GroundLight::Live] {
        let poses = [
            pose([300.0, 400.0, 120.0], 45.0, -20.0),
            pose([800.0, 800.0, 500.0], 0.0, -90.0),
            pose([1200.0, 300.0, 60.0], 200.0, -5.0),
        ];
        let of = |threads: usize, order: [usize; 3]| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let session = session(stage(PIXELS as u32), Parameters { light, ..run() });
                let mut pictures: Vec<_> =
                    order.map(|k| (k, draw(&*session, PIXELS, &poses[k]))).into_iter().collect();
                pictures.sort_by_key(|(k, _)| *k);
                pictures.into_iter().map(|(_, picture)| picture).collect::<Vec<_>>()
            })
        };
        let one = of(1, [0, 1, 2]);
        assert!(one == of(3, [2, 0, 1]) && one == of(2, [1, 2, 0]), "{light:?}");
    }
}
