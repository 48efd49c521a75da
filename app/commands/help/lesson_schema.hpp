#pragma once

#include <ostream>

namespace jw {

/// JSON Schema of lesson files, for editors: docs/lesson.schema.json.
void write_lesson_schema(std::ostream& out);

}  // namespace jw
