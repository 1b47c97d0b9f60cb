//! Calls of safety application instructions. REQ-EXEC-060, 061.

use twinrung_bytecode::channel::Channel;

use super::rig::Rig;

#[test]
fn safety_instruction_when_executed_then_mirrors_and_switches() {
    let mut rig = Rig::new(
        "stop DCI_STOP; cha chb status reset o BOOL",
        &["DCS(stop,E-STOP,EQUIVALENT - ACTIVE HIGH,500,AUTOMATIC,AUTOMATIC,cha,chb,status,reset)XIC(stop.O1)OTE(o)"],
    );
    rig.prescan();
    assert_eq!(rig.all("stop.DiscrepancyTime stop.EnableIn"), [500, 0]);
    for name in ["cha", "chb", "status"] {
        rig.set(name, 1);
    }
    for _ in 0..20 {
        rig.scan();
    }
    assert_eq!(rig.all("stop.ChannelA stop.ChannelB stop.EnableIn stop.EnableOut stop.O1 o"), [1; 6]);
    rig.set("chb", 0);
    rig.scan();
    assert_eq!(rig.all("stop.ChannelB stop.O1 o"), [0, 0, 0]);
}

/// REQ-EXEC-003, REQ-EXEC-060: the prescan keeps what the input members hold, a scan stores the operands.
#[test]
fn safety_instruction_when_an_operand_is_nan_then_its_member_is_canonical() {
    let mut rig = Rig::new(
        "level DCAF_INPUT; tolerance high low cha chb REAL; status reset BOOL",
        &["DCAF(level,AUTOMATIC,AUTOMATIC,500,tolerance,high,low,cha,chb,status,reset)"],
    );
    for (name, bits) in
        [("tolerance", 0x7F80_0001), ("high", 0x7FFF_FFFF), ("cha", 0xFFC0_0001_u32), ("chb", 0xFF80_0001)]
    {
        rig.set(name, bits as i32);
    }
    rig.set_real("low", -1.5);
    rig.prescan();
    assert_eq!(rig.all("level.Tolerance level.HighLimit level.LowLimit level.ChannelA level.ChannelB"), [0; 5]);
    rig.scan();
    assert_eq!(rig.all("level.Tolerance level.HighLimit level.ChannelA level.ChannelB"), [0x7FC0_0000; 4]);
    assert_eq!(rig.get_real("level.LowLimit"), -1.5);
    assert_eq!(rig.get("cha"), 0xFFC0_0001_u32 as i32);
}

/// REQ-EXEC-061: the first execution takes the configuration, as it is, where no prescan has done so.
#[test]
fn muting_when_no_prescan_has_reached_it_then_its_first_execution_takes_the_configuration() {
    let mut rig = Rig::new(
        "good bad MUTING_TWO_SENSOR_SYM; curtain sensor1 sensor2 yes no BOOL",
        &[
            "TSSM(good,AUTOMATIC,500,0,50,3,12,curtain,sensor1,sensor2,yes,no,yes,yes,no)",
            "TSSM(bad,AUTOMATIC,500,60,50,3,12,curtain,sensor1,sensor2,yes,no,yes,yes,no)",
        ],
    );
    let start = |rig: &mut Rig| {
        for name in ["curtain", "sensor1", "sensor2", "yes"] {
            rig.set(name, 1);
        }
        rig.scan();
        rig.all("good.FP good.FaultCode bad.FP bad.FaultCode")
    };
    assert_eq!(start(&mut rig), [0, 0, 1, 0xF06F]);
    rig.silent.reset();
    rig.observed.reset();
    assert_eq!(start(&mut rig), [0, 0, 1, 0xF06F]);
}
