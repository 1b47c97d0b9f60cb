//! The way out where a finding has no better one of its own.

/// What to do about a finding of this code.
pub(super) fn remedy(id: &str) -> Option<&'static str> {
    Some(match id {
        "E0101" => "name a file that exists and is UTF-8 text",
        "E0102" => "export the project again as L5X",
        "E0103" => "compare the declaration with one of the samples",
        "E0104" => "write a series of instructions and branches, closed by `;`",
        "E0105" => "write a tag, a number or a word, as the instruction takes it",
        "E0106" => "put parentheses around the relation",
        "E0107" => "write a number, a list in brackets or a text in quotes",
        "E0108" => "split what is too large",
        "E0201" => "declare it, or correct the name",
        "E0202" => "correct the name of the member",
        "E0203" => "declare the type, or correct its name",
        "E0204" | "E0208" | "E0209" => "correct the name, or declare it",
        "E0205" => "begin the rung that is meant with LBL",
        "E0206" => "rename one of the two",
        "E0207" => "choose a name of letters, digits and single underscores",
        "E0210" => "name data with constant subscripts, and no alias that leads back here",
        "E0301" => "give the instruction the operands that it has",
        "E0302" => "use data of the type that is expected, or another instruction",
        "E0303" => "enter a tag or a value where it is missing",
        "E0304" => "write one of the words of the list",
        "E0305" => "write a value within the range",
        "E0306" => "write a number within the array or word; elements and bits count from 0",
        "E0307" => "change the declaration of the type",
        "E0308" => "export the project again",
        "E0309" => "write a value that the type can hold",
        "E0401" => "complete the file with --controller CATALOG/REVISION",
        "E0402" => "name a GuardLogix controller and a revision that it has",
        "E0403" => "complete the file with --period MS and --watchdog MS",
        "E0406" => "delete the rung, or write NOP()",
        "E0407" => "export it without source protection",
        "E0408" => "write it in another way",
        "E0409" => "change the declaration of the Add-On Instruction",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::codes::HERE;

    #[test]
    fn remedy_when_asked_for_each_code_of_reading_and_resolving_then_given() {
        let ids = HERE.iter().map(|code| code.id).filter(|id| ("E0101".."E05").contains(id));
        let without: Vec<&str> = ids.filter(|id| remedy(id).is_none()).collect();
        // A suppression always says itself how to mend it; that more findings are not listed is no finding of its own.
        assert_eq!(without, ["E0411", "E0109"]);
    }
}
