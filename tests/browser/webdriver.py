"""Headless Chromium over the W3C WebDriver protocol, with the Python standard library only."""

import base64
import http.client
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time

CHROMEDRIVER = "/usr/bin/chromedriver"
START_S = 60
REPLY_S = 60


class BrowserError(Exception):
    pass


def _free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Browser:
    """A context manager. On exit it stops the driver and the browser by their process group."""

    def __init__(self):
        if not os.access(CHROMEDRIVER, os.X_OK):
            raise BrowserError(f"{CHROMEDRIVER} is missing: install the package chromium-driver")
        self._folder = tempfile.mkdtemp(prefix="gsbench-browser-")
        self._port = _free_port()
        self._session = None
        # In its own session: the browser joins the same process group and is stopped with it.
        self._driver = subprocess.Popen(
            [CHROMEDRIVER, f"--port={self._port}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True)

    def __enter__(self):
        try:
            self._wait_until_ready()
            self._start_session()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        try:
            if self._session:
                self._call("DELETE", "")
        except (BrowserError, OSError):
            pass  # the driver is killed below in any case
        finally:
            try:
                os.killpg(self._driver.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self._driver.wait()
            shutil.rmtree(self._folder, ignore_errors=True)

    def _wait_until_ready(self):
        give_up = time.monotonic() + START_S
        while True:
            if self._driver.poll() is not None:
                raise BrowserError(f"chromedriver ended with {self._driver.returncode}")
            try:
                if self._request("GET", "/status")["ready"]:
                    return
            except OSError:
                pass
            if time.monotonic() > give_up:
                raise BrowserError(f"chromedriver is not ready after {START_S} s")
            time.sleep(0.05)

    def _start_session(self):
        arguments = [
            "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync",
            "--disable-dev-shm-usage", "--hide-scrollbars", "--window-size=1280,900",
            f"--user-data-dir={self._folder}"]
        reply = self._request("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome",
            "goog:loggingPrefs": {"browser": "ALL"},
            "goog:chromeOptions": {"args": arguments}}}})
        self._session = reply["sessionId"]

    def _request(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self._port, timeout=REPLY_S)
        try:
            text = None if method in ("GET", "DELETE") else json.dumps(body or {})
            connection.request(method, path, text, {"Content-Type": "application/json"})
            value = json.loads(connection.getresponse().read())["value"]
        except (ValueError, KeyError, http.client.HTTPException) as error:
            raise BrowserError(f"{method} {path}: {error!r}") from error
        finally:
            connection.close()
        if isinstance(value, dict) and "error" in value:
            raise BrowserError(f"{method} {path}: {value['error']}: {value['message']}")
        return value

    def _call(self, method, path, body=None):
        return self._request(method, f"/session/{self._session}{path}", body)

    def devtools(self, command, **parameters):
        return self._call("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, path):
        self._call("POST", "/url", {"url": "file://" + os.path.abspath(path)})

    def run(self, script, *arguments):
        """Runs a JavaScript function body and returns its value."""
        return self._call("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def set_width(self, width, height=900):
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height,
                      deviceScaleFactor=1, mobile=False)

    def set_dark(self, dark):
        self.devtools("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def drag(self, from_x, from_y, to_x, to_y):
        def move(x, y):
            return {"type": "pointerMove", "duration": 50, "x": int(x), "y": int(y)}
        self._call("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
            "actions": [move(from_x, from_y), {"type": "pointerDown", "button": 0},
                        move((from_x + to_x) / 2, to_y), move(to_x, to_y),
                        {"type": "pointerUp", "button": 0}]}]})

    def double_click(self, x, y):
        press = [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
        self._call("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
            "actions": [{"type": "pointerMove", "duration": 0, "x": int(x), "y": int(y)},
                        *press, *press]}]})

    def console(self):
        """The messages that the page has written to the console since the last call."""
        return self._call("POST", "/se/log", {"type": "browser"})

    def screenshot(self, path, whole_page=False):
        picture = self.devtools("Page.captureScreenshot", format="png",
                                captureBeyondViewport=whole_page)
        with open(path, "wb") as file:
            file.write(base64.b64decode(picture["data"]))

    def print_a4(self, path):
        paper = self._call("POST", "/print", {
            "page": {"width": 21.0, "height": 29.7},
            "margin": {"top": 1.5, "bottom": 1.8, "left": 1.3, "right": 1.3},
            "background": False, "shrinkToFit": False})
        with open(path, "wb") as file:
            file.write(base64.b64decode(paper))
