#!/usr/bin/env python3
"""links.py FOLDER: checks that every link and picture within the pages of FOLDER leads to a file and an anchor. links.py FILE.md
...: checks the links between files of the source tree, as hosts of repositories show them.

LinkChecker would do for the site, but gives its rights away where it runs as root, and then may not read the pages.
"""

import re
import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Doxygen lists the private classes of a class at the top without listing them below.
DOXYGENS_OWN = {"nested-classes"}
TARGETS = {"a": "href", "area": "href", "link": "href", "img": "src", "script": "src", "iframe": "src", "object": "data", "source": "src"}


class Page(HTMLParser):
    def __init__(self):
        super().__init__()
        self.links, self.places = [], set()

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.places.update(attrs[name] for name in ("id", "name") if attrs.get(name))
        if attrs.get(TARGETS.get(tag)):
            self.links.append((self.getpos()[0], attrs[TARGETS[tag]]))


@cache
def html(path):
    page = Page()
    page.feed(path.read_text(errors="replace"))
    return page.links, page.places


@cache
def markdown(path):
    """Links outside code, and the places that headings and `<a id>` make."""
    links, places, fenced = [], set(), False
    for number, line in enumerate(path.read_text().splitlines(), 1):
        fenced ^= line.startswith("```")
        if fenced:
            continue
        if heading := re.match(r"#+ +(.*)", line):
            places.add(re.sub(r"[^\w\- ]", "", heading[1].lower()).replace(" ", "-"))
        places.update(re.findall(r'<a id="([\w-]+)"></a>', line))
        links += [(number, target) for target in re.findall(r"\]\(([^()\s]+)\)", re.sub(r"`[^`]*`", "", line))]
    return links, places


def broken(path, read):
    for number, link in read(path)[0]:
        url = urlsplit(link)
        if url.scheme or url.netloc:
            continue
        target = (path.parent / unquote(url.path)).resolve() if url.path else path
        if not target.exists():
            yield f"{path}:{number}: {link}: there is no {target.name}"
        elif target.suffix == path.suffix and unquote(url.fragment) not in read(target)[1] | DOXYGENS_OWN | {""}:
            yield f"{path}:{number}: {link}: {target.name} has no place of that name"


def main(arguments):
    pages = [(page, html) for folder in arguments if folder.is_dir() for page in sorted(folder.rglob("*.html"))]
    pages += [(page, markdown) for page in arguments if page.suffix == ".md"]
    faults = [fault for page, read in pages for fault in broken(page.resolve(), read)]
    print(*faults, f"{len(pages)} pages, {sum(len(read(page)[0]) for page, read in pages)} links, {len(faults)} broken", sep="\n")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main([Path(argument).resolve() for argument in sys.argv[1:]]))
