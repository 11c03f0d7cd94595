"""Scripts of the project, which belong to no package, as modules."""

import importlib.util
import sys
from contextlib import contextmanager


@contextmanager
def loaded(path):
    """The module that a script is, known by its own name meanwhile."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = module
    try:
        spec.loader.exec_module(module)
        yield module
    finally:
        del sys.modules[path.stem]
