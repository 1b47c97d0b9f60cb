//! A generated program as `.rll` and as L5X.

use std::fmt::Write as _;

use super::{Coil, INPUTS, Number, Operand, Part, Program, Rung};

impl Program {
    /// The project as `.rll`.
    pub fn rll(&self) -> String {
        let mut out =
            format!("CONTROLLER Bench_{} (ProcessorType := \"1756-L73S\", Major := 20)\n  TAG\n", self.rungs.len());
        for (name, type_name) in self.tags() {
            let _ = writeln!(out, "    {name} : {type_name} (Class := Safety);");
        }
        out.push_str("  END_TAG\n  PROGRAM Bench (Class := Safety, MAIN := \"Main\")\n    ROUTINE Main\n");
        for (index, rung) in self.rungs.iter().enumerate() {
            out.push_str("      N: ");
            rung.write(index, &mut out);
            out.push('\n');
        }
        out.push_str(
            "    END_ROUTINE\n  END_PROGRAM\n  TASK SafetyTask (Type := PERIODIC, Class := Safety, Rate := 10, \
             Priority := 5, Watchdog := 10)\n    Bench;\n  END_TASK\nEND_CONTROLLER\n",
        );
        out
    }

    /// The project as L5X, with the data of each tag in both forms that exports have.
    pub fn l5x(&self) -> String {
        let name = format!("Bench_{}", self.rungs.len());
        let mut out = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
             <RSLogix5000Content SchemaRevision=\"1.0\" SoftwareRevision=\"20.01\" TargetName=\"{name}\" TargetType=\"Controller\" \
             ContainsContext=\"false\" ExportOptions=\"NoRawData L5KData DecoratedData AllProjDocTrans\">\n\
             <Controller Use=\"Target\" Name=\"{name}\" ProcessorType=\"1756-L73S\" MajorRev=\"20\" MinorRev=\"11\">\n\
             <SafetyInfo SafetyLocked=\"false\" SignatureRunModeProtect=\"false\" ConfigureSafetyIOAlways=\"false\"/>\n\
             <DataTypes/>\n<Modules/>\n<AddOnInstructionDefinitions/>\n<Tags>\n"
        );
        let mut presets = self.rungs.iter().filter_map(|rung| rung.timer).map(|(_, preset)| preset);
        for (name, type_name) in self.tags() {
            let preset = if type_name == "TIMER" { presets.next() } else { None };
            tag(&mut out, &name, type_name, preset);
        }
        out.push_str(
            "</Tags>\n<Programs>\n<Program Name=\"Bench\" TestEdits=\"false\" MainRoutineName=\"Main\" Disabled=\"false\" \
             Class=\"Safety\">\n<Tags/>\n<Routines>\n<Routine Name=\"Main\" Type=\"RLL\">\n<RLLContent>\n",
        );
        for (index, rung) in self.rungs.iter().enumerate() {
            let _ = write!(out, "<Rung Number=\"{index}\" Type=\"N\">\n<Text>\n<![CDATA[");
            rung.write(index, &mut out);
            out.push_str("]]>\n</Text>\n</Rung>\n");
        }
        out.push_str(
            "</RLLContent>\n</Routine>\n</Routines>\n</Program>\n</Programs>\n<Tasks>\n\
             <Task Name=\"SafetyTask\" Type=\"PERIODIC\" Rate=\"10\" Priority=\"5\" Watchdog=\"10\" DisableUpdateOutputs=\"false\" \
             InhibitTask=\"false\" Class=\"Safety\">\n<ScheduledPrograms>\n<ScheduledProgram Name=\"Bench\"/>\n\
             </ScheduledPrograms>\n</Task>\n</Tasks>\n</Controller>\n</RSLogix5000Content>\n",
        );
        out
    }

    fn tags(&self) -> impl Iterator<Item = (String, &'static str)> {
        let rungs = self.rungs.len();
        let named = |letter: &'static str, count: usize, type_name: &'static str| {
            (0..count).map(move |index| (format!("{letter}{index}"), type_name))
        };
        named("x", INPUTS, "BOOL").chain(named("y", rungs, "BOOL")).chain(named("n", rungs / 5, "DINT")).chain(named(
            "t",
            rungs / 10,
            "TIMER",
        ))
    }
}

