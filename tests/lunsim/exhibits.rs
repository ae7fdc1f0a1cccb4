//! The twelve pictures of the report's exhibits.

use generator::{Generator, PlaneKind, Planes};
use lunoid_tests::Shipped;
use lunsim::Lunsim;
use signal::Probe;

use crate::shared::distance;

const EXHIBITS: [&str; 3] = ["lunsim-landing", "lunsim-roving", "lunsim-sun"];

#[test]
fn all_twelve_show_one_map_of_about_400_craters() {
    let maps = EXHIBITS.map(|name| Shipped::read(name, None).landscape);
    let count = maps[0].features().craters().len();
    println!("{count} craters");
    for c in maps[0].features().craters() { let [x,y]=c.centre(); if (x-25000.).abs()<6000. && (y-21500.).abs()<7000. { println!("TMP {} {x:.0} {y:.0} foot {:.0} outer {:.0} depth {:.0}", c.type_number(), c.foot(), c.outer(), c.depth()); } }
    assert!((380..=420).contains(&count), "{count} craters");
    assert_eq!(maps[0].level().extent(), [0.0, 0.0, 43_000.0, 43_000.0]);
    assert!(maps.iter().all(|map| map.features() == maps[0].features()));
}

#[test]
fn every_frame_is_ground_from_edge_to_edge_and_near_exact() {
    for name in EXHIBITS {
        let shipped = Shipped::read(name, None);
        assert_eq!(shipped.frames(), 4);
        for frame in 0..4 {
            let pose = shipped.pose(frame).pose;
            let mut planes = Planes::new(1024, 1024, &[PlaneKind::Range]);
            let session = Lunsim.prepare(shipped.stage()).unwrap();
            let counts = session.frame(frame, &pose, &mut planes, &mut Probe::off()).unwrap();
            let sky =
                planes.get(PlaneKind::Range).unwrap().iter().filter(|range| range.is_infinite()).count();
            println!("{name} {frame}: {} craters, {sky} pixels of sky", counts.features);
            // `exact` does not look straight down.
            if pose.attitude.pitch > -1.2 {
                println!("{:?}", distance(&shipped.stage(), frame, &pose, 64));
            }
        }
    }
}
