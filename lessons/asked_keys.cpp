#include "lessons/asked_keys.hpp"

namespace jw {

namespace {

thread_local AskedKeys* asked_keys_listening = nullptr;

}  // namespace

AskedKeys::AskedKeys() { asked_keys_listening = this; }

AskedKeys::~AskedKeys() { asked_keys_listening = nullptr; }

AskedKeys* AskedKeys::listening() { return asked_keys_listening; }

}  // namespace jw
