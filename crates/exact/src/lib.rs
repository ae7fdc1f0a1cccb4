//! The same picture by closed form and root finding, no sweeps and no parts.
