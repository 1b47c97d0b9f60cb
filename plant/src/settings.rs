//! The configuration of a module as a project declares it.

use twinrung_catalog::modules::Module;
use twinrung_catalog::points::{Points, SettingValue};
use twinrung_catalog::reaction::INPUT_RPI_US;

use crate::stimulus::Terminal;

/// Error latch time of a point that does not set one, ms. 1734-UM013 Tables 18, 20, 21.
pub const ERROR_LATCH_MS: u64 = 1000;

/// The settings of one point: keys and values as declared. The catalogue says which there are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PointSettings {
    entries: Vec<(String, String)>,
}

impl PointSettings {
    /// Takes keys and values.
    pub fn new<K: Into<String>, V: Into<String>>(entries: impl IntoIterator<Item = (K, V)>) -> PointSettings {
        PointSettings { entries: entries.into_iter().map(|(key, value)| (key.into(), value.into())).collect() }
    }

    /// A value by its key.
    pub fn word(&self, key: &str) -> Option<&str> {
        self.entries.iter().find(|(own, _)| own.eq_ignore_ascii_case(key)).map(|(_, value)| value.as_str())
    }

    /// Whether a key has this value.
    pub fn has(&self, key: &str, word: &str) -> bool {
        self.word(key).is_some_and(|own| own.eq_ignore_ascii_case(word))
    }

    /// A whole number by its key.
    pub fn number(&self, key: &str) -> Option<i64> {
        self.word(key)?.parse().ok()
    }

    /// A time in ms by its key, or what holds without one.
    pub fn milliseconds(&self, key: &str, default_ms: u64) -> u64 {
        self.number(key).and_then(|number| u64::try_from(number).ok()).unwrap_or(default_ms)
    }

    /// The error latch time in ms.
    pub fn error_latch_ms(&self) -> u64 {
        self.milliseconds("ErrorLatchTime", ERROR_LATCH_MS)
    }
}

/// A module as a project declares it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModuleSettings {
    /// Catalogue number, with or without a series letter.
    pub catalog_number: String,
    /// The points that the project configures; another one is not used.
    pub points: Vec<(Terminal, PointSettings)>,
    /// Requested packet interval of the input connection in µs.
    pub input_rpi_us: u64,
    /// Connection reaction time limit of the input connection in µs.
    pub input_limit_us: u64,
    /// Connection reaction time limit of the output connection in µs.
    pub output_limit_us: u64,
}

impl ModuleSettings {
    /// A module without a configured point, with a connection each 10 ms that has the limits of the manual's example:
    /// 40.064 ms in, 60.032 ms out for a task of 20 ms (1734-UM013, Configure Safety Connections).
    pub fn new(catalog_number: &str) -> ModuleSettings {
        ModuleSettings {
            catalog_number: catalog_number.to_owned(),
            points: Vec::new(),
            input_rpi_us: INPUT_RPI_US,
            input_limit_us: 40_064,
            output_limit_us: 60_032,
        }
    }

    /// Configures a point.
    pub fn point(mut self, terminal: Terminal, settings: &[(&str, &str)]) -> ModuleSettings {
        self.points.push((terminal, PointSettings::new(settings.iter().copied())));
        self
    }

    /// The settings of a point; none where the project does not configure it. What the catalogue does not allow is not set: the
    /// compiler refuses it, and an image that it did not make may hold anything.
    pub fn of(&self, terminal: Terminal) -> PointSettings {
        let found = self.points.iter().find(|(own, _)| *own == terminal);
        let module = Module::by_catalog_number(&self.catalog_number);
        let points = module.and_then(|module| module.points.iter().find(|points| points.letter == terminal.letter));
        let (Some((_, settings)), Some(points)) = (found, points) else { return PointSettings::default() };
        let mut settings = settings.clone();
        settings.entries.retain(|(key, value)| allows(points, key, value));
        settings
    }
}

fn allows(points: &Points, key: &str, value: &str) -> bool {
    let setting = points.settings.iter().find(|setting| setting.key.eq_ignore_ascii_case(key));
    setting.is_some_and(|setting| match setting.value {
        SettingValue::Word(words) => words.iter().any(|word| word.eq_ignore_ascii_case(value)),
        SettingValue::Number { least, greatest, step, .. } => value
            .parse::<i64>()
            .is_ok_and(|number| (least..=greatest).contains(&number) && number.checked_rem(step) == Some(0)),
    })
}
