"""Packs the installed module into a wheel; wheel.sh calls it in the folder with the package."""

import os

from setuptools import Distribution, setup


class BinaryDistribution(Distribution):
    """The module was compiled by cmake: the wheel is for this Python and this machine all the same."""

    def has_ext_modules(self):
        return True


setup(
    name="jointwise",
    version=os.environ["JW_VERSION"],
    description="Spatial kinematics of constrained rigid bodies",
    long_description="Mechanisms, their constraint equations, Jacobian and rank, motion, reactions and pictures.",
    packages=["jointwise"],
    package_data={"jointwise": ["*.so", "*.pyi", "py.typed", "libs/*", "share/**/*"]},
    python_requires=">=3.11",
    install_requires=["numpy"],
    distclass=BinaryDistribution,
    zip_safe=False,
)
