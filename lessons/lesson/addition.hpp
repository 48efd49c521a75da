#pragma once

namespace jw {

/// A joint or a driver that is added in one step.
struct Addition {
    enum class Kind { joint, driver };
    Kind kind = Kind::joint;
    int index = 0;  ///< into mechanism.joints or mechanism.drivers

    bool operator==(const Addition&) const = default;
};

}  // namespace jw
