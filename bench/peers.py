"""The peers in Python: what is imported if it is there. A peer that is absent fails with a plain message in every case."""

import importlib


class Missing:
    """Stands for a module that could not be imported."""

    def __init__(self, name, error):
        self._said = f"{name} is not installed: {error}"

    def __getattr__(self, _):
        raise ModuleNotFoundError(self._said)


def wanted(name):
    try:
        return importlib.import_module(name)
    except Exception as error:  # A wheel may also fail to load.
        return Missing(name.split(".")[0], error)
