"""The law of propagation of uncertainty (JCGM 100 5.1, 5.2, G.4) out of derivatives and components."""
import mpmath as mp

from statements import INFINITE


def uncertainty(gradient, inputs):
    """(u, effective degrees of freedom) of a result with these derivatives with respect to quantities."""
    parts = [gradient.get(symbol, mp.mpf(0)) * u for symbol, u, _ in inputs.components]
    variance = mp.fsum(p * p for p in parts)
    for (i, j), r in inputs.correlation.items():
        variance += 2 * r * parts[i] * parts[j]
    return mp.sqrt(variance) if variance > 0 else mp.mpf(0)


def effective_degrees_of_freedom(gradient, inputs):
    """Welch-Satterthwaite (G.2b), for independent components."""
    u = uncertainty(gradient, inputs)
    lower = mp.fsum((gradient.get(s, 0) * c) ** 4 / nu for s, c, nu in inputs.components if nu != INFINITE)
    return u ** 4 / lower if lower else INFINITE
