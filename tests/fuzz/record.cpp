#include "app/snapshot/facts/facts_file.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

bool check_record(const std::string& input) {
    snapshot::Record record;
    try {
        record = snapshot::record_of(input, "input.json");
    } catch (const std::runtime_error& refused) {
        promise(
            std::string(refused.what()).find("expected") != std::string::npos,
            "a refusal says what was expected");
        return false;
    }
    const std::string written = snapshot::text_of(record);
    const snapshot::Record again = snapshot::record_of(written, "written.json");
    promise(snapshot::text_of(again) == written, "a record that is written again is the same:\n" + written);
    promise(again.facts.size() == record.facts.size(), "no fact is lost");
    promise(again.name == record.name && again.title == record.title, "its words stay");
    return true;
}

}  // namespace jw::fuzz
