//! The `twinrung` command.
fn main() {}
