//! From L5X to a signed image, and from an image to loaded channels: time and memory.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use twinrung_benches::{Result, controller, median};
use twinrung_bytecode::{admit, bound};
use twinrung_workbench::mix::{Mix, Program};

use crate::options::Options;
use crate::reference::output;
use crate::table;

/// Runs a command from Python, which says how long it took, how much processor time, and how much memory its largest
/// process had. Processor time tells more than the clock where other work goes on.
const MEASURE: &str = "import resource,subprocess,sys,time\n\
t=time.perf_counter()\n\
r=subprocess.run(sys.argv[1:],stdout=subprocess.DEVNULL)\n\
e=time.perf_counter()-t\n\
u=resource.getrusage(resource.RUSAGE_CHILDREN)\n\
print(r.returncode,e,u.ru_utime+u.ru_stime,u.ru_maxrss)";
/// Reads an L5X; says how long the reading alone took.
const READ: &str = "import sys,time,xml.etree.ElementTree as E\n\
t=time.perf_counter()\nE.parse(sys.argv[1])\nprint(time.perf_counter()-t)";
/// The sizes that the thresholds are stated for.
const RUNGS: usize = 10_000;
/// KiB in a MB of the thresholds.
const KIB_PER_MB: f64 = 1_000_000.0 / 1024.0;

struct Whole {
    seconds: f64,
    processor_seconds: f64,
    megabytes: f64,
}

fn whole(command: &[&Path]) -> Result<Whole> {
    let text = output(Command::new("python3").args(["-c", MEASURE]).args(command))?;
    let fields: Vec<&str> = text.split_whitespace().collect();
    let [code, seconds, processor, kib] = fields.as_slice() else {
        return Err(format!("not understood: {text}").into());
    };
    if *code != "0" {
        return Err(format!("{command:?} ended with {code}").into());
    }
    Ok(Whole {
        seconds: seconds.parse()?,
        processor_seconds: processor.parse()?,
        megabytes: kib.parse::<f64>()? / KIB_PER_MB,
    })
}

/// The command itself, built now: what is measured is what a user runs.
fn twinrung() -> Result<PathBuf> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("../Cargo.toml");
    output(
        Command::new(cargo).args(["build", "--release", "--quiet", "-p", "twinrung", "--manifest-path"]).arg(manifest),
    )?;
    let folder = std::env::current_exe()?.parent().map(Path::to_owned).unwrap_or_default();
    Ok(folder.join("twinrung"))
}

/// `twinrung build` of an L5X against Python's xml.etree reading it, as whole processes.
pub fn against_python(options: &Options) -> Result<()> {
    let twinrung = twinrung()?;
    let folder = tempfile::tempdir()?;
    let image = folder.path().join("project.image");
    let script = folder.path().join("read.py");
    std::fs::write(&script, READ)?;
    table::begin(
        &format!("L5X to a signed image against Python's xml.etree reading it, {} pairs", options.pairs),
        &[
            "mix",
            "rungs",
            "L5X, MB",
            "twinrung build, s",
            "its processor time, s",
            "peak, MB",
            "Python process, s",
            "its reading alone, s",
            "ratio to the process",
            "in processor time",
            "ratio to the reading",
        ],
    );
    let mut ratios = Vec::new();
    let mut growth = Vec::new();
    for mix in [Mix::Simple, Mix::Plant] {
        let mut medians = Vec::new();
        for rungs in [RUNGS, 10 * RUNGS] {
            let path = folder.path().join("project.L5X");
            std::fs::write(&path, Program::new(mix, rungs, options.seeds[0]).l5x())?;
            let mut runs = Vec::new();
            for _ in 0..options.pairs {
                let own = whole(&[&twinrung, Path::new("build"), &path, Path::new("-o"), &image])?;
                let python = whole(&[Path::new("python3"), &script, &path])?;
                let reading: f64 = output(Command::new("python3").arg(&script).arg(&path))?.trim().parse()?;
                runs.push((own, python, reading));
            }
            let of = |field: fn(&(Whole, Whole, f64)) -> f64| -> Vec<f64> { runs.iter().map(field).collect() };
            let to_process = of(|(own, python, _)| own.seconds / python.seconds);
            let seconds = median(of(|(own, _, _)| own.seconds));
            let processor = median(of(|(own, _, _)| own.processor_seconds));
            if rungs == RUNGS {
                ratios.push(median(to_process.clone()));
            }
            medians.push((seconds, processor));
            table::row(&[
                mix.to_string(),
                rungs.to_string(),
                format!("{:.1}", std::fs::metadata(&path)?.len() as f64 / 1e6),
                format!("{seconds:.3}"),
                format!("{processor:.3}"),
                format!("{:.0}", median(of(|(own, _, _)| own.megabytes))),
                format!("{:.3}", median(of(|(_, python, _)| python.seconds))),
                format!("{:.3}", median(of(|(_, _, reading)| *reading))),
                table::spread(&to_process),
                table::spread(&of(|(own, python, _)| own.processor_seconds / python.processor_seconds)),
                table::spread(&of(|(own, _, reading)| own.seconds / reading)),
            ]);
        }
        if let [small, large] = medians.as_slice() {
            growth.push((mix, large.0 / small.0, large.1 / small.1));
        }
    }
    table::end(Some((1.5, &ratios)));
    for (mix, seconds, processor) in growth {
        println!(
            "`{mix}`: {} rungs take {seconds:.2} times as long as {RUNGS} ({processor:.2} times the processor time); at most 12.\n",
            10 * RUNGS
        );
    }
    Ok(())
}