fn tag(out: &mut String, name: &str, type_name: &str, preset: Option<u32>) {
    let _ = match preset {
        Some(preset) => writeln!(
            out,
            "<Tag Name=\"{name}\" Class=\"Safety\" TagType=\"Base\" DataType=\"{type_name}\" Constant=\"false\" \
             ExternalAccess=\"Read/Write\"><Data Format=\"L5K\"><![CDATA[[0,{preset},0]]]></Data><Data Format=\"Decorated\">\
             <Structure DataType=\"TIMER\"><DataValueMember Name=\"PRE\" DataType=\"DINT\" Radix=\"Decimal\" Value=\"{preset}\"/>\
             <DataValueMember Name=\"ACC\" DataType=\"DINT\" Radix=\"Decimal\" Value=\"0\"/>\
             <DataValueMember Name=\"EN\" DataType=\"BOOL\" Value=\"0\"/><DataValueMember Name=\"TT\" DataType=\"BOOL\" Value=\"0\"/>\
             <DataValueMember Name=\"DN\" DataType=\"BOOL\" Value=\"0\"/></Structure></Data></Tag>"
        ),
        None => writeln!(
            out,
            "<Tag Name=\"{name}\" Class=\"Safety\" TagType=\"Base\" DataType=\"{type_name}\" Radix=\"Decimal\" Constant=\"false\" \
             ExternalAccess=\"Read/Write\"><Data Format=\"L5K\"><![CDATA[0]]></Data><Data Format=\"Decorated\">\
             <DataValue DataType=\"{type_name}\" Radix=\"Decimal\" Value=\"0\"/></Data></Tag>"
        ),
    };
}

impl Rung {
    fn write(&self, index: usize, out: &mut String) {
        network(&self.network, "", out);
        if let Some(number) = self.comparison {
            let _ = write!(out, "GRT(n{number},7)");
        }
        let coil = match self.coil {
            Coil::Energize => "OTE",
            Coil::Latch => "OTL",
            Coil::Unlatch => "OTU",
        };
        let alone = self.timer.is_none() && self.number.is_none();
        let _ = write!(out, "{}{coil}(y{index})", if alone { "" } else { "[" });
        if let Some((timer, preset)) = self.timer {
            let _ = write!(out, " ,TON(t{timer},{preset},0)");
        }
        let _ = match self.number {
            Some(Number::Count(number)) => write!(out, " ,ADD(n{number},1,n{number})"),
            Some(Number::Copy { from, to }) => write!(out, " ,MOV(n{from},n{to})"),
            None => Ok(()),
        };
        out.push_str(if alone { ";" } else { " ];" });
    }
}

fn network(parts: &[Part], gap: &str, out: &mut String) {
    for (index, part) in parts.iter().enumerate() {
        if index > 0 {
            out.push_str(gap);
        }
        match part {
            Part::Contact { closed, operand } => {
                let kind = if *closed { 'O' } else { 'C' };
                let _ = match operand {
                    Operand::Input(input) => write!(out, "XI{kind}(x{input})"),
                    Operand::Coil(coil) => write!(out, "XI{kind}(y{coil})"),
                    Operand::Done(timer) => write!(out, "XI{kind}(t{timer}.DN)"),
                };
            }
            Part::Branch(legs) => {
                out.push('[');
                for (index, leg) in legs.iter().enumerate() {
                    if index > 0 {
                        out.push_str(" ,");
                    }
                    network(leg, " ", out);
                }
                out.push_str(" ]");
            }
        }
    }
}
