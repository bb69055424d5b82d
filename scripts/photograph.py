"""Takes pictures of a page of scripts/page.py: photograph.py PAGE.html WIDTH HEIGHT {PICTURE ADDRESS}...

PICTURE ends in .png or .jpg. ADDRESS is what comes after # (examples/page/page.js has the words). Exit status 3: no browser is
available.
"""

import base64
import pathlib
import sys

import browser


def photograph(page, width, height, pictures):
    with browser.chromium(width, height) as opened:
        opened.get(browser.url(page))
        browser.drawn(opened)
        for picture, address in pictures:
            browser.go(opened, address)
            form = {"format": "jpeg", "quality": 88} if picture.endswith(".jpg") else {"format": "png"}
            taken = opened.execute_cdp_cmd("Page.captureScreenshot", form)
            pathlib.Path(picture).write_bytes(base64.b64decode(taken["data"]))
            print(f"  {picture}")


if __name__ == "__main__":
    if len(sys.argv) < 6 or len(sys.argv) % 2 == 1:
        sys.exit(__doc__)
    try:
        photograph(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), list(zip(sys.argv[4::2], sys.argv[5::2])))
    except browser.Missing as missing:
        print(f"gusset: no pictures: {missing}", file=sys.stderr)
        sys.exit(3)
