"""The symbols of the lectures by numpy alone: what the notebooks compute by hand with.

The first notebook derives each of them and compares it with the module.
"""

import numpy as np


def tilde(a):
    """The 3 x 3 matrix with tilde(a) @ b = a x b."""
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def G(p):
    """G = [-e, ẽ + e0 I], 3 x 4."""
    return np.column_stack([-p[1:], tilde(p[1:]) + p[0] * np.eye(3)])


def L(p):
    """L = [-e, -ẽ + e0 I], 3 x 4."""
    return np.column_stack([-p[1:], -tilde(p[1:]) + p[0] * np.eye(3)])


def A(p):
    """The rotation matrix of slide 24, local to global."""
    e0, e = p[0], p[1:]
    return (2 * e0**2 - 1) * np.eye(3) + 2 * (np.outer(e, e) + e0 * tilde(e))


def bar(s_local):
    """The 4 x 4 matrix with Lᵀ s′ = bar(s′) p; its lower right block is -s̃′."""
    return np.block([[0.0, -s_local], [s_local[:, None], -tilde(s_local)]])


def close(one, other, tolerance=1e-12):
    """True if two arrays of numbers about 1 are equal up to rounding."""
    return np.allclose(one, other, rtol=0, atol=tolerance)
