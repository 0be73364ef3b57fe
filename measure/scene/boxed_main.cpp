// accuracy_boxed cheapest | converge SCENE --submission DIR: the same for a submission, without
// running its code in this process; or for several and the reference. The exit status is 1 if a submission cannot be measured.
#include "grader/service/process/spawn.h"
#include "measure/charts/labels.h"
#include "measure/renders/boxed.h"
#include "measure/renders/spec.h"
#include "measure/scene/begin.h"
#include "measure/scene/pixels.h"
#include "pt/end_of_program.h"
#include "pt/scene/tracer.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace measure::scene {

namespace {

constexpr std::chrono::seconds kCallLimit{20};  // of processor time; a call takes about kQuick

// From now on this submission renders the pixels. Throws SubmissionFailed if a task that all pixels
// need does not compile.
void open_boxed(const Boxed& boxed, pt::Engine engine) {
  Spec needed;
  needed.engine = engine;
  needed.path.to = 1;
  for (const std::string& task : tasks_used(needed)) {
    const auto found = boxed.unusable.find(task);
    if (found != boxed.unusable.end()) throw SubmissionFailed(task + " " + found->second);
  }
  open_worker(boxed, kCallLimit);
}

// It is built when it is opened for the first time.
Subject built_once(const std::string& name, const std::string& submission, pt::Engine engine) {
  return {name, [=, boxed = std::optional<Boxed>()]() mutable {
            if (!boxed) boxed = build_submission(submission);
            open_boxed(*boxed, engine);
          }};
}

// Each submission that is named, as it was built or still to be built.
std::vector<Subject> submissions_of(const Options& options) {
  std::vector<Subject> all;
  const std::vector<std::string> labels = labels_of(options.submissions);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    all.push_back(built_once(labels[i], options.submissions[i], options.engine));
  }
  for (std::size_t i = 0; i < options.built.size(); ++i) {
    const std::string name = i < options.names.size() ? options.names[i] : "";
    all.push_back({name, [engine = options.engine, file = options.built[i]] {
                     open_boxed(read_boxed(file), engine);
                   }});
  }
  return all;
}

}  // namespace

}  // namespace measure::scene

int main(int argc, char** argv) {
  using namespace measure::scene;
  grader::process::hide_process();
  std::signal(SIGPIPE, SIG_IGN);
  return pt::run_program([&] {
    const auto is_not_measured = [](const pt::Error& error) {
      std::fprintf(stderr, "the submission cannot be measured: %s\n",
                   pt::sentence_of(error).c_str());
      return 1;
    };
    try {
      Call call = parse_call(argc, argv);
      Options& options = call.options;
      options.threads = 1;  // there is one worker
      std::vector<Subject> all = submissions_of(options);
      if (all.empty()) throw pt::Error("say whose code: --submission DIR");
      if (all.size() > 1) {
        // In the same box, so that their times can be compared.
        all.insert(all.begin(), built_once("reference", "", options.engine));
        return run_call(call, all);
      }
      all[0].open();
      options.whose = all[0].name;
      return run_call(call);
    } catch (const measure::SubmissionFailed& error) {
      return is_not_measured(error);
    } catch (const NotApart& error) {
      return is_not_measured(error);
    }
  });
}
