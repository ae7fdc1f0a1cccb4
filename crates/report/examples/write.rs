//! Writes pages.
fn main() {
    for f in std::env::args().skip(1) {
        println!("{:?}", report::write_page(f.as_ref()));
    }
}
