"""The page of showcases as a reader has it, in Debian's Chromium: test_page.py PAGE.html FOLDER

The tests evaluate screenshots, which stay in FOLDER.
"""

import io
import json
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import browser  # noqa: E402

WIDTH, HEIGHT = 640, 420


class Page(unittest.TestCase):
    path = folder = opened = None

    @classmethod
    def setUpClass(cls):
        from PIL import Image, ImageChops
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.actions.action_builder import ActionBuilder
        from selenium.webdriver.common.actions.interaction import POINTER_TOUCH
        from selenium.webdriver.common.actions.pointer_input import PointerInput
        from selenium.webdriver.common.by import By
        from selenium.webdriver.common.keys import Keys
        cls.Image, cls.Chops, cls.Keys, cls.By = Image, ImageChops, Keys, By
        cls.Actions = ActionChains
        cls.touch = staticmethod(lambda: ActionBuilder(cls.opened, mouse=PointerInput(POINTER_TOUCH, "finger")))
        cls.opened.get(browser.url(cls.path))
        browser.drawn(cls.opened)
        described = cls.opened.execute_script("return document.getElementById('described').textContent")
        cls.showcases = {showcase["id"]: showcase for showcase in json.loads(described)}

    def element(self, name):
        return self.opened.find_element(self.By.ID, name)

    def seen(self, name):
        """The stage as it is drawn now."""
        browser.drawn(self.opened)
        picture = self.Image.open(io.BytesIO(self.opened.get_screenshot_as_png())).convert("RGB")
        box = self.opened.execute_script("const r = document.getElementById('stage').getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]")
        picture = picture.crop([round(edge) for edge in box])
        picture.save(self.folder / f"{name}.png")
        return picture

    def empty(self):
        """The stage without the drawing on the canvas."""
        self.opened.execute_script("document.getElementById('canvas').style.visibility = 'hidden'")
        picture = self.seen("empty")
        self.opened.execute_script("document.getElementById('canvas').style.visibility = ''")
        return picture

    def share(self, a, b, box=None):
        """The share of pixels that are clearly different."""
        if box:
            a, b = a.crop(box), b.crop(box)
        different = self.Chops.difference(a, b).convert("L").point(lambda level: 255 if level > 12 else 0)
        return different.histogram()[255] / (different.width * different.height)

    def show(self, address):
        # Nothing has the focus, whose outline would be in the picture.
        self.opened.execute_script("document.activeElement.blur()")
        browser.go(self.opened, address + "&theme=light")

    def test_each_showcase_is_seen_and_its_slider_moves(self):
        self.assertGreaterEqual(len(self.showcases), 1)
        for name in self.showcases:
            with self.subTest(showcase=name):
                self.show(f"show={name}")
                half, empty = self.seen(f"{name}-half"), self.empty()
                width, height = half.size
                for box in ((0, 0, width // 2, height), (width // 2, 0, width, height)):
                    self.assertGreater(self.share(half, empty, box), 0.05, "no mesh on this side")
                self.assertGreater(len(half.resize((width // 4, height // 4)).getcolors(1 << 20)), 200, "flat colours: no light")
                slider = self.element("slider")
                slider.send_keys(self.Keys.END)
                left = self.seen(f"{name}-left")
                slider.send_keys(self.Keys.HOME)
                right = self.seen(f"{name}-right")
                self.assertGreater(self.share(left, right), 0.004, "the slider changes nothing")
                # The left state is shown left of the line, the right state right of it; names are above.
                inner = (10, 60, width // 2 - 4, height - 10), (width // 2 + 4, 60, width - 10, height - 10)
                self.assertLess(self.share(half, left, inner[0]), 0.001)
                self.assertLess(self.share(half, right, inner[1]), 0.001)

    def test_slider_moves_by_mouse(self):
        self.show("show=stitch")
        before = self.seen("mouse-before")
        slider = self.element("slider")
        self.Actions(self.opened).drag_and_drop_by_offset(slider, round(0.3 * slider.size["width"]), 0).perform()
        self.assertAlmostEqual(int(slider.get_attribute("value")), 800, delta=40)
        self.assertGreater(self.share(before, self.seen("mouse-after")), 0.002)

    def test_wireframe(self):
        self.show("show=stitch")
        before = self.seen("wire-off")
        self.element("wire").click()
        self.assertGreater(self.share(before, self.seen("wire-on")), 0.02)
        self.element("wire").click()
        self.assertLess(self.share(before, self.seen("wire-off-again")), 0.0005)

    def test_distances_and_their_legend(self):
        measured = [name for name, showcase in self.showcases.items() if "distance" in showcase]
        self.assertTrue(measured)
        for name in measured:
            self.show(f"show={name}&slider=0")
            before = self.seen(f"{name}-plain")
            self.assertFalse(self.element("legend").is_displayed())
            self.element("measured").click()
            after = self.seen(f"{name}-distances")
            self.assertTrue(self.element("legend").is_displayed())
            ticks = [float(tick.text) for tick in self.element("legend-ticks").find_elements(self.By.TAG_NAME, "span")]
            self.assertEqual(ticks, sorted(ticks))
            self.assertAlmostEqual(ticks[-1], self.showcases[name]["distance"]["shown"], delta=0.06 * ticks[-1])
            self.assertIn(self.showcases[name]["distance"]["unit"], self.element("legend-title").text)
            # Away from the legend, which is at the lower left.
            width, height = before.size
            self.assertGreater(self.share(before, after, (width // 2, 0, width, height)), 0.005)
        for name in self.showcases.keys() - set(measured):
            self.show(f"show={name}&distance=1")
            self.assertFalse(self.element("measured").is_displayed())
            self.assertFalse(self.element("legend").is_displayed())

    def test_turns_by_mouse_touch_and_keys(self):
        canvas = self.element("canvas")
        self.show("show=stitch&slider=0")
        start = self.seen("turn-start")
        self.Actions(self.opened).drag_and_drop_by_offset(canvas, 120, 40).perform()
        by_mouse = self.seen("turn-mouse")
        self.assertGreater(self.share(start, by_mouse), 0.02)
        touch = self.touch()
        touch.pointer_action.move_to(canvas).pointer_down().move_to(canvas, -120, -30).pointer_up()
        touch.perform()
        by_touch = self.seen("turn-touch")
        self.assertGreater(self.share(by_mouse, by_touch), 0.02)
        for keys in (self.Keys.ARROW_LEFT * 4, self.Keys.ARROW_UP * 3, "++"):
            before = self.seen("turn-before-keys")
            canvas.send_keys(keys)
            self.assertGreater(self.share(before, self.seen("turn-keys")), 0.01, repr(keys))
        canvas.send_keys("0")
        # Except the outline of the focused element.
        self.assertLess(self.share(start, self.seen("turn-back"), (10, 10, start.width - 10, start.height - 10)), 0.0005)

    def test_close_up_and_side_by_side(self):
        self.show("show=holes")
        whole = self.seen("look-whole")
        self.element("side").click()
        both = self.seen("look-side")
        self.assertFalse(self.element("slider").is_enabled())
        empty = self.empty()
        width, height = both.size
        for box in ((0, 0, width // 2, height), (width // 2, 0, width, height)):
            self.assertGreater(self.share(both, empty, box), 0.05)
        self.assertGreater(self.share(whole, both), 0.05)
        for name, showcase in self.showcases.items():
            self.show(f"show={name}")
            self.assertEqual(self.element("near").is_displayed(), "near" in showcase)

    def test_all_controls_are_reached_by_keyboard(self):
        self.show("show=stitch")
        self.opened.execute_script("document.activeElement.blur()")
        reached = set()
        for _ in range(20):
            self.Actions(self.opened).send_keys(self.Keys.TAB).perform()
            reached.add(self.opened.execute_script("return document.activeElement.id"))
        self.assertLessEqual({"canvas", "slider", "pairs", "side", "wire", "whole", "theme"} | {f"show={name}" for name in self.showcases}, reached)

    def test_a_link_shows_its_showcase(self):
        for name, showcase in self.showcases.items():
            self.element(f"show={name}").click()
            self.seen(f"link-{name}")
            self.assertEqual(self.element("text").text, showcase["text"])
            # The description of the two compared states.
            states = [showcase["states"][k] for k in showcase["pairs"][0]]
            told = [line for state in states if "note" in state for line in (state["name"], state["note"])]
            self.assertEqual(self.element("notes").text.split("\n") if told else [], told)

    def test_dark_and_light(self):
        for scheme, is_dark in (("dark", True), ("light", False)):
            media = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
            self.opened.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
            picture = self.seen(f"theme-{scheme}")
            corner = sum(picture.getpixel((picture.width - 12, picture.height - 12))) / 3
            self.assertEqual(corner < 100, is_dark, f"{scheme}: {corner}")
        self.element("theme").click()
        self.assertLess(sum(self.seen("theme-toggled").getpixel((picture.width - 12, picture.height - 12))) / 3, 100)
        self.opened.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_zz_asks_for_nothing_and_complains_of_nothing(self):
        self.assertEqual(self.opened.execute_script("return performance.getEntriesByType('resource').map((e) => e.name).filter((n) => !n.startsWith('blob:'))"), [])
        self.assertEqual(browser.complaints(self.opened), [])


if __name__ == "__main__":
    Page.path, Page.folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    Page.folder.mkdir(parents=True, exist_ok=True)
    try:
        import PIL  # noqa: F401
        with browser.chromium(WIDTH, HEIGHT) as Page.opened:
            unittest.main(argv=sys.argv[:1], verbosity=2)
    except (browser.Missing, ImportError) as missing:
        print(f"SKIPPED: {missing}; apt-get install chromium chromium-driver python3-selenium python3-pil")
        sys.exit(0)
