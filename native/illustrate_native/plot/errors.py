"""What stops a plot."""


class PlotError(ValueError):
    """The plot cannot be made: the message names what is wrong and the way out."""
