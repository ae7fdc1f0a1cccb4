//! Remote shadow before the mission: sun-parallel profiles, boundaries, tiles.
