//! `bindings/fortran/kstrip.f90` from the text of `include/kstrip.h`.

use kstrip_testing::header::{Function, Structure, Variable, declared};

/// What is one object for all elements of a function that has an array of statuses.
const FOR_ALL: [&str; 6] = ["rail", "wheel", "set", "track", "table", "workspace"];

/// Pointers by these names, and those to bytes, are arrays; other pointers are one object.
const ARRAYS: &str = "x y z contacts distance points strips \
    text counts turned_y turned_z \
    coefficients weight shifts differences amplitudes conicities wave_lengths";

const HEAD: &str = "\
! kstrip from Fortran 2018: creep forces of rolling contact by Kalker's strip theory.
!
! Written from include/kstrip.h; do not edit:
! KSTRIP_WRITE_FORTRAN=1 cargo test --test builds fortran
!
! Names, units and signs are those of kstrip.h, which has more details. Every function returns a
! status: 0 is success, above 0 a warning, below 0 an error with outputs untouched;
! kstrip_message() returns the text of a status. Members of types are initially zero, and pointers
! null; zero selects the default of an option. Arguments that may be NULL in C are optional. An
! array that C stores by rows is stored by columns in Fortran: the derivative of force i with
! respect to creepage j is jacobian(j, i).
module kstrip
   use, intrinsic :: iso_c_binding
   implicit none
";

