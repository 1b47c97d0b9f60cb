//! The list of the `.rll` files, one place for the crate and its build script.

/// One `.rll` file, under the name of the instruction or part that it defines.
macro_rules! source {
    ($name:literal, $file:literal) => {
        ($name, include_str!(concat!("../rll/", $file, ".rll")))
    };
}

/// The Add-On Instructions in source form: the mnemonic of the instruction, or the name of the shared part, and the text
/// that defines it. Parts stand before the instructions that call them.
pub static SOURCES: &[(&str, &str)] = &[
    source!("Pair_Evaluator", "pair_evaluator"),
    source!("Channel_Fault_Latch", "channel_fault_latch"),
    source!("Stop_Core", "stop_core"),
    source!("Muting_Core", "muting_core"),
    source!("Analog_Core", "analog_core"),
    source!("Redundant_Input_Core", "redundant_input_core"),
    source!("Valve_Feedback", "valve_feedback"),
    source!("Stroke_Permissives", "stroke_permissives"),
    source!("DCS", "dcs"),
    source!("DCST", "dcst"),
    source!("DCSTL", "dcstl"),
    source!("DCSTM", "dcstm"),
    source!("DCM", "dcm"),
    source!("DCSRT", "dcsrt"),
    source!("SMAT", "smat"),
    source!("THRSe", "thrse"),
    source!("CROUT", "crout"),
    source!("ROUT", "rout"),
    source!("DCA", "dca"),
    source!("DCAF", "dcaf"),
    source!("TSAM", "tsam"),
    source!("TSSM", "tssm"),
    source!("FSBM", "fsbm"),
    source!("DIN", "din"),
    source!("RIN", "rin"),
    source!("ENPEND", "enpend"),
    source!("ESTOP", "estop"),
    source!("LC", "lc"),
    source!("FPMS", "fpms"),
    source!("THRS", "thrs"),
    source!("EPMS", "epms"),
    source!("CPM", "cpm"),
    source!("CSM", "csm"),
    source!("AVC", "avc"),
    source!("MVC", "mvc"),
    source!("MMVC", "mmvc"),
    source!("CBIM", "cbim"),
    source!("CBSSM", "cbssm"),
    source!("CBCM", "cbcm"),
];
