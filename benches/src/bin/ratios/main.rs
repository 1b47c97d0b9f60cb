//! Compares Twinrung with other systems on this machine, in one run, and prints the tables of docs/performance.md.
//!
//! `cargo run --release -p twinrung-benches --bin ratios -- [--pairs 7] [--seeds 1,2,3] [--rungs 1000,10000]
//! [--large 100000] [--scans 300] [--tables c,data,size,build,load,threads]`
//!
//! The C renderings come from `../shared/bench` where it is there, with gcc and Python; without them only what needs no
//! other system is measured.

mod building;
mod machine;
mod options;
mod reference;
mod scanning;
mod table;
mod threads;

use options::Options;
use twinrung_benches::Result;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [verb, image] = arguments.as_slice()
        && verb == "memory"
    {
        return building::print_memory(image.as_ref());
    }
    let options = Options::read(&arguments)?;
    if cfg!(debug_assertions) {
        eprintln!("this is a debug build: its figures say nothing");
    }
    println!("{}\n", machine::description());
    let print: [fn(&Options) -> Result<()>; options::TABLES.len()] = [
        scanning::against_c,
        scanning::data_dependence,
        scanning::size_dependence,
        building::against_python,
        building::loading,
        threads::on_two,
    ];
    for (name, print) in options::TABLES.iter().zip(print) {
        if options.tables.iter().any(|wanted| wanted == name) {
            print(&options)?;
        }
    }
    Ok(())
}
