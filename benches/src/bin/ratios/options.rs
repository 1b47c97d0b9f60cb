//! What to measure.

use twinrung_benches::Result;

/// The command line.
#[derive(Debug, Clone)]
pub struct Options {
    /// Paired runs of each comparison.
    pub pairs: usize,
    /// Seeds of the plant mix; the simple mix takes the first.
    pub seeds: Vec<u64>,
    /// Sizes that are compared with C.
    pub rungs: Vec<usize>,
    /// The size that shows how costs grow.
    pub large: usize,
    /// Scans of a run.
    pub scans: u64,
    /// The tables to print.
    pub tables: Vec<String>,
}

/// All tables, in their order: against C, against the data, against the size, against Python, loading, on two
/// threads.
pub const TABLES: [&str; 6] = ["c", "data", "size", "build", "load", "threads"];

impl Options {
    /// Reads `--name value` pairs.
    pub fn read(arguments: &[String]) -> Result<Options> {
        let mut options = Options {
            pairs: 7,
            seeds: vec![1, 2, 3],
            rungs: vec![1000, 10_000],
            large: 100_000,
            scans: 300,
            tables: TABLES.map(str::to_owned).to_vec(),
        };
        let mut rest = arguments.iter();
        while let Some(name) = rest.next() {
            let value = rest.next().ok_or_else(|| format!("{name} needs a value"))?;
            match name.as_str() {
                "--pairs" => options.pairs = value.parse()?,
                "--seeds" => options.seeds = list(value)?,
                "--rungs" => options.rungs = list(value)?,
                "--large" => options.large = value.parse()?,
                "--scans" => options.scans = value.parse()?,
                "--tables" => options.tables = list(value)?,
                _ => return Err(format!("no option {name}").into()),
            }
        }
        if options.pairs == 0 || options.scans == 0 || options.seeds.is_empty() || options.rungs.is_empty() {
            return Err("pairs, scans, seeds and rungs are at least one each".into());
        }
        if let Some(unknown) = options.tables.iter().find(|name| !TABLES.contains(&name.as_str())) {
            return Err(format!("no table {unknown}; there are {}", TABLES.join(", ")).into());
        }
        Ok(options)
    }
}

fn list<T: std::str::FromStr>(text: &str) -> Result<Vec<T>>
where
    T::Err: std::error::Error + 'static,
{
    Ok(text.split(',').map(str::parse).collect::<std::result::Result<_, _>>()?)
}
