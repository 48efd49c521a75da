"""Euler parameters by numpy alone: nothing of the module, so that it can be compared with this."""

import numpy as np


def product(p, q):
    """Euler parameters of the turn q (in the frame of the body) after p."""
    return np.concatenate(
        [[p[0] * q[0] - p[1:] @ q[1:]], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])]
    )


def turn(v):
    """Euler parameters of the turn by |v| rad about v."""
    angle = np.linalg.norm(v)
    return np.concatenate([[np.cos(angle / 2)], np.sinc(angle / (2 * np.pi)) / 2 * np.asarray(v)])
