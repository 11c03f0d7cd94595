"""Which tests a run takes: the quick suite before every change, the slow one beside it, in CI a sample of that too.

Slow is what drives a browser, Blender or another program, a real rig, a kill, a sweep of damaged files or a long
search.  A test says so by the marker `slow`, by the marker `real`, or by a fixture of `PROGRAMS`.
"""

SUITES = ("quick", "slow", "sample", "all")
PROGRAMS = {"playwright", "firefox", "bpy_python", "run_inside", "window"}
"""Fixtures that start a browser or Blender."""


def is_slow(item):
    """Whether the collected test belongs to the second suite."""
    marked = any(item.get_closest_marker(name) for name in ("slow", "real"))
    return marked or not PROGRAMS.isdisjoint(item.fixturenames)


def taken(items, suite):
    """Those of the collected tests that the suite takes, in their order.

    `sample` is the quick suite and the first slow test of every file: the same ones every time, one meeting with every
    program.  Real rigs, which a checkout has not, are left to the second suite.
    """
    if suite in ("all", "slow"):
        return [each for each in items if suite == "all" or is_slow(each)]
    met = [each for each in items if suite == "sample" and is_slow(each) and not each.get_closest_marker("real")]
    first = {each.path: each for each in reversed(met)}
    return [each for each in items if not is_slow(each) or first.get(each.path) is each]
