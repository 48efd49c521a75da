#include "core/jets/rare_equations.hpp"

namespace jw {

JW_RARE_EQUATIONS()

}  // namespace jw
