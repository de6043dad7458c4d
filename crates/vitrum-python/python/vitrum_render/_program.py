"""The program ``vitrum``, which the package brings along."""

import sys


def main() -> None:
    """Runs the program with the words of the command line."""
    from ._native import main as run

    # The program hears of Ctrl-C itself.
    import signal

    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(run(["vitrum", *sys.argv[1:]]))
