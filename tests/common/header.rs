//! What the text of `include/kstrip.h` declares: structures, functions, constants.

use std::collections::BTreeMap;

/// A structure and its members, in order.
pub struct Structure {
    pub name: String,
    pub members: Vec<Variable>,
}

/// A member of a structure, or an argument of a function: `const double *x`.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Without `struct`, with `const` and `*` if it is a pointer.
    pub kind: String,
    pub name: String,
    /// Elements of an array member, else 1.
    pub elements: usize,
}

/// `kind name(arguments)`
pub struct Function {
    pub kind: String,
    pub name: String,
    pub arguments: Vec<Variable>,
}

/// Everything that the header declares, in its order.
pub struct Declared {
    pub constants: Vec<(String, i64)>,
    pub structures: Vec<Structure>,
    pub functions: Vec<Function>,
}

impl Variable {
    /// From `const struct kstrip_contact *contact`, `double values[4]` or
    /// `double values[KSTRIP_NAME]`.
    fn parse(text: &str, constants: &[(String, i64)]) -> Self {
        let text = text.replace("struct ", "");
        let start = text.rfind(|c: char| c == '*' || c.is_whitespace()).map_or(0, |i| i + 1);
        let (kind, name) = text.split_at(start);
        let (name, elements) = match name.split_once('[') {
            Some((name, counts)) => {
                let elements = counts.trim_end_matches(']').split("][").map(|count| {
                    let known = constants.iter().find(|(name, _)| name == count);
                    let number = known.map(|(_, value)| value.to_string());
                    let number: usize =
                        number.as_deref().unwrap_or(count).parse().expect("a number of elements");
                    number
                });
                (name, elements.product())
            }
            None => (name, 1),
        };
        Self { kind: kind.trim().to_owned(), name: name.to_owned(), elements }
    }

    /// What a pointer points to, and whether it may be written.
    pub fn target(&self) -> Option<(&str, bool)> {
        let target = self.kind.strip_suffix('*')?.trim();
        Some(match target.strip_prefix("const ") {
            Some(target) => (target.trim(), false),
            None => (target, true),
        })
    }
}

impl Function {
    /// As one line of C.
    pub fn declaration(&self) -> String {
        let arguments: Vec<String> =
            self.arguments.iter().map(|a| format!("{} {}", a.kind, a.name)).collect();
        let arguments = if arguments.is_empty() { "void".to_owned() } else { arguments.join(", ") };
        format!("{} {}({arguments})", self.kind, self.name).replace("* ", "*")
    }
}

/// Take a header apart. Its only syntax is what cbindgen writes for this library.
pub fn declared(header: &str) -> Declared {
    let mut found = Declared { constants: vec![], structures: vec![], functions: vec![] };
    let code = without_comments(header);
    let mut lines = code.lines().map(str::trim).filter(|line| !line.is_empty());
    while let Some(line) = lines.next() {
        if let Some(definition) = line.strip_prefix("#define ") {
            if let Some((name, value)) = definition.split_once(' ') {
                let value = value.trim().parse().expect("constants are integers");
                found.constants.push((name.to_owned(), value));
            }
        } else if let Some(rest) = line.strip_prefix("typedef struct ") {
            let name = rest.split_whitespace().next().expect("a name").to_owned();
            let members = lines
                .by_ref()
                .take_while(|line| !line.starts_with('}'))
                .map(|line| line.strip_suffix(';').expect("one member a line"))
                .map(|line| Variable::parse(line, &found.constants))
                .collect();
            found.structures.push(Structure { name, members });
        } else if line.contains("kstrip_") && line.contains('(') {
            let mut text = line.to_owned();
            while !text.ends_with(';') {
                text.push(' ');
                text.push_str(lines.next().expect("a function ends"));
            }
            let (head, arguments) = text.split_once('(').expect("an argument list");
            let head = Variable::parse(head, &[]);
            let arguments = arguments.trim_end_matches(';').trim_end_matches(')');
            let arguments = arguments.split(',').map(str::trim).filter(|a| *a != "void");
            found.functions.push(Function {
                kind: head.kind,
                name: head.name,
                arguments: arguments.map(|argument| Variable::parse(argument, &[])).collect(),
            });
        }
    }
    found
}

fn without_comments(text: &str) -> String {
    let mut code = String::new();
    let mut rest = text;
    while let Some((before, comment)) = rest.split_once("/*") {
        code.push_str(before);
        rest = comment.split_once("*/").expect("comments end").1;
    }
    code + rest
}

/// Size and alignment of a structure, and the offset of each member, by the rule of every C
/// compiler for machines that align each number to its size.
pub struct Layout {
    pub size: usize,
    pub alignment: usize,
    pub offsets: Vec<usize>,
}

