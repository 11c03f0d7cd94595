"""Prints each failure as it happens: a run that is cut, or fails late, would name none until its end."""

import pytest


def pytest_configure(config):
    config.pluginmanager.register(_FailuresAtOnce(config))


class _FailuresAtOnce:
    def __init__(self, config):
        self._config = config

    @pytest.hookimpl(trylast=True)
    def pytest_runtest_logreport(self, report):
        terminal = self._config.pluginmanager.get_plugin("terminalreporter")
        if report.failed and terminal is not None:
            terminal.ensure_newline()
            terminal.write_line(f"FAILED at {report.when}: {report.nodeid}", red=True)
            terminal.write_line(report.longreprtext)
