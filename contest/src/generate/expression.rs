//! Expressions of CPT, CMP, FAL and FSC, parenthesised wherever a relation is near.

use super::literals;
use super::writer::Writer;

impl Writer<'_> {
    /// An arithmetic expression.
    pub fn expression(&mut self, depth: usize) -> String {
        if depth == 0 || self.random.percent(25) {
            return self.atom();
        }
        match self.random.below(10) {
            0 => {
                let inner = self.expression(depth - 1);
                // A sign before a bit pattern is refused.
                if inner.starts_with(|first: char| first.is_ascii_digit()) { inner } else { format!("-({inner})") }
            }
            1 => format!("NOT ({})", self.expression(depth - 1)),
            2 => format!("ABS({})", self.expression(depth - 1)),
            3 => format!("SQR({})", self.expression(depth - 1)),
            4..=6 => {
                let mut text = self.atom();
                for _ in 0..self.random.between(1, 3) {
                    let operator = self.operator();
                    text = format!("{text} {operator} {}", self.atom());
                }
                text
            }
            _ => {
                let (left, right) = (self.expression(depth - 1), self.expression(depth - 1));
                let operator = self.operator();
                format!("({left}) {operator} ({right})")
            }
        }
    }

    /// An expression that is used as a truth value.
    pub fn condition(&mut self, depth: usize) -> String {
        match self.random.below(8) {
            0 => self.expression(depth),
            1 if depth > 0 => format!("NOT ({})", self.condition(depth - 1)),
            2..=3 if depth > 0 => {
                let (left, right) = (self.condition(depth - 1), self.condition(depth - 1));
                let operator = *self.random.of(&["AND", "OR", "XOR", "+"]);
                format!("({left}) {operator} ({right})")
            }
            _ => {
                let (left, right) = (self.expression(depth.min(1)), self.expression(depth.min(1)));
                let relation = *self.random.of(&["=", "<>", "<", "<=", ">", ">="]);
                format!("({left}) {relation} ({right})")
            }
        }
    }

    fn operator(&mut self) -> &'static str {
        const OPERATORS: &[&str] = &["+", "-", "*", "/", "MOD", "AND", "OR", "XOR", "+", "-"];
        self.random.of::<&'static str>(OPERATORS)
    }

    fn atom(&mut self) -> String {
        if self.random.percent(25) {
            let text = if self.random.percent(15) {
                literals::real_text(self.random)
            } else {
                literals::integer_text(self.random)
            };
            return if text.starts_with('-') { format!("({text})") } else { text };
        }
        match self.place(|place| place.kind.is_number() && !place.is_array()) {
            Some(named) => named.text,
            None => literals::integer_text(self.random),
        }
    }
}