const TAIL: &str = "\
contains

   !> What a status means and what the caller must change, in English.
   function kstrip_message(status) result(text)
      integer(c_int32_t), intent(in) :: status
      character(len=:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: n
      call c_f_pointer(kstrip_status_string(status), letters, [1000])
      n = 0
      do while (letters(n + 1) /= c_null_char)
         n = n + 1
      end do
      allocate (character(len=n) :: text)
      text = transfer(letters(1:n), text)
   end function
end module
";

/// The first sentence of the comment that ends where `place` begins, without its stars.
fn sentence(header: &str, place: usize) -> String {
    let comment = comment(header, place);
    let words: Vec<&str> =
        comment.split_whitespace().take_while(|word| !word.starts_with('@')).collect();
    let text = words.join(" ");
    text.split_inclusive(". ").next().unwrap_or_default().trim().to_owned()
}

/// The comment that ends where `place` begins.
fn comment(header: &str, place: usize) -> String {
    let before = header[..place].trim_end();
    let Some(inside) = before.strip_suffix("*/") else { return String::new() };
    let start = inside.rfind("/**").map_or(0, |start| start + 3);
    inside[start..]
        .lines()
        .map(|line| line.trim_start().trim_start_matches('*'))
        .collect::<Vec<_>>()
        .join("\n")
}

/// Lines of a comment in Fortran, at most 132 characters.
fn remark(indent: &str, text: &str) -> String {
    let mut lines = vec![format!("{indent}!>")];
    for word in text.split_whitespace() {
        let last = lines.last_mut().expect("a line");
        if last.len() + word.len() > 120 {
            lines.push(format!("{indent}!> {word}"))
        } else {
            *last += &format!(" {word}")
        }
    }
    if text.is_empty() { String::new() } else { lines.join("\n") + "\n" }
}

/// The type of a number or structure, and its value when it is not set.
fn kind(name: &str) -> (String, &'static str) {
    match name {
        "double" => ("real(c_double)".to_owned(), " = 0"),
        "int32_t" | "uint32_t" | "kstrip_status" => ("integer(c_int32_t)".to_owned(), " = 0"),
        "uint8_t" => ("integer(c_int8_t)".to_owned(), ""),
        "char" => ("character(kind=c_char)".to_owned(), ""),
        "ptrdiff_t" => ("integer(c_intptr_t)".to_owned(), " = 0"),
        structure => (format!("type({structure})"), ""),
    }
}

fn structure(header: &str, found: &Structure) -> String {
    let place = header.find(&format!("typedef struct {} {{", found.name)).expect("it is there");
    let body = &header[place..place + header[place..].find("\n}").expect("it ends")];
    let mut text = remark("   ", &sentence(header, place));
    text += &format!("   type, bind(c) :: {}\n", found.name);
    for member in &found.members {
        if member.target().is_some() {
            let count =
                if member.elements > 1 { format!("({})", member.elements) } else { String::new() };
            text += &format!("      type(c_ptr) :: {}{count} = c_null_ptr\n", member.name);
            continue;
        }
        let (kind, zero) = kind(&member.kind);
        // [3][3], or [KSTRIP_NAME]
        let counts = body
            .split(&format!(" {}[", member.name))
            .nth(1)
            .and_then(|rest| rest.split("];").next());
        let counts = counts.map_or(String::new(), |counts| {
            // (the last index of C is the first of Fortran)
            let mut counts: Vec<&str> = counts.split("][").collect();
            counts.reverse();
            format!("({})", counts.join(", ").to_lowercase())
        });
        text += &format!("      {kind} :: {}{counts}{zero}\n", member.name);
    }
    text + "   end type\n\n"
}

fn function(header: &str, found: &Function) -> String {
    let place = header
        .find(&format!("{} {}(", found.kind, found.name))
        .or_else(|| header.find(&format!("{}{}(", found.kind, found.name)));
    let place = place.expect("it is there");
    let documentation = comment(header, place);
    // What @param says of it
    let may_be_null = |argument: &Variable| {
        let given = documentation.split("@return").next().unwrap_or_default();
        let of_it = given.split("@param").skip(1).find(|part| {
            let names = part.trim_start_matches("[out]").split("  ").next().unwrap_or_default();
            names.split([',', ' ']).any(|name| name == argument.name)
        });
        argument.kind.starts_with("const kstrip_options")
            || of_it.is_some_and(|text| text.contains("NULL"))
    };
    let names: Vec<&str> = found.arguments.iter().map(|argument| argument.name.as_str()).collect();
    let result =
        if found.kind.contains('*') { "type(c_ptr)".to_owned() } else { kind(&found.kind).0 };
    let mut text = remark("      ", &sentence(header, place));
    text += &format!("      {result} function {}({}) bind(c)\n", found.name, names.join(", "));
    text += "         import\n";
    for argument in &found.arguments {
        let name = &argument.name;
        text += &match argument.target() {
            None => format!("         {}, value :: {name}\n", kind(&argument.kind).0),
            Some((target, written)) => {
                let intent = if written { "inout" } else { "in" };
                let many = names.contains(&"statuses") && !FOR_ALL.contains(&name.as_str());
                let is_named = ARRAYS.split(' ').any(|own| own == name);
                let array = if many || is_named || target == "uint8_t" { "(*)" } else { "" };
                let optional = if may_be_null(argument) { ", optional" } else { "" };
                format!(
                    "         {}, intent({intent}){optional} :: {name}{array}\n",
                    kind(target).0
                )
            }
        };
    }
    text + "      end function\n\n"
}

pub fn module(header: &str) -> String {
    whole_module(header).lines().fold(String::new(), |text, line| text + &broken(line) + "\n")
}

/// A statement that is too long for Fortran's 132 columns goes on in the next lines.
fn broken(line: &str) -> String {
    match line.get(..100).and_then(|start| start.rfind(", ")) {
        Some(end) if line.len() > 130 && !line.trim_start().starts_with('!') => {
            let rest = broken(&format!("         {}", &line[end + 2..]));
            format!("{}, &\n{rest}", &line[..end])
        }
        _ => line.to_owned(),
    }
}

fn whole_module(header: &str) -> String {
    let declared = declared(header);
    let mut text = HEAD.to_owned() + "\n";
    for (name, value) in &declared.constants {
        let name = name.to_lowercase();
        // Fortran does not tell KSTRIP_ABI_VERSION from kstrip_abi_version().
        let taken = declared.functions.iter().any(|function| function.name == name);
        let suffix = if taken { "_expected" } else { "" };
        text += &format!("   integer(c_int32_t), parameter :: {name}{suffix} = {value}\n");
    }
    text += "\n";
    declared.structures.iter().for_each(|found| text += &structure(header, found));
    text += "   interface\n";
    declared.functions.iter().for_each(|found| text += &function(header, found));
    text.trim_end().to_owned() + "\n   end interface\n" + TAIL
}
