#include "grader/service/wire/crash.h"

#include <csignal>
#include <cstdint>
#include <initializer_list>

#include <sys/resource.h>

namespace grader::wire {

namespace {

// The size is the same on every machine, whatever the machine's own limit is.
constexpr std::uintptr_t kStackSize = std::uintptr_t{8} << 20;

// The range of addresses that count as an overflow: around the end of the stack, or beyond it by
// the size of a large variable.
constexpr std::uintptr_t kAbove = std::uintptr_t{1} << 16, kBelow = std::uintptr_t{64} << 20;

std::uintptr_t stack_top = 0;

// The handler has a stack of its own, as the usual stack may be full.
alignas(16) char handler_stack[1 << 15];

void on_wrong_address(int signal, siginfo_t* info, void*) {
  const std::uintptr_t down = stack_top - reinterpret_cast<std::uintptr_t>(info->si_addr);
  std::signal(signal, SIG_DFL);
  // For other addresses the same instruction now fails again, and ends the process.
  if (down + kAbove > kStackSize && down < kStackSize + kBelow) raise(SIGSTKFLT);
}

}  // namespace

void report_stack_overflow() {
  char here = 0;
  stack_top = reinterpret_cast<std::uintptr_t>(&here);
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  limit.rlim_cur = kStackSize;
  setrlimit(RLIMIT_STACK, &limit);
  stack_t own{};
  own.ss_sp = handler_stack;
  own.ss_size = sizeof handler_stack;
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_wrong_address;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS}) sigaction(signal, &action, nullptr);
}  // NOLINT(clang-analyzer-core.StackAddressEscape): the address is compared, and never followed

}  // namespace grader::wire
