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
    """Welch-Satterthwaite (G.2b), for independent components; those of one estimate of variance count as one."""
    u = uncertainty(gradient, inputs)
    parts = {}
    for i, (symbol, c, nu) in enumerate(inputs.components):
        if nu != INFINITE:
            key = inputs.estimates.get(i, i), nu
            parts[key] = parts.get(key, 0) + (gradient.get(symbol, 0) * c) ** 2
    lower = mp.fsum(part ** 2 / nu for (_, nu), part in parts.items())
    return u ** 4 / lower if lower else INFINITE
