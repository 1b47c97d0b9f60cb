//! The rules, one file each: the entry of the code table with its samples, the check, and the test that both samples
//! behave as the entry says.

/// A complete project for a sample: what stands in its TAG block and in its routine.
macro_rules! sample {
    (on $processor:literal, $revision:literal; $tags:literal, $rungs:literal) => {
        concat!(
            "CONTROLLER Sample (ProcessorType := \"", $processor, "\", Major := ", $revision, ")\n",
            "  TAG\n", $tags, "  END_TAG\n",
            "  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n", $rungs,
            "    END_ROUTINE\n  END_PROGRAM\n",
            "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n",
            "    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
        )
    };
    ($tags:literal, $rungs:literal) => { sample!(on "1756-L73S", "20"; $tags, $rungs) };
    (io; $tags:literal, $rungs:literal) => {
        sample!(modules
            "  MODULE Rack (CatalogNumber := \"1734-AENT\", Parent := \"Local\", IPAddress := \"192.168.1.10\") END_MODULE\n  MODULE Field_In (CatalogNumber := \"1734-IB8S\", Parent := \"Rack\", Slot := 1, SafetyNetwork := 16#0000_0000_0001_0002, RPI := 10) END_MODULE\n  MODULE Field_Out (CatalogNumber := \"1734-OB8S\", Parent := \"Rack\", Slot := 2, SafetyNetwork := 16#0000_0000_0001_0002) END_MODULE\n";
            $tags, $rungs)
    };
    (modules $modules:literal; $tags:literal, $rungs:literal) => {
        concat!(
            "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20, SafetyNetwork := 16#0000_0000_0001_0001)\n",
            $modules, "  TAG\n", $tags, "  END_TAG\n",
            "  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n", $rungs,
            "    END_ROUTINE\n  END_PROGRAM\n",
            "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n",
            "    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
        )
    };
}

/// A complete project with a safety Add-On Instruction: what stands among its attributes, or at its end.
macro_rules! instruction {
    (attributes $attributes:literal) => { instruction!($attributes; "") };
    (history $history:literal) => { instruction!(""; $history) };
    ($attributes:literal; $history:literal) => {
        concat!(
            "CONTROLLER Sample (ProcessorType := \"1756-L73S\", Major := 20)\n",
            "  ADD_ON_INSTRUCTION_DEFINITION Copy_Bit (Class := Safety", $attributes, ")\n    PARAMETERS\n",
            "      From : BOOL (Usage := Input, Required := Yes);\n",
            "      To : BOOL (Usage := Output, Required := Yes);\n    END_PARAMETERS\n",
            "    ROUTINE Logic\n      RC: \"To follows From.\";\n      N: XIC(From)OTE(To);\n    END_ROUTINE\n", $history,
            "  END_ADD_ON_INSTRUCTION_DEFINITION\n",
            "  TAG\n    Copy : Copy_Bit (Class := Safety);\n    Run, Go : BOOL (Class := Safety);\n  END_TAG\n",
            "  PROGRAM Safety_Main (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n      N: Copy_Bit(Copy,Go,Run);\n",
            "    END_ROUTINE\n  END_PROGRAM\n",
            "  TASK Safety_Task (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 20, Priority := 5)\n",
            "    Safety_Main;\n  END_TASK\nEND_CONTROLLER\n"
        )
    };
}

