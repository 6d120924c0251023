// Starts the program.
#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "app/command_line.hpp"
#include "app/last_words.hpp"
#include "app/thread_waiting.hpp"
#include "base/memory.hpp"

namespace {

/// Opens the standard streams that the caller closed: the first files that the program opens must not take
/// their places and receive what is printed.
void open_closed_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) == -1 && ::open("/dev/null", O_RDWR) != stream) std::_Exit(3);
}

}  // namespace

int main(int argument_count, char** arguments) {
  open_closed_streams();
  // A file that grows beyond its limit becomes an error of the write instead of a signal, and a reader of the
  // program's words who goes ends no run.
  for (const int number : {SIGXFSZ, SIGPIPE}) std::signal(number, SIG_IGN);
  fiberfate::bound_memory();
  fiberfate::tell_last_words();
  fiberfate::let_waiting_threads_sleep(arguments);
  return fiberfate::run_command_line(argument_count, arguments);
}
