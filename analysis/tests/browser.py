"""A headless Chromium over the WebDriver protocol, with the standard library alone."""

import base64
import json
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.request

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--hide-scrollbars"]


def available():
    return bool(shutil.which("chromedriver") and shutil.which("chromium"))


def _free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Browser:
    """Use as a context: `with Browser() as browser`."""

    def __enter__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        port = _free_port()
        self.address = f"http://127.0.0.1:{port}"
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        try:
            self._wait()
            self.session = self._start()
        except BaseException:
            self._stop_driver()
            raise
        return self

    def __exit__(self, *_):
        try:
            self._call("DELETE", f"/session/{self.session}")
        finally:
            self._stop_driver()

    def _stop_driver(self):
        self.driver.terminate()
        self.driver.wait(10)
        self.profile.cleanup()

    def _wait(self):
        for _ in range(100):
            try:
                return self._call("GET", "/status")
            except OSError:
                time.sleep(0.1)
        raise TimeoutError("chromedriver does not answer")

    def _start(self):
        flags = FLAGS + [f"--user-data-dir={self.profile.name}"]
        options = {"args": flags, "binary": shutil.which("chromium")}
        wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        return self._call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        direct = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"},
                                         method=method)
        with direct.open(request, timeout=60) as answer:
            return json.load(answer)["value"]

    def _session(self, path, body):
        return self._call("POST", f"/session/{self.session}{path}", body)

    def _devtools(self, command, **parameters):
        return self._session("/goog/cdp/execute", {"cmd": command, "params": parameters})

    def resize(self, width, height):
        self._devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                       mobile=width < 600)

    def colours(self, scheme):
        """`scheme`: "light" or "dark"."""
        self._devtools("Emulation.setEmulatedMedia",
                       features=[{"name": "prefers-color-scheme", "value": scheme}])

    def open(self, path):
        self._session("/url", {"url": path.resolve().as_uri()})

    def click(self, selector):
        """A click of the mouse, refused where something else covers the element."""
        found = self._session("/element", {"using": "css selector", "value": selector})
        self._session(f"/element/{next(iter(found.values()))}/click", {})

    def press(self, key):
        """`key`: one character, or a code of the WebDriver protocol for a key that writes none."""
        strokes = [{"type": "keyDown", "value": key}, {"type": "keyUp", "value": key}]
        self._session("/actions", {"actions": [{"type": "key", "id": "keyboard", "actions": strokes}]})

    def evaluate(self, script):
        return self._session("/execute/sync", {"script": script, "args": []})

    def complaints(self):
        """What the console said since the last call."""
        return [entry["message"] for entry in self._session("/se/log", {"type": "browser"})]

    def screenshot(self, path, whole=True):
        shot = self._devtools("Page.captureScreenshot", captureBeyondViewport=whole)
        path.write_bytes(base64.b64decode(shot["data"]))
