#!/usr/bin/env python3
"""The reference that doxygen prints, made of what is written once.

The comments of gusset.h are prose for readers of the header. As doxygen's filter (`reference.py FILE`) this sorts each one into
brief, details, parameters, errors, complexity, threads, source and version, puts it into the group of the file of src/ffi
that it comes from, and adds the example: the first block of examples/reference that calls the function, which is compiled and
run. scripts/reference_cpp.py does the same for the C++ headers.

`reference.py --check` tells what a function lacks, and fails if it lacks anything.
"""

import functools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADER = ROOT / "include/gusset.h"
COMMENT = r"/\*\*((?:(?!\*/).)*)\*/\s*"
FUNCTION = re.compile(COMMENT + r"(GUSSET_API\s[^;]*?(\w+)\(([^;]*)\)\s*;)", re.S)
ANYTHING = re.compile(COMMENT + r"(?:#define (?P<constant>\w+)|(?:GUSSET_\w+\s+)*[^;{}()]*?\b(?P<function>\w+)\(|"
                      r"typedef [^;{(]*?\(\*(?P<callback>\w+)\)|typedef (?:struct|enum)?\s*\w+ (?P<tag>\w+)(?:;| \{)|"
                      r"enum (?P<enum>\w+))", re.S)
# First words of sentences that go on about the parameter before them.
GOES_ON = ("NULL ", "It ", "They ", "Either ", "Each has ", "Each may ", "Each names ", "For gusset_", "No bound")
COMPLEXITY = re.compile(r"(?:About |At most |Besides )?O\(|Bounded work|In proportion|Loops of n|Time and memory|"
                        r"Composite, blended|Linear|Extra memory|No memory")
CONTEXT = "Threads, progress, cancelling and the account of an error; NULL for the defaults: then there is no account."


@functools.cache
def header():
    return HEADER.read_text()


@functools.cache
def statuses():
    return set(re.findall(r"\bGUSSET_ERROR_(\w+) =", header()))


@functools.cache
def groups():
    """The groups of docs/reference.dox, and the source that each names for its methods."""
    text = (ROOT / "docs/reference.dox").read_text()
    pages = dict(re.findall(r"@defgroup (\w+)(.*?)\*/", text, re.S))
    own = {name: re.search(r"@par Source\n \* (.*)", page) for name, page in pages.items()}

    def source(name):
        return own[name].group(1) if own.get(name) else source(name.rpartition("_")[0])

    return {name: source(name) for name in pages}


@functools.cache
def origins():
    """Where in src/ffi each name of the interface is declared: the file, without its ending."""
    found, folder = {}, ROOT / "src/ffi"
    for path in sorted({*folder.glob("*.rs"), *folder.glob("*/*.rs")} - {*folder.glob("plugin/*"), *folder.glob("openmfx/*")}):
        declared = r"^\s*pub (?:unsafe )?(?:extern \"C\" )?(?:const|fn|struct|type|enum) (\w+)"
        place = path.relative_to(folder).with_suffix("")
        place = place.parent if place.name == "mod" else place
        found.update((name, place) for name in re.findall(declared, path.read_text(), re.M))
    return found


def group(name):
    """The group named after the folder and the file; or else after the file, or the longest beginning of its name."""
    place = origins().get(name, Path())
    exact = "_".join(place.parts)
    fitting = [one for one in groups() if place.name == one or place.name.startswith(one + "_")]
    return exact if exact in groups() else max(fitting, key=len, default=None)


@functools.cache
def blocks():
    """The examples: file and name of each block, and what it says."""
    found = []
    for path in sorted((ROOT / "examples/reference").glob("*.c")):
        for name, text in re.findall(r"^//! \[(\w+)\]\n(.*?)^//! \[\1\]\n", path.read_text(), re.S | re.M):
            found.append((path.name, name, text))
    return found


@functools.cache
def first_version(name):
    """The version that brought a function, as the package of the library lists it."""
    lists = sorted((ROOT / "packaging/debian").glob("*.symbols"))
    listed = re.search(rf"^ {name}@Base (\S+)", "".join(path.read_text() for path in lists), re.M)
    return listed.group(1) if listed else re.search(r'VERSION_STRING "(.*?)"', header()).group(1)


def example(name):
    return next(((file, block) for file, block, text in blocks() if re.search(rf"\b{name}\(", text)), None)


def prose(comment):
    """The paragraphs of a comment, each a list of sentences."""
    text = "\n".join(re.sub(r"^\s*\* ?", "", line) for line in comment.strip().splitlines())
    paragraphs = [re.sub(r"\s+", " ", part).strip() for part in re.split(r"\n\s*\n", text)]
    return [re.split(r"(?:(?<=[^\s.][.])|(?<=_[.]{3}))\s+(?=[A-Za-z0-9(|])", part) for part in paragraphs if part]


