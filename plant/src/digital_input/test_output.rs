//! Test outputs of an input module. 1734-UM013, Configure the Test Outputs; Tables 13 and 19.

use super::lamp::MutingLamp;
use crate::error_latch::ErrorLatch;
use crate::settings::PointSettings;

/// What a test output is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TestMode {
    /// Nothing is connected.
    NotUsed,
    /// A standard output that the controller switches.
    Standard,
    /// A source of test pulses.
    PulseTest,
    /// 24 V all the time.
    PowerSupply,
    /// A lamp that the controller switches and the module tests.
    MutingLamp,
}

/// Why a test output shows an error: the codes of 1734-UM013 Table 13. `Configuration invalid` (1) cannot occur, since the
/// compiler refuses it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TestFault {
    /// No error.
    None = 0,
    /// It is on and touches 0 V.
    Overload = 2,
    /// Another output drives its wire.
    Cross = 3,
    /// 24 V stand at it while it is off.
    OutputOn = 5,
    /// The lamp takes too little current.
    Undercurrent = 6,
}

/// A test output.
#[derive(Debug, Clone)]
pub struct TestOutput {
    /// Which one.
    pub number: u8,
    /// What it is for.
    pub mode: TestMode,
    /// Whether the controller switches it on.
    pub commanded: bool,
    /// Whether it keeps its state when the controller is lost (Test Output Fault Action).
    pub holds_last: bool,
    /// The lamp at it.
    pub lamp: Option<MutingLamp>,
    latch: ErrorLatch,
    fault: TestFault,
    /// What the last pulse of its own found.
    pulse_fault: Option<TestFault>,
}

impl TestOutput {
    /// As configured. T0 and T1 pulse where the project does not set them, T2 and T3 are not used. (1734-UM013, Configure
    /// the Test Outputs; Table 19 says not used for all: the text is followed, since it names them)
    pub fn new(number: u8, settings: &PointSettings, latch_ms: u64) -> TestOutput {
        let pulses = u32::from(number)
            < twinrung_catalog::modules::Module::by_catalog_number("1734-IB8S")
                .map_or(0, |module| module.pulsing_tests);
        let mode = match settings.word("Mode").unwrap_or_default().to_ascii_uppercase().as_str() {
            "STANDARD" => TestMode::Standard,
            "PULSE_TEST" => TestMode::PulseTest,
            "POWER_SUPPLY" => TestMode::PowerSupply,
            "MUTING_LAMP" => TestMode::MutingLamp,
            "" if pulses => TestMode::PulseTest,
            _ => TestMode::NotUsed,
        };
        TestOutput {
            number,
            mode,
            commanded: false,
            holds_last: settings.has("FaultAction", "HOLD_LAST"),
            lamp: (mode == TestMode::MutingLamp).then(MutingLamp::new),
            latch: ErrorLatch::new(latch_ms),
            fault: TestFault::None,
            pulse_fault: None,
        }
    }

    /// As new.
    pub fn power_up(&mut self) {
        self.commanded = false;
        self.lamp = self.lamp.as_ref().map(|_| MutingLamp::new());
        self.latch.power_up();
        self.fault = TestFault::None;
        self.pulse_fault = None;
    }

    /// Whether it switches 24 V, its pulses aside.
    pub fn is_on(&self) -> bool {
        match self.mode {
            TestMode::NotUsed => false,
            TestMode::PulseTest | TestMode::PowerSupply => true,
            TestMode::Standard | TestMode::MutingLamp => self.commanded,
        }
    }

    /// Whether it pulses.
    pub fn pulses(&self) -> bool {
        self.mode == TestMode::PulseTest
    }

    /// What a pulse of its own found.
    pub fn judge_pulse(&mut self, now_ms: u64, found: Option<TestFault>) {
        self.pulse_fault = found;
        if found.is_some() {
            self.latch.seen(now_ms);
        }
    }

    /// Looks at its terminal: whether it touches 0 V, whether it touches 24 V.
    pub fn step(&mut self, now_ms: u64, field_power: bool, grounded: bool, supplied: bool) {
        let stuck = supplied && !grounded && !self.is_on() && self.mode != TestMode::NotUsed;
        let lamp_is_out = self.lamp.as_ref().is_some_and(|lamp| !lamp.status());
        if !field_power {
            // What a pulse found before says nothing about the next one.
            self.pulse_fault = None;
        }
        let found = match self.pulse_fault {
            _ if !field_power => None,
            _ if self.is_on() && grounded => Some(TestFault::Overload),
            _ if stuck => Some(TestFault::OutputOn),
            None if lamp_is_out => Some(TestFault::Undercurrent),
            other => other,
        };
        match found {
            Some(fault) => {
                self.fault = fault;
                self.latch.seen(now_ms);
            }
            None => {
                self.latch.gone(now_ms, true);
                if !self.latch.is_set() {
                    self.fault = TestFault::None;
                }
            }
        }
    }

    /// Its error.
    pub fn fault(&self) -> TestFault {
        self.fault
    }
}
