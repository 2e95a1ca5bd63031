"""Networks with what instruments do to all of their readings alike, both faces, instruments that lean, the curvature of the Earth and correlated readings."""
import mpmath as mp

from book import Book
from plane_and_space import EVALUATED, Net

INDEX, COLLIMATION, ZERO, SCALE = 0.0021, -0.0014, 1.3, 9e-6  # gon, mm


class Faces(Net):
    """Readings by instrument T, in one face or the other."""

    def __init__(self, seed, fall):
        super().__init__(seed)
        self.further, self.marks, self.fall = {}, [], fall

    def read(self, kind, a, b, u, face="one", label=None):
        super().read(kind, a, b, u)
        row, (dx, dy, dz) = self.rows[-1], self.delta(a, b)
        sign = 1 if face == "one" else -1
        if kind == "slope-distance":
            row[3] = round(row[3] * (1 + SCALE) + ZERO / 1000, 5)
        elif kind == "zenith-angle":
            level = mp.hypot(dx, dy)
            row[4] = round(float(row[4] + sign * INDEX + self.fall * level ** 3 / (level ** 2 + dz ** 2) * 200 / mp.pi), 5)
            row[4] = row[4] if face == "one" else round(400 - row[4], 5)
        elif kind == "direction":
            row[4] = round((row[4] + sign * COLLIMATION / mp.sin(mp.atan2(mp.hypot(dx, dy), dz)) + (0 if face == "one" else 200)) % 400, 5)
            row[4] = float(row[4])
        self.marks.append(["T", face if kind in ("direction", "zenith-angle") else None, label])
        return self

    def setup(self):
        made = super().setup()
        made["readings"]["columns"] += ["instrument", "face", "label"]
        made["readings"]["rows"] = [row + marks for row, marks in zip(made["readings"]["rows"], self.marks)]
        return made | self.further

    def figures(self, *rows):
        self.further["figures"] = {"columns": ["instrument", "figure", "knowledge", "length [mm]", "u_length [mm]", "ratio [ppm]", "u_ratio [ppm]", "angle [gon]", "u_angle [gon]"],
                                   "rows": [["T", *row] for row in rows]}
        return self

    def leaning(self, *rows):
        self.further["stations"] = {"columns": ["point", "tilt", "u_tilt [gon]"], "rows": [list(row) for row in rows]}
        return self


def station(seed, size=1.0):
    net = Faces(seed, 0.85 / 2 / 6.371e6 if size > 1 else 0)
    for name, (x, y, z) in {"A": (0.0, 0.0, 1.2), "B": (24.0, 1.5, 4.4), "C": (20.0, 16.0, -2.1), "D": (-2.0, 14.0, 0.9)}.items():
        net.point(name, x * size, y * size, z * size, state="fixed")
    net.point("S", 9.431 * size, 7.125 * size, 1.5 * size).point("P", 15.22 * size, -3.71 * size, 3.4 * size)
    for target in "ABCDP":
        for face in ("one", "two"):
            net.read("direction", "S", target, 0.001, face).read("zenith-angle", "S", target, 0.0012, face)
        net.read("slope-distance", "S", target, 0.6, label=f"d{target}")
    return net


UNKNOWN = ["unknown", *[None] * 6]
EARTH = {"earth_radius": {"value": 6371, "unit": "km"}}


def main():
    book = Book("instruments-in-networks", "Networks with figures of instruments", "Simulated readings in both faces of an instrument that leans, is out of adjustment, or looks over the curvature of the Earth. Reference values of a second evaluator: see covaria verify.")
    cases = {}
    cases["Index and collimation from both faces"] = station("faces").figures(["index", *UNKNOWN], ["collimation", *UNKNOWN], ["zero", "fixed", ZERO, *[None] * 5], ["scale", "fixed", None, None, SCALE * 1e6, *[None] * 3])
    cases["Zero of distances unknown, scale, index and collimation stated"] = station("stated").figures(
        ["zero", *UNKNOWN], ["scale", "stated", None, None, 8, 2.5, None, None], ["index", "stated", *[None] * 4, 0.002, 0.0008], ["collimation", "stated", *[None] * 4, -0.001, 0.0009])
    cases["An instrument that leans"] = station("leans").figures(["index", *UNKNOWN], ["collimation", *UNKNOWN], ["zero", *UNKNOWN]).leaning(("S", "unknown", None))
    cases["An instrument levelled within u, correlated distances"] = station("levelled").figures(
        ["index", "fixed", *[None] * 4, INDEX, None], ["zero", *UNKNOWN], ["scale", "stated", None, None, 8, 2.5, None, None]).leaning(("S", "levelled", 0.002))
    cases["An instrument levelled within u, correlated distances"].further["correlations"] = {"columns": ["first", "second", "coefficient"], "rows": [["dA", "dB", 0.5], ["dB", "dC", -0.3], ["dD", "dP", 0.4]]}
    cases["Refraction unknown over 800 m"] = station("refraction", 40).figures(["refraction", *UNKNOWN], ["collimation", *UNKNOWN], ["index", *UNKNOWN], ["zero", *UNKNOWN])
    cases["Refraction stated over 400 m, an instrument that leans"] = station("curvature", 20).figures(
        ["refraction", "stated", None, None, 130000, 50000, None, None], ["collimation", *UNKNOWN], ["index", *UNKNOWN], ["zero", *UNKNOWN]).leaning(("S", "unknown", None))
    cases["Curvature of the Earth by a refraction coefficient without uncertainty"] = station("fixed refraction", 15).figures(["index", *UNKNOWN], ["collimation", *UNKNOWN], ["zero", *UNKNOWN], ["scale", *UNKNOWN])
    for number, (title, net) in enumerate(cases.items(), 1):
        if any(word in title for word in ("Refraction", "Curvature")):
            net.further |= EARTH
        entry = book.analysis(f"instrument-{number}", "network-adjustment", title, net.setup())
        units = {"c_T": "mm", "m_T": "ppm", "k_T": "1", "i_T": "arcsec", "q_T": "arcsec", "tilt_x_S": "gon", "tilt_y_S": "gon", "o_S": "gon", None: "m"}
        book.case(title, EVALUATED, entry, units, net.started(), None, ["JCGM 102:2011, 6.3"], draws=4)
    book.write("Instruments in networks: a second evaluator at 50 digits, made by tests/reference/cases/instruments_in_networks.py")


if __name__ == "__main__":
    main()
