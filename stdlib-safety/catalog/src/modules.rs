//! Safety I/O modules: the tags that each connection choice makes, member by member, with the class that the module manual
//! gives each. Source: 1734-UM013, chapters on configuration and `Values and States of Tags`; the words for the choices
//! are ours (decided), made from the manual's menu entries.

use crate::predefined::Element;

/// Whether safety logic may rely on a member.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemberClass {
    /// Safety data.
    Safety,
    /// `RunMode` and `ConnectionFaulted`: marked STANDARD, and to be watched all the same.
    ConnectionStatus,
    /// Marked STANDARD: readable, and unqualified.
    Standard,
}

/// A member of a module's tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModuleMember {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub element: Element,
    /// Its class.
    pub class: MemberClass,
}

/// One choice of a connection menu, and the members that it adds.
#[derive(Debug, PartialEq, Eq)]
pub struct ConnectionChoice {
    /// The word in a MODULE declaration.
    pub word: &'static str,
    /// The members that it adds to the tag, in order.
    pub members: &'static [ModuleMember],
}

/// A safety I/O module.
#[derive(Debug, PartialEq, Eq)]
pub struct Module {
    /// Catalogue number without a series letter.
    pub catalog_number: &'static str,
    /// What it is.
    pub name: &'static str,
    /// Members that the input tag always has, before those of the chosen `InputStatus`.
    pub input: &'static [ModuleMember],
    /// Choices of `InputStatus`; the first is taken where a declaration names none (decided).
    pub input_status: &'static [ConnectionChoice],
    /// Choices of `OutputData`; the first is taken where a declaration names none (decided). A choice without members
    /// makes no output tag.
    pub output_data: &'static [ConnectionChoice],
}

const fn safety(name: &'static str) -> ModuleMember {
    ModuleMember { name, element: Element::Bool, class: MemberClass::Safety }
}

const fn standard(name: &'static str) -> ModuleMember {
    ModuleMember { name, element: Element::Bool, class: MemberClass::Standard }
}

const fn connection(name: &'static str) -> ModuleMember {
    ModuleMember { name, element: Element::Bool, class: MemberClass::ConnectionStatus }
}

const fn analog(name: &'static str) -> ModuleMember {
    ModuleMember { name, element: Element::Int, class: MemberClass::Safety }
}

const RUN_MODE: ModuleMember = connection("RunMode");
const CONNECTION_FAULTED: ModuleMember = connection("ConnectionFaulted");

/// Eight safety inputs, four test outputs.
pub static IB8S: Module = Module {
    catalog_number: "1734-IB8S",
    name: "POINT Guard safety digital input",
    input: &[
        RUN_MODE,
        CONNECTION_FAULTED,
        safety("Pt00Data"),
        safety("Pt01Data"),
        safety("Pt02Data"),
        safety("Pt03Data"),
        safety("Pt04Data"),
        safety("Pt05Data"),
        safety("Pt06Data"),
        safety("Pt07Data"),
    ],
    input_status: &[
        ConnectionChoice {
            word: "COMBINED_STATUS_MUTING",
            members: &[
                safety("Muting01Status"),
                safety("Muting03Status"),
                standard("InputPowerStatus"),
                safety("CombinedInputStatus"),
            ],
        },
        ConnectionChoice { word: "NONE", members: &[] },
        ConnectionChoice {
            word: "PT_STATUS",
            members: &[
                safety("Pt00Status"),
                safety("Pt01Status"),
                safety("Pt02Status"),
                safety("Pt03Status"),
                safety("Pt04Status"),
                safety("Pt05Status"),
                safety("Pt06Status"),
                safety("Pt07Status"),
            ],
        },
        ConnectionChoice {
            word: "PT_STATUS_MUTING",
            members: &[
                safety("Pt00Status"),
                safety("Pt01Status"),
                safety("Pt02Status"),
                safety("Pt03Status"),
                safety("Pt04Status"),
                safety("Pt05Status"),
                safety("Pt06Status"),
                safety("Pt07Status"),
                safety("Muting01Status"),
                safety("Muting03Status"),
                standard("InputPowerStatus"),
            ],
        },
        ConnectionChoice {
            word: "PT_STATUS_MUTING_TEST_OUTPUT",
            members: &[
                safety("Pt00Status"),
                safety("Pt01Status"),
                safety("Pt02Status"),
                safety("Pt03Status"),
                safety("Pt04Status"),
                safety("Pt05Status"),
                safety("Pt06Status"),
                safety("Pt07Status"),
                standard("Pt00TestOutputStatus"),
                standard("Pt01TestOutputStatus"),
                standard("Pt02TestOutputStatus"),
                standard("Pt03TestOutputStatus"),
                safety("Muting01Status"),
                safety("Muting03Status"),
                standard("InputPowerStatus"),
            ],
        },
    ],
    output_data: &[
        ConnectionChoice { word: "NONE", members: &[] },
        ConnectionChoice {
            word: "TEST",
            members: &[standard("Test00Data"), standard("Test01Data"), standard("Test02Data"), standard("Test03Data")],
        },
    ],
};

