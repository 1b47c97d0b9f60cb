//! One state for each safety application instruction, behind one type.

use twinrung_catalog::Opcode;

macro_rules! states {
    ($($(#[$doc:meta])* $variant:ident in $($module:ident)::+;)*) => {
        /// The memory of one call of a safety application instruction, apart from its backing tag.
        ///
        /// Memory is private to this half of the library: compared between the channels are the members of the backing
        /// tag, never this.
        #[derive(Clone, Debug, PartialEq)]
        pub enum State {
            $($(#[$doc])* $variant(crate::$($module)::+::$variant),)*
        }

        impl State {
            /// The memory of a new call, as prescan leaves it; `None` where the instruction is not one of this library.
            pub fn new(opcode: Opcode) -> Option<State> {
                match opcode {
                    $(Opcode::$variant => Some(State::$variant(Default::default())),)*
                    _ => None,
                }
            }

            /// Prescan: forgets everything and writes the output members.
            ///
            /// `operands` are the values of the operands after the backing tag in the catalog's order, `members` the
            /// members of the backing tag in the catalog's order: BOOL as 0 or 1, REAL as its bits. The caller has
            /// mirrored the operands into the members, which are what is read here. A slice of another length than
            /// the backing type has cannot come from an admitted image; its every member is set to 0.
            pub fn prescan(&mut self, operands: &[i32], members: &mut [i32]) {
                let _mirrored = operands;
                match self {
                    $(State::$variant(state) => {
                        match <&mut crate::$($module)::+::Members>::try_from(&mut *members) {
                            Ok(members) => state.prescan(members),
                            Err(_) => members.fill(0),
                        }
                    })*
                }
            }

            /// One execution of the call with the rung condition `rung` at the scan's frozen time `now_ms`.
            ///
            /// Slices as for [`State::prescan`]. Only output members are written; `EnableIn` and `EnableOut` are the
            /// caller's.
            pub fn scan(&mut self, rung: bool, now_ms: i64, operands: &[i32], members: &mut [i32]) {
                let _mirrored = operands;
                match self {
                    $(State::$variant(state) => {
                        match <&mut crate::$($module)::+::Members>::try_from(&mut *members) {
                            Ok(members) => state.scan(rung, now_ms, members),
                            Err(_) => members.fill(0),
                        }
                    })*
                }
            }
        }

        #[cfg(feature = "injection")]
        impl State {
            /// How many bits this memory has: always the same for an instruction.
            pub fn bits(&self) -> u32 {
                match self {
                    $(State::$variant(state) => $crate::injection::Bits::count(state),)*
                }
            }

            /// One of its bits, counted from 0.
            pub fn bit(&self, bit: u32) -> bool {
                match self {
                    $(State::$variant(state) => $crate::injection::Bits::bit(state, bit),)*
                }
            }

            /// Turns a bit round; false, and nothing is changed, where the memory has no such value.
            pub fn flip(&mut self, bit: u32) -> bool {
                match self {
                    $(State::$variant(state) => $crate::injection::Bits::flip(state, bit),)*
                }
            }
        }
    };
}

states! {
    /// Dual Channel Input Stop.
    Dcs in dual_channel::dcs;
    /// Dual Channel Input Stop with Test.
    Dcst in dual_channel::dcst;
    /// Dual Channel Input Stop with Test and Lock.
    Dcstl in dual_channel::dcstl;
    /// Dual Channel Input Stop with Test and Mute.
    Dcstm in dual_channel::dcstm;
    /// Dual Channel Input Monitor.
    Dcm in dual_channel::dcm;
    /// Dual Channel Input Start.
    Dcsrt in dual_channel::dcsrt;
    /// Safety Mat.
    Smat in dual_channel::smat;
    /// Two-Hand Run Station Enhanced.
    Thrse in dual_channel::thrse;
    /// Two Sensor Asymmetrical Muting.
    Tsam in muting::tsam;
    /// Two Sensor Symmetrical Muting.
    Tssm in muting::tssm;
    /// Four Sensor Bi-directional Muting.
    Fsbm in muting::fsbm;
    /// Dual Channel Analog Input of DINT values.
    Dca in analog::dca;
    /// Dual Channel Analog Input of REAL values.
    Dcaf in analog::dcaf;
    /// Redundant Output.
    Rout in outputs::rout;
    /// Configurable Redundant Output.
    Crout in outputs::crout;
    /// Diverse Input.
    Din in version_14::din;
    /// Redundant Input.
    Rin in version_14::rin;
    /// Enable Pendant.
    Enpend in version_14::enpend;
    /// Emergency Stop.
    Estop in version_14::estop;
    /// Light Curtain.
    Lc in version_14::lc;
    /// Five Position Mode Selector.
    Fpms in version_14::fpms;
    /// Two-Hand Run Station.
    Thrs in version_14::thrs;
    /// Eight Position Mode Selector.
    Epms in metal_form::epms;
    /// Crankshaft Position Monitor.
    Cpm in metal_form::cpm;
    /// Camshaft Monitor.
    Csm in metal_form::csm;
    /// Auxiliary Valve Control.
    Avc in metal_form::avc;
    /// Main Valve Control.
    Mvc in metal_form::mvc;
    /// Maintenance Manual Valve Control.
    Mmvc in metal_form::mmvc;
    /// Clutch Brake Inch Mode.
    Cbim in metal_form::cbim;
    /// Clutch Brake Single Stroke Mode.
    Cbssm in metal_form::cbssm;
    /// Clutch Brake Continuous Mode.
    Cbcm in metal_form::cbcm;
}
