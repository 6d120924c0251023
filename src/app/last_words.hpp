// What the program says when nothing else can speak for it.
#pragma once

namespace fiberfate {

/// Lets an exception that nobody catches, such as one in a destructor, end the program with a sentence and
/// status 3.
void tell_last_words();

/// What is said of memory that ran out.
inline constexpr const char* out_of_memory = "out of memory: 'fiberfate check' tells what a case needs";

}  // namespace fiberfate