/// Declares the entry of a rule in the code table.
macro_rules! rule {
    ($(#[$doc:meta])* $id:literal, $severity:ident, $title:literal, $explanation:literal, $citation:literal, good: $good:expr, bad: $bad:expr) => {
        $(#[$doc])*
        pub static CODE: crate::diagnostic::Code = crate::diagnostic::Code {
            id: $id,
            severity: crate::diagnostic::Severity::$severity,
            title: $title,
            explanation: $explanation,
            citation: $citation,
            good: $good,
            bad: $bad,
        };

        #[cfg(test)]
        mod tests {
            #[test]
            fn rule_when_broken_then_fires_at_the_marked_place_only_and_when_kept_then_not() {
                crate::rules::testing::holds(&super::CODE);
            }
        }
    };
}

macro_rules! rules {
    ($($module:ident),* $(,)?) => {
        $(pub mod $module;)*

        /// The entries of all rules.
        pub static CODES: &[&crate::diagnostic::Code] = &[$(&$module::CODE,)*];
    };
}

pub mod usage;

#[cfg(test)]
mod testing;

rules! {
    adapter_connections,
    admission,
    alias_across_classes,
    automatic_restart,
    backing_once,
    backing_operand,
    backing_written,
    backward_jump,
    condition_before_box,
    connected_tag,
    connection_time,
    copy_length_constant,
    copy_size,
    deep_branches,
    enable_in,
    expression_operator,
    forces,
    input_written,
    instruction_signature,
    integer_division,
    limit_off,
    maker_signature,
    masked_discrepancy,
    master_control,
    mixed_compare,
    module_setting,
    muting_lamp,
    network_number,
    no_output,
    not_scheduled,
    one_safety_task,
    operand_pair,
    output_not_written,
    output_operation,
    parameter_in_use,
    parameter_sequence,
    pending_edits,
    period,
    point_pair,
    point_setting,
    position,
    preset,
    producer_network,
    program_routines,
    reaction_time_limit,
    real,
    recursion,
    reset_of_tof,
    routine_language,
    safety_type,
    schedule,
    shared_network,
    shared_storage,
    short_discrepancy,
    short_pattern,
    signature_history,
    sil_2_data,
    standard_tag,
    standard_write,
    status_constant,
    status_not_watched,
    subroutine,
    system_attribute,
    tag_map,
    test_source,
    two_coils,
    two_hand_timing,
    uncertified,
    unguarded_divisor,
    unique_node,
    unknown_module,
    unqualified_operand,
    unqualified_output,
    watchdog,
    written_tag,
}

use twinrung_grammar::tree::File;

use crate::diagnostic::Findings;
use crate::project::Project;

/// Applies every rule that looks at the project as a whole.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for rule in ALL {
        rule(project, findings);
    }
}

/// Applies every rule that looks at what the files say beside what is compiled of them.
pub(crate) fn check_files(files: &[&File], project: &Project, findings: &mut Findings) {
    instruction_signature::check(files, project, findings);
    maker_signature::check(files, findings);
    signature_history::check(files, findings);
}

/// Rules over whole projects; findings are ordered by place afterwards.
static ALL: &[fn(&Project, &mut Findings)] = &[
    admission::check,
    pending_edits::check,
    preset::check,
    real::check,
    one_safety_task::check,
    period::check,
    watchdog::check,
    schedule::check,
    program_routines::check,
    forces::check,
    connected_tag::check,
    standard_write::check,
    written_tag::check,
    copy_size::check,
    operand_pair::check,
    recursion::check,
    backing_once::check,
    backing_operand::check,
    backing_written::check,
    enable_in::check,
    position::check,
    subroutine::check,
    master_control::check,
    reset_of_tof::check,
    two_coils::check,
    no_output::check,
    shared_storage::check,
    output_not_written::check,
    status_not_watched::check,
    deep_branches::check,
    unguarded_divisor::check,
    condition_before_box::check,
    automatic_restart::check,
    limit_off::check,
    status_constant::check,
    short_discrepancy::check,
    two_hand_timing::check,
    not_scheduled::check,
    input_written::check,
    short_pattern::check,
    mixed_compare::check,
    integer_division::check,
    backward_jump::check,
    point_setting::check,
    output_operation::check,
    test_source::check,
    muting_lamp::check,
    point_pair::check,
    masked_discrepancy::check,
    unknown_module::check,
    network_number::check,
    unique_node::check,
    connection_time::check,
    reaction_time_limit::check,
    adapter_connections::check,
    producer_network::check,
    shared_network::check,
    crate::flow::check,
];
