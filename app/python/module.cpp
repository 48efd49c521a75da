#include "app/python/bindings.hpp"

/// jointwise._jointwise: the library of docs/library.md for Python. Users import the package jointwise, which
/// contains it.
PYBIND11_MODULE(_jointwise, module) {
    using namespace jointwise::python;
    module.doc() =
        "Spatial kinematics of constrained rigid bodies. SI units and radians; body 0 is the ground.";
    module.attr("__version__") = JOINTWISE_VERSION;
    add_errors(module);
    add_mechanism(module);
    add_poses(module);
    add_equations(module);
    add_evaluator(module);
    add_motion(module);
    add_measures(module);
    add_statics(module);
    add_lessons(module);
    add_pictures(module);
    add_films(module);
}
