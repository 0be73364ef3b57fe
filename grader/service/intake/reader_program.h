#pragma once

#include "pt/end_of_program.h"
#include "pt/error.h"

#include <csignal>
#include <cstdio>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

namespace grader::intake {

// At the limit of processor time the kernel kills the process, as it does if no memory is left. So
// a program that reads what somebody handed in (read_boxed.h) reports slow input a little earlier.
inline void tell_before_the_limit() {
  constexpr rlim_t kSecondsToTell = 2;
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0 || limit.rlim_max == RLIM_INFINITY) return;
  std::signal(SIGXCPU, [](int) {
    constexpr char kWords[] = "it takes too long\n";
    (void)!write(STDERR_FILENO, kWords, sizeof kWords - 1);
    _exit(2);
  });
  limit.rlim_cur = limit.rlim_max > kSecondsToTell ? limit.rlim_max - kSecondsToTell : 1;
  setrlimit(RLIMIT_CPU, &limit);
}

// The exit status for the main of such a program: 2 if what it read is at fault, 3 if the machine is,
// each after one sentence.
template <class Read>
int run_reader(Read read) {
  tell_before_the_limit();
  try {
    read();
    return 0;
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 2;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "it needs too much memory\n");
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", pt::sentence_of(error).c_str());
    return 3;
  }
}

}  // namespace grader::intake
