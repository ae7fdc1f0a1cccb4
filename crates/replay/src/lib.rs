//! Missions into frames.
