// The untrusted side: runs tasks of a submission on request, until the judge closes the connection
// or kills it. The judge handles everything that happens here
// (grader/service/wire/worker_process.h), and has set all limits before this program starts.
#include "grader/service/process/limits.h"
#include "grader/service/wire/connection.h"
#include "grader/service/wire/crash.h"
#include "grader/service/wire/serve.h"

#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <typeinfo>

#include <cxxabi.h>

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
