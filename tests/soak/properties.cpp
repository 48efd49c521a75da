#include "tests/soak/property.hpp"

namespace jw::test {

const std::vector<Property>& properties() {
    static const std::vector<Property> all{
        {"accelerations",
         "Accelerations are the same in joint coordinates, in block equations, in all four dense coordinate "
         "choices and in the long double reference.",
         9, accelerations_agree},
    };
    return all;
}

}  // namespace jw::test