impl Declared {
    /// The layout of every structure by name.
    pub fn layouts(&self) -> BTreeMap<&str, Layout> {
        let mut known: BTreeMap<&str, Layout> = BTreeMap::new();
        for structure in &self.structures {
            let mut layout = Layout { size: 0, alignment: 1, offsets: vec![] };
            for member in &structure.members {
                let (size, alignment) = match member.kind.as_str() {
                    "double" => (8, 8),
                    "float" | "int32_t" | "uint32_t" | "kstrip_status" => (4, 4),
                    "ptrdiff_t" => (size_of::<usize>(), align_of::<usize>()),
                    // of the machine that the test runs on; docs/maintain/abi.txt has those of 64
                    // bits
                    pointer if pointer.contains('*') => (size_of::<usize>(), align_of::<usize>()),
                    other => {
                        let inner = known.get(other);
                        let inner = inner.unwrap_or_else(|| {
                            panic!("{}: {other} has no fixed size", structure.name)
                        });
                        (inner.size, inner.alignment)
                    }
                };
                let offset = layout.size.next_multiple_of(alignment);
                layout.offsets.push(offset);
                layout.size = offset + size * member.elements;
                layout.alignment = layout.alignment.max(alignment);
            }
            layout.size = layout.size.next_multiple_of(layout.alignment);
            known.insert(&structure.name, layout);
        }
        known
    }

    /// The binary interface as text: `docs/maintain/abi.txt`.
    pub fn interface(&self) -> String {
        let layouts = self.layouts();
        let mut text = String::new();
        for (name, value) in &self.constants {
            // Versions of the source do not bind a program that is compiled.
            if !name.starts_with("KSTRIP_VERSION_") {
                text += &format!("constant {name} {value}\n");
            }
        }
        for structure in &self.structures {
            let Structure { name, members } = structure;
            let layout = &layouts[name.as_str()];
            text += &format!("struct {name} size {} alignment {}\n", layout.size, layout.alignment);
            for (member, offset) in members.iter().zip(&layout.offsets) {
                let Variable { kind, name: member, elements } = member;
                let array = if *elements == 1 { String::new() } else { format!("[{elements}]") };
                text += &format!("member {name} {offset} {kind} {member}{array}\n");
            }
        }
        for function in &self.functions {
            text += &format!("function {}\n", function.declaration());
        }
        text
    }

    /// The list of structures for the macro `layouts!` of `tests/builds/c_programs.rs`; those of
    /// single precision have the same members.
    pub fn rust_list(&self) -> String {
        let mut text = "// Every structure of include/kstrip.h. Written together with it:\n\
             // KSTRIP_WRITE_HEADER=1 cargo test --test interface binary_interface\nlayouts! {\n"
            .to_owned();
        for Structure { name, members } in &self.structures {
            if name.ends_with("_f32") {
                continue;
            }
            // One member has another name in Rust; in arrays it has its own.
            let renamed = |member: &Variable| member.kind == "kstrip_status";
            let mut line = format!("    {name} {{");
            for (i, member) in members.iter().enumerate() {
                let name = if renamed(member) { "warning" } else { member.name.as_str() };
                let comma = if i + 1 < members.len() { "," } else { " }" };
                if line.len() + name.len() + 3 > 100 {
                    text += &format!("{line}\n");
                    line = " ".repeat(7);
                }
                line += &format!(" {name}{comma}");
            }
            text += &format!("{line}\n");
        }
        text + "}\n"
    }

    /// A C program that prints sizes and offsets as the compiler has them.
    pub fn c_printer(&self) -> String {
        let mut text =
            "#include \"kstrip_f32.h\"\n#include <stdio.h>\nint main(void)\n{\n".to_owned();
        let mut print = |what: String, number: String| {
            text += &format!("    printf(\"{what} %u\\n\", (unsigned){number});\n");
        };
        print("size kstrip_status".to_owned(), "sizeof(kstrip_status)".to_owned());
        for Structure { name, members } in &self.structures {
            print(format!("size {name}"), format!("sizeof({name})"));
            for Variable { name: member, .. } in members {
                print(format!("offset {name}.{member}"), format!("offsetof({name}, {member})"));
            }
        }
        text + "    return 0;\n}\n"
    }

    /// A C file that compiles only where structures have the layout of `docs/maintain/abi.txt`.
    pub fn c_assertions(&self) -> String {
        let layouts = self.layouts();
        let mut text = "#include \"kstrip_f32.h\"\n".to_owned();
        for Structure { name, members } in &self.structures {
            let layout = &layouts[name.as_str()];
            // Structures of pointers have the size of this machine's.
            let sized = |kind: &str| kind.contains('*') || kind == "ptrdiff_t";
            let pointers = members.iter().any(|member| sized(&member.kind));
            if pointers {
                let size = size_of::<usize>();
                text += &format!("#if UINTPTR_MAX == UINT{}_MAX\n", 8 * size);
            }
            text += &format!("_Static_assert(sizeof({name}) == {}, \"{name}\");\n", layout.size);
            for (Variable { name: member, .. }, offset) in members.iter().zip(&layout.offsets) {
                text += &format!(
                    "_Static_assert(offsetof({name}, {member}) == {offset}, \"{name}.{member}\");\n"
                );
            }
            if pointers {
                text += "#endif\n";
            }
        }
        text
    }
}
