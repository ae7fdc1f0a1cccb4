//! Pictures of banks and surveys.
