#pragma once

#include "app/snapshot/fact_list.hpp"
#include "core/motion/loads.hpp"

namespace jw::snapshot {

/// Adds facts about forces, torques and springs. They have no names: those of each kind are counted from 1.
void add_loads(const Loads& loads, const Mechanism& mechanism, FactList& facts);

}  // namespace jw::snapshot
