//! A deliberately wrong instruction in one channel is caught by the comparison in the scan in which it shows, and outputs
//! are off in that scan.

use twinrung_bytecode::image::Image;
use twinrung_bytecode::index::BitCell;
use twinrung_catalog::Opcode;
use twinrung_controller::{Controller, Difference, SafetyFault, StopReason};
use twinrung_primary::Primary;
use twinrung_trio::Subject;
use twinrung_workbench::{Signal, names};

use crate::wrong_partner::{Defect, WrongPartner};

/// SUB is executed wherever the image says ADD.
struct SubForAdd;

impl Defect for SubForAdd {
    fn change(records: &mut Image) {
        for routine in &mut records.routines {
            let add = routine.code.windows(2).position(|pair| pair == [Opcode::Add as u8, 3]);
            routine.code[add.expect("the program adds")] = Opcode::Sub as u8;
            routine.text = routine.text.replace("ADD(", "SUB(");
        }
    }
}

const PROGRAM: &str = r#"
CONTROLLER Wrong (ProcessorType := "1756-L73S", Major := 20)
  TAG
    Go, Out : BOOL (Class := Safety);
    Count : DINT (Class := Safety);
  END_TAG
  PROGRAM Main (Class := Safety, MAIN := "Main")
    ROUTINE Main
      N: XIC(Go)ADD(Count,1,Count);
      N: OTE(Out);
    END_ROUTINE
  END_PROGRAM
  TASK Safety (Type := PERIODIC, Class := Safety, Rate := 10, Watchdog := 10, Priority := 5)
    Main;
  END_TASK
END_CONTROLLER
"#;

#[test]
fn comparison_when_one_channel_has_a_wrong_instruction_then_outputs_are_off_in_the_scan_in_which_it_shows() {
    let subject = Subject::from_text(PROGRAM).unwrap();
    let signal = |name| names::signal(&subject.image, name).unwrap();
    let (Signal::Bit(go), Signal::Bit(out), Signal::Word(count, _)) = (signal("Go"), signal("Out"), signal("Count"))
    else {
        panic!("two BOOLs and a number")
    };
    let mut controller: Controller<Primary, WrongPartner<SubForAdd>> =
        Controller::load(subject.image.clone(), &subject.bytes).unwrap();
    for cell in [go, out] {
        controller.publish_also(range_of_bit(cell));
    }
    controller.freeze_also(range_of_bit(go));
    controller.power_up_in_run();
    assert_eq!(controller.scan(0).stopped, None, "the wrong instruction has not shown yet");
    assert_eq!(controller.published_bit(out), Some(true));
    controller.drive_bit(go, true);
    let report = controller.scan(10);
    let difference = Difference::Word(count, 1, -1);
    assert_eq!(report.stopped, Some(StopReason::Safety(SafetyFault::Difference(difference))));
    assert_eq!(controller.published_bit(out), Some(false), "off in that same scan");
}

fn range_of_bit(cell: BitCell) -> twinrung_bytecode::CellRange {
    let tag = twinrung_bytecode::index::TagIndex(0);
    twinrung_bytecode::CellRange { tag, bit_cell: cell.0, bit_cells: 1, word_cell: 0, word_cells: 0 }
}
