"""The exceptions of Vitrum. Each says what is wrong, and in ``advice`` what to do."""

from __future__ import annotations


class VitrumError(Exception):
    """The base of all exceptions of this package.

    Attributes
    ----------
    advice : str or None
        A sentence that says how to mend it.
    key : str or None
        The scene's key that is wrong, such as ``light.0.azimuth``.
    """

    def __init__(self, message: str, advice: str | None = None, key: str | None = None) -> None:
        super().__init__(message, advice, key)
        self.message = message
        self.advice = advice
        self.key = key

    def __str__(self) -> str:
        told = self.advice is None or self.advice in self.message
        return self.message if told else f"{self.message}; {self.advice}"


class InvalidValue(VitrumError, ValueError):
    """A value that cannot be used: an array, an argument, or data that makes no picture with its scene."""


class SceneError(InvalidValue, KeyError):
    """A scene's key that does not exist, or whose value is of the wrong type or out of its range."""


class FileError(VitrumError, OSError):
    """A file that cannot be read, is damaged, or cannot be written."""


class DeviceError(VitrumError, RuntimeError):
    """A device that cannot be opened, failed, or lacks the memory."""


class Cancelled(VitrumError):
    """Work that was given up."""
