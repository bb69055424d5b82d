#!/usr/bin/env python3
"""Writes, from the description of the interface, a wrapper for each function: `wrappers.py interface.json source > wrappers.c`, and
`header` in place of `source` for a header that puts the wrappers in place of the functions.

A file that is compiled with `-include wrappers.h` behaves as before. Before each of its calls, the wrapper repeats the call in
another process, each time with one hostile number, pointer or size. The declarations show everything that the arguments reach:
fields of structs, elements of arrays, options within options. The examples of the reference, one for each function, are the rows of
the table, so that no function is forgotten. hostile.h has the hostile values; torture.h, results.h and questions.h check each call.
"""

import json
import re
import sys
from dataclasses import dataclass

NUMBERS = {"double": "F64", "float": "F32", "uint32_t": "U32", "int32_t": "I32", "uint64_t": "U64", "int64_t": "I64",
           "size_t": "COUNT", "uint8_t": "U8"}
# Pointers to three numbers for which no count follows.
VECTORS = {"point", "normal", "direction", "query"}
# The target of a `const void *`: coordinates in the type of the field `scalar`, or numbers.
UNTYPED = {"positions": "SCALARS", "points": "SCALARS", "nodes": "SCALARS", "values": "SCALARS", "x": "SCALARS", "y": "SCALARS",
           "z": "SCALARS", "face_offsets": "OFFSET", "face_corners": "U32", "merge": "U32"}
# Arrays of points: three coordinates each, or as many as a field `dimension` says.
POINTS = {"points", "points_a", "points_b", "positions", "queries", "axis_points", "controls"}
# Arrays of results, whose content after a failure is unspecified. For other outputs, the first element is checked.
UNSPECIFIED = {"out", "rows", "columns", "deviations", "merge", "derivatives", "tangents", "curvatures",
               "controls", "parameters", "statuses"}
# The field that marks an empty element, where it is not all 0.
NONE = {"gusset_surface_nearest_point": "flags"}
# Handles that functions change, and the names of their states in results.h.
HASHED = {"gusset_net": "net", "gusset_scene": "scene", "gusset_stream_decoder": "decoder"}
# Numbers that say how an array is to be read: only values that no array has.
READ_AS = {"scalar", "index", "dimension", "face_size", "counts", "value_type", "components"}


@dataclass
class Item:
    """A field or a parameter: its type without const and struct, its stars, its name and the sizes of an array."""
    type: str
    stars: int
    name: str
    sizes: list
    constant: bool

    @staticmethod
    def of(field):
        pointers = field.get("pointers", [])
        return Item(field["type"], len(pointers), field["name"], [str(size) for size in field.get("sizes", [])], pointers[:1] == ["const"])


class Header:
    def __init__(self, interface):
        # Functions whose work does not grow with the input.
        self.constant = {one["name"] for one in interface["functions"] if one.get("complexity", "").split(" ")[0] == "O(1)."}
        self.names = NUMBERS | {one["name"]: NUMBERS[one["type"]] for one in interface["choices"]}
        self.tagged = {one["name"] for section in ("structs", "handles") for one in interface[section]}
        self.structs = {one["name"]: [Item.of(field) for field in one["fields"]] for one in interface["structs"]}
        self.functions = []
        for one in interface["functions"]:
            given = ", ".join(self.declared(field) for field in one["params"]) or "void"
            result = one["result"]
            self.functions.append((result, one["name"], [Item.of(field) for field in one["params"]], f"{one['name']}({given})"))

        self.destroyed = {name for _, name, _, _ in self.functions if name.endswith("_destroy")}

    def declared(self, param):
        """A parameter as C declares it."""
        pointers = param.get("pointers", [])
        stars = "".join("*const " if target == "const" else "*" for target in [*pointers[1:], ""][:len(pointers)])
        constant, tag = "const " * (pointers[:1] == ["const"]), "struct " * (param["type"] in self.tagged)
        return f"{constant}{tag}{param['type']} {stars}{param['name']}"

    def versioned(self, kind):
        return kind in self.structs and self.structs[kind][0].name == "struct_size"

    def has_pointers(self, kind):
        return any(one.stars for one in self.structs[kind])


def count_after(items, at, within):
    """How many elements the pointer items[at] has for certain: an expression."""
    for one in items[at + 1:]:
        if one.type == "size_t" and not one.stars and "stride" not in one.name:
            return within + one.name
        # A number of another meaning, or, after an input, a result, whose count comes next.
        if not one.stars or items[at].constant and not one.constant:
            break
    return "3" if items[at].name in VECTORS else "1"


