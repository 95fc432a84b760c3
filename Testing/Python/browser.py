# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a window, driven through chromedriver by the protocol of WebDriver, which is JSON over HTTP."""

import base64
import json
import re
import shutil
import subprocess
import tempfile
import urllib.request

PROGRAMS = ("chromium", "chromedriver")
# As root there is no sandbox; the network is left alone; WebGL is drawn by the processor.
ARGUMENTS = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-component-update",
             "--disable-background-networking", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--window-size=1200,1000")


def missing():
    """The programs that are not installed."""
    return [name for name in PROGRAMS if shutil.which(name) is None]


class Browser:
    """A context, with a profile of its own; with arguments besides the usual ones."""

    def __init__(self, *arguments):
        self._arguments = [*ARGUMENTS, *arguments]

    def __enter__(self):
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True)
        try:
            line = next(line for line in self._driver.stdout if "started successfully on port" in line)
            self._address = "http://127.0.0.1:%s/session" % re.search(r"port (\d+)", line).group(1)
            options = {"binary": shutil.which("chromium"), "args": [*self._arguments, "--user-data-dir=" + self._profile.name]}
            self._address += "/" + self.ask("", capabilities={"alwaysMatch": {
                "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}})["sessionId"]
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_):
        try:
            self.ask("", method="DELETE")
        finally:
            self._end()

    def _end(self):
        self._driver.terminate()
        self._driver.wait()
        self._driver.stdout.close()
        self._profile.cleanup()

    def ask(self, path, method="POST", **body):
        request = urllib.request.Request(self._address + path, method=method,
                                         data=json.dumps(body).encode() if method == "POST" else None)
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request, timeout=60) as answer:
            return json.load(answer)["value"]

    def open(self, path):
        self.ask("/url", url=path.resolve().as_uri())

    def run(self, script, *arguments):
        """What JavaScript returns."""
        return self.ask("/execute/sync", script=script, args=list(arguments))

    def wait(self, script, *arguments):
        """The same of a script that calls its last argument with what it returns."""
        return self.ask("/execute/async", script=script, args=list(arguments))

    def command(self, name, **parameters):
        """One of Chromium's own."""
        return self.ask("/goog/cdp/execute", cmd=name, params=parameters)

    def messages(self):
        """What the console says since the last call: errors and warnings of the page, none of the graphics driver."""
        entries = self.ask("/se/log", type="browser")
        return [entry["message"] for entry in entries if "GL Driver Message" not in entry["message"]]

    def picture(self, selector):
        """An element, as it looks, as the bytes of a PNG file."""
        element = self.ask("/element", using="css selector", value=selector)
        return base64.b64decode(self.ask("/element/%s/screenshot" % next(iter(element.values())), method="GET"))
