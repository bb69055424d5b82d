"""Debian's Chromium without a window, which draws by software and asks nobody for anything."""

import contextlib
import json
import pathlib
import shutil
import tempfile
import time


class Missing(Exception):
    """No browser or driver is available."""


@contextlib.contextmanager
def chromium(width, height):
    """A selenium driver with pages of this size."""
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError as error:
        raise Missing(f"no selenium ({error}): Debian's package python3-selenium has it, for /usr/bin/python3") from error
    browser, driver = shutil.which("chromium"), shutil.which("chromedriver")
    if not browser or not driver:
        raise Missing("no " + ("chromedriver" if browser else "chromium"))
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    with tempfile.TemporaryDirectory() as profile:
        for argument in (
            "headless=new", "no-sandbox", "disable-dev-shm-usage", "use-angle=swiftshader", "enable-unsafe-swiftshader", "disable-quic",
            "no-first-run", "disable-background-networking", "disable-component-update", "disable-sync", "disable-extensions",
            "hide-scrollbars", f"user-data-dir={profile}",
        ):
            options.add_argument("--" + argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        opened = webdriver.Chrome(service=Service(driver), options=options)
        try:
            size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
            opened.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
            opened.set_script_timeout(180)
            yield opened
        finally:
            opened.quit()


def wait(opened, condition, seconds=60):
    """Until an expression of the page's is true."""
    end = time.monotonic() + seconds
    while not (value := opened.execute_script(f"return {condition}")):
        if time.monotonic() > end:
            raise TimeoutError(condition)
        time.sleep(0.02)
    return value


def drawn(opened):
    """Until the page has drawn, and nothing is left to draw."""
    wait(opened, "document.documentElement.dataset.drawn || document.documentElement.dataset.failed")
    failed = opened.execute_script("return document.documentElement.dataset.failed")
    if failed:
        raise RuntimeError(failed)
    before = None
    while before != (now := opened.execute_script("return document.documentElement.dataset.drawn")):
        before = now
        opened.execute_async_script("requestAnimationFrame(() => requestAnimationFrame(arguments[0]))")


def go(opened, address):
    """Sets the part of the address after #, and waits for the picture."""
    opened.execute_script("location.hash = arguments[0]", address)
    drawn(opened)


def url(path):
    return pathlib.Path(path).resolve().as_uri()


def complaints(opened):
    """The errors that the page or the browser logged."""
    return [json.dumps(entry) for entry in opened.get_log("browser") if entry["level"] in ("SEVERE", "WARNING")]
