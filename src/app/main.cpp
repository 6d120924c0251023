// Starts the program.
#include "app/command_line.hpp"
#include "app/thread_waiting.hpp"

int main(int argument_count, char** arguments) {
  fiberfate::let_waiting_threads_sleep(arguments);
  return fiberfate::run_command_line(argument_count, arguments);
}
