// Says why the program ends where nothing else can.
#include "app/last_words.hpp"

#include <unistd.h>

#include <cstring>
#include <exception>
#include <new>

#include "app/exit_status.hpp"

namespace fiberfate {
namespace {

const char* reason() noexcept {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  } catch (...) {
  }
  return "an error of the program itself";
}

/// Writes without memory of its own.
void say(const char* text) noexcept {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text, std::strlen(text));
}

[[noreturn]] void speak_and_end() noexcept {
  say("fiberfate: ");
  say(reason());
  say("\n");
  ::_exit(static_cast<int>(ExitStatus::failed));
}

}  // namespace

void tell_last_words() {
  std::set_terminate(speak_and_end);
}

}  // namespace fiberfate
