//! What a project is made of beside what comes from the export.

use twinrung_grammar::read;
use twinrung_grammar::tree::{ErrorKind, File, Name, RoutineBody, Sources, Span, Tag};

/// A name as it is compared.
pub fn fold(name: &str) -> String {
    name.to_ascii_lowercase()
}

/// A name that stands nowhere.
pub fn name(text: impl Into<String>) -> Name {
    Name::new(text.into(), Span::default())
}

/// A safety project without anything in it.
pub const SKELETON: &str = "
    CONTROLLER Idiom (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)
      PROGRAM Safety_Idiom (Class := Safety) END_PROGRAM
      TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5) Safety_Idiom; END_TASK
    END_CONTROLLER";

/// A tag of class Safety with the type and data of another.
pub fn plain(tag: &Tag) -> Tag {
    let mut plain = safety_tag(tag.name.as_str(), "BOOL");
    plain.data_type.clone_from(&tag.data_type);
    plain.dimensions = tag.dimensions;
    plain.data.clone_from(&tag.data);
    plain
}

/// A tag of class Safety.
pub fn safety_tag(title: &str, data_type: &str) -> Tag {
    declared(&format!("TAG {title} : {data_type} (Class := Safety); END_TAG")).tags.remove(0)
}

/// The body of a routine with these rungs.
pub fn ladder(rungs: &[String]) -> RoutineBody {
    let rungs: String = rungs.iter().map(|rung| format!("N: {rung}; ")).collect();
    declared(&format!("ROUTINE Main {rungs} END_ROUTINE")).routines.remove(0).body
}

/// What a text declares.
pub fn declared(text: &str) -> File {
    let reading = read(&mut Sources::new(), "idiom.rll", text.as_bytes().to_vec());
    let wrong = reading.errors.iter().find(|error| error.kind != ErrorKind::Empty);
    assert!(wrong.is_none(), "{wrong:?}\n{text}");
    reading.file
}
