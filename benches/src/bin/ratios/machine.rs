//! On what machine figures were taken.

use std::fs;
use std::process::Command;

/// Processor, load, compilers.
pub fn description() -> String {
    let processor = fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|line| line.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    let load = fs::read_to_string("/proc/loadavg").ok().and_then(|text| Some(text.split(' ').next()?.to_owned()));
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    format!(
        "{}, {cores} cores, load {} when begun; {}; {}; {}",
        processor.unwrap_or_else(|| std::env::consts::ARCH.to_owned()),
        load.unwrap_or_else(|| "unknown".to_owned()),
        version("rustc"),
        version("gcc"),
        version("python3"),
    )
}

fn version(program: &str) -> String {
    let output = Command::new(program).arg("--version").output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    text.ok().and_then(|text| text.lines().next().map(str::to_owned)).unwrap_or_else(|| format!("no {program}"))
}
