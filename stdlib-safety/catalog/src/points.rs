//! What can be set on the points and test outputs of safety I/O modules, with ranges and increments, and the limits of
//! safety connections. Source: 1734-UM013 Tables 18 to 21; the words are ours (decided), made from the manual's.

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

const SOURCES_4: &[&str] = &["NONE", "T0", "T1", "T2", "T3"];
const SOURCES_8: &[&str] = &["NONE", "T0", "T1", "T2", "T3", "T4", "T5", "T6", "T7"];
const SOURCES_12: &[&str] = &["NONE", "T0", "T1", "T2", "T3", "T4", "T5", "T6", "T7", "T8", "T9", "T10", "T11"];

/// Table 18; 1791ES-UM001 Table 68 has the same.
const fn input_settings(sources: &'static [&'static str]) -> [Setting; 8] {
    [
        word("Mode", &["NOT_USED", "SAFETY_PULSE_TEST", "SAFETY", "STANDARD"]),
        word("TestSource", sources),
        number("OffOn", 0, 126, 6, "ms"),
        number("OnOff", 0, 126, 6, "ms"),
        word("Type", &["SINGLE", "EQUIVALENT", "COMPLEMENTARY"]),
        DISCREPANCY_TIME,
        LATCH_TIME,
        SIL,
    ]
}

static INPUT_SETTINGS_4: [Setting; 8] = input_settings(SOURCES_4);
static INPUT_SETTINGS_8: [Setting; 8] = input_settings(SOURCES_8);
static INPUT_SETTINGS_12: [Setting; 8] = input_settings(SOURCES_12);

/// Table 19; 1791ES-UM001 Table 69 has the same modes.
static TEST_SETTINGS: [Setting; 2] = [
    word("Mode", &["NOT_USED", "STANDARD", "PULSE_TEST", "POWER_SUPPLY", "MUTING_LAMP"]),
    word("FaultAction", &["CLEAR_OFF", "HOLD_LAST"]),
];

/// Table 20; 1791ES-UM001 Table 70 has the same.
static OUTPUT_SETTINGS: [Setting; 4] =
    [word("Mode", &["NOT_USED", "SAFETY", "SAFETY_PULSE_TEST"]), word("Channel", &["SINGLE", "DUAL"]), LATCH_TIME, SIL];

const fn inputs(count: u32, settings: &'static [Setting]) -> Points {
    Points { letter: 'I', count, test: false, settings }
}

const fn tests(count: u32) -> Points {
    Points { letter: 'T', count, test: true, settings: &TEST_SETTINGS }
}

const fn outputs(count: u32) -> Points {
    Points { letter: 'O', count, test: false, settings: &OUTPUT_SETTINGS }
}

/// Four safety inputs of a module with four test outputs.
pub static INPUTS_4_TESTS_4: Points = inputs(4, &INPUT_SETTINGS_4);
/// Eight safety inputs of a module with four test outputs.
pub static INPUTS_8_TESTS_4: Points = inputs(8, &INPUT_SETTINGS_4);
/// Twelve safety inputs of a module with four test outputs.
pub static INPUTS_12_TESTS_4: Points = inputs(12, &INPUT_SETTINGS_4);
/// Eight safety inputs of a module with eight test outputs.
pub static INPUTS_8_TESTS_8: Points = inputs(8, &INPUT_SETTINGS_8);
/// Twelve safety inputs of a module with twelve test outputs.
pub static INPUTS_12_TESTS_12: Points = inputs(12, &INPUT_SETTINGS_12);
/// Four test outputs.
pub static TESTS_4: Points = tests(4);
/// Eight test outputs.
pub static TESTS_8: Points = tests(8);
/// Twelve test outputs.
pub static TESTS_12: Points = tests(12);
/// Four safety outputs.
pub static OUTPUTS_4: Points = outputs(4);
/// Eight safety outputs.
pub static OUTPUTS_8: Points = outputs(8);

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

/// Connections that an adapter of a POINT rack has. 1734-UM013.
pub const CONNECTIONS_OF_ADAPTER: u32 = 20;

/// Adapters for which that holds.
pub const ADAPTERS: [&str; 2] = ["1734-AENT", "1734-AENTR"];

/// Input connections: requested packet interval in µs, both ends included. 1734-UM013, Configure Safety Connections.
pub const RPI_US: (u64, u64) = (6_000, 500_000);
/// Timeout multiplier, both ends included.
pub const TIMEOUT_MULTIPLIER: (u32, u32) = (1, 4);
/// Network delay multiplier in percent, both ends included.
pub const NETWORK_DELAY_MULTIPLIER: (u32, u32) = (10, 600);
/// Times of safety connections are counted in units of so many µs. neutral-text-and-l5x.md D.3, derived.
pub const TIME_UNIT_US: u64 = 128;
