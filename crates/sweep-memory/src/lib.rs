//! Sweep memory: scan converter and digital memory.
