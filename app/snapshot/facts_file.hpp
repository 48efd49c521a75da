#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/host/frames/environment.hpp"
#include "app/session/output/json.hpp"
#include "app/snapshot/facts.hpp"

namespace jw::snapshot {

using host::Environment;

/// A snapshot without its pictures, as its file NAME.json holds it.
struct Record {
    std::string name;   ///< "A-equations": what it shows; stays when steps come or go elsewhere
    std::string title;  ///< of the step
    Environment drawn_with;
    std::vector<std::string> blessed;           ///< reasons for which it was changed, the last at the end
    std::map<std::string, std::string> things;  ///< "#3fa2c4": what has this colour in the picture of ids
    std::vector<Fact> facts;
};

/// The record as JSON, one fact a line.
std::string text_of(const Record& record);
/// @param file  for errors
/// @throws std::runtime_error saying what is wrong with it, and what was expected
Record record_of(const std::string& text, const std::string& file);

}  // namespace jw::snapshot
