"""Tables of project files, typed or out of a CSV file."""
import csv
import re

from units import exact, factor


def table(given, folder):
    """Rows as maps from key to text or value in SI, without empty cells; the unit of a column stands in its head."""
    if given is None:
        return []
    if "csv" in given:
        lines = [line for line in (folder / given["csv"]).read_text().splitlines() if line and not line.startswith("#")]
        columns, *listed = csv.reader(lines)
        columns = [given.get("columns", {}).get(column, column) for column in columns]
    else:
        columns, listed = given["columns"], given["rows"]
    heads = [re.fullmatch(r"([^\[]*?)\s*(?:\[(.*)\])?", column).groups() for column in columns]
    return [{key: exact(cell) * factor(unit) if unit else cell for (key, unit), cell in zip(heads, row) if cell not in (None, "")} for row in listed]
