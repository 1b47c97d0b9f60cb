//! Table 9 of 1756-RM093 and what a connection does in time. REQ-PLANT-001, REQ-PLANT-002

use twinrung_plant::{Connection, Received, Sent, Times};

/// RPI and limit of the manual's example, µs; a packet takes 1 ms.
const TIMES: Times = Times { rpi_us: 10_000, limit_us: 40_064, delay_us: 1_000, first_us: 0 };

/// What packets at 0, 10, 20 ms ... carry.
fn sent(packets: &[Sent]) -> Connection {
    let mut connection = Connection::new(TIMES);
    for packet in packets {
        let now_us = connection.next_us();
        connection.pass(now_us, || packet.clone());
    }
    connection
}

fn sent_twice() -> Connection {
    sent(&[Sent::Run(vec![7]), Sent::Run(vec![8])])
}

/// What is sent; the two bits, and what a value is. Row by row. The fourth row of the table, both bits on, is an invalid state:
/// [`Received`] has no such value. REQ-PLANT-001
#[test]
fn connection_when_its_producer_runs_idles_or_is_lost_then_status_and_data_are_those_of_the_table() {
    let rows =
        [(Sent::Run(vec![7]), (true, false), 7), (Sent::Idle, (false, false), 0), (Sent::Nothing, (false, true), 0)];
    for (packet, bits, value) in rows {
        let mut connection = sent(&[packet]);
        let received = connection.at(1_000);
        assert_eq!((received.run_mode(), received.connection_faulted()), bits, "{received:?}");
        assert_eq!(received.value(0), value, "{received:?}");
    }
}

/// REQ-PLANT-002
#[test]
fn connection_when_nothing_has_arrived_yet_then_it_is_faulted() {
    assert_eq!(Connection::new(TIMES).at(0), Received::Faulted);
    assert_eq!(sent_twice().at(999), Received::Faulted);
}

/// REQ-PLANT-002
#[test]
fn connection_when_packets_arrive_then_the_newest_counts() {
    let mut connection = sent_twice();
    assert_eq!(connection.at(1_000), Received::Run(&[7]));
    assert_eq!(connection.at(11_000), Received::Run(&[8]));
}

/// 1756-RM093 Appendix C: without a valid packet within the limit the connection times out. REQ-PLANT-002
#[test]
fn connection_when_the_newest_packet_is_older_than_the_limit_then_it_is_faulted() {
    let mut connection = sent_twice();
    assert_eq!(connection.at(50_064), Received::Run(&[8]));
    assert_eq!(connection.at(50_065), Received::Faulted);
}

/// REQ-PLANT-002
#[test]
fn connection_when_the_network_loses_packets_then_it_is_faulted_and_comes_back_with_the_next_one() {
    let mut connection = sent_twice();
    connection.carry(false);
    (20_000..=60_000).step_by(10_000).for_each(|now_us| connection.pass(now_us, || Sent::Run(vec![9])));
    assert_eq!(connection.at(60_000), Received::Faulted);
    connection.carry(true);
    connection.pass(70_000, || Sent::Run(vec![10]));
    assert_eq!(connection.at(71_000), Received::Run(&[10]));
}

/// REQ-PLANT-002
#[test]
fn connection_when_packets_take_longer_than_the_limit_then_their_data_is_never_used() {
    let mut connection = Connection::new(Times { delay_us: 40_065, ..TIMES });
    (0..90_000).step_by(10_000).for_each(|now_us| connection.pass(now_us, || Sent::Run(vec![7])));
    assert_eq!(connection.at(200_000), Received::Faulted);
}

/// REQ-PLANT-002
#[test]
fn connection_when_the_producer_is_idle_or_silent_then_the_consumer_is_idle_or_faulted() {
    let mut connection = sent(&[Sent::Run(vec![7]), Sent::Run(vec![8]), Sent::Idle, Sent::Nothing, Sent::Nothing]);
    assert_eq!(connection.at(21_000), Received::Idle);
    assert_eq!(connection.at(60_064), Received::Idle);
    assert_eq!(connection.at(60_065), Received::Faulted);
}

/// Packets keep their grid, however often somebody looks. REQ-PLANT-002
#[test]
fn connection_when_data_changes_between_packets_then_the_consumer_sees_it_with_the_next() {
    let mut connection = Connection::new(Times { rpi_us: 10_500, delay_us: 0, first_us: 500, ..TIMES });
    let seen: Vec<i32> = (0..25)
        .map(|ms: i32| {
            let now_us = u64::from(ms.unsigned_abs()) * 1000;
            connection.pass(now_us, || Sent::Run(vec![ms]));
            connection.at(now_us).value(0)
        })
        .collect();
    // Packets are due at 0.5, 11, 21.5 ms.
    assert_eq!((seen[1], seen[10], seen[11], seen[21], seen[22]), (1, 1, 11, 11, 22));
}
