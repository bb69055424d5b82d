"""The peers in Python. A peer is imported at its first use, so that a process with one contender does not load others. A missing
peer fails with a plain message in every case."""

import importlib


class Peer:
    """A module that is imported at its first use."""

    def __init__(self, module, after=None):
        self._module, self._after = module, after

    def __getattr__(self, name):
        try:
            if self._after:
                importlib.import_module(self._after)
            module = importlib.import_module(self._module)
        except Exception as error:  # A wheel may also fail to load.
            raise ModuleNotFoundError(f"{(self._after or self._module).split('.')[0]} is not installed: {error}") from error
        return getattr(module, name)
