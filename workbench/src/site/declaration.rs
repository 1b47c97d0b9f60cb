//! The declaration of a module as an image carries it: a line `key := value` for each fact.

use twinrung_plant::{ModuleSettings, PointSettings, Terminal};

use crate::reaction::connection::{Connection, Direction};

/// The lines of a declaration.
pub struct Declaration<'t> {
    lines: Vec<(&'t str, &'t str)>,
}

impl<'t> Declaration<'t> {
    /// Takes the lines apart.
    pub fn read(text: &'t str) -> Declaration<'t> {
        Declaration { lines: text.lines().filter_map(|line| line.split_once(" := ")).collect() }
    }

    fn all(&self, key: &'static str) -> impl Iterator<Item = &'t str> + '_ {
        self.lines.iter().filter(move |(own, _)| *own == key).map(|(_, value)| *value)
    }

    fn one(&self, key: &'static str) -> Option<&'t str> {
        self.all(key).next()
    }

    /// What a model needs to know, in a task with this period in µs.
    pub fn settings(&self, period_us: u64) -> Option<ModuleSettings> {
        let input = self.connection(Direction::In, "safetyinput", None);
        let output = self.connection(Direction::Out, "safetyoutput", Some(period_us));
        let points = self.all("Point").filter_map(|line| {
            let mut words = line.split(' ');
            let terminal = Terminal::parse(words.next()?)?;
            Some((terminal, PointSettings::new(words.filter_map(|word| word.split_once('=')))))
        });
        Some(ModuleSettings {
            catalog_number: self.one("CatalogNumber")?.to_owned(),
            points: points.collect(),
            input_rpi_us: input.rpi_us(),
            input_limit_us: input.limit_us(),
            output_limit_us: output.limit_us(),
        })
    }

    /// The connection of a kind: as an export shows it, or with the interval of the module.
    fn connection(&self, direction: Direction, kind: &str, rpi_us: Option<u64>) -> Connection {
        let shown = self.all("Connection").find_map(|line| {
            let words: Vec<&str> = line.split(' ').collect();
            words.iter().any(|word| word.to_ascii_lowercase().starts_with(kind)).then_some(words)
        });
        let number = |key: &str| -> Option<u64> {
            let words = shown.as_ref()?;
            let at = words.iter().position(|word| *word == key)?;
            words.get(at + 1)?.parse().ok()
        };
        let small = |key: &str| number(key).and_then(|value| u32::try_from(value).ok());
        let own = || self.one("RPI_us").and_then(|text| text.parse().ok());
        let rpi_us = rpi_us.or_else(|| number("rpi_us")).or_else(own);
        Connection::new(direction, rpi_us, small("timeout"), small("delay"), number("limit_us"))
    }

    /// Whether a tag is of this module: `Doors:I` by the module's name, `Rack:1:I` by its place.
    pub fn owns(&self, module: &str, tag: &str) -> bool {
        let Some((owner, _)) = tag.rsplit_once(':') else { return false };
        let place = self.one("Parent").zip(self.one("Slot"));
        owner.eq_ignore_ascii_case(module)
            || place.is_some_and(|(parent, slot)| {
                owner.rsplit_once(':').is_some_and(|(own, at)| own.eq_ignore_ascii_case(parent) && at == slot)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXPORTED: &str = "MODULE := Doors\nCatalogNumber := 1734-IB8S\nParent := Rack\nSlot := 1\n\
        Point := I00 MODE=SAFETY_PULSE_TEST TESTSOURCE=T0\n\
        Connection := SafetyInput SafetyInput rpi_us 20000 timeout 2 delay 200 limit_us -\n";

    #[test]
    fn declaration_when_exported_then_the_interval_of_its_connection_counts() {
        let settings = Declaration::read(EXPORTED).settings(30_000).unwrap();
        assert_eq!((settings.input_rpi_us, settings.input_limit_us), (20_000, 80_000));
        assert_eq!(settings.output_limit_us, 90_112);
        assert!(settings.of(Terminal::new('I', 0)).has("TestSource", "T0"));
    }

    #[test]
    fn tags_when_named_after_the_module_or_its_place_then_they_are_its_own() {
        let declaration = Declaration::read(EXPORTED);
        assert!(declaration.owns("Doors", "doors:I"));
        assert!(declaration.owns("Doors", "Rack:1:I"));
        assert!(!declaration.owns("Doors", "Rack:2:I"));
    }
}
