//! Text without fonts: estimated widths, wrapped lines, superscripts.

/// Estimated width of `text` in px at the font size `size` (px), for the widest common sans-serif fonts.
pub(super) fn width(text: &str, size: f64) -> f64 {
    size * text.chars().map(em).sum::<f64>()
}

/// Width of a bold text over that of a regular one.
pub(super) const BOLD: f64 = 1.12;

fn em(c: char) -> f64 {
    match c {
        'i' | 'j' | 'l' | '\'' | '|' | 'I' => 0.32,
        't' | 'f' | 'r' | ' ' | '.' | ',' | ':' | ';' | '!' | '/' | '-' => 0.41,
        '(' | ')' | '[' | ']' | '²' | '³' | '¹' | '⁰'..='⁻' => 0.42,
        'm' | 'w' | 'M' | 'W' | '%' | '@' => 0.98,
        '−' | '+' | '=' | '×' | '<' | '>' | '~' | '…' => 0.86,
        'A'..='Z' => 0.76,
        '\u{300}'..='\u{36f}' => 0.0,
        '\0'..='\u{24f}' => 0.64,
        '\u{250}'..='\u{10ff}' | '\u{2000}'..='\u{206f}' => 0.7,
        _ => 1.0,
    }
}

/// Lines of at most `room` px; a word longer than a line is broken.
pub(super) fn wrap(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace().flat_map(|w| pieces(w, size, room)) {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(&word, size) + em(' ') * size <= room => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

fn pieces(word: &str, size: f64, room: f64) -> Vec<String> {
    let (mut done, mut now, mut used) = (Vec::new(), String::new(), 0.0);
    for c in word.chars() {
        let step = em(c) * size;
        if used + step > room && !now.is_empty() {
            done.push(std::mem::take(&mut now));
            used = 0.0;
        }
        now.push(c);
        used += step;
    }
    done.push(now);
    done
}

/// Text and font size that fit into `room` px: shrunk to 0.7 of `size` at most, then cut with an ellipsis.
pub(super) fn fit(text: &str, size: f64, room: f64) -> (String, f64) {
    let wide = width(text, size);
    if wide <= room {
        return (text.to_owned(), size);
    }
    let small = (size * room / wide).max(0.7 * size).floor();
    if width(text, small) <= room {
        return (text.to_owned(), small);
    }
    let head = wrap(text, small, room - small).into_iter().next();
    (head.unwrap_or_default() + "…", small)
}

/// Characters that XML forbids become U+FFFD, other control characters a blank.
pub(super) fn clean(text: &str) -> String {
    let legal = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        c if c.is_control() || c == '\u{fffe}' || c == '\u{ffff}' => '\u{fffd}',
        c => c,
    };
    text.chars().map(legal).collect()
}

/// Integer in superscript digits: −6 gives `⁻⁶`.
pub(super) fn superscript(n: i32) -> String {
    n.to_string().chars().map(raised).collect()
}

/// Raised form of a digit or minus sign.
pub(super) fn raised(c: char) -> char {
    match c {
        '-' | '−' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

/// Power of ten as `10⁻⁶`.
pub(super) fn power(n: i32) -> String {
    format!("10{}", superscript(n))
}

/// Decimal number with a true minus sign.
pub(super) fn decimal(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.chars().any(|c| c.is_ascii_digit() && c != '0') => {
            format!("−{digits}")
        }
        Some(digits) => digits.to_owned(),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minus_zero_has_no_sign() {
        assert_eq!(decimal(-0.001, 1), "0.0");
        assert_eq!(decimal(-2.5, 1), "−2.5");
    }

    #[test]
    fn a_line_is_never_wider_than_its_room() {
        let lines = wrap("steel ball on a verylongwordwithoutanyblank x", 11.0, 60.0);
        assert!(lines.len() > 3);
        assert!(lines.iter().all(|l| width(l, 11.0) <= 60.0), "{lines:?}");
    }

    #[test]
    fn the_micro_sign_counts_one_character() {
        assert_eq!(width("µm", 10.0).to_bits(), width("nm", 10.0).to_bits());
    }

    #[test]
    fn powers_are_raised() {
        assert_eq!(power(-12), "10⁻¹²");
    }

    #[test]
    fn what_xml_forbids_is_replaced() {
        assert_eq!(clean("a\u{0}b\nc"), "a\u{fffd}b c");
    }
}
