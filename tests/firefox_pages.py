"""Firefox for the viewer's tests, driven over its own Marionette protocol; a skip says what is missing.

Firefox draws WebGL without a graphics card only under an X server (Xvfb will do) and with Mesa's software
drivers; headless it has none.  `Firefox` starts both kinds.
"""

import json
import os
import shutil
import signal
import socket
import subprocess
import time

import pytest

PREFERENCES = {
    "app.update.enabled": False,
    "browser.shell.checkDefaultBrowser": False,
    "browser.startup.homepage_override.mstone": "ignore",
    "datareporting.policy.dataSubmissionEnabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
    "toolkit.telemetry.enabled": False,
    "webgl.force-enabled": True,
}


def firefox_path():
    found = next((path for name in ("firefox-esr", "firefox") if (path := shutil.which(name))), None)
    if found is None:
        pytest.skip("no Firefox is installed")
    return found


class Firefox:
    """One page in Firefox: the mouse, scripts, and what its console said."""

    def __init__(self, folder, headless):
        command = [firefox_path(), "--marionette", "--no-remote", "--profile", str(folder)]
        if headless:
            command.append("--headless")
        elif shutil.which("xvfb-run") is None:
            pytest.skip("no xvfb-run is installed: Firefox has WebGL under an X server only")
        else:
            command = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", *command]
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        preferences = {**PREFERENCES, "marionette.port": port}
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items()]
        folder.joinpath("user.js").write_text("".join(lines))
        environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "HOME": str(folder)}
        with folder.joinpath("output.txt").open("w") as output:
            self.process = subprocess.Popen(
                command, env=environment, stdout=output, stderr=subprocess.STDOUT, start_new_session=True
            )
        self.output = folder / "output.txt"
        try:
            self.connection = self._connected(port)
            self.left, self.sent = b"", 0
            self._received()  # the greeting
            self._ask("WebDriver:NewSession", capabilities={})
            self._ask("WebDriver:SetWindowRect", x=0, y=0, width=1300, height=880)
        except BaseException:
            self.close()
            raise

    def open(self, path, fragment=""):
        self._ask("WebDriver:Navigate", url=path.resolve().as_uri() + fragment)
        self.until("page.usdrigui !== undefined")

    def script(self, expression):
        """Value of a JavaScript expression in the page; `page` is its window."""
        text = f"const page = window.wrappedJSObject ?? window; return JSON.stringify({expression});"
        value = self._ask("WebDriver:ExecuteScript", script=text, args=[])["value"]
        return None if value is None else json.loads(value)

    def until(self, expression, seconds=60.0):
        end = time.monotonic() + seconds
        while not self.script(expression):
            assert time.monotonic() < end, f"still not so: {expression}"
            time.sleep(0.05)

    def drag(self, start, end, steps=8):
        """A real mouse, pressed at `start` and released at `end`, pixels of the window."""
        way = [[a + k / steps * (b - a) for a, b in zip(start, end, strict=True)] for k in range(steps + 1)]
        first, *moves = [{"type": "pointerMove", "duration": 40, "x": round(x), "y": round(y)} for x, y in way]
        press, release = {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}
        hand = {"type": "pointer", "id": "hand", "parameters": {"pointerType": "mouse"}}
        self._ask("WebDriver:PerformActions", actions=[{**hand, "actions": [first, press, *moves, release]}])
        time.sleep(0.1)

    def complaints(self):
        """Lines that the page's scripts left on the console of errors."""
        lines = self.output.read_text(errors="replace").splitlines()
        return [line for line in lines if "JavaScript error" in line and ".html" in line]

    def close(self):
        for kind in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(self.process.pid, kind)
                self.process.wait(15)
            except (ProcessLookupError, subprocess.TimeoutExpired):
                continue
            break

    # --- Marionette: length, colon, JSON ------------------------------------------------------------

    def _connected(self, port, seconds=60.0):
        end = time.monotonic() + seconds
        while True:
            try:
                found = socket.create_connection(("127.0.0.1", port), 5)
                found.settimeout(120)
                return found
            except OSError:
                assert self.process.poll() is None, self.output.read_text(errors="replace")
                assert time.monotonic() < end, "Firefox does not listen"
                time.sleep(0.2)

    def _ask(self, name, **parameters):
        self.sent += 1
        text = json.dumps([0, self.sent, name, parameters]).encode()
        self.connection.sendall(b"%d:%s" % (len(text), text))
        _, _, error, result = self._received()
        assert error is None, error
        return result

    def _received(self):
        while b":" not in self.left:
            self._read()
        size, _, self.left = self.left.partition(b":")
        while len(self.left) < int(size):
            self._read()
        text, self.left = self.left[: int(size)], self.left[int(size) :]
        return json.loads(text)

    def _read(self):
        more = self.connection.recv(1 << 20)
        assert more, "Firefox has gone"
        self.left += more