def number(header, item, kind, lvalue, path, wide):
    code = header.names[kind]
    if item.name == "struct_size":
        code = "STRUCT_SIZE"
    elif item.name in READ_AS:
        code = "READ_AS"
    elif code == "COUNT" and "stride" in item.name:
        code = "STRIDE"
    elif item.name == "capacity":
        code = "CAPACITY"
    elif code == "COUNT" and wide:
        code = "WIDE"
    return f"torture_slot(TORTURE_{code}, &{lvalue}, {path});"


def visit(header, items, at, within, path, wide=False):
    """The statements that list everything reached through items[at]."""
    item, lines = items[at], []
    lvalue = within + item.name
    label = f'torture_path({path}, "{item.name}")' if path else f'"{item.name}"'
    if item.stars == 0 and item.type in header.names:
        if not item.sizes:
            return [number(header, item, item.type, lvalue, label, wide)]
        total = " * ".join(item.sizes)
        return [f"for (size_t i = 0; i < {total}; ++i) torture_slot(TORTURE_{header.names[item.type]}, "
                f"({item.type} *){lvalue} + i, {label});"]
    if item.stars == 0 and item.type in header.structs:
        return [f"for (size_t i = 0; i < {' * '.join(item.sizes) or 1}; ++i) visit_{item.type}((struct {item.type} *)&{lvalue} + i, {label});"]
    if item.stars == 0:
        return []  # callbacks
    if item.sizes:
        return [f"for (size_t i = 0; i < {item.sizes[0]}; ++i) torture_slot(TORTURE_POINTER, &{lvalue}[i], {label});"]
    # An array of handles may begin anywhere; its misaligned elements are not handles.
    loose = item.type in ("void", "char", "uint8_t") and item.stars == 1 or item.stars == 2 and item.constant
    handle = item.stars == 1 and item.type + "_destroy" in header.destroyed
    kind = "HANDLE" if handle else "BYTES" if loose else "POINTER"
    lines.append(f"torture_slot(TORTURE_{kind}, &{lvalue}, {label});")
    if item.stars > 1 or not item.constant or item.type == "char":
        if item.stars == 1 and header.versioned(item.type):
            lines.append(f"if ({lvalue}) torture_slot(TORTURE_STRUCT_SIZE, &{lvalue}->struct_size, {label});")
        return lines
    count = count_after(items, at, within)
    if item.type in header.structs:
        lines.append(f"if ({lvalue} && {count} > 0) visit_{item.type}((struct {item.type} *)torture_writable({lvalue}, "
                     f"sizeof *{lvalue}), {label});")
    else:
        kind = UNTYPED.get(item.name) if item.type == "void" else header.names.get(item.type)
        if kind == "SCALARS":
            told = any(one.name == "scalar" for one in items)
            # Another struct gives the type of the values.
            untold = "TORTURE_U8" if item.name == "values" else "TORTURE_F64"
            kind = f"{within}scalar == GUSSET_F64 ? TORTURE_F64 : TORTURE_F32" if told else untold
        elif kind == "COUNT":
            kind = "TORTURE_U64"
        elif kind:
            kind = f"TORTURE_{kind}"
        if kind:
            lines.append(f"torture_elements({kind}, {lvalue}, {count}, {label});")
        if kind and item.name in POINTS:
            dimension = within + "dimension" if any(one.name == "dimension" for one in items) else "3"
            stride = next((within + one.name for one in items if "stride" in one.name), "0")
            lines.append(f"torture_points({kind}, {lvalue}, {count}, {dimension}, {stride}, {label});")
    return lines


def finite(header, kind):
    """The statements that look at the coordinates which a result of that kind lends, two at least of each point."""
    lines = ["    if (torture_told->phase >= TORTURE_ONE_ALLOCATION) hash = torture_hash_net(hash, made);"] if kind == "gusset_net" else []
    for _, name, given, _ in header.functions:
        if not re.fullmatch(kind + "_get_(mesh|view|strip_mesh)", name) or len(given) != 2 or not header.versioned(given[1].type):
            continue
        view, fields = given[1].type, header.structs[given[1].type]
        if view == "gusset_mesh_view":
            lines.append(f"    {{ struct {view} seen = {{.struct_size = sizeof seen}}; if (({name})(made, &seen) == GUSSET_OK) "
                         "hash = torture_finite_mesh(hash, &seen); }")
            continue
        counts = {"gusset_net_view": [("x", "rows"), ("y", "rows"), ("z", "rows")] if kind != "gusset_net" else []}.get(view)
        if counts is None:
            counts = [(one.name, count_after(fields, at, "")) for at, one in enumerate(fields)
                      if one.type == "double" and one.stars == 1 and one.name in ("points", "controls", "normals")]
        for field, count in counts:
            if count == "1":
                continue
            real = "seen.scalar == GUSSET_F64" if any(one.name == "scalar" for one in fields) else "1"
            lines.append(f"    {{ struct {view} seen = {{.struct_size = sizeof seen}}; if (({name})(made, &seen) == GUSSET_OK) "
                         f'hash = torture_finite(hash, seen.{field}, seen.{count}, {real}, "{field}"); }}')
    return lines


