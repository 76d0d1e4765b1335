"""The small changes of one line that make mutants of a C file, and where they count."""
import os
import re
from typing import NamedTuple

STRING = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'')
COMMENT = re.compile(r"/\*.*?(\*/|$)|//.*")
CHANGES = [  # kind, pattern, what takes its place
    ("comparison", r"(?<![-<>=!])(<|>)(?![<>=])", {"<": ">=", ">": "<="}),
    ("comparison", r"(<=|>=|==|!=)", {"<=": ">", ">=": "<", "==": "!=", "!=": "=="}),
    ("logic", r"(&&|\|\|)", {"&&": "||", "||": "&&"}),
    ("condition", r"(?<![\w)])(!)(?=[\w(*])", {"!": ""}),
    ("condition", r"\bif \(([\w>.-]+(?:\([^()&|=<>!]*\))?)\)", lambda c: "!" + c),
    ("sign", r"(?<=[\w)\]] )([+-])(?= [\w(])", {"+": "-", "-": "+"}),
    # not -1, a mark of failure or of none, of which the sign counts
    ("constant", r"(?<![\w.])(?<![=?:,] -)(?<!\(-)(?<!return -)(\d+)(?![\w.])",
     lambda n: str(int(n) + 1)),
    ("constant", r"(?<![\w.])(\d+\.\d*|\d+e-?\d+|\d*\.\d+e-?\d+)(?![\w.])",
     lambda x: "(%s * 1.5)" % x),
    ("index", r"\[([A-Za-z_]\w*)\](?! *=[^=])", lambda i: "%s + 1" % i),
    ("call", r"^\s+((?:TRY\()?\w+\(.*\);)$", lambda call: ";"),
]

# Room alone, more of it changes nothing: declarations without a value, sizes of allocations
# and of arrays. What only gives memory back is for the sanitizers to notice.
DECLARATION = re.compile(
    r"^\s+(static |const |unsigned |enum )*(double|float|int|long|char|bool|size_t|hsize_t"
    r"|struct \w+|\{)[^=()]*;$")
ARRAY = re.compile(r"^\s+(?:static |const |unsigned )*(?:\w+ )+\*?\w+(\[[^]]*\])+(?= =|,|;)")
ALLOCATION = re.compile(r"\b(?:[mc]alloc|realloc)\(")
BUFFER = re.compile(r"\bv?snprintf\([^,]*,[^,]*,")
GIVES_BACK = re.compile(
    r"^\s+((\w+_)?free(_\w+)?|munmap|cholmod_finish|H5[PST]close|va_end)\(.*\);$")
BEGINS = re.compile(r"\b(\w+)\(")


class Mutant(NamedTuple):
    file: str
    line: int  # from 1
    function: str
    kind: str
    old: str  # both without indent
    new: str
    nth: int  # of the same change of the same text in the function, from 0

    def key(self):
        """What it is called where lines have moved."""
        return self.file, self.function, self.old, self.new, self.nth


def blank(match):
    return " " * len(match.group())


def parenthesis_end(text, start):
    """Behind the parenthesis that closes the one at start - 1."""
    depth = 1
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if not depth:
            return at
    return len(text)


def hidden(line):
    """The line with what is not to be changed blanked, columns as they were."""
    line = STRING.sub(lambda m: '"' + "\1" * (len(m.group()) - 2) + '"', line)
    line = COMMENT.sub(blank, line)
    line = BUFFER.sub(blank, line)
    line = ARRAY.sub(blank, line)
    for m in ALLOCATION.finditer(line):
        end = parenthesis_end(line, m.end())
        line = line[: m.end()] + " " * (end - m.end()) + line[end:]
    return line


def code_lines(text):
    """Number from 0 and function of the lines that hold code; function "": a table's values."""
    inside = comment = values = False
    function, head, asserting = "", "", 0
    for number, line in enumerate(text):
        bare = line.strip()
        if comment or bare.startswith("/*"):
            comment = "*/" not in line
            continue
        if asserting or bare.startswith(("assert(", "static_assert(")):
            bare = COMMENT.sub("", STRING.sub("", line))
            asserting += bare.count("(") - bare.count(")")
            continue
        if values or (not inside and re.match(r"\w.*= \{$", line)):
            if values and not line.startswith("}"):
                yield number, ""
            values = not line.startswith("}")
        elif line.startswith("{"):
            inside = True
            named = BEGINS.search(head)
            function = named.group(1) if named else ""
        elif line.startswith("}"):
            inside, head = False, ""
        elif inside:
            if bare and not bare.startswith(("#", "*", "//", "case ")) and not (
                    DECLARATION.search(line) or GIVES_BACK.search(line)):
                yield number, function
        elif not bare or bare.startswith("#") or line.endswith(";"):
            head = ""
        else:
            head += line + " "


def changes_of(line):
    """Every change of one line: kind and new line."""
    seen = hidden(line)
    for kind, pattern, put in CHANGES:
        for m in re.finditer(pattern, seen):
            old = line[m.start(1) : m.end(1)]
            new = put[old] if isinstance(put, dict) else put(old)
            changed = line[: m.start(1)] + new + line[m.end(1) :]
            if changed != line:
                yield kind, changed


def mutants_of(top, file):
    with open(os.path.join(top, file)) as source:
        text = source.read().split("\n")
    times = {}
    for number, function in code_lines(text):
        for kind, new in changes_of(text[number]):
            change = function, text[number].strip(), new.strip()
            times[change] = times.get(change, -1) + 1
            yield Mutant(file, number + 1, function, kind, *change[1:], times[change])


def planted(text, mutant):
    """The file's text with the mutant in it."""
    lines = text.split("\n")
    line = lines[mutant.line - 1]
    lines[mutant.line - 1] = line[: len(line) - len(line.lstrip())] + mutant.new
    return "\n".join(lines)
