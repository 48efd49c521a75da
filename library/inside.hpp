#pragma once

#include "core/model/mechanism.hpp"
#include "core/motion/loads.hpp"
#include "jointwise/mechanism.hpp"

/// Contents of the library's classes; programs that use the library see only their names.
namespace jointwise {
inline namespace JOINTWISE_ABI {

struct Mechanism::Inside {
    jw::Mechanism mechanism;
    jw::Loads loads;  ///< one entry of `masses` per body
};

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
