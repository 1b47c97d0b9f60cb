//! Puts each listed defect into a copy of the project, alone, and measures how long `twinrung fuzz` takes to find it.
//!
//! `cargo run --release -p twinrung-defects`

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use twinrung_defects::{Bench, Channel, Defect, ScratchTree, read};
use twinrung_workbench::evidence::{Measured, Times};

/// Seconds that the project without a defect is fuzzed before: a difference there would be taken for a defect found.
const SOUND_S: u32 = 10;

/// Puts each listed defect into a copy of the project and measures how long the fuzzer takes to find it
#[derive(Debug, Parser)]
#[command(after_help = "Times go to tests/defects/times.toml; `twinrung evidence` shows them.\n\
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
    /// In which way it is looked for; each defect is built once for both
    #[arg(long, value_enum, default_value_t = Way::Both)]
    way: Way,
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

/// How a defect is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Way {
    /// First guided, then plain.
    Both,
    /// As the fuzzer is.
    Guided,
    /// Random programs alone, to compare.
    Plain,
}

impl Way {
    /// Whether each run is plain.
    fn runs(self) -> &'static [bool] {
        match self {
            Way::Both => &[false, true],
            Way::Guided => &[false],
            Way::Plain => &[true],
        }
    }
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
    let runs = arguments.way.runs();
    let known: Vec<BTreeMap<String, Measured>> = runs.iter().map(|plain| times.of(*plain).clone()).collect();
    let asked: Vec<&Defect> = lists
        .iter()
        .filter(|(channel, _)| arguments.channel.as_ref().is_none_or(|name| name == channel.name()))
        .flat_map(|(_, list)| list)
        .filter(|defect| arguments.is_asked(defect, &known))
        .collect();
    let folder = arguments.scratch.clone().unwrap_or_else(|| root.join("target/seeded-defects"));
    let tree = ScratchTree::copy(&root, &folder.join("tree"))?;
    let Arguments { jobs, limit, seed, .. } = *arguments;
    let bench = Bench { folder, jobs, limit_s: limit, seed, plain: false };
    bench.build(&tree)?;
    bench.keep_sound()?;
    Bench { limit_s: SOUND_S, ..bench.clone() }.run()?;
    let (mut missed, mut broken) = (0, 0);
    for (number, defect) in asked.iter().enumerate() {
        let applied = tree.apply(defect)?;
        let built = bench.build(&tree);
        drop(applied);
        let place = format!("{:>3}/{} {}", number + 1, asked.len(), defect.name);
        if let Err(error) = built {
            println!("{place}: {error}");
            broken += runs.len();
            continue;
        }
        for plain in runs {
            let measured = Bench { plain: *plain, ..bench.clone() }.run();
            let said = match &measured {
                Ok((Measured { found: true, seconds, cases }, _)) => format!("{seconds:.1} s, {cases} programs"),
                Ok((Measured { found: false, seconds, cases }, _)) => {
                    format!("NOT FOUND in {seconds:.0} s, {cases} programs")
                }
                Err(error) => error.to_string(),
            };
            println!("{place}, {}: {said}", if *plain { "plain" } else { "guided" });
            match measured {
                Ok((measured, conditions)) => {
                    missed += usize::from(!measured.found);
                    times.measured_under(*plain, conditions);
                    times.of(*plain).insert(defect.name.clone(), measured);
                }
                Err(_) => broken += 1,
            }
        }
        // After each, so that a run that is ended keeps what it measured.
        fs::write(&times_path, toml::to_string(&times)?)?;
    }
    println!("{} measured, {missed} not found, {broken} could not be measured", asked.len() * runs.len() - broken);
    Ok(if broken > 0 { 2 } else { u8::from(missed > 0) })
}

impl Arguments {
    fn is_asked(&self, defect: &Defect, known: &[BTreeMap<String, Measured>]) -> bool {
        let named = self.only.is_empty() || self.only.iter().any(|part| defect.name.contains(part));
        let found = |times: &BTreeMap<String, Measured>| times.get(&defect.name).is_some_and(|one| one.found);
        named && !(self.missing && known.iter().all(found))
    }
}