/// Eight safety outputs.
pub static OB8S: Module = Module {
    catalog_number: "1734-OB8S",
    name: "POINT Guard safety digital output",
    input: &[RUN_MODE, CONNECTION_FAULTED],
    input_status: &[
        ConnectionChoice {
            word: "COMBINED_STATUS_READBACK_POWER",
            members: &[
                standard("Pt00Readback"),
                standard("Pt01Readback"),
                standard("Pt02Readback"),
                standard("Pt03Readback"),
                standard("Pt04Readback"),
                standard("Pt05Readback"),
                standard("Pt06Readback"),
                standard("Pt07Readback"),
                standard("OutputPowerStatus"),
                safety("CombinedOutputStatus"),
            ],
        },
        ConnectionChoice { word: "NONE", members: &[] },
        ConnectionChoice {
            word: "PT_STATUS",
            members: &[
                safety("Pt00OutputStatus"),
                safety("Pt01OutputStatus"),
                safety("Pt02OutputStatus"),
                safety("Pt03OutputStatus"),
                safety("Pt04OutputStatus"),
                safety("Pt05OutputStatus"),
                safety("Pt06OutputStatus"),
                safety("Pt07OutputStatus"),
            ],
        },
        ConnectionChoice {
            word: "PT_STATUS_READBACK",
            members: &[
                safety("Pt00OutputStatus"),
                safety("Pt01OutputStatus"),
                safety("Pt02OutputStatus"),
                safety("Pt03OutputStatus"),
                safety("Pt04OutputStatus"),
                safety("Pt05OutputStatus"),
                safety("Pt06OutputStatus"),
                safety("Pt07OutputStatus"),
                standard("Pt00Readback"),
                standard("Pt01Readback"),
                standard("Pt02Readback"),
                standard("Pt03Readback"),
                standard("Pt04Readback"),
                standard("Pt05Readback"),
                standard("Pt06Readback"),
                standard("Pt07Readback"),
            ],
        },
    ],
    output_data: &[
        ConnectionChoice {
            word: "SAFETY",
            members: &[
                safety("Pt00Data"),
                safety("Pt01Data"),
                safety("Pt02Data"),
                safety("Pt03Data"),
                safety("Pt04Data"),
                safety("Pt05Data"),
                safety("Pt06Data"),
                safety("Pt07Data"),
            ],
        },
        ConnectionChoice { word: "NONE", members: &[] },
    ],
};

