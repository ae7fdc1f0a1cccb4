//! Polyhedron generator (section 12): rocks and culture in display-plane position.