/// Verification and loading, and what a rung takes in memory.
pub fn loading(options: &Options) -> Result<()> {
    let folder = tempfile::tempdir()?;
    table::begin(
        &format!("Loading an image, medians of {} runs", options.pairs),
        &[
            "mix",
            "rungs",
            "image, bytes per rung",
            "verify, ms",
            "load both channels, ms",
            "bound, ms",
            "channels, bytes per rung",
            "all, bytes per rung",
        ],
    );
    for mix in [Mix::Simple, Mix::Plant] {
        for rungs in [RUNGS, 10 * RUNGS] {
            let project = twinrung_benches::checked("mix.rll", &Program::new(mix, rungs, options.seeds[0]).rll())?;
            let (_, bytes) = twinrung_benches::image(&project)?;
            drop(project);
            let mut runs = Vec::new();
            for _ in 0..options.pairs {
                let begun = Instant::now();
                let admitted = admit(&bytes)?;
                let verified = Instant::now();
                let bound = bound::instructions(&admitted);
                let bounded = Instant::now();
                let loaded = controller(&admitted, &bytes)?;
                let done = Instant::now();
                std::hint::black_box((bound, loaded));
                runs.push((verified - begun, done - bounded, bounded - verified));
            }
            let path = folder.path().join("project.image");
            std::fs::write(&path, &bytes)?;
            let memory = output(Command::new(std::env::current_exe()?).arg("memory").arg(&path))?;
            let numbers: Vec<f64> = memory.split_whitespace().map(str::parse).collect::<std::result::Result<_, _>>()?;
            let [channels, all] = numbers.as_slice() else { return Err("no memory figures".into()) };
            let ms = |durations: Vec<std::time::Duration>| format!("{:.1}", median(durations).as_secs_f64() * 1e3);
            table::row(&[
                mix.to_string(),
                rungs.to_string(),
                format!("{:.0}", bytes.len() as f64 / rungs as f64),
                ms(runs.iter().map(|run| run.0).collect()),
                ms(runs.iter().map(|run| run.1).collect()),
                ms(runs.iter().map(|run| run.2).collect()),
                format!("{:.0}", channels / rungs as f64),
                format!("{:.0}", all / rungs as f64),
            ]);
        }
    }
    table::end(None);
    Ok(())
}

/// In a process of its own: how much the resident memory grows by loading the channels, and by all, in bytes.
pub fn print_memory(path: &Path) -> Result<()> {
    let before = resident()?;
    let bytes = std::fs::read(path)?;
    let image = admit(&bytes)?;
    let admitted = resident()?;
    let mut controller = controller(&image, &bytes)?;
    controller.scan(0);
    let loaded = resident()?;
    println!("{} {}", loaded.saturating_sub(admitted), loaded.saturating_sub(before));
    Ok(())
}

/// Resident memory in bytes, from the kernel.
fn resident() -> Result<u64> {
    let text = std::fs::read_to_string("/proc/self/status")?;
    let line = text.lines().find(|line| line.starts_with("VmRSS:")).ok_or("no VmRSS")?;
    let kib: u64 = line.split_whitespace().nth(1).ok_or("no VmRSS")?.parse()?;
    Ok(kib * 1024)
}
