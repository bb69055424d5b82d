"""Makes one HTML file of showcases, which needs nothing beside it: page.py TITLE OUT.html SHOWCASES...

Each of SHOWCASES is a NAME for NAME.json and NAME.bin, as examples/page/showcase.hpp writes them.
"""

import base64
import gzip
import html
import json
import pathlib
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "examples/page"


def packed(data):
    """As base64 of a gzip stream, which is the same each time."""
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode("ascii")


def moved(described, by):
    """The description of arrays that are shifted by this offset."""
    if isinstance(described, list):
        return [moved(one, by) for one in described]
    if isinstance(described, dict):
        return {key: value + by if key == "at" else moved(value, by) for key, value in described.items()}
    return described


def page(title, names):
    described, arrays = [], b""
    for name in names:
        described += moved(json.loads(pathlib.Path(f"{name}.json").read_text("utf-8")), len(arrays))
        arrays += pathlib.Path(f"{name}.bin").read_bytes()
    links = [f"""<a id="show={show["id"]}" href="#show={show["id"]}">{html.escape(show["title"])}</a>""" for show in described]
    parts = {
        "TITLE": html.escape(title),
        "SHOWCASES": "\n    ".join(links),
        "STYLE": (PAGE / "page.css").read_text("utf-8"),
        "LICENCE": (PAGE / "three/LICENSE.three").read_text("utf-8").strip(),
        "THREE": packed((PAGE / "three/three.min.js").read_bytes()),
        # In a script only this could end it.
        "DESCRIBED": json.dumps(described, ensure_ascii=True, separators=(",", ":")).replace("<", "\\u003c"),
        "ARRAYS": packed(arrays),
        "SCRIPT": "".join((PAGE / name).read_text("utf-8") for name in ("decode.js", "view.js", "page.js")),
    }
    text = (PAGE / "page.html").read_text("utf-8")
    for key, value in parts.items():
        text = text.replace(f"@{key}@", value)
    return text


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    pathlib.Path(sys.argv[2]).write_text(page(sys.argv[1], sys.argv[3:]), "utf-8")
