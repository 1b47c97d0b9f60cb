//! What TSAM, TSSM and FSBM share around the core: their members and the memory of a call.

/// The members that the three instructions have, with `read_inputs`, `read_configuration` and `write` for them, and
/// the memory of a call.
macro_rules! muting_instruction {
    (
        $(#[$doc:meta])* $name:ident, $sequence:ty, $backing:path;
        inputs { $($input:ident = $input_name:literal),* $(,)? }
    ) => {
        crate::members::members! {
            $backing;
            inputs {
                RESTART_TYPE = "RestartType",
                MAXIMUM_MUTE_TIME = "MaximumMuteTime",
                MAXIMUM_OVERRIDE_TIME = "MaximumOverrideTime",
                LIGHT_CURTAIN = "LightCurtain",
                SENSOR_1 = "Sensor1",
                SENSOR_2 = "Sensor2",
                ENABLE_MUTE = "EnableMute",
                OVERRIDE = "Override",
                INPUT_STATUS = "InputStatus",
                MUTING_LAMP_STATUS = "MutingLampStatus",
                RESET = "Reset",
                $($input = $input_name,)*
            }
            outputs {
                O1 = "O1",
                ML = "ML",
                CA = "CA",
                FP = "FP",
                FAULT_CODE = "FaultCode",
                DIAGNOSTIC_CODE = "DiagnosticCode",
            }
        }

        $(#[$doc])*
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct $name {
            muting: $crate::muting::common::Muting<$sequence>,
        }

        $crate::bits!($name { muting });

        impl $name {
            pub(crate) fn prescan(&mut self, members: &mut Members) {
                let times = read_times(members);
                let usable = times.usable();
                let configuration = $crate::muting::common::Configuration {
                    restart_automatic: members[RESTART_TYPE] != 0,
                    mute_s: members[MAXIMUM_MUTE_TIME],
                    override_s: members[MAXIMUM_OVERRIDE_TIME],
                    times,
                };
                self.muting.prescan(configuration, usable);
                clear_outputs(members);
            }

            pub(crate) fn scan(&mut self, rung: bool, now_ms: i64, members: &mut Members) {
                if !rung {
                    self.muting.rung_false();
                    clear_outputs(members);
                    return;
                }
                let inputs = $crate::muting::common::Inputs {
                    enable_mute: members[ENABLE_MUTE] != 0,
                    override_request: members[OVERRIDE] != 0,
                    input_status: members[INPUT_STATUS] != 0,
                    lamp_good: members[MUTING_LAMP_STATUS] != 0,
                    reset: members[RESET] != 0,
                };
                let outputs = self.muting.scan(&inputs, &read_field(members), now_ms);
                members[O1] = i32::from(outputs.o1);
                members[ML] = i32::from(outputs.muting_lamp);
                members[CA] = i32::from(outputs.clear_area);
                members[FP] = i32::from(outputs.fault != $crate::codes::NONE);
                members[FAULT_CODE] = outputs.fault;
                members[DIAGNOSTIC_CODE] = outputs.diagnostic;
            }
        }
    };
}

pub(crate) use muting_instruction;
