#pragma once

#include "jointwise/lesson.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

struct Lesson::Inside {
    jw::Lesson lesson;
};

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
