//! Lists of the sub-areas within the limits of the list memory, and which features find no place.

use std::cmp::Ordering;

use raster::{Lists, Screen};
use scene_sampler::Scene;

use crate::hardware::Memory;
use crate::policy::Overload;

/// A triangle that found no place in the list of a sub-area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LostEntry {
    /// Number of the sub-area.
    pub sub_area: u32,
    /// Number of the triangle in the frame.
    pub triangle: u32,
    /// How many more places the list, or the whole memory, would have needed for it, at least 1.
    pub short: u32,
}

/// What a triangle is worth to the list of a sub-area.
#[derive(Debug, Clone, Copy)]
struct Wish {
    sub_area: u32,
    triangle: u32,
    worth: f64,
}

impl Wish {
    /// The worthier first; of equals the one with the smaller number, then in the earlier sub-area.
    fn order(&self, other: &Self) -> Ordering {
        let by_number = || (self.triangle, self.sub_area).cmp(&(other.triangle, other.sub_area));
        other.worth.total_cmp(&self.worth).then_with(by_number)
    }
}

/// Lists the triangles of a scene within the limits of `memory`. What finds no place is told by sub-area, then by triangle.
pub fn lists(scene: &Scene, screen: &Screen, overload: Overload, memory: &Memory) -> (Lists, Vec<LostEntry>) {
    let mut lists = Lists::default();
    lists.fill(screen, &scene.faces.triangles);
    let wish = |sub_area: usize, triangle: u32| Wish {
        sub_area: sub_area as u32,
        triangle,
        worth: worth(scene, screen, overload, sub_area, triangle),
    };
    let mut lost = Vec::new();
    if let Some(depth) = memory.list_depth {
        let full = (0..screen.sub_areas()).filter(|area| lists.of(*area).len() > depth as usize);
        lost = full
            .flat_map(|area| {
                beyond(depth, lists.of(area).iter().map(|&triangle| wish(area, triangle)).collect())
            })
            .collect();
        take_out(&mut lists, &mut lost);
    }
    if let Some(most) = memory.list_entries.filter(|most| lists.entries() > *most as usize) {
        let areas = 0..screen.sub_areas();
        let all =
            areas.flat_map(|area| lists.of(area).iter().map(move |&triangle| wish(area, triangle))).collect();
        let mut more = beyond(most, all);
        take_out(&mut lists, &mut more);
        lost.extend(more);
        lost.sort_unstable_by_key(place);
    }
    (lists, lost)
}

/// Those that come after the first `places`, in the order of their worth.
fn beyond(places: u32, mut wishes: Vec<Wish>) -> Vec<LostEntry> {
    wishes.sort_unstable_by(Wish::order);
    let lost = wishes.iter().skip(places as usize).zip(1..);
    lost.map(|(wish, short)| LostEntry { sub_area: wish.sub_area, triangle: wish.triangle, short }).collect()
}

/// Takes entries out of the lists, and orders them by place.
fn take_out(lists: &mut Lists, lost: &mut [LostEntry]) {
    lost.sort_unstable_by_key(place);
    lists.retain(|area, triangle| lost.binary_search_by_key(&(area, triangle), place).is_err());
}

fn place(lost: &LostEntry) -> (u32, u32) {
    (lost.sub_area, lost.triangle)
}

/// What a triangle is worth: more is kept longer.
fn worth(scene: &Scene, screen: &Screen, overload: Overload, sub_area: usize, triangle: u32) -> f64 {
    match overload {
        Overload::DropSmallest | Overload::Late | Overload::Extend => {
            scene.faces.triangles[triangle as usize].doubled_area() as f64
        }
        Overload::DropFarthest => {
            let area = screen.sub_area(sub_area);
            let middle = [area.columns(), area.rows()].map(|range| f64::from(range.start + range.end) / 2.0);
            scene.faces.plane(triangle, &scene.camera).map_or(0.0, |plane| plane.at(middle))
        }
    }
}

#[cfg(test)]
mod tests {
    use scenario::Effects;

    use super::*;
    use crate::sampled::Sampled;
    use crate::scenes;
    use crate::session::Session;

    /// Places (sub-area, triangle, short) that are lost under `memory`.
    fn lost(effects: Effects, overload: Overload, memory: Memory) -> Vec<(u32, u32, u32)> {
        let (generator, update) = scenes::slow(10);
        let session =
            Session::new(scenes::stage(effects, update), generator.parameters, generator.hardware).unwrap();
        let scene = session.gather(0, &scenes::pose()).unwrap().scene;
        let (lists, lost) = lists(&scene, &session.screen, overload, &memory);
        for area in 0..session.screen.sub_areas() {
            assert!(
                lost.iter().all(|lost| {
                    lost.sub_area as usize != area || !lists.of(area).contains(&lost.triangle)
                })
            );
        }
        lost.iter().map(|lost| (lost.sub_area, lost.triangle, lost.short)).collect()
    }

    fn panes() -> Effects {
        Effects { overlays: vec![scenes::pane()], ..Effects::default() }
    }

    /// A large sheet far away, and a small one near by, over all four sub-areas.
    fn sheets() -> Effects {
        Effects {
            sheets: vec![scenes::sheet(0, 50.0, 0.9), scenes::sheet(1, 20.0, 0.5)],
            ..Effects::default()
        }
    }

    #[test]
    fn of_equals_the_larger_numbers_lose_their_places() {
        let depth = Memory { list_depth: Some(1), ..Memory::default() };
        assert_eq!(lost(panes(), Overload::DropSmallest, depth), [(0, 1, 1), (2, 1, 1)]);
        let most = |places| Memory { list_entries: Some(places), ..Memory::default() };
        assert_eq!(lost(panes(), Overload::DropSmallest, most(3)), [(2, 1, 1)]);
        assert_eq!(lost(panes(), Overload::DropSmallest, most(1)), [(0, 1, 2), (2, 0, 1), (2, 1, 3)]);
        assert!(lost(panes(), Overload::DropSmallest, most(4)).is_empty());
        assert!(lost(panes(), Overload::DropSmallest, Memory::default()).is_empty());
    }

    #[test]
    fn each_policy_drops_its_own() {
        let memory = Memory { list_depth: Some(1), ..Memory::default() };
        let triangles = |overload| {
            lost(sheets(), overload, memory).iter().map(|(_, triangle, _)| *triangle).collect::<Vec<_>>()
        };
        assert_eq!(triangles(Overload::DropSmallest), [1; 4]);
        assert_eq!(triangles(Overload::DropFarthest), [0; 4]);
    }

    #[test]
    fn what_is_lost_is_counted() {
        use generator::{Generator, Planes};
        let (generator, update) = scenes::slow(10);
        let memory = Memory { list_depth: Some(1), list_entries: Some(1), points: Some(1) };
        let hardware = crate::Hardware { memory, ..generator.hardware };
        let generator = Sampled { hardware, ..generator };
        let session = generator.prepare(scenes::stage(scenes::pane_and_stars(), update)).unwrap();
        let mut planes = Planes::new(16, 16, &[]);
        let counts = session.frame(0, &scenes::pose(), &mut planes, &mut signal::Probe::off()).unwrap();
        assert_eq!((counts["entries"], counts["lost_entries"]), (1, 3));
        assert_eq!((counts["lights"], counts["lost_points"]), (1, 1));
    }
}
