//! Members of a module's tags, by the names that the catalogue gives them, as something that a module can read or be told.

/// Something that a module reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// `RunMode`.
    RunMode,
    /// `ConnectionFaulted`.
    ConnectionFaulted,
    /// `Pt00Data`, `Ch0Data`.
    Data(u8),
    /// `Pt00Status`, `Pt00InputStatus`, `Pt00OutputStatus`, `Ch0InputStatus`.
    Status(u8),
    /// `CombinedInputStatus`, `CombinedOutputStatus`.
    CombinedStatus,
    /// `InputPowerStatus`, `OutputPowerStatus`.
    Power,
    /// `Muting01Status`.
    Muting(u8),
    /// `Pt00TestOutputStatus`.
    TestStatus(u8),
    /// `Pt00Readback`.
    Readback(u8),
    /// `Ch0CombinedAlarmStatus`.
    CombinedAlarm(u8),
    /// `Ch0FaultReason`.
    FaultReason(u8),
    /// `Ch0HHAlarmStatus`.
    HighHigh(u8),
    /// `Ch0LLAlarmStatus`.
    LowLow(u8),
    /// `Ch0HAlarmStatus`.
    High(u8),
    /// `Ch0LAlarmStatus`.
    Low(u8),
    /// `Ch0TachOverfrequency`.
    Overfrequency(u8),
    /// `Ch0TachUnderfrequency`.
    Underfrequency(u8),
    /// `Ch0TachDualLow`.
    DualLow(u8),
}

/// Something that a module is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Command {
    /// `Pt00Data`: a safety output.
    Output(u8),
    /// `Test01Data`: a test output.
    Test(u8),
    /// `Ch0ResetTach`.
    ResetTachometer(u8),
}

const PLAIN: &[(&str, Reading)] = &[
    ("RunMode", Reading::RunMode),
    ("ConnectionFaulted", Reading::ConnectionFaulted),
    ("CombinedInputStatus", Reading::CombinedStatus),
    ("CombinedOutputStatus", Reading::CombinedStatus),
    ("InputPowerStatus", Reading::Power),
    ("OutputPowerStatus", Reading::Power),
];

/// What stands before and behind the number.
type Numbered<T> = (&'static str, &'static str, fn(u8) -> T);

const NUMBERED: &[Numbered<Reading>] = &[
    ("Pt", "Data", Reading::Data),
    ("Pt", "Status", Reading::Status),
    ("Pt", "InputStatus", Reading::Status),
    ("Pt", "OutputStatus", Reading::Status),
    ("Pt", "TestOutputStatus", Reading::TestStatus),
    ("Pt", "Readback", Reading::Readback),
    ("Muting", "Status", Reading::Muting),
    ("Ch", "Data", Reading::Data),
    ("Ch", "InputStatus", Reading::Status),
    ("Ch", "CombinedAlarmStatus", Reading::CombinedAlarm),
    ("Ch", "FaultReason", Reading::FaultReason),
    ("Ch", "HHAlarmStatus", Reading::HighHigh),
    ("Ch", "LLAlarmStatus", Reading::LowLow),
    ("Ch", "HAlarmStatus", Reading::High),
    ("Ch", "LAlarmStatus", Reading::Low),
    ("Ch", "TachOverfrequency", Reading::Overfrequency),
    ("Ch", "TachUnderfrequency", Reading::Underfrequency),
    ("Ch", "TachDualLow", Reading::DualLow),
];

const COMMANDS: &[Numbered<Command>] =
    &[("Pt", "Data", Command::Output), ("Test", "Data", Command::Test), ("Ch", "ResetTach", Command::ResetTachometer)];

fn numbered<T>(table: &[Numbered<T>], member: &str) -> Option<T> {
    let first = member.find(|character: char| character.is_ascii_digit())?;
    let (before, rest) = member.split_at(first);
    let end = rest.find(|character: char| !character.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, behind) = rest.split_at(end);
    let (.., make) =
        table.iter().find(|(one, other, _)| one.eq_ignore_ascii_case(before) && other.eq_ignore_ascii_case(behind))?;
    Some(make(digits.parse().ok()?))
}

impl Reading {
    /// The reading behind a member of an input tag.
    pub fn of(member: &str) -> Option<Reading> {
        let plain = PLAIN.iter().find(|(name, _)| name.eq_ignore_ascii_case(member));
        plain.map(|(_, reading)| *reading).or_else(|| numbered(NUMBERED, member))
    }
}

impl Command {
    /// The command behind a member of an output tag.
    pub fn of(member: &str) -> Option<Command> {
        numbered(COMMANDS, member)
    }
}

#[cfg(test)]
mod tests {
    use twinrung_catalog::modules::Module;

    use super::*;

    const MODELLED: [&str; 3] = ["1734-IB8S", "1734-OB8S", "1734-IE4S"];

    #[test]
    fn members_when_the_catalogue_gives_them_to_a_modelled_module_then_each_is_a_reading_or_a_command() {
        let modules: Vec<&Module> = MODELLED.iter().filter_map(|number| Module::by_catalog_number(number)).collect();
        assert_eq!(modules.len(), MODELLED.len());
        let unknown: Vec<&str> = modules
            .iter()
            .flat_map(|module| {
                let chosen = module.input_status.iter().flat_map(|choice| choice.each_member());
                let read = module.each_input().chain(chosen).filter(|one| Reading::of(one.name).is_none());
                let told = module.output_data.iter().flat_map(|choice| choice.each_member());
                read.chain(told.filter(|one| Command::of(one.name).is_none()))
            })
            .map(|member| member.name)
            .collect();
        assert_eq!(unknown, [] as [&str; 0]);
    }

    #[test]
    fn members_when_two_begin_alike_then_each_has_its_own_reading() {
        assert_eq!(Reading::of("Pt03TestOutputStatus"), Some(Reading::TestStatus(3)));
        assert_eq!(Reading::of("Ch2HAlarmStatus"), Some(Reading::High(2)));
        assert_eq!(Reading::of("Ch2HHAlarmStatus"), Some(Reading::HighHigh(2)));
        assert_eq!(Command::of("Test01Data"), Some(Command::Test(1)));
    }
}
