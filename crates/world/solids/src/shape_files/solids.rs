//! From a mesh to solids.

use super::blame::{Blame, Refusal};
use super::dress::{Wardrobe, dressed};
use super::faults::Faults;
use super::mesh::Mesh;
use super::oriented::Oriented;
use super::shells::{Shell, shells};
use super::told::Told;
use super::{ALBEDO, Openness};
use crate::check::check_vertices;
use crate::split::{split, volume};
use crate::{Solid, SolidError};

/// The solids of a mesh; what is wrong with a shape is added to `faults`.
pub(super) fn solids(mesh: &Mesh, openness: Openness, told: &mut Told, faults: &mut Faults) -> Vec<Solid> {
    let mut solids = Vec::new();
    for shell in shells(mesh, told) {
        let made = match openness {
            Openness::Closed => closed(mesh, &shell, told),
            Openness::Any => closed_or_open(mesh, &shell).map(|solid| vec![solid]).map_err(Refusal::from),
        };
        match made {
            Ok(made) => solids.extend(made),
            Err(refusal) => {
                let problem = Blame { mesh, shell: &shell, faults }.problem(&refusal);
                faults.push(problem);
            }
        }
    }
    solids
}

/// A convex solid; anything else is a surface.
fn closed_or_open(mesh: &Mesh, shell: &Shell) -> Result<Solid, SolidError> {
    let (places, outlines) = (&shell.joined.places, shell.joined.outlines(ALBEDO));
    let solid = Solid::new(places.clone(), outlines.clone());
    dressed(solid.or_else(|_| Solid::open(places.clone(), outlines))?, mesh, &shell.joined)
}

/// A convex solid, or several that fill the shell.
fn closed(mesh: &Mesh, shell: &Shell, told: &mut Told) -> Result<Vec<Solid>, Refusal> {
    match Solid::new(shell.joined.places.clone(), shell.joined.outlines(ALBEDO)) {
        Ok(solid) => Ok(vec![dressed(solid, mesh, &shell.joined)?]),
        Err(error @ (SolidError::BadFace { .. } | SolidError::BadVertex { .. })) => Err(error.into()),
        Err(_) if !shell.closes => Err(Refusal::NotClosed),
        // A face of fewer than three corners has no edge to another, so it is a shell by itself.
        Err(error @ SolidError::TooSmall { .. }) => Err(error.into()),
        Err(_) => parts(mesh, shell, told),
    }
}

/// Convex parts that fill a shell which is not convex.
fn parts(mesh: &Mesh, shell: &Shell, told: &mut Told) -> Result<Vec<Solid>, Refusal> {
    check_vertices(&shell.joined.places)?;
    let oriented = Oriented::new(&shell.joined).ok_or(Refusal::NotOrientable)?;
    let extent = shell.joined.places.iter().map(|at| at.distance(shell.joined.places[0])).fold(0.0, f64::max);
    if volume(&oriented.triangles).abs() <= f64::EPSILON * extent * extent * extent {
        return Err(SolidError::Flat.into());
    }
    let split = split(&oriented.triangles, ALBEDO).map_err(Refusal::NotSplit)?;
    told.split(&split, oriented.is_turned);
    let wardrobe = Wardrobe::new(mesh, &shell.joined, &oriented);
    let parts = split.parts.into_iter().map(|part| wardrobe.dressed(part));
    Ok(parts.collect::<Result<_, _>>()?)
}
