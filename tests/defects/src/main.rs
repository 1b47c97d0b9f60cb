//! Puts each listed defect into a copy of the project, alone, and measures how long `twinrung fuzz` takes to find it.
//!
//! `cargo run --release -p twinrung-defects`

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use twinrung_defects::{Bench, Channel, Defect, Measured, ScratchTree, Times, page, read};

/// Seconds that the project without a defect is fuzzed before: a difference there would be taken for a defect found.
const SOUND_S: u32 = 10;

/// Puts each listed defect into a copy of the project and measures how long the fuzzer takes to find it
#[derive(Debug, Parser)]
#[command(after_help = "Times go to tests/defects/times.toml and the page docs/seeded-defects.md.\n\
Exit code: 0 every defect was found, 1 some were not, 2 something does not build or cannot be read.")]
struct Arguments {
    /// Only defects whose name contains this; may be given several times
    #[arg(long, value_name = "NAME")]
    only: Vec<String>,
    /// Only those of one channel: primary or partner
    #[arg(long, value_name = "CHANNEL")]
    channel: Option<String>,
    /// Only those that were not measured before, or were missed
    #[arg(long)]
    missing: bool,
    /// Random programs alone, to compare
    #[arg(long)]
    plain: bool,
    /// Seconds after which a defect counts as missed
    #[arg(long, value_name = "SECONDS", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..))]
    limit: u32,
    /// Threads of the fuzzer
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=1024))]
    jobs: u32,
    /// First seed
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Folder of the copy and what is built from it; kept, so that the next run builds less
    #[arg(long, value_name = "FOLDER")]
    scratch: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(code) => ExitCode::from(code),
        Err(error) => {
            eprintln!("seeded_defects: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<u8, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize()?;
    let mut lists: Vec<(Channel, Vec<Defect>)> = Vec::new();
    for channel in Channel::ALL {
        lists.extend(read(&root, channel)?.map(|list| (channel, list)));
    }
    let times_path = root.join("tests/defects/times.toml");
    let mut times: Times = match fs::read_to_string(&times_path) {
        Ok(text) => toml::from_str(&text)?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => Times::default(),
        Err(error) => return Err(error.into()),
    };
    let known = times.of(arguments.plain).clone();
    let asked: Vec<&Defect> = lists
        .iter()
        .filter(|(channel, _)| arguments.channel.as_ref().is_none_or(|name| name == channel.name()))
        .flat_map(|(_, list)| list)
        .filter(|defect| arguments.is_asked(defect, &known))
        .collect();
    let folder = arguments.scratch.clone().unwrap_or_else(|| root.join("target/seeded-defects"));
    let tree = ScratchTree::copy(&root, &folder.join("tree"))?;
    let Arguments { jobs, limit, seed, plain, .. } = *arguments;
    let bench = Bench { folder, jobs, limit_s: limit, seed, plain };
    bench.build(&tree)?;
    bench.keep_sound()?;
    Bench { limit_s: SOUND_S, ..bench.clone() }.run()?;
    let (mut missed, mut broken) = (0, 0);
    for (number, defect) in asked.iter().enumerate() {
        let applied = tree.apply(defect)?;
        let measured = bench.build(&tree).and_then(|()| bench.run());
        drop(applied);
        let name = &defect.name;
        let said = match &measured {
            Ok((Measured { found: true, seconds, cases }, _)) => format!("{seconds:.1} s, {cases} programs"),
            Ok((Measured { found: false, seconds, cases }, _)) => {
                format!("NOT FOUND in {seconds:.0} s, {cases} programs")
            }
            Err(error) => error.to_string(),
        };
        println!("{:>3}/{} {name}: {said}", number + 1, asked.len());
        match measured {
            Ok((measured, conditions)) => {
                missed += usize::from(!measured.found);
                times.measured_under(plain, conditions);
                times.of(plain).insert(name.clone(), measured);
            }
            Err(_) => broken += 1,
        }
        // After each, so that a run that is ended keeps what it measured.
        fs::write(&times_path, toml::to_string(&times)?)?;
        fs::write(root.join("docs/seeded-defects.md"), page(&lists, &times))?;
    }
    println!("{} measured, {missed} not found, {broken} could not be measured", asked.len() - broken);
    Ok(if broken > 0 { 2 } else { u8::from(missed > 0) })
}

impl Arguments {
    fn is_asked(&self, defect: &Defect, known: &BTreeMap<String, Measured>) -> bool {
        let named = self.only.is_empty() || self.only.iter().any(|part| defect.name.contains(part));
        named && !(self.missing && known.get(&defect.name).is_some_and(|one| one.found))
    }
}
