// Tests work in child processes: answers, errors, crashes, limits.
#include "io/child_process.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "io/byte_stream.hpp"

namespace fiberfate {
namespace {

std::string failure_of(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  try {
    return "answered " + run_in_child(work, limits);
  } catch (const ChildFailure& failure) {
    return failure.what();
  }
}

TEST(ChildProcess, GivesBackWhatTheWorkReturns) {
  EXPECT_EQ(run_in_child([] { return std::string("an answer"); }, {}), "an answer");
  const std::string long_answer(3'000'000, 'x');  // more than a pipe holds
  EXPECT_EQ(run_in_child([&] { return long_answer; }, {}), long_answer);
}

TEST(ChildProcess, RaisesTheInputErrorsOfTheWork) {
  const auto work = []() -> std::string {
    throw InputError(
        {{"part.stl", 3, 7, "part.file", "x", "is wrong", "mend it"}, {"", 0, 0, "", "", "b", ""}});
  };
  try {
    static_cast<void>(run_in_child(work, {}));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "part.stl:3:7: part.file = x: is wrong: mend it\nb");
  }
}

TEST(ChildProcess, TellsHowItCrashed) {
  EXPECT_NE(failure_of([]() -> std::string { std::abort(); }).find("it crashed (Aborted)"),
            std::string::npos);
  EXPECT_NE(failure_of([]() -> std::string { throw 1; }).find("it crashed"), std::string::npos);
  EXPECT_NE(failure_of([]() -> std::string {
              std::raise(SIGKILL);
              return "";
            }).find("it crashed (Killed)"),
            std::string::npos);
  EXPECT_EQ(failure_of([]() -> std::string { throw std::runtime_error("no such luck"); }), "no such luck");
}

TEST(ChildProcess, EndsWorkThatTakesTooLong) {
  const auto work = []() -> std::string {
    const std::atomic<bool> on = true;
    while (on) continue;
    return "";
  };
  EXPECT_EQ(failure_of(work, {.processor_seconds = 1}), "it takes more than 1 s");
}

TEST(ChildProcess, LeavesOtherThreadsAlone) {
  std::vector<std::string> answers(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < answers.size(); ++i)
    threads.emplace_back([&answers, i] {
      for (int repeat = 0; repeat < 5; ++repeat)
        answers[i] = run_in_child([i] { return std::to_string(i); }, {});
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < answers.size(); ++i) EXPECT_EQ(answers[i], std::to_string(i));
}

TEST(ByteStream, RefusesToReadBeyondItsEnd) {
  ByteWriter writer;
  writer.put(std::vector<std::string>{"one", "two"});
  const std::string bytes = writer.take();
  EXPECT_EQ(ByteReader(bytes).take<std::vector<std::string>>(), (std::vector<std::string>{"one", "two"}));
  EXPECT_THROW(
      static_cast<void>(ByteReader(bytes.substr(0, bytes.size() - 1)).take<std::vector<std::string>>()),
      std::runtime_error);
}

}  // namespace
}  // namespace fiberfate
