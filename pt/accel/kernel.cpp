#include "pt/accel/kernel.h"

#include "pt/error.h"

#include <cstdlib>
#include <string>
#include <string_view>

namespace pt {

extern const Kernel kernel_plain;
#if defined(PT_X86_KERNELS)
extern const Kernel kernel_v2;
extern const Kernel kernel_v3;
extern const Kernel kernel_v4;
#endif

namespace {

// The instructions that each level adds and that traverse.h can use. Machines that have these have
// the rest of the level.
bool can_run(std::string_view name) {
#if defined(PT_X86_KERNELS)
  if (name == "v2") return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
  if (name == "v3") {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  }
  if (name == "v4") {
    return can_run("v3") && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  }
#endif
  return name == "plain";
}

// The fastest first.
constexpr const Kernel* kKernels[] = {
#if defined(PT_X86_KERNELS)
    &kernel_v4, &kernel_v3, &kernel_v2,
#endif
    &kernel_plain};

}  // namespace

const Kernel* find_kernel(const char* name) {
  for (const Kernel* kernel : kKernels) {
    if (std::string_view(kernel->name) == name && can_run(name)) return kernel;
  }
  return nullptr;
}

const Kernel& best_kernel() {
  if (const char* asked = std::getenv("FIRSTLIGHT_KERNEL")) {
    if (const Kernel* kernel = find_kernel(asked)) return *kernel;
    throw Error("FIRSTLIGHT_KERNEL is '" + std::string(asked) +
                "', which this machine cannot run: set it to plain, v2, v3 or v4, or not at all");
  }
  for (const Kernel* kernel : kKernels) {
    if (can_run(kernel->name)) return *kernel;
  }
  return kernel_plain;
}

}  // namespace pt
