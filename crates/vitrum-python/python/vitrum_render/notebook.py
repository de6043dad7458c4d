"""Pictures that are turned by hand, in a notebook."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .viewer import Viewer


def view(data: Any = None, spacing: Any = None, **look: Any) -> Viewer:
    """A widget that shows data: dragging turns the camera, with Shift the light; the wheel comes nearer; sliders and a menu change the look.

    The kernel's process renders: small pictures while something moves, and the whole one at rest. Arrow keys turn, ``+`` and ``-`` come nearer and go away,
    and ``0`` goes back to the first view.

    Parameters
    ----------
    data, spacing, **look
        As :class:`vitrum_render.Session` takes them; ``size`` is that of the whole picture, (width, height), (640, 480) without it.

    Returns
    -------
    Viewer
        ``viewer.scene`` is the scene as shown, ``viewer.picture`` the last whole picture, ``viewer.snapshot()`` makes one; ``viewer.close()`` ends it.

    Raises
    ------
    ImportError
        Where anywidget is not installed.
    InvalidValue, SceneError, FileError, DeviceError
        As :class:`vitrum_render.Session`.
    """
    try:
        import anywidget  # noqa: F401
    except ImportError:
        raise ImportError("the widget needs the package anywidget: `pip install vitrum-render[notebook]`") from None
    from .viewer import Viewer

    return Viewer(data, spacing, **look)
