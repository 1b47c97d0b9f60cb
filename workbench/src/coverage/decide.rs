//! Which conditions decided a rung: those whose other position alone, with every other condition as it was, would have changed
//! the power at an instruction that acts.

use super::shape::{Element, Node, Rung};

/// What was seen of an element in one evaluation of its rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Seen {
    /// Whether power reached it; nothing where it was not evaluated.
    pub reached: Option<bool>,
    /// Whether it lets power through, or would; nothing where that is not known.
    pub passes: Option<bool>,
}

/// What was found out about one evaluation of a rung.
#[derive(Debug, Default)]
pub struct Decided {
    /// Power at the end of the rung.
    pub end: Option<bool>,
    /// Conditions that decided, with their position.
    pub conditions: Vec<(u32, bool)>,
    /// Whether following the wires gave what was seen. Where it does not, nothing is concluded.
    pub consistent: bool,
}

/// Follows the wires of a rung.
pub fn decided(rung: &Rung, seen: &[Seen]) -> Decided {
    let input = seen.first().and_then(|first| first.reached);
    let states: Vec<Option<bool>> =
        rung.elements.iter().zip(seen).map(|(element, seen)| state(element, *seen)).collect();
    let (actual, end) = power(rung, &states, input);
    let consistent = actual
        .iter()
        .zip(seen)
        .all(|(followed, seen)| !matches!((followed, seen.reached), (Some(followed), Some(seen)) if *followed != seen));
    let mut found = Decided { end, conditions: Vec::new(), consistent };
    // Where the rung itself gets no power (a zone that is switched off) no condition matters.
    if !consistent || input != Some(true) {
        return found;
    }
    for (position, element) in rung.elements.iter().enumerate() {
        let (true, Some(passes)) = (element.is_condition(), states[position]) else { continue };
        let mut flipped = states.clone();
        flipped[position] = Some(!passes);
        if differs(rung, &(actual.as_slice(), end), &power(rung, &flipped, input)) {
            found.conditions.push((position as u32, passes));
        }
    }
    found
}

/// What an element does with the power that reaches it.
fn state(element: &Element, seen: Seen) -> Option<bool> {
    match element {
        Element::Condition(_) => seen.passes,
        // What acts passes power on, unless it was seen to end the rung.
        Element::Output(..) => Some(seen.passes.unwrap_or(true)),
        Element::AddOn(..) => seen.passes,
    }
}

/// Power at each element, and at the end of the rung.
fn power(rung: &Rung, states: &[Option<bool>], input: Option<bool>) -> (Vec<Option<bool>>, Option<bool>) {
    let mut reached = vec![None; states.len()];
    let end = series(&rung.series, states, input, &mut reached);
    (reached, end)
}

/// The depth of branches is limited by the verifier.
fn series(nodes: &[Node], states: &[Option<bool>], input: Option<bool>, reached: &mut [Option<bool>]) -> Option<bool> {
    nodes.iter().fold(input, |power, node| match node {
        Node::Element(position) => {
            let position = *position as usize;
            reached[position] = power;
            and(power, states[position])
        }
        Node::Branch(legs) => {
            let ends = legs.iter().map(|leg| series(leg, states, power, reached));
            ends.fold(Some(false), or)
        }
    })
}

fn and(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

fn or(a: Option<bool>, b: Option<bool>) -> Option<bool> {
    match (a, b) {
        (Some(true), _) | (_, Some(true)) => Some(true),
        (Some(false), Some(false)) => Some(false),
        _ => None,
    }
}

/// Whether power at an instruction that acts is for certain another; on a rung where nothing acts, power at its end.
fn differs(
    rung: &Rung,
    (before, before_end): &(&[Option<bool>], Option<bool>),
    after: &(Vec<Option<bool>>, Option<bool>),
) -> bool {
    let other = |a: Option<bool>, b: Option<bool>| matches!((a, b), (Some(a), Some(b)) if a != b);
    let acts = rung.elements.iter().any(|element| !element.is_condition());
    if !acts {
        return other(*before_end, after.1);
    }
    let elements = rung.elements.iter().zip(before.iter().zip(&after.0));
    elements.filter(|(element, _)| !element.is_condition()).any(|(_, (a, b))| other(*a, *b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coverage::Program;
    use crate::fuzz::Subject;

    /// The rung of a neutral text, with its conditions open or closed: power and pass of each element.
    fn rung(neutral: &str) -> Program {
        let text = format!(
            "CONTROLLER T (ProcessorType := \"1756-L73S\", Major := 20)\nTAG\nA, B, C, D, X, Y : BOOL (Class := Safety);\nEND_TAG\n\
             PROGRAM P (Class := Safety, MAIN := \"Main\")\nROUTINE Main\nN: {neutral}\nEND_ROUTINE\nEND_PROGRAM\n\
             TASK S (Type := PERIODIC, Class := Safety, Rate := 20, Watchdog := 10, Priority := 5)\nP;\nEND_TASK\nEND_CONTROLLER\n"
        );
        let subject = Subject::from_text(&text).unwrap();
        Program::new(&subject.image)
    }

    /// The positions of the conditions that decide, when the conditions pass as given.
    fn deciders(neutral: &str, passes: &[bool]) -> Vec<u32> {
        let program = rung(neutral);
        let (_, rung) = program.rungs().next().unwrap();
        let mut conditions = passes.iter();
        let states: Vec<Option<bool>> = rung
            .elements
            .iter()
            .map(|element| if element.is_condition() { conditions.next().copied() } else { Some(true) })
            .collect();
        let (reached, _) = power(rung, &states, Some(true));
        let seen: Vec<Seen> =
            reached.iter().zip(&states).map(|(reached, passes)| Seen { reached: *reached, passes: *passes }).collect();
        decided(rung, &seen).conditions.iter().map(|(position, _)| *position).collect()
    }

    /// REQ-TEST-012
    #[test]
    fn series_when_all_are_closed_then_each_decides_and_when_one_is_open_then_that_one_alone() {
        assert_eq!(deciders("XIC(A)XIO(B)OTE(X);", &[true, true]), [0, 1]);
        assert_eq!(deciders("XIC(A)XIO(B)OTE(X);", &[true, false]), [1]);
        assert_eq!(deciders("XIC(A)XIO(B)OTE(X);", &[false, false]), [] as [u32; 0]);
    }

    /// REQ-TEST-012
    #[test]
    fn branch_when_one_leg_is_closed_then_that_leg_decides_and_when_both_are_then_none() {
        assert_eq!(deciders("[XIC(A) ,XIC(B) ]OTE(X);", &[true, false]), [0]);
        assert_eq!(deciders("[XIC(A) ,XIC(B) ]OTE(X);", &[true, true]), [] as [u32; 0]);
        assert_eq!(deciders("[XIC(A) ,XIC(B) ]OTE(X);", &[false, false]), [0, 1]);
    }

    /// REQ-TEST-012
    #[test]
    fn contact_when_it_feeds_one_of_two_coils_then_it_decides_that_one() {
        assert_eq!(deciders("XIC(A)[XIC(B)OTE(X) ,OTE(Y) ];", &[true, false]), [0, 1]);
    }

    #[test]
    fn contact_when_the_position_of_another_is_not_known_then_nothing_is_concluded() {
        let program = rung("XIC(A)XIC(B)OTE(X);");
        let (_, rung) = program.rungs().next().unwrap();
        let seen = |reached, passes| Seen { reached: Some(reached), passes };
        let found = decided(rung, &[seen(true, Some(false)), seen(false, None), seen(false, Some(true))]);
        assert_eq!(found.conditions, []);
    }
}
