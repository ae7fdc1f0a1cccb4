//! The two ships of the study's data base: LPH and DD963.

use super::{Block, Level, Marking, Ship};

const fn level(up: f64, breadth: f64, entrance: f64, run: f64, transom: f64, cut_back: f64) -> Level {
    Level { up, breadth, entrance, run, transom, cut_back }
}

const fn block(along: [f64; 2], across: [f64; 2], up: [f64; 2], taper: f64) -> Block {
    Block { along, across, up, taper }
}

/// A spot for a helicopter on the flight deck.
const fn spot(aft: f64) -> Marking {
    Marking { along: [aft, aft + 6.0], across: [-9.0, -3.0] }
}

impl Ship {
    /// Amphibious assault ship LPH-2: 592 ft x 84 ft, draught 27 ft, with a flight deck and an island to starboard.
    pub const LPH2: Self = Self {
        name: "LPH-2",
        length: 180.4416,
        beam: 25.6032,
        draught: 8.2296,
        levels: [
            level(-8.2296, 0.55, 0.55, 0.50, 0.10, 6.0),
            level(-5.0, 0.92, 0.50, 0.45, 0.30, 3.0),
            level(0.0, 1.0, 0.42, 0.35, 0.55, 0.0),
            level(8.0, 1.02, 0.32, 0.25, 0.75, 0.0),
            level(16.0, 1.22, 0.14, 0.10, 0.85, 0.0),
        ],
        blocks: &[
            block([-22.0, 22.0], [8.5, 14.5], [16.0, 22.0], 1.0),
            block([-16.0, 14.0], [9.0, 14.0], [22.0, 26.0], 0.95),
            block([-6.0, 4.0], [9.5, 13.5], [26.0, 32.0], 0.8),
            block([6.0, 11.0], [10.0, 13.0], [26.0, 29.0], 0.9),
            block([-1.4, 0.2], [11.0, 12.0], [32.0, 46.0], 0.5),
            block([-3.0, 1.8], [10.0, 13.0], [40.0, 40.8], 1.0),
        ],
        markings: &[
            Marking { along: [-84.0, 72.0], across: [-0.4, 0.4] },
            spot(-70.0),
            spot(-44.0),
            spot(-18.0),
            spot(8.0),
            spot(34.0),
            spot(56.0),
        ],
    };

    /// Destroyer of the Spruance class, DD963: 563 ft x 55 ft, draught 29 ft, with a landing deck aft.
    pub const DD963: Self = Self {
        name: "DD963",
        length: 171.6024,
        beam: 16.764,
        draught: 8.8392,
        levels: [
            level(-8.8392, 0.30, 0.60, 0.55, 0.10, 8.0),
            level(-4.0, 0.85, 0.58, 0.50, 0.35, 3.0),
            level(0.0, 1.0, 0.55, 0.45, 0.60, 0.0),
            level(4.0, 1.0, 0.44, 0.40, 0.75, 0.0),
            level(8.0, 1.04, 0.30, 0.30, 0.85, 0.0),
        ],
        blocks: &[
            block([14.0, 40.0], [-6.0, 6.0], [8.0, 15.0], 0.95),
            block([26.0, 38.0], [-6.5, 6.5], [15.0, 20.0], 0.9),
            block([-34.0, 12.0], [-6.5, 6.5], [8.0, 13.0], 0.97),
            block([2.0, 12.0], [-4.5, 0.5], [13.0, 22.0], 0.85),
            block([-30.0, -20.0], [-0.5, 4.5], [13.0, 21.0], 0.85),
            block([16.0, 19.0], [-1.5, 1.5], [15.0, 36.0], 0.3),
            block([-14.0, -11.0], [-1.5, 1.5], [13.0, 38.0], 0.3),
            block([55.0, 61.0], [-1.8, 1.8], [8.0, 11.0], 0.8),
            block([-76.0, -70.0], [-1.8, 1.8], [8.0, 11.0], 0.8),
        ],
        markings: &[
            Marking { along: [-54.0, -37.0], across: [-0.2, 0.2] },
            Marking { along: [-46.0, -45.6], across: [-5.0, 5.0] },
        ],
    };
}
