//! Feature generator (section 10): sub-generators and their loads.
