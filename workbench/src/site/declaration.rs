//! The declaration of a module as an image carries it: a line `key := value` for each fact.

use twinrung_plant::{ModuleSettings, PointSettings, Terminal};

use crate::reaction::connection::{Connection, Direction, Shown};

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
        let rpi_us = self.one("RPI_us").and_then(|text| text.parse().ok());
        let input = Connection::inputs(self.shown(Direction::In), rpi_us);
        let output = Connection::outputs(self.shown(Direction::Out), period_us);
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

    /// What an export shows of a connection: `NAME TYPE rpi_us 10000 timeout 2 delay 200 limit_us -`, where a name may have
    /// blanks.
    fn shown(&self, direction: Direction) -> Shown {
        const BEHIND_TYPE: usize = 8;
        let mut lines = self.all("Connection").map(|line| line.split(' ').collect::<Vec<&str>>());
        let is_it = |words: &Vec<&str>| words.iter().rev().nth(BEHIND_TYPE).is_some_and(|kind| direction.carries(kind));
        let Some(words) = lines.find(is_it) else { return Shown::default() };
        let values = words.get(words.len() - BEHIND_TYPE..).unwrap_or_default();
        let number = |key: &str| -> Option<u64> {
            let [_, value] = values.chunks_exact(2).find(|pair| pair.first() == Some(&key))? else { return None };
            value.parse().ok()
        };
        let count = |key: &str| number(key).and_then(|value| u32::try_from(value).ok());
        Shown {
            rpi_us: number("rpi_us"),
            timeouts: count("timeout"),
            delay_percent: count("delay"),
            limit_us: number("limit_us"),
        }
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

    /// A name is no type, whatever it is called.
    #[test]
    fn connection_when_only_its_name_is_that_of_a_type_then_it_is_another_one() {
        let named = EXPORTED.replace(
            "Connection := ",
            "Connection := SafetyInput rpi_us Output rpi_us 5000 timeout 1 delay 100 limit_us -\nConnection := ",
        );
        let settings = Declaration::read(&named).settings(30_000).unwrap();
        assert_eq!((settings.input_rpi_us, settings.input_limit_us), (20_000, 80_000));
    }

    #[test]
    fn tags_when_named_after_the_module_or_its_place_then_they_are_its_own() {
        let declaration = Declaration::read(EXPORTED);
        assert!(declaration.owns("Doors", "doors:I"));
        assert!(declaration.owns("Doors", "Rack:1:I"));
        assert!(!declaration.owns("Doors", "Rack:2:I"));
    }
}
