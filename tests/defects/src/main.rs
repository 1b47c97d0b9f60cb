//! Puts each listed defect into a copy of the project and measures how long `twinrung fuzz` takes to find it. Those that lie in
//! functions are all in one build, and one of them at a time is switched on; each of the others has a build of its own.
//!
//! `cargo run --release -p twinrung-defects`

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use twinrung_defects::{Bench, Channel, Defect, MeasureError, ScratchTree, mutant, read};
use twinrung_mutants::{Loom, Mutant};
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
    /// In which way it is looked for
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
    let Arguments { jobs, limit, seed, .. } = *arguments;
    // Before hours go by.
    runs.iter().try_for_each(|plain| times.admits(*plain, jobs, limit, seed))?;
    let folder = arguments.scratch.clone().unwrap_or_else(|| root.join("target/seeded-defects"));
    let tree = ScratchTree::copy(&root, &folder.join("tree"))?;
    let bench = Bench { folder, jobs, limit_s: limit, seed, plain: false, switch: 0 };
    bench.build(&tree)?;
    bench.keep_sound()?;
    let mut loom = Loom::new(tree.root(), mutants(&tree, &asked)?)?;
    loom.build(&bench.words())?;
    Bench { limit_s: SOUND_S, ..bench.clone() }.run()?;
    let mut session = Session { times, times_path, runs, of: asked.len(), begun: 0, missed: 0, broken: 0 };
    for (switch, mutant) in loom.viable() {
        session.measure(&mutant.name, &Bench { switch, ..bench.clone() })?;
    }
    let woven: BTreeSet<String> = loom.viable().map(|(_, mutant)| mutant.name.clone()).collect();
    drop(loom);
    for defect in asked.iter().filter(|defect| !woven.contains(&defect.name)) {
        let applied = tree.apply(defect)?;
        let built = bench.build(&tree);
        drop(applied);
        match built {
            Ok(()) => session.measure(&defect.name, &bench)?,
            Err(error) => session.cannot(&defect.name, &error),
        }
    }
    println!("{}", session.said());
    Ok(if session.broken > 0 { 2 } else { u8::from(session.missed > 0) })
}

/// The defects as mutants of the functions that they lie in.
fn mutants(tree: &ScratchTree, defects: &[&Defect]) -> Result<Vec<Mutant>, Box<dyn Error>> {
    let one = |defect: &&Defect| {
        let text = fs::read_to_string(tree.root().join(&defect.file))?;
        mutant(defect, &text).map_err(|misfit| format!("{}: {misfit}", defect.name).into())
    };
    defects.iter().map(one).collect()
}

/// What was measured so far.
struct Session {
    times: Times,
    times_path: PathBuf,
    runs: &'static [bool],
    of: usize,
    begun: usize,
    missed: usize,
    broken: usize,
}

impl Session {
    /// Measures one defect in each way, and writes the times down: a run that is ended keeps what it measured.
    fn measure(&mut self, name: &str, bench: &Bench) -> Result<(), Box<dyn Error>> {
        self.begun += 1;
        for plain in self.runs {
            let measured = Bench { plain: *plain, ..bench.clone() }.run();
            let said = match &measured {
                Ok((Measured { found: true, seconds, cases }, _)) => format!("{seconds:.1} s, {cases} programs"),
                Ok((Measured { found: false, seconds, cases }, _)) => {
                    format!("NOT FOUND in {seconds:.0} s, {cases} programs")
                }
                Err(error) => error.to_string(),
            };
            println!("{:>3}/{} {name}, {}: {said}", self.begun, self.of, if *plain { "plain" } else { "guided" });
            match measured {
                Ok((measured, conditions)) => {
                    self.missed += usize::from(!measured.found);
                    self.times.enter(*plain, name, measured, conditions)?;
                }
                Err(_) => self.broken += 1,
            }
        }
        fs::write(&self.times_path, toml::to_string(&self.times)?)?;
        Ok(())
    }

    /// A defect with which nothing can be built.
    fn cannot(&mut self, name: &str, error: &MeasureError) {
        self.begun += 1;
        self.broken += self.runs.len();
        println!("{:>3}/{} {name}: {error}", self.begun, self.of);
    }

    fn said(&self) -> String {
        let measured = self.of * self.runs.len() - self.broken;
        format!("{measured} measured, {} not found, {} could not be measured", self.missed, self.broken)
    }
}

impl Arguments {
    fn is_asked(&self, defect: &Defect, known: &[BTreeMap<String, Measured>]) -> bool {
        let named = self.only.is_empty() || self.only.iter().any(|part| defect.name.contains(part));
        let found = |times: &BTreeMap<String, Measured>| times.get(&defect.name).is_some_and(|one| one.found);
        named && !(self.missing && known.iter().all(found))
    }
}
