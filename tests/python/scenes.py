"""Mechanisms that several tests use."""

import numpy as np

import jointwise as jw


def two_bodies(joint_type):
    """Two moving bodies in general position, and one joint between them whose equations are not satisfied there."""
    m = jw.Mechanism()
    m.add_body("one", [0.1, 0.2, 0.3], [0.8, 0.0, 0.6, 0.0])
    m.add_body("two", [0.9, -0.4, 0.6], [0.5, 0.5, -0.5, 0.5])
    m.add_joint(
        "joint", joint_type, "one", "two",
        at=[0.3, -0.2, 0.5], to=[0.7, 0.4, 0.1], axis=[0.6, 0.0, 0.8], axis2=[-0.8, 0.0, 0.6],
        side=[-0.8, 0.0, 0.6], pitch=0.2,
        ratio=-1.5, radius=0.3, curve=[[1, 0, 0], [0, 1.5, 0.2], [-1, 0, 0], [0, -1, 0]],
    )
    pose = jw.start_pose(m)
    pose.r[1] += [0.02, -0.03, 0.05]
    turned = pose.p[2] + [0.03, 0.05, -0.02, 0.04]
    pose.p[2] = turned / np.linalg.norm(turned)
    return m, pose


def moving(pose):
    """Velocities of size 1 of everything but the ground."""
    random = np.random.default_rng(7)
    bodies = len(pose.r) - 1
    ground = np.zeros((1, 3))
    return jw.Rates(
        np.vstack([ground, random.uniform(-1, 1, (bodies, 3))]),
        np.vstack([ground, random.uniform(-1, 1, (bodies, 3))]),
        random.uniform(-1, 1, len(pose.theta)),
    )


def four_bar(driven="A"):
    """The mechanism of docs/library.md: 20 equations of four hinges, 17 of them independent, and a motor.

    Hinge A can be driven without end, D until the crank and the coupler are in line.
    """
    A, B, C, D = np.array([[0, 0, 0], [0, 1, 0], [2, 2, 0], [3, 0, 0]], dtype=float)
    m = jw.Mechanism()
    crank = m.add_body("crank", (A + B) / 2)
    coupler = m.add_body("coupler", (B + C) / 2)
    rocker = m.add_body("rocker", (C + D) / 2)
    m.add_joint("A", "revolute", 0, crank, at=A)
    m.add_joint("B", "revolute", crank, coupler, at=B)
    m.add_joint("C", "revolute", coupler, rocker, at=C)
    m.add_joint("D", "revolute", 0, rocker, at=D)
    m.add_driver("motor", driven, [0.0, 2 * np.pi])
    return m


def pendulum(angle=1e-3):
    """A bob of 2 kg on a rod of 1 m about y, at an angle from below [rad]."""
    m = jw.Mechanism()
    bob = m.add_body("bob", [np.sin(angle), 0, -np.cos(angle)])
    m.add_joint("pin", "revolute", 0, bob, axis=[0, 1, 0])
    m.set_mass(bob, 2.0, 1e-3 * np.eye(3))
    m.set_gravity([0, 0, -9.81])
    return m
