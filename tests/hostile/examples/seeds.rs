//! Writes the seeds of every target: `cargo run -p twinrung-hostile --example seeds -- fuzz/corpus`.

use std::path::PathBuf;

use twinrung_hostile::{Target, seeds};

fn main() -> std::io::Result<()> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "fuzz/corpus".to_owned()));
    for target in Target::ALL {
        let into = folder.join(target.name());
        std::fs::create_dir_all(&into)?;
        let seeds = seeds(target)?;
        for (name, bytes) in &seeds {
            std::fs::write(into.join(name), bytes)?;
        }
        println!("{}: {} seeds", into.display(), seeds.len());
    }
    Ok(())
}
