//! Valid rule texts from bytes: whatever the bytes, the text parses. For properties and fuzzers.
//!
//! Each choice takes a byte; where they have run out the plainest alternative is taken, so every text ends. Between
//! signs and words stand blanks, line ends and comments of all kinds, as the bytes will. Imports are left out: their
//! files would have to exist.

/// How deep brackets and choices nest at most.
const DEPTH: u8 = 4;

/// The rule text of these bytes.
pub fn rules(bytes: &[u8]) -> String {
    let mut writer = Rules { bytes: bytes.iter(), out: String::new(), depth: 0 };
    if writer.chance() {
        writer.words("version \"2025.1\"");
    }
    while !writer.bytes.as_slice().is_empty() {
        writer.definition();
    }
    writer.out
}

struct Rules<'b> {
    bytes: std::slice::Iter<'b, u8>,
    out: String,
    depth: u8,
}

const NAMES: [&str; 8] = ["a", "Lot", "scope.sx", "grün", "h_1", "Tree", "material.color.r", "$x"];
const RULES: [&str; 4] = ["Lot", "Tree", "Wall_2", "Étage"];
const NUMBERS: [&str; 6] = ["1", "0.25", ".5", "5.", "3e3", "12"];
const TEXTS: [&str; 4] = ["\"red\"", "\"\"", "\"a // b\"", "\"say \\\"x\\\"\""];
const INFIXES: [&str; 16] = ["+", "-", "*", "/", "%", "<", "<=", ">", "==", "!=", "&&", "||", ".+", ".*", ".==", ".||"];
const GAPS: [&str; 16] = [
    " ",
    " ",
    " ",
    "",
    "",
    "  ",
    "\t",
    "\n",
    "\n  ",
    "\n\n\n",
    " // é\n",
    " # x\r\n",
    "\n// own\n",
    " /* in */ ",
    "\n/* a\n   b */\n",
    "\u{a0}",
];

