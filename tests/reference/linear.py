"""Linear least squares by normal equations, and its simplest case, a mean."""
import mpmath as mp


def fitted(design, y):
    """(solution, its derivatives with respect to y, standard deviation of the residuals, degrees of freedom)"""
    gain = (design.T * design) ** -1 * design.T
    solution = gain * mp.matrix(y)
    nu = mp.mpf(design.rows - design.cols)
    return solution, gain, mp.norm(mp.matrix(y) - design * solution) / mp.sqrt(nu), nu


def scatter(values):
    """Mean and experimental standard deviation."""
    n = len(values)
    mean = mp.fsum(values) / n
    return mean, mp.sqrt(mp.fsum((x - mean) ** 2 for x in values) / (n - 1)) if n > 1 else mp.mpf(0)
