//! The C renderings of a generated program: made by the shared generator, compiled as its own script does.

use std::path::{Path, PathBuf};
use std::process::Command;

use twinrung_benches::Result;
use twinrung_workbench::mix::Mix;

/// A compiled reference.
pub struct Reference {
    threaded: PathBuf,
    /// Keeps the files until the reference is dropped.
    _folder: tempfile::TempDir,
}

/// One run of it.
#[derive(Debug, Clone, Copy)]
pub struct Run {
    /// Median ns per rung.
    pub ns_per_rung: f64,
    /// The state after the last scan.
    pub hash: u64,
}

/// Where the shared generator is.
pub fn folder() -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/bench");
    path.join("gen.py").is_file().then_some(path)
}

/// Runs a command and answers with what it prints.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if !output.status.success() {
        return Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(String::from_utf8(output.stdout)?)
}

impl Reference {
    /// Generates and compiles; and checks that the shared generator writes the program that the workbench generates.
    pub fn new(shared: &Path, mix: Mix, rungs: usize, seed: u64, rll: &str) -> Result<Reference> {
        let folder = tempfile::tempdir()?;
        let out = folder.path();
        let numbers = [rungs.to_string(), "1".to_owned(), seed.to_string()];
        let [rungs, scans, seed] = &numbers;
        output(Command::new("python3").arg(shared.join("gen.py")).arg(rungs).arg(out).args([
            scans.as_str(),
            &mix.to_string(),
            seed,
        ]))?;
        if std::fs::read_to_string(out.join("project.rll"))? != rll {
            return Err(format!("the two generators differ: {mix}, {rungs} rungs, seed {seed}").into());
        }
        let threaded = out.join("c_threaded");
        output(
            Command::new("gcc")
                .args(["-O2", "-fno-strict-aliasing", "-DGOTO", "-fno-gcse"])
                .arg(format!("-I{}", out.display()))
                .arg(format!("-I{}", shared.display()))
                .args([shared.join("main.c"), shared.join("interp.c")])
                .arg("-o")
                .arg(&threaded),
        )?;
        Ok(Reference { threaded, _folder: folder })
    }

    /// Runs the direct-threaded interpreter with 16 toggles before each scan.
    pub fn run(&self, scans: u64) -> Result<Run> {
        let text = output(Command::new(&self.threaded).args([scans.to_string().as_str(), "0", "16"]))?;
        let field = |name: &str| {
            let from = text.find(name)? + name.len();
            text.get(from..)?.split_whitespace().next()
        };
        let wrong = || format!("not understood: {text}");
        Ok(Run {
            ns_per_rung: field("p50=").ok_or_else(wrong)?.parse()?,
            hash: u64::from_str_radix(field("yn=").ok_or_else(wrong)?, 16)?,
        })
    }
}
