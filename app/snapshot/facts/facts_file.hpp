#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/host/frames/environment.hpp"
#include "app/session/output/json.hpp"
#include "app/snapshot/facts/facts.hpp"

namespace jw::snapshot {

using host::Environment;

/// A snapshot without its pictures, as stored in its file NAME.json.
struct Record {
    std::string name;   ///< "A-equations": what it shows; stays the same when other steps come or go
    std::string title;  ///< of the step
    Environment drawn_with;
    std::vector<std::string> blessed;           ///< reasons for its changes, the last at the end
    std::map<std::string, std::string> things;  ///< "#3fa2c4": what has this colour in the picture of ids
    std::vector<Fact> facts;
};

/// The record as JSON, one fact per line.
std::string text_of(const Record& record);
/// @param file  for errors
/// @throws std::runtime_error saying what is wrong with it, and what was expected
Record record_of(const std::string& text, const std::string& file);

}  // namespace jw::snapshot
