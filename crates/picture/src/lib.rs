//! Grey pictures, PNG, animated PNG, Y4M, contact sheets.
