//! Parts of a mesh as closed shells, and what does not close.

use super::joined::Joined;
use super::mesh::Mesh;
use super::told::Told;

/// A shape of joined faces.
pub(super) struct Shell<'m> {
    /// Number of the part that it begins in.
    pub part: usize,
    pub joined: Joined<'m>,
    /// Whether every edge has exactly two faces.
    pub closes: bool,
}

/// The shapes of a mesh, in order of the parts that they begin in.
///
/// A part whose faces close is taken by itself, shell by shell. All other parts are joined first: many programs write a group for
/// each face or material. What closes then is a shell, and what does not stays as its parts had it.
pub(super) fn shells<'m>(mesh: &'m Mesh, told: &mut Told) -> Vec<Shell<'m>> {
    let (mut shells, mut rest) = (Vec::new(), Vec::new());
    for (part, faces) in mesh.parts.iter().map(|part| &part.faces).enumerate() {
        let joined = Joined::new(mesh, faces.iter().map(|face| (part, face)));
        told.left_out(joined.left_out);
        let found = joined.shells();
        if found.iter().all(|(_, closes)| *closes) {
            shells.extend(found.iter().map(|(faces, _)| Shell {
                part,
                joined: joined.only(faces),
                closes: true,
            }));
        } else {
            rest.extend(faces.iter().map(|face| (part, face)));
        }
    }
    let joined = Joined::new(mesh, rest.into_iter());
    let mut open = vec![Vec::new(); mesh.parts.len()];
    for (faces, closes) in joined.shells() {
        if closes {
            let part = joined.faces[faces[0]].part;
            shells.push(Shell { part, joined: joined.only(&faces), closes });
        } else {
            faces.into_iter().for_each(|face| open[joined.faces[face].part].push(face));
        }
    }
    let open = open.iter().enumerate().filter(|(_, faces)| !faces.is_empty());
    shells.extend(open.map(|(part, faces)| Shell { part, joined: joined.only(faces), closes: false }));
    shells.sort_by_key(|shell| shell.part);
    shells
}
