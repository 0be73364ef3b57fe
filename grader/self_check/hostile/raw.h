// This text takes the place of RAW in an attack: system calls without the C library, so that no
// name in the object shows them.
#include <cstdio>
#include <initializer_list>

#include <fcntl.h>
#include <sys/syscall.h>
#include <time.h>

namespace {

[[maybe_unused]] long raw(long number, long a = 0, long b = 0, long c = 0, long d = 0, long e = 0) {
#if defined(__x86_64__)
  long result;
  register long r10 asm("r10") = d;
  register long r8 asm("r8") = e;
  asm volatile("syscall"
               : "=a"(result)
               : "a"(number), "D"(a), "S"(b), "d"(c), "r"(r10), "r"(r8)
               : "rcx", "r11", "memory");
  return result;
#elif defined(__aarch64__)
  register long x8 asm("x8") = number;
  register long x0 asm("x0") = a;
  register long x1 asm("x1") = b;
  register long x2 asm("x2") = c;
  register long x3 asm("x3") = d;
  register long x4 asm("x4") = e;
  asm volatile("svc 0" : "+r"(x0) : "r"(x8), "r"(x1), "r"(x2), "r"(x3), "r"(x4) : "memory");
  return x0;
#endif
}

[[maybe_unused]] long address(const void* pointer) { return reinterpret_cast<long>(pointer); }

[[maybe_unused]] long open_file(const char* path, int flags) {
  return raw(SYS_openat, AT_FDCWD, address(path), flags, 0600);
}

// Prints the words by which the test finds an attack that got somewhere.
[[maybe_unused]] void broke_out(const char* how) {
  std::printf("BROKE OUT: %s\n", how);
  std::fflush(stdout);
}

// Makes all attempts, beginning anywhere: one that ends the process hides those after it, and a worker that crashes is
// started again some hundred times.
[[maybe_unused]] void attempt(std::initializer_list<void (*)()> attempts) {
  timespec now{};
  raw(SYS_clock_gettime, CLOCK_MONOTONIC, address(&now));
  const auto start = static_cast<unsigned long>(now.tv_nsec / 100);
  for (unsigned long i = 0; i < attempts.size(); ++i) {
    attempts.begin()[(start + i) % attempts.size()]();
  }
}

// Ends an attack without a value, so that the task earns nothing by chance.
[[noreturn, maybe_unused]] void leave() { __builtin_trap(); }

}  // namespace
