//! The faces of a closed shell as triangles that all run the same way round.

use glam::DVec3;

use super::joined::Joined;
use crate::split::volume;

/// Triangles of a shell.
pub(super) struct Oriented {
    /// Counter-clockwise seen from outside, by right-handed axes.
    pub triangles: Vec<[DVec3; 3]>,
    /// Number of the face of each.
    pub faces: Vec<usize>,
    /// Whether the shell's faces do not all run as the format asks.
    pub is_turned: bool,
}

impl Oriented {
    /// The triangles of a shell whose every edge has two faces; `None` if no way round suits all faces, as of a bottle of Klein's.
    pub fn new(shell: &Joined) -> Option<Self> {
        let turns = turns(shell)?;
        let mut made = Self { triangles: Vec::new(), faces: Vec::new(), is_turned: false };
        for (number, (face, turned)) in shell.faces.iter().zip(&turns).enumerate() {
            let at = |corner: usize| shell.places[face.corners[corner] as usize];
            for corner in 1..face.corners.len() - 1 {
                let [b, c] = if *turned { [corner + 1, corner] } else { [corner, corner + 1] };
                made.triangles.push([at(0), at(b), at(c)]);
                made.faces.push(number);
            }
        }
        // Body axes are left-handed: what the format has outside is inside by the right-handed rule.
        let is_inside_out = volume(&made.triangles) > 0.0;
        if !is_inside_out {
            made.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
        made.is_turned = is_inside_out || turns.contains(&true);
        Some(made)
    }
}

/// Which faces must be turned to run as the first does.
fn turns(shell: &Joined) -> Option<Vec<bool>> {
    let edges = shell.edges();
    let mut beside = vec![Vec::new(); shell.faces.len()];
    for faces in edges.values() {
        let [(one, up), (other, also_up)] = faces[..] else { return None };
        beside[one].push((other, up == also_up));
        beside[other].push((one, up == also_up));
    }
    let mut turns = vec![None; shell.faces.len()];
    let mut open = vec![(0, false)];
    while let Some((face, is_turned)) = open.pop() {
        match turns[face] {
            Some(known) if known != is_turned => return None,
            Some(_) => {}
            None => {
                turns[face] = Some(is_turned);
                open.extend(beside[face].iter().map(|&(other, differs)| (other, is_turned != differs)));
            }
        }
    }
    turns.into_iter().collect()
}
