//! Timing records: what the digital side did and when, and baselines to hold it to.