def extent(header, one):
    """From where to where the library writes to what an output points to: not to the size that its caller has set."""
    return f"{'sizeof(size_t)' if header.versioned(one.type) else '0'}, sizeof *{one.name}"


def size_of(header, given, one):
    """The expression for the size of an output, if the size is not fixed."""
    if header.versioned(one.type):
        return f"{one.name}->struct_size"
    return "count" if one.name != "written" and any(other.name == "count" for other in given[:given.index(one)]) else ""


def wrapper(header, result, name, given, declaration):
    arguments = ", ".join(one.name for one in given)
    arrays = [one for one in given if one.stars and (one.type in header.names or (one.type in header.structs and not header.versioned(one.type)))]
    outputs = [one for one in given if one.stars == 2 and not one.constant and one.type not in ("void", "char")]
    # An array of handles is filled or left.
    outputs = [] if any(one.name == "capacity" for one in given) else outputs
    outputs = [one for one in outputs if any(f == one.type + "_destroy" for _, f, _, _ in header.functions)]
    made, others = (outputs[0], outputs[1:]) if outputs else (None, [])
    # An array of handles.
    many = next((one for one in given if one.stars == 2 and not one.constant and any(c.name == "capacity" for c in given)), None)
    context = None if name.startswith("gusset_context_") else "context" if "const struct gusset_context *context" in declaration else None
    fallible = result == "gusset_status"
    # Outputs of which something is known after a failure.
    cleared = [one for at, one in enumerate(given)
               if fallible and one.stars == 1 and not one.constant and (one.type in header.names or one.type in header.structs)
               and count_after(given, at, "") == "1" and not one.name in UNSPECIFIED]
    lines = [f"{result} torture_{declaration} {{"]
    if given and not name.endswith("_destroy"):
        promise = "NO_CONTEXT" if not context else "CONSTANT" if name in header.constant else "ASKS"
        lines.append(f'    if (torture_enter("{name}", TORTURE_{promise})) {{')
        if context:
            lines.append("        context = torture_own_context();")
        if made:
            lines.append(f"        struct {made.type} *made = NULL;\n        {made.name} = &made;")
        for one in others:
            lines.append(f"        struct {one.type} *made_{one.name} = NULL;\n        if ({one.name}) {one.name} = &made_{one.name};")
        if many:
            lines.append(f"        struct {many.type} *made[64] = {{0}}, **const own = {many.name} && capacity <= 64 ? made : NULL;\n"
                         f"        if (own) {many.name} = made;")
        for one in given:
            # Copies of structs, with garbage behind them: a size that is too large covers unknown fields.
            if one.stars == 1 and header.versioned(one.type) and count_after(given, given.index(one), "") in "13":
                lines.append(f"        {one.name} = ({'const ' if one.constant else ''}struct {one.type} *)torture_copy({one.name}, "
                             f"{one.name} ? {one.name}->struct_size : 0, sizeof *{one.name});")
        if "const void *data, size_t size" in declaration:
            lines.append("        data = torture_copy(data, size, size);")
        for at, one in enumerate(given):
            if one.name != "user":  # what a callback gets is its own affair
                lines += ["        " + line for line in visit(header, given, at, "", "", wide=not arrays)]
        if made:
            lines.append(f"        struct {made.type} **const own = {made.name};")
        for one in cleared:
            lines.append(f"        const {one.type} *const own_{one.name} = {one.name};")
            if size_of(header, given, one):
                lines.append(f"        const size_t size_{one.name} = {one.name} ? {size_of(header, given, one)} : 0;")
        changed = any(one.stars == 1 and not one.constant and one.type not in header.names and one.type not in header.structs
                      for one in given)
        lines.append(f"        torture_pure = {int(fallible and not changed)};")
        edited = next((one for one in given if one.stars == 1 and not one.constant and one.type in HASHED), None)
        hashed = f"torture_hash_{HASHED[edited.type]}(1, {edited.name})" if edited else "0"
        lines.append("        while (torture_next()) {")
        if context:
            lines.append("            if (torture_told->phase != TORTURE_ARGUMENTS) context = torture_context;")
        if made:
            lines.append(f"            made = (struct {made.type} *)TORTURE_UNTOUCHED;")
        for one in others:
            lines.append(f"            made_{one.name} = (struct {one.type} *)TORTURE_UNTOUCHED;")
        if many:
            lines.append("            memset(made, 0, sizeof made);")
        if fallible:
            if edited:
                lines.append(f"            if (torture_told->phase >= TORTURE_ONE_ALLOCATION) torture_before = {hashed};")
            for one in cleared:
                # An output with an impossible size stays unchanged.
                sized = f" && {size_of(header, given, one)} == size_{one.name}" if size_of(header, given, one) else ""
                lines.append(f"            const int soiled_{one.name} = {one.name} && {one.name} == own_{one.name}{sized};")
                lines.append(f"            if (soiled_{one.name}) torture_soil({one.name}, {extent(header, one)});")
            lines.append("            torture_arm();")
            lines.append(f"            const gusset_status status = ({name})({arguments});")
            lines.append(f"            torture_check(status, {f'{context} == torture_context ? context : NULL' if context else 'NULL'});")
            for one in cleared:
                part = f"{one.name}, {extent(header, one)}"
                if one.type in NONE:
                    part = f"&{one.name}->{NONE[one.type]}, 0, sizeof {one.name}->{NONE[one.type]}"
                # A buffer that is too small reports the size needed.
                told = " && status != GUSSET_ERROR_BUFFER_TOO_SMALL" if one.type == "size_t" else ""
                lines.append(f"            if (soiled_{one.name}{told}) torture_cleared(status, {part}, \"{one.name}\");")
        else:
            lines.append(f"            {'' if result == 'void' else '(void)'}({name})({arguments});")
        if made:
            lines.append(f"            if ({made.name} == own) torture_made(status, made);")
            lines.append(f"            uint64_t result = status == GUSSET_OK ? finite_{made.type}(made) : 0;")
            for one in others:
                lines.append(f"            if ({one.name} == &made_{one.name} && status != GUSSET_OK && made_{one.name}) "
                             f'torture_fails("{one.name} is not cleared");')
                lines.append(f"            if ({one.name} == &made_{one.name} && status == GUSSET_OK && made_{one.name}) "
                             f"result = result * 31 + finite_{one.type}(made_{one.name}), ({one.type}_destroy)(made_{one.name});")
            lines.append(f"            if (status == GUSSET_OK) ({made.type}_destroy)(made);")
        elif fallible:
            lines.append("            uint64_t result = 0;")
        if many:
            lines.append(f"            for (size_t i = 0; {many.name} == own && i < 64; ++i) {{\n"
                         f'                if (status != GUSSET_OK && made[i]) torture_fails("{many.name} is not cleared");\n'
                         f"                if (status == GUSSET_OK && made[i]) result = result * 31 + finite_{many.type}(made[i]), "
                         f"({many.type}_destroy)(made[i]);\n            }}")
        if fallible:
            for one in given:
                # Lent arrays have another address each time, and the context does not belong to the result.
                if one.stars == 1 and not one.constant and header.versioned(one.type) and not header.has_pointers(one.type):
                    lines.append(f"            if ({one.name} && torture_told->phase >= TORTURE_ONE_ALLOCATION) "
                                 f"result = torture_hash(result, {one.name}, sizeof *{one.name});")
            lines.append(f"            torture_results(status, torture_told->phase >= TORTURE_ONE_ALLOCATION ? {hashed} : 0, result);")
        lines.append("        }\n        torture_leave();\n    }")
    lines.append(f"    {'' if result == 'void' else 'return '}({name})({arguments});\n}}")
    return "\n".join(line for line in lines if line)


