// Runs functions in child processes.
#include "io/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <new>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "io/byte_stream.hpp"

namespace fiberfate {
namespace {

/// What an answer of the child holds: its first byte.
enum class Answer : char { result, input_error, failure };

void limit(__rlimit_resource resource, std::uint64_t most) {
  rlimit now{};
  getrlimit(resource, &now);
  now.rlim_cur = std::min<rlim_t>(most, now.rlim_max);
  setrlimit(resource, &now);
}

/// Makes a fresh child what a worker should be: silent, bounded, ended with its parent, and deaf to the
/// interrupts that the parent answers.
void settle(const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(number, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::ceil(limits.processor_seconds)));
  if (!has_shadow_memory) limit(RLIMIT_AS, held_address_space() + limits.memory_bytes);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

void put_problems(ByteWriter& bytes, const InputError& error) {
  bytes.put(error.problems().size());
  for (const InputProblem& one : error.problems()) {
    bytes.put(one.line);
    bytes.put(one.column);
    for (const std::string& text : {one.file, one.key, one.value, one.complaint, one.remedy}) bytes.put(text);
  }
}

[[noreturn]] void raise_problems(ByteReader& bytes) {
  std::vector<InputProblem> problems(bytes.take<std::size_t>());
  for (InputProblem& one : problems) {
    bytes.take(one.line);
    bytes.take(one.column);
    for (std::string* text : {&one.file, &one.key, &one.value, &one.complaint, &one.remedy})
      bytes.take(*text);
  }
  throw InputError(std::move(problems));
}

std::string answer_of(const std::function<std::string()>& work) {
  ByteWriter bytes;
  try {
    const std::string result = work();
    bytes.put(Answer::result);
    bytes.put(result);
  } catch (const InputError& error) {
    bytes.put(Answer::input_error);
    put_problems(bytes, error);
  } catch (const std::bad_alloc&) {
    bytes.put(Answer::failure);
    bytes.put(std::string("it takes too much memory"));
  } catch (const std::exception& error) {
    bytes.put(Answer::failure);
    bytes.put(std::string(error.what()));
  }
  return bytes.take();
}

[[noreturn]] void serve(int pipe_end, const std::function<std::string()>& work,
                        const ChildLimits& limits) noexcept {
  settle(limits);
  const std::string answer = answer_of(work);
  std::string_view rest = answer;
  while (!rest.empty()) {
    const ssize_t written = ::write(pipe_end, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    rest.remove_prefix(written);
  }
  ::_exit(0);  // no destructors: what they would end belongs to the parent
}

std::string read_all(int pipe_end) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = ::read(pipe_end, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), count);
  }
}

void require_end(pid_t child, const ChildLimits& limits) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    throw ChildFailure(fmt::format("it takes more than {:.0f} s", limits.processor_seconds));
  if (WIFSIGNALED(status)) throw ChildFailure(fmt::format("it crashed ({})", ::strsignal(WTERMSIG(status))));
  if (WEXITSTATUS(status) != 0) throw ChildFailure("it crashed");
}

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw ChildFailure(fmt::format("no pipe to it could be made ({})", std::strerror(errno)));
  const pid_t child = ::fork();
  if (child == 0) serve(ends[1], work, limits);
  const int reason = errno;
  ::close(ends[1]);
  const std::string answer = child < 0 ? "" : read_all(ends[0]);
  ::close(ends[0]);
  if (child < 0)
    throw ChildFailure(fmt::format("no process for it could be started ({})", std::strerror(reason)));
  require_end(child, limits);
  ByteReader bytes(answer);
  switch (bytes.take<Answer>()) {
    case Answer::input_error:
      raise_problems(bytes);
    case Answer::failure:
      throw ChildFailure(bytes.take<std::string>());
    case Answer::result:
      break;
  }
  return bytes.take<std::string>();
}

}  // namespace fiberfate
