//! What can be set on the points and test outputs of safety I/O modules, with ranges and increments. Source: 1734-UM013
//! Tables 18 to 21; the words are ours (decided), made from the manual's.

/// What a setting takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SettingValue {
    /// One of these words.
    Word(&'static [&'static str]),
    /// A whole number, both ends included, a multiple of `step`.
    Number {
        /// Least value.
        least: i64,
        /// Greatest value.
        greatest: i64,
        /// The value is a multiple of this.
        step: i64,
        /// `ms`, `V`, or empty.
        unit: &'static str,
    },
}

/// A setting of a point.
#[derive(Debug, PartialEq, Eq)]
pub struct Setting {
    /// Its key in a POINT or TEST entry.
    pub key: &'static str,
    /// What it takes.
    pub value: SettingValue,
}

/// The points of one kind that a module has.
#[derive(Debug, PartialEq, Eq)]
pub struct Points {
    /// The letter that their names begin with: `I00`, `O00`, `C0`, `T0`.
    pub letter: char,
    /// How many there are.
    pub count: u32,
    /// Whether they are declared with TEST.
    pub test: bool,
    /// What can be set.
    pub settings: &'static [Setting],
}

const fn word(key: &'static str, words: &'static [&'static str]) -> Setting {
    Setting { key, value: SettingValue::Word(words) }
}

const fn number(key: &'static str, least: i64, greatest: i64, step: i64, unit: &'static str) -> Setting {
    Setting { key, value: SettingValue::Number { least, greatest, step, unit } }
}

const SIL: Setting = word("SIL", &["2", "3"]);
const LATCH_TIME: Setting = number("ErrorLatchTime", 0, 65_530, 10, "ms");
const DISCREPANCY_TIME: Setting = number("DiscrepancyTime", 0, 65_530, 10, "ms");

/// Safety digital inputs. Table 18.
pub static DIGITAL_INPUTS: Points = Points {
    letter: 'I',
    count: 8,
    test: false,
    settings: &[
        word("Mode", &["NOT_USED", "SAFETY_PULSE_TEST", "SAFETY", "STANDARD"]),
        word("TestSource", &["NONE", "T0", "T1", "T2", "T3"]),
        number("OffOn", 0, 126, 6, "ms"),
        number("OnOff", 0, 126, 6, "ms"),
        word("Type", &["SINGLE", "EQUIVALENT", "COMPLEMENTARY"]),
        DISCREPANCY_TIME,
        LATCH_TIME,
        SIL,
    ],
};

/// Test outputs. Table 19.
pub static TEST_OUTPUTS: Points = Points {
    letter: 'T',
    count: 4,
    test: true,
    settings: &[
        word("Mode", &["NOT_USED", "STANDARD", "PULSE_TEST", "POWER_SUPPLY", "MUTING_LAMP"]),
        word("FaultAction", &["CLEAR_OFF", "HOLD_LAST"]),
    ],
};

/// Safety digital outputs. Table 20.
pub static DIGITAL_OUTPUTS: Points = Points {
    letter: 'O',
    count: 8,
    test: false,
    settings: &[
        word("Mode", &["NOT_USED", "SAFETY", "SAFETY_PULSE_TEST"]),
        word("Channel", &["SINGLE", "DUAL"]),
        LATCH_TIME,
        SIL,
    ],
};

/// Safety analog inputs. Table 21.
pub static ANALOG_INPUTS: Points = Points {
    letter: 'C',
    count: 4,
    test: false,
    settings: &[
        word("Mode", &["NOT_USED", "SAFETY", "STANDARD"]),
        word("Range", &["V_10", "V_0_5", "V_0_10", "V_5", "MA_4_20", "MA_0_20", "TACHOMETER"]),
        word("Type", &["SINGLE", "EQUIVALENT"]),
        word("Filter", &["HZ_1", "HZ_5", "HZ_10", "HZ_50"]),
        LATCH_TIME,
        number("LowEngineering", -30_000, 30_000, 1, ""),
        number("HighEngineering", -30_000, 30_000, 1, ""),
        word("TachometerDualLow", &["OFF", "ON"]),
        word("TachometerTrigger", &["FALLING", "RISING"]),
        number("TachometerOff", 0, 23, 1, "V"),
        number("TachometerOn", 1, 24, 1, "V"),
        word("SensorPower", &["EXTERNAL", "MODULE"]),
        word("Alarms", &["DISABLE", "ENABLE"]),
        number("HighHighAlarm", -32_768, 32_767, 1, ""),
        number("LowLowAlarm", -32_768, 32_767, 1, ""),
        number("HighHighLowLowDeadband", 0, 32_767, 1, ""),
        number("HighAlarm", -32_768, 32_767, 1, ""),
        number("LowAlarm", -32_768, 32_767, 1, ""),
        number("HighLowDeadband", 0, 32_767, 1, ""),
        DISCREPANCY_TIME,
        number("DiscrepancyDeadband", 0, 32_767, 1, ""),
        number("ChannelOffset", -32_768, 32_767, 1, ""),
        SIL,
    ],
};

/// The points of a module, by its catalogue number without a series letter.
pub fn of_module(catalog_number: &str) -> &'static [&'static Points] {
    static IB8S: [&Points; 2] = [&DIGITAL_INPUTS, &TEST_OUTPUTS];
    static OB8S: [&Points; 1] = [&DIGITAL_OUTPUTS];
    static IE4S: [&Points; 1] = [&ANALOG_INPUTS];
    match catalog_number {
        "1734-IB8S" => &IB8S,
        "1734-OB8S" => &OB8S,
        "1734-IE4S" => &IE4S,
        _ => &[],
    }
}

/// Mode of a test output that a project does not set. 1734-UM013, Configure the Test Outputs.
pub fn test_output_mode(number: u32) -> &'static str {
    if number < 2 { "PULSE_TEST" } else { "NOT_USED" }
}

/// Test outputs that can watch a muting lamp. Table 19.
pub const MUTING_LAMPS: [u32; 2] = [1, 3];

/// Connections that an adapter of a POINT rack has. 1734-UM013.
pub const CONNECTIONS_OF_ADAPTER: u32 = 20;

/// Adapters for which that holds.
pub const ADAPTERS: [&str; 2] = ["1734-AENT", "1734-AENTR"];

/// Safety modules that 1756-RM093 names (Figure 11 ff., Appendices E and G) and whose tags are in no manual here: an export
/// shows them, or they stay invisible.
pub const GUARD_IO: [&str; 9] = [
    "1791DS-IB12",
    "1791DS-IB8XOB8",
    "1791DS-IB4XOX4",
    "1791DS-IB4XOW4",
    "1791DS-IB8XOBV4",
    "1791ES-IB8XOBV4",
    "1732DS-IB8XOBV4",
    "1732ES-IB12XOB4",
    "1732ES-IB8XOB8",
];

/// Input connections: requested packet interval in µs, both ends included. 1734-UM013, Configure Safety Connections.
pub const RPI_US: (u64, u64) = (6_000, 500_000);
/// Timeout multiplier, both ends included.
pub const TIMEOUT_MULTIPLIER: (u32, u32) = (1, 4);
/// Network delay multiplier in percent, both ends included.
pub const NETWORK_DELAY_MULTIPLIER: (u32, u32) = (10, 600);
/// Times of safety connections are counted in units of so many µs. neutral-text-and-l5x.md D.3, derived.
pub const TIME_UNIT_US: u64 = 128;