impl Rules<'_> {
    // ---- definitions

    fn definition(&mut self) {
        self.out.push('\n');
        while self.chance() {
            self.annotation();
        }
        match self.pick(7) {
            0 => self.rule(),
            1 => self.paper_rule(),
            2 => {
                self.word("attr");
                self.name();
                self.word("=");
                self.value();
            }
            3 => {
                self.word("const");
                self.function();
            }
            4 => {
                // `style` is a keyword at the start of a line alone.
                self.out.push_str("\nstyle Winter");
                if self.chance() {
                    self.words("extends Bare");
                }
            }
            5 => self.words("attr width ( index )"),
            _ => self.function(),
        }
    }

    fn annotation(&mut self) {
        let all =
            ["@Hidden", "@Range ( min = 0 , max = 1 )", "@Group ( \"a\" , 2 )", "@Handle ( offset = { 0 , 1 , 0 } )"];
        let annotation = all[self.pick(4)];
        self.words(annotation);
    }

    fn function(&mut self) {
        self.word("f");
        self.parameters();
        self.locals();
        self.word("=");
        self.value();
    }

    fn rule(&mut self) {
        if self.chance() {
            let word = ["start", "extension"][self.pick(2)];
            self.word(word);
        }
        self.rule_name();
        if self.chance() {
            self.parameters();
            self.locals();
        }
        self.word("-->");
        self.body();
    }

    fn paper_rule(&mut self) {
        // An id is one at the start of a line alone, and so is a name that is none.
        self.out.push_str("\nr1 : Lot");
        if self.chance() {
            self.word(":");
            self.expression();
        }
        self.word("~>");
        self.body();
        if self.chance() {
            self.words(": 0.5");
        }
    }

    fn parameters(&mut self) {
        let list = ["( x )", "( )", "( x , y )"][self.pick(3)];
        self.words(list);
    }

    fn locals(&mut self) {
        if self.chance() {
            self.words("with ( m :=");
            self.value();
            if self.chance() {
                self.words("n :=");
                self.value();
            }
            self.word(")");
        }
    }

    // ---- successors

    fn body(&mut self) {
        match self.pick_nested(6) {
            0..=3 => self.ops(),
            4 => {
                self.cases(Rules::body);
            }
            _ => self.chances(true),
        }
    }

    fn ops(&mut self) {
        self.op();
        while self.chance() {
            self.op();
        }
    }

    fn op(&mut self) {
        match self.pick_nested(12) {
            0 => self.rule_name(),
            1 => self.words("NIL"),
            2 => {
                self.rule_name();
                self.out.push('.');
            }
            3 => {
                self.words("extrude");
                self.args();
            }
            4 => self.nested("[", Rules::body, "]"),
            5 => self.split(),
            6 => {
                self.words("comp ( f )");
                self.block(Rules::selector);
            }
            7 => {
                self.words("scatter ( surface , 9 )");
                self.nested("{", Rules::body, "}");
            }
            8 => {
                self.words("inline ( unify )");
                self.nested("{", Rules::ops, "}");
            }
            9 => self.words("Subdiv ( x , 1r , 2 ) { A | B }"),
            10 => {
                self.words("plants ( h =");
                self.value();
                self.word(")");
                self.out.push_str(".Tree");
            }
            _ => self.words("splitAndSetbackPerimeter ( 0.5 ) { '0.3 : 2 : A | ~1 : 3 : B } * { remainder : NIL }"),
        }
    }

    fn split(&mut self) {
        self.words("split ( x , noAdjust )");
        self.block(Rules::size);
        if self.chance() {
            self.word("*");
        }
    }

    fn block(&mut self, head: fn(&mut Self)) {
        self.depth += 1;
        self.word("{");
        loop {
            head(self);
            self.body();
            if !self.chance() {
                break;
            }
            self.word("|");
        }
        self.word("}");
        self.depth -= 1;
    }

    fn size(&mut self) {
        if self.depth < DEPTH && self.pick(5) == 4 {
            self.words("{ ~1 : A | 2 : B } * |");
        }
        match self.pick(4) {
            0 => self.number(),
            1 => self.words("2r"),
            2 => {
                self.words("~");
                self.operand();
            }
            _ => {
                self.words("'");
                self.number();
            }
        }
        self.word(":");
    }

    fn selector(&mut self) {
        match self.pick(3) {
            0 => self.words("front"),
            1 => self.words("street.back"),
            _ => self.words("comp.index % 2 == 0"),
        }
        let separator = [":", "=", "=:"][self.pick(3)];
        self.word(separator);
    }

    fn cases(&mut self, content: fn(&mut Self)) {
        self.depth += 1;
        self.word("case");
        self.expression();
        self.word(":");
        content(self);
        while self.chance() {
            self.word("case");
            self.expression();
            self.word(":");
            content(self);
        }
        self.words("else :");
        content(self);
        self.depth -= 1;
    }

    /// Percentages; in successors they may be names.
    fn chances(&mut self, in_body: bool) {
        let content = if in_body { Rules::body } else { Rules::value };
        self.depth += 1;
        self.words("30% :");
        content(self);
        while self.chance() {
            let share = if in_body && self.chance() { "w %" } else { "2.5 %" };
            self.words(share);
            self.word(":");
            content(self);
        }
        self.words("else :");
        content(self);
        self.depth -= 1;
    }

    // ---- values

    fn value(&mut self) {
        match self.pick_nested(8) {
            0..=5 => self.expression(),
            6 => self.cases(Rules::value),
            _ => self.chances(false),
        }
    }

    fn expression(&mut self) {
        self.operand();
        while self.chance() {
            let infix = INFIXES[self.pick(INFIXES.len())];
            self.word(infix);
            self.operand();
        }
    }

    fn operand(&mut self) {
        if self.chance() {
            let prefix = ["-", "!", "+"][self.pick(3)];
            self.word(prefix);
        }
        match self.pick_nested(8) {
            0 => self.number(),
            1 => self.name(),
            2 => {
                let text = TEXTS[self.pick(TEXTS.len())];
                self.word(text);
            }
            3 => {
                self.word("rand");
                self.args();
            }
            4 => self.nested("(", Rules::value, ")"),
            5 => self.words("[ 1 , 2 ; 3 , 4 ]"),
            6 => self.words("[ 1 : 2 : 9 ]"),
            _ => {
                self.word("list");
                self.nested("[", Rules::expression, "]");
            }
        }
    }

    fn args(&mut self) {
        self.depth += 1;
        self.word("(");
        self.value();
        while self.chance() {
            self.word(",");
            if self.chance() {
                self.words("width =");
            }
            self.value();
        }
        self.word(")");
        self.depth -= 1;
    }

    // ---- words

    fn nested(&mut self, open: &str, inside: fn(&mut Self), close: &str) {
        self.depth += 1;
        self.word(open);
        inside(self);
        self.word(close);
        self.depth -= 1;
    }

    fn name(&mut self) {
        let name = NAMES[self.pick(NAMES.len())];
        self.word(name);
    }

    fn rule_name(&mut self) {
        let name = RULES[self.pick(RULES.len())];
        self.word(name);
    }

    fn number(&mut self) {
        let number = NUMBERS[self.pick(NUMBERS.len())];
        self.word(number);
    }

    fn words(&mut self, words: &str) {
        words.split(' ').for_each(|word| self.word(word));
    }

    fn word(&mut self, word: &str) {
        let gap = GAPS[self.pick(GAPS.len())];
        let brackets = ['(', ')', '{', '}', ',', '|'];
        let stands_alone = word.starts_with(brackets) || self.out.ends_with(brackets) || word == "[" || word == "]";
        self.out.push_str(if gap.is_empty() && !stands_alone { " " } else { gap });
        self.out.push_str(word);
    }

    /// One of so many, the first where no bytes are left.
    fn pick(&mut self, count: usize) -> usize {
        self.bytes.next().map_or(0, |byte| usize::from(*byte) % count)
    }

    /// The same, and the first where nesting has gone deep enough.
    fn pick_nested(&mut self, count: usize) -> usize {
        if self.depth >= DEPTH { 0 } else { self.pick(count) }
    }

    fn chance(&mut self) -> bool {
        self.pick(3) == 2
    }
}
