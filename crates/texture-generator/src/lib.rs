//! Texture generator (section 13): small detail against ground range.
