//! Safety outputs that a module drives one by one. 1756-RM093 Appendix G; 1791ES-UM001, Configure the Module Outputs.

use twinrung_catalog::modules::{self, OutputOperation};

use crate::diagnostic::{Finding, Findings};
use crate::project::Project;

rule! {
    /// An output set to single on a module that reaches SIL 2 in pairs only.
    "S0415", Error, "an output is set to single on a module that needs pairs",
    "The outputs of these Guard I/O modules are approved for SIL 2 as dual channel only: 1791DS-IB8XOB8 and 1791DS-IB4XOW4; the modules with bipolar outputs (OBV) have no other operation. One output alone is approved on the 1734-OB8S, 1732ES-IB12XOB4 and 1732ES-IB8XOB8. Set both outputs of the pair to Channel := DUAL and write both, or take another module.",
    "1756-RM093 Appendix G, SIL 2 Outputs Using SIL 3 Guard I/O Output Modules; 1791ES-UM001, Configure the Module Outputs",
    good: sample!(modules "  MODULE Block (CatalogNumber := \"1732ES-IB8XOB8\", Parent := \"Local\", IPAddress := \"192.168.1.11\", SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT O00 (Mode := SAFETY, Channel := SINGLE);\n    POINT O01 (Mode := SAFETY, Channel := SINGLE);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Block:I.Pt00Data)OTE(Run);\n"),
    bad: sample!(modules "  MODULE Block (CatalogNumber := \"1791ES-IB8XOBV4\", Parent := \"Local\", IPAddress := \"192.168.1.11\", SafetyNetwork := 16#0000_0000_0001_0002)\n    POINT O00 (Mode := SAFETY, Channel := <<SINGLE>>);\n    POINT O01 (Mode := SAFETY, Channel := <<SINGLE>>);\n  END_MODULE\n"; "    Run : BOOL (Class := Safety);\n", "      N: XIC(Block:I.Pt00Data)OTE(Run);\n")
}

/// Every point of every module that needs pairs.
pub(crate) fn check(project: &Project, findings: &mut Findings) {
    for module in &project.modules {
        let Some(known) = modules::Module::by_catalog_number(&module.catalog_number) else { continue };
        let why = match known.output_operation {
            OutputOperation::SingleOrDual => continue,
            OutputOperation::PairsForSafety => "is approved for SIL 2 with its outputs in pairs only",
            OutputOperation::PairsOnly => "drives its outputs in pairs only",
        };
        for point in &module.points {
            let setting = point.setting("Channel").filter(|one| one.value.eq_ignore_ascii_case("SINGLE"));
            let unused = point.setting("Mode").is_some_and(|mode| mode.value.eq_ignore_ascii_case("NOT_USED"));
            let Some(setting) = setting.filter(|_| !unused) else { continue };
            let message = format!("{} is single, and the {} {why}", point.name, known.catalog_number);
            let finding = Finding::new(&CODE, setting.value_span, message);
            findings.push(finding.help("set both outputs of the pair to Channel := DUAL, and write both"));
        }
    }
}