def write_source(header):
    """Prints the file to compile: the wrappers and their helpers."""
    print("/* Written by wrappers.py from gusset.h. */\n#include \"torture.h\"\n")
    for name in header.structs:
        print(f"static void visit_{name}(struct {name} *s, const char *path);")
    for name, fields in header.structs.items():
        wide = not header.has_pointers(name)
        print(f"\nstatic void visit_{name}(struct {name} *s, const char *path) {{")
        for at in range(len(fields)):
            print("\n".join("    " + line for line in visit(header, fields, at, "s->", "path", wide)))
        print("}")
    handles = [name.removesuffix("_destroy") for _, name, _, _ in header.functions if name.endswith("_destroy")]
    for handle in handles:
        body = "\n".join(finite(header, handle)) or "    (void)made;"
        print(f"\nstatic uint64_t finite_{handle}(const struct {handle} *made) {{\n    uint64_t hash = 1;\n{body}\n    return hash;\n}}")
    for function in header.functions:
        print("\n" + wrapper(header, *function))


def write_header(header):
    """Prints the file that examples include: the wrappers in place of the functions of gusset.h."""
    print("/* Written by wrappers.py from gusset.h. */\n#ifndef WRAPPERS_H\n#define WRAPPERS_H\n#include <gusset.h>\n")
    for result, _, _, declaration in header.functions:
        print(f"{result} torture_{declaration};")
    print()
    for _, name, given, _ in header.functions:
        if given:
            print(f"#define {name}(...) torture_{name}(__VA_ARGS__)")
    print("#endif")


def main():
    header = Header(json.loads(open(sys.argv[1]).read()))
    {"source": write_source, "header": write_header}[sys.argv[2]](header)


if __name__ == "__main__":
    main()
