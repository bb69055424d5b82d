"""The peers in Python. One is imported when it is first used, so that who works alone has nobody else in memory; one that is absent
fails with a plain message in every case."""

import importlib


class Peer:
    """Stands for a module until something of it is asked for."""

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
