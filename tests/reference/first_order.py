"""The law of propagation of uncertainty (JCGM 100 5.1, 5.2, G.4) out of derivatives and components."""
import mpmath as mp

from dual import Dual


class Inputs:
    """Estimates, components (u, nu) and correlations between components."""

    def __init__(self):
        self.estimate, self.components, self.correlation = {}, [], {}
        self.known, self.estimates = set(), {}
        self.nu = None  # degrees of freedom of all results, where residuals decide them
        self.taken, self.origin = set(), {}  # analyses whose results are inputs, and the component there of a component here

    def add(self, symbol, u, nu=mp.inf):
        self.components.append((symbol, u, nu))
        return len(self.components) - 1

    def deviation(self, symbol, u, nu=mp.inf, estimate=None):
        """A deviation about zero as a dual; the same one where it is asked for again. Those of one `estimate` of variance share its nu."""
        if symbol not in self.known and u != 0:
            self.known.add(symbol)
            i = self.add(symbol, u, nu)
            if estimate is not None:
                self.estimates[i] = estimate
        return Dual(0, {symbol: mp.mpf(1)} if u != 0 else {})

    def of_symbol(self, symbol):
        return [i for i, (s, _, _) in enumerate(self.components) if s == symbol]

    def correlate(self, i, j, r):
        self.correlation[min(i, j), max(i, j)] = r


def uncertainty(gradient, inputs):
    """u of a result with these derivatives with respect to quantities."""
    parts = [gradient.get(symbol, mp.mpf(0)) * u for symbol, u, _ in inputs.components]
    variance = mp.fsum(p * p for p in parts)
    for (i, j), r in inputs.correlation.items():
        variance += 2 * r * parts[i] * parts[j]
    return mp.sqrt(variance) if variance > 0 else mp.mpf(0)


def effective_degrees_of_freedom(gradient, inputs):
    """Welch-Satterthwaite (G.2b), for independent components; those of one estimate of variance count as one."""
    u = uncertainty(gradient, inputs)
    parts = {}
    for i, (symbol, c, nu) in enumerate(inputs.components):
        if nu != mp.inf:
            key = inputs.estimates.get(i, i), nu
            parts[key] = parts.get(key, 0) + (gradient.get(symbol, 0) * c) ** 2
    lower = mp.fsum(part ** 2 / nu for (_, nu), part in parts.items())
    return u ** 4 / lower if lower else mp.inf
