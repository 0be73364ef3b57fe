// The untrusted side: runs tasks of a submission on request, until the judge closes the connection
// or kills it. The judge handles everything that happens here
// (grader/service/wire/worker_process.h), and has set all limits before this program starts.
#include "grader/service/process/cause_of_end.h"
#include "grader/service/process/limits.h"
#include "grader/service/wire/connection.h"
#include "grader/service/wire/serve.h"

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <memory>
#include <new>
#include <string>
#include <typeinfo>

#include <cxxabi.h>
#include <sys/resource.h>

namespace grader::wire {

namespace {

// The worker's end: distinguishes stack overflows from other crashes.

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
  if (down + kAbove > kStackSize && down < kStackSize + kBelow) raise(process::kStackOverflow);
}

// From now on a stack overflow ends this process with a signal of its own, instead
// of that for any wrong address. Call it in main().
void report_stack_overflow() {
  stack_top = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
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
}

}  // namespace

}  // namespace grader::wire

namespace {

// "std::out_of_range: vector::_M_range_check: ..."
std::string describe(const std::exception& error) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> type(
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), &std::free);
  return (type ? std::string(type.get()) + ": " : "") + error.what();
}

}  // namespace

int main() {
  using grader::wire::Kind;
  if (!grader::process::kSanitized) grader::wire::report_stack_overflow();
  while (true) {
    const std::string call = grader::wire::receive(Kind::call);
    try {
      grader::wire::send(Kind::reply, grader::wire::serve(call));
    } catch (const std::bad_alloc&) {
      grader::wire::send(Kind::threw, "std::bad_alloc: out of memory");
    } catch (const std::exception& error) {
      grader::wire::send(Kind::threw, describe(error));
    } catch (...) {
      grader::wire::send(Kind::threw, "something that is not a std::exception");
    }
  }
}
