//! What of a project reaches the image, and how.

mod support;

use support::{admitted, image, project};

const TAGS: &str = "    X : BOOL (Class := Safety);";

#[test]
fn signatures_when_compiled_then_those_that_the_loader_finds() {
    let compiled = image(&project("", TAGS, "OTE(X)", ""));
    let loaded = twinrung_bytecode::admit(&compiled.bytes).unwrap();
    assert_eq!(&compiled.application_signature, loaded.application_signature());
    assert_eq!(&compiled.image_signature, loaded.image_signature());
    assert_ne!(compiled.application_signature, compiled.image_signature);
}

const UNIT: &str = "  ADD_ON_INSTRUCTION_DEFINITION Unit (Class := Safety, Vendor := \"Acme Safety\")
    PARAMETERS
      Limit : DINT (Usage := Input) := 7;
      Armed : BOOL (Usage := Input) := 1;
      Least : DINT (Usage := Input) := 5;
    END_PARAMETERS
    ROUTINE Logic
      N: NOP();
    END_ROUTINE
  END_ADD_ON_INSTRUCTION_DEFINITION
  DATATYPE Line_T
    DINT Number;
    Unit Units[2];
  END_DATATYPE
";

#[test]
fn instances_when_in_arrays_then_each_begins_with_the_defaults_of_its_definition() {
    let tags = format!("{TAGS}\n    Units : Unit[3] (Class := Safety);\n    Lines : Line_T[2] (Class := Safety);");
    let image = admitted(&project(UNIT, &tags, "OTE(X)", ""));
    let records = image.image();
    let tag = |name: &str| records.tags.iter().find(|tag| tag.name == name).unwrap();
    let words = |name: &str, count: usize| &records.initial_words[tag(name).word_cell as usize..][..count];
    // EnableIn, EnableOut, Armed.
    let bits = |name: &str, count: usize| &records.initial_bits[tag(name).bit_cell as usize..][..count];
    assert_eq!(words("Units", 6), [7, 5, 7, 5, 7, 5]);
    assert_eq!(bits("Units", 9), [0, 0, 1, 0, 0, 1, 0, 0, 1]);
    assert_eq!(words("Lines", 10), [0, 7, 5, 7, 5, 0, 7, 5, 7, 5]);
    assert_eq!(bits("Lines", 12), [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]);
}

#[test]
fn instances_when_in_an_array_of_local_tags_then_each_begins_with_the_defaults_of_its_definition() {
    let group = UNIT.replace("  DATATYPE Line_T\n    DINT Number;\n    Unit Units[2];\n  END_DATATYPE\n", "")
        + "  ADD_ON_INSTRUCTION_DEFINITION Group (Class := Safety)\n    LOCAL_TAGS\n      Units : Unit[2];\n    END_LOCAL_TAGS\n    \
           ROUTINE Logic\n      N: NOP();\n    END_ROUTINE\n  END_ADD_ON_INSTRUCTION_DEFINITION\n";
    let tags = format!("{TAGS}\n    One : Group (Class := Safety);");
    let image = admitted(&project(&group, &tags, "OTE(X)", ""));
    let one = image.image().tags.iter().find(|tag| tag.name == "One").unwrap();
    assert_eq!(image.image().initial_words[one.word_cell as usize..][..4], [7, 5, 7, 5]);
    // EnableIn and EnableOut of the group, then of each unit, with Armed.
    assert_eq!(image.image().initial_bits[one.bit_cell as usize..][..8], [0, 0, 0, 0, 1, 0, 0, 1]);
}

#[test]
fn setting_when_it_holds_a_control_character_then_a_blank_stands_for_it() {
    let vendor = |name: &str| {
        let tags = format!("{TAGS}\n    One : Unit (Class := Safety);");
        let image = admitted(&project(&UNIT.replace("Acme Safety", name), &tags, "OTE(X)", ""));
        let settings = &image.image().add_ons[0].attributes;
        settings.iter().find(|(key, _)| key == "Vendor").unwrap().1.clone()
    };
    assert_eq!(vendor("Acme Safety"), "Acme Safety");
    assert_eq!(vendor("Acme\tSafety"), "\"Acme Safety\"");
    assert_eq!(vendor("Acme (Safety)"), "\"Acme (Safety)\"");
}

#[test]
fn tags_when_they_are_produced_consumed_or_of_declared_integrity_then_their_settings_are_in_the_image() {
    let types = "  DATATYPE Line_T\n    CONNECTION_STATUS Status;\n    BOOL Stop;\n  END_DATATYPE\n";
    let tags = "    X : BOOL (Class := Safety, SIL := 2);\n    Plain : BOOL (Class := Safety);\n    Out_Line : Line_T (Class := Safety, Produced := 2, RPI := 20);\n    In_Line : Line_T (Class := Safety, Producer := Other, RemoteTag := \"Out_Line\", RPI := 40);";
    let image = admitted(&project(types, tags, "XIC(In_Line.Stop)XIO(In_Line.Status.ConnectionFaulted)OTE(X)", ""));
    let settings = |name: &str| {
        let tag = image.image().tags.iter().find(|tag| tag.name == name).unwrap();
        let list = tag.attributes.iter().map(|(key, value)| format!("{key}={value}"));
        list.collect::<Vec<_>>().join(" ")
    };
    assert_eq!(settings("X"), "SIL=2");
    assert_eq!(settings("Plain"), "");
    assert_eq!(settings("Out_Line"), "Produced=2 RPI_us=20000");
    assert_eq!(settings("In_Line"), "Producer=Other RPI_us=40000 RemoteTag=Out_Line");
}
