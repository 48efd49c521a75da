"""Spatial kinematics of constrained rigid bodies: mechanisms, their equations, rank, motion, pictures.

SI units and radians; body 0 is the ground. Names and arguments are those of the C++ library (docs/library.md).
"""

from pathlib import Path

from ._jointwise import (
    Coordinates,
    Equations,
    EquationsTable,
    Equilibrium,
    Evaluator,
    Film,
    Image,
    Lesson,
    LessonError,
    Mechanism,
    Mistake,
    Moment,
    NotReached,
    Pose,
    Quantities,
    Rank,
    Rates,
    Reaction,
    Reactions,
    SmallMotion,
    Trajectory,
    __version__,
    accelerations_at,
    assemble,
    draw,
    equations_at,
    find_equilibrium,
    follow,
    joint_types,
    quantity_names,
    rank_at,
    reactions_at,
    read_lesson,
    read_lesson_text,
    simulate,
    start_pose,
    start_rates,
    velocities_at,
)

__all__ = [
    "Coordinates",
    "Equations",
    "EquationsTable",
    "Equilibrium",
    "Evaluator",
    "Film",
    "Image",
    "Lesson",
    "LessonError",
    "Mechanism",
    "Mistake",
    "Moment",
    "NotReached",
    "Pose",
    "Quantities",
    "Rank",
    "Rates",
    "Reaction",
    "Reactions",
    "SmallMotion",
    "Trajectory",
    "accelerations_at",
    "assemble",
    "draw",
    "equations_at",
    "find_equilibrium",
    "follow",
    "joint_types",
    "lesson_file",
    "lessons_folder",
    "quantity_names",
    "rank_at",
    "reactions_at",
    "read_lesson",
    "read_lesson_text",
    "simulate",
    "start_pose",
    "start_rates",
    "velocities_at",
]


def lessons_folder() -> Path:
    """Folder of the lessons that come with the module, a folder for each chapter."""
    return Path(__file__).parent / "share" / "jointwise" / "lessons" / "catalogue"


def lesson_file(name: str) -> Path:
    """File of a lesson by chapter and name: 'loops/four-bar'. Raises ValueError if there is none."""
    file = lessons_folder() / f"{name}.toml"
    if not file.is_file():
        raise ValueError(f"jointwise: there is no lesson '{name}' in {lessons_folder()}")
    return file
