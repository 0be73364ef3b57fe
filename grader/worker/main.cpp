// The untrusted side: runs tasks of a submission on request, until the judge closes the connection
// or kills it. Whatever happens in here is the judge's to handle (grader/remote/worker_process.h);
// the judge has set all limits before this program started.
#include "grader/worker/connection.h"
#include "grader/worker/serve.h"

#include <exception>

int main() {
  using grader::remote::Kind;
  while (true) {
    const std::string call = grader::worker::receive(Kind::call);
    try {
      grader::worker::send(Kind::reply, grader::worker::serve(call));
    } catch (const std::exception& error) {
      grader::worker::send(Kind::threw, error.what());
    } catch (...) {
      grader::worker::send(Kind::threw, "something that is no exception");
    }
  }
}