def parameters(declaration):
    """Name and type of each parameter."""
    inside = declaration[declaration.index("(") + 1:declaration.rindex(")")]
    found = []
    for part in re.split(r",\s*", re.sub(r"\s+", " ", inside)):
        if part != "void":
            kind, name = re.match(r"(.*?)(\w+)$", part.strip()).groups()
            found.append((name, kind.strip()))
    return found


def usual(name, kind):
    """What is said of a parameter that needs no words of its own, as its type says all."""
    bare = re.sub(r"\b(const|struct)\b|[*\s]", "", kind)
    stars = kind.count("*")
    if name == "context":
        return CONTEXT
    if stars == 2 and re.search(rf"\b{bare}_destroy\(|\b{bare.replace('validation', 'validate')}_destroy\(", header()):
        return f"Receives the result, for its _destroy function; NULL on failure. See ::{bare}."
    if name == "index":
        return "Its number, counted from 0; from the number of what is there on, ::GUSSET_ERROR_NO_SUCH_ELEMENT."
    if stars == 1 and name == "options":
        return f"NULL for the defaults; see ::{bare}."
    if stars == 1 and re.search(rf"^typedef struct {bare} \{{", header(), re.M):
        if "const" in kind:
            return f"See ::{bare}."
        return f"Receives the answer, see ::{bare}; its struct_size set by the caller, all else is overwritten."
    if stars == 1 and re.search(rf"^typedef struct {bare} {bare};", header(), re.M):
        return f"A handle; see ::{bare}."
    return None


def direction(kind):
    if "*" not in kind or kind.count("*") == 1 and "const" in kind:
        return "in"
    opaque = re.sub(r"\b(const|struct)\b|[*\s]", "", kind)
    edited = kind.count("*") == 1 and re.search(rf"^typedef struct {opaque} {opaque};", header(), re.M)
    return "in,out" if edited else "out" if not kind.startswith("const") or kind.count("*") == 2 else "in"


def threads(name, given, said):
    """What the types of the handles promise: const ones are shared, others are used alone."""
    if name.endswith("_destroy"):
        return "From any thread, when no other call uses the handle."
    if any(text.startswith("From any thread") for text in said):
        return " ".join(said)
    edited = [n for n, kind in given if direction(kind) == "in,out" and n != "context"]
    if edited:
        return " ".join([f"From any thread; `{edited[0]}` is changed, and no other call may use it meanwhile.", *said])
    if name.startswith("gusset_context_"):
        return "From the thread that uses the context."
    return " ".join(["From any thread; handles that are const may be shared by any number of calls.", *said])


class Function:
    """A function of the header, its comment sorted."""

    def __init__(self, comment, declaration, name):
        self.name, self.declaration, self.given = name, declaration, parameters(declaration)
        self.described, self.errors, self.complexity, self.said, self.source = {}, [], [], [], []
        self.details, self.brief = [], None
        for sentences in prose(comment):
            self.sort(sentences)
        if name.endswith("_destroy") and not self.complexity:
            self.complexity = ["At most in proportion to what the handle holds."]

    def sort(self, sentences):
        """Puts each sentence of a paragraph where it belongs; those that begin with nothing known go on with the one before."""
        kept, last = [], None
        names = {n for n, _ in self.given}
        parts = []
        for sentence in sentences:
            # "query: x, y, z; radius: at least 0" speaks of two.
            parts += re.split(r"(?<=;) (?=(?:%s): )" % "|".join(names or {"-"}), sentence)
        for part in parts:
            spoken = re.match(r"(\w+(?:, \w+)*): ", part)
            if re.match(r"(?:Errors|The rest|All else|Otherwise)\b", part):
                self.errors.append(part)
                last = "errors"
            elif COMPLEXITY.match(part):
                self.complexity.append(part)
                last = "complexity"
            elif re.match(r"From any thread|The same b(?:its|ytes) for any", part):
                self.said.append(part)
                last = "threads"
            elif re.match(r"Sources?: ", part):
                self.source.append(part.split(": ", 1)[1])
                last = "source"
            elif spoken and set(spoken.group(1).split(", ")) <= names:
                last = spoken.group(1).split(", ")
                for one in last:
                    self.described[one] = part[spoken.end():].rstrip(";")
            elif isinstance(last, list) and part.startswith(GOES_ON):
                for one in last:
                    self.described[one] += " " + part
            elif last in ("complexity", "source"):
                {"complexity": self.complexity, "source": self.source}[last].append(part)
            elif self.brief is None:
                self.brief = part
            else:
                kept.append(part)
                last = None
        if kept:
            self.details.append(" ".join(kept))

    def parameter(self, name, kind):
        if name in self.described:
            text = self.described[name]
            if "struct" in kind and "*" in kind and "::" not in text:
                text += " See ::%s." % re.sub(r"\b(const|struct)\b|[*\s]", "", kind) if text.endswith(".") else ""
            return text
        if re.search(r"count|capacity|stride|size", name):
            beside = [other for other, text in self.described.items() if re.search(rf"\b{name}\b", text)]
            # points_b beside count_b; else what goes in before what comes out.
            beside.sort(key=lambda other: (other[-2:] != name[-2:], direction(dict(self.given)[other]) != "in"))
            if beside:
                return f"See `{beside[0]}`."
        standard = usual(name, kind)
        if standard is None and re.search(rf"`{name}`", " ".join(self.details + [self.brief or ""])):
            return f"As said of `{name}` above."
        return standard

    def lacks(self):
        """What a reader would miss."""
        missing = [f"parameter {n}" for n, kind in self.given if self.parameter(n, kind) is None]
        fallible = re.search(r"\bgusset_status\b", self.declaration.split("(")[0])
        found = {
            "a brief": self.brief,
            "a group (docs/reference.dox) for its file of src/ffi": group(self.name),
            "errors": self.errors or not fallible,
            "complexity": self.complexity or any("gusset_" in text for text in self.errors),
            "an example (examples/reference)": example(self.name),
        }
        return missing + [what for what, there in found.items() if not there]

    def page(self):
        """The comment as doxygen takes it."""
        lines = [f"@brief {self.brief}", "", f"@ingroup {group(self.name)}", ""]
        for text in self.details:
            lines += [text, ""]
        lines += [f"@param[{direction(kind)}] {n} {self.parameter(n, kind)}" for n, kind in self.given]
        if self.errors:
            errors = re.sub(r"\b[A-Z][A-Z_]+\b", status_link, " ".join(self.errors))
            lines += [f"@return ::GUSSET_OK, or the status of the error. {errors}"]
        elif not self.declaration.split("(")[0].split()[1:2] == ["void"]:
            lines += [f"@return {self.brief}"]
        like = re.findall(r"gusset_\w+", " ".join(self.errors))
        lines += ["@par Complexity", " ".join(self.complexity) or f"As of ::{like[0]}."]
        lines += ["@par Threads", threads(self.name, self.given, self.said)]
        lines += ["@par Source", " ".join(self.source) or groups()[group(self.name)]]
        lines += [f"@since {first_version(self.name)}"]
        if found := example(self.name):
            where = f"From examples/reference/{found[0]}, which the tests run. MUST: the call succeeds; HOLDS: so it is."
            lines += ["@par Example", where, f"@snippet {found[0]} {found[1]}"]
        return "/**\n" + "\n".join(" * " + escaped(line) for line in lines) + "\n */\n" + self.declaration


