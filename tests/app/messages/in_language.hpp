#pragma once

#include <string>
#include <string_view>

#include "app/session/wording/messages.hpp"

namespace jw::test {

/// Sets the language of all messages for its lifetime.
class InLanguage {
public:
    explicit InLanguage(std::string_view tag) : before_(language()) { set_language(tag); }
    ~InLanguage() { set_language(before_); }
    InLanguage(const InLanguage&) = delete;
    InLanguage& operator=(const InLanguage&) = delete;

private:
    std::string before_;
};

}  // namespace jw::test
