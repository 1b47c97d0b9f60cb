//! Values in the cells of a table.

use twinrung_contest::Value;

/// Reads a cell as a value of the same type as `like`.
///
/// Integers are decimal or, with `16#`, `8#` or `2#`, a pattern of 32 bits; REAL is decimal, `NaN` (16#7FC0_0000), `inf`, `-inf` or
/// a pattern of 32 bits.
///
/// # Errors
///
/// What is wrong with the text.
pub fn read(text: &str, like: Value) -> Result<Value, String> {
    let pattern = pattern(text)?;
    match like {
        Value::Bool(_) => match text {
            "0" => Ok(Value::Bool(false)),
            "1" => Ok(Value::Bool(true)),
            _ => Err(format!("`{text}` is no BOOL")),
        },
        Value::Integer(_) => match pattern {
            Some(bits) => Ok(Value::Integer(bits as i32)),
            None => text.parse().map(Value::Integer).map_err(|_| format!("`{text}` is no integer")),
        },
        Value::Real(_) => match (pattern, text) {
            (Some(bits), _) => Ok(Value::Real(f32::from_bits(bits))),
            (None, "NaN") => Ok(Value::Real(f32::from_bits(0x7FC0_0000))),
            (None, text) => text.parse().map(Value::Real).map_err(|_| format!("`{text}` is no REAL")),
        },
    }
}

fn pattern(text: &str) -> Result<Option<u32>, String> {
    let Some((base, digits)) = text.split_once('#') else { return Ok(None) };
    let base = base.parse::<u32>().ok().filter(|base| matches!(base, 2 | 8 | 16));
    let base = base.ok_or_else(|| format!("`{text}` has none of the bases 2, 8, 16"))?;
    let digits = digits.replace('_', "");
    u32::from_str_radix(&digits, base).map(Some).map_err(|_| format!("`{text}` is no pattern of 32 bits"))
}

/// Whether two values are the same, bit for bit.
pub fn same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Real(a), Value::Real(b)) => a.to_bits() == b.to_bits(),
        (a, b) => a == b,
    }
}

/// The value for a message.
pub fn shown(value: Value) -> String {
    match value {
        Value::Real(real) => format!("{real:?} (16#{:08x})", real.to_bits()),
        Value::Integer(integer) => format!("{integer} (16#{integer:08x})"),
        Value::Bool(_) => value.to_string(),
    }
}