def status_link(word):
    return f"::GUSSET_ERROR_{word.group()}" if word.group() in statuses() else word.group()


def escaped(line):
    """Signs that doxygen would take for its own."""
    return line if line.startswith("@snippet") else re.sub(r"(?<!\\)([<>#])", r"\\\1", line)


def functions():
    return [Function(*match.group(1, 2, 3)) for match in FUNCTION.finditer(header())]


def c_header():
    text = FUNCTION.sub(lambda m: Function(*m.group(1, 2, 3)).page() if group(m.group(3)) else m.group(), header())

    def grouped(match):
        name = next(filter(None, match.groupdict().values()), None)
        if match.group("function") or not name or not group(name):
            return match.group()
        comment = "\n".join(escaped(line) for line in match.group(1).splitlines())
        rest = match.group()[match.group().index("*/"):]
        return f"/**{comment}\n@ingroup {group(name)}\n{rest}"

    text = ANYTHING.sub(grouped, text)
    # What is for compilers, and what its first line explains.
    text = re.sub(r"^#define GUSSET_(API|MUST_USE)\b.*\n", "", text, flags=re.M)
    text = re.sub(r"^(#define GUSSET_VERSION_(?:MINOR|PATCH|STRING) .*)", r"/** See ::GUSSET_VERSION_MAJOR. */\n\1", text, flags=re.M)
    return "/** @file\n The C interface. */\n" + text


def plain_header(path):
    """A header whose comments are as doxygen wants them: without what is for compilers."""
    text = re.sub(r"^#define GUSSET_\w*(?:API|MUST_USE)\b.*\n", "", path.read_text(), flags=re.M)
    return f"/** @file\n {text.split('.')[0].lstrip('/* ')}. */\n{text}"


def check():
    status = 0
    for function in functions():
        for what in function.lacks():
            print(f"{function.name} lacks {what}")
            status = 1
    names = {function.name for function in functions()}
    guides = "".join(path.read_text() for path in sorted((ROOT / "examples/guides").glob("*.c")))
    for symbol in (ROOT / "include/gusset.symbols").read_text().split():
        if symbol not in names and symbol not in guides:
            print(f"{symbol} is exported, and in no example")
            status = 1
    for file, block, text in blocks():
        for name in sorted(set(re.findall(r"\b(gusset_\w+)\(", text)) - names):
            print(f"examples/reference/{file}, {block}: there is no {name}")
            status = 1
    if not status:
        print(f"{len(names)} functions, each with all its parts and one of {len(blocks())} examples")
    return status


def main(arguments):
    if arguments == ["--check"]:
        return check()
    path = Path(arguments[0]).resolve()
    sys.stdout.write(c_header() if path == HEADER else plain_header(path))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