/// Four safety analog inputs.
pub static IE4S: Module = Module {
    catalog_number: "1734-IE4S",
    name: "POINT Guard safety analog input",
    input: &[RUN_MODE, CONNECTION_FAULTED, analog("Ch0Data"), analog("Ch1Data"), analog("Ch2Data"), analog("Ch3Data")],
    input_status: &[
        ConnectionChoice {
            word: "PT_STATUS",
            members: &[
                safety("Ch0Status"),
                safety("Ch1Status"),
                safety("Ch2Status"),
                safety("Ch3Status"),
                standard("InputPowerStatus"),
            ],
        },
        ConnectionChoice { word: "NONE", members: &[] },
        ConnectionChoice {
            word: "COMBINED_STATUS_POWER",
            members: &[safety("CombinedInputStatus"), standard("InputPowerStatus")],
        },
    ],
    output_data: &[
        ConnectionChoice { word: "NONE", members: &[] },
        ConnectionChoice {
            word: "RESET_TACHOMETER",
            members: &[safety("Ch0ResetTach"), safety("Ch1ResetTach"), safety("Ch2ResetTach"), safety("Ch3ResetTach")],
        },
    ],
};

/// Every safety I/O module whose tags are known.
pub static ALL: &[&Module] = &[&IB8S, &OB8S, &IE4S];

/// Adapters and other modules that carry no safety data of their own and may stand in the tree.
pub static CARRIERS: &[&str] = &[
    "1734-AENT",
    "1734-AENTR",
    "1756-EN2T",
    "1756-EN2TR",
    "1756-EN3TR",
    "1756-ENBT",
    "1756-DNB",
    "1768-ENBT",
    "ETHERNET-MODULE",
];

/// A catalogue number without its series letter: `1734-IB8S` of `1734-IB8S/A`.
pub fn without_series(catalog_number: &str) -> &str {
    catalog_number.split_once('/').map_or(catalog_number, |(number, _)| number)
}

impl Module {
    /// Finds a module by catalogue number; case and a series letter (`1734-IB8S/A`) make no difference.
    pub fn by_catalog_number(catalog_number: &str) -> Option<&'static Module> {
        let number = without_series(catalog_number);
        ALL.iter().copied().find(|module| module.catalog_number.eq_ignore_ascii_case(number))
    }
}

/// The class of a member of a module's input tag: as the catalogue has it, and for a module or member that it does not
/// have by the name (decided): read-backs, power status and what belongs to test outputs are marked STANDARD in every
/// module manual, all other members carry safety data.
pub fn class_of_input(catalog_number: &str, member: &str) -> MemberClass {
    let known = Module::by_catalog_number(catalog_number).and_then(|module| {
        let chosen = module.input_status.iter().flat_map(|choice| choice.members);
        module.input.iter().chain(chosen).find(|one| one.name.eq_ignore_ascii_case(member))
    });
    if let Some(known) = known {
        return known.class;
    }
    let ends = |ending: &str| {
        let at = member.len().saturating_sub(ending.len());
        member.get(at..).is_some_and(|end| end.eq_ignore_ascii_case(ending))
    };
    let begins = |beginning: &str| member.get(..beginning.len()).is_some_and(|one| one.eq_ignore_ascii_case(beginning));
    if ["RunMode", "ConnectionFaulted"].iter().any(|name| member.eq_ignore_ascii_case(name)) {
        MemberClass::ConnectionStatus
    } else if begins("Test") || ["Readback", "PowerStatus", "TestOutputStatus"].iter().any(|ending| ends(ending)) {
        MemberClass::Standard
    } else {
        MemberClass::Safety
    }
}

/// Whether a member of a module's input tag says that data is valid, and not what a device says.
pub fn is_status(member: &str) -> bool {
    let at = member.len().saturating_sub("Status".len());
    member.get(at..).is_some_and(|end| end.eq_ignore_ascii_case("Status"))
}

/// Whether a member of a module's output tag switches a safety output; test outputs do not.
pub fn is_safety_output(catalog_number: &str, member: &str) -> bool {
    let known = Module::by_catalog_number(catalog_number).and_then(|module| {
        module.output_data.iter().flat_map(|choice| choice.members).find(|one| one.name.eq_ignore_ascii_case(member))
    });
    match known {
        Some(known) => known.class == MemberClass::Safety,
        None => !member.get(..4).is_some_and(|one| one.eq_ignore_ascii_case("Test")),
    }
}
