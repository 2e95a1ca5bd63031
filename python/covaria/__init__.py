"""Measurement uncertainty with Covaria's projects. All arrays are in SI units."""

from ._covaria import Analysis, Project, __version__, load

__all__ = ["Analysis", "Project", "Results", "load"]


class Results(dict):
    """The content of results.json, and under 'arrays' y, u, k, U and covariance of each analysis (SI)."""

    def __init__(self, content, html):
        super().__init__(content)
        self._html = html

    def __repr__(self):
        return "<covaria.Results of %s>" % ", ".join(repr(a["id"]) for a in self["analyses"])

    def _repr_html_(self):
        return self._html
