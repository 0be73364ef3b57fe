#include "grader/mistakes/naming.h"

#include "grader/mistakes/compare.h"

namespace grader::mistakes {

namespace {

constexpr std::size_t kMaxNames = 3;

}  // namespace

bool explains(const Fingerprint& mistake, const Evidence& evidence) {
  return evidence.broken.contains(mistake.breaks) && agree(evidence.answers, mistake.answers);
}

std::vector<const Fingerprint*> name_by_battery(const KnownTask& known, const Evidence& evidence) {
  if (evidence.broken.empty() || agree(evidence.answers, known.right)) return {};
  std::vector<const Fingerprint*> found;
  for (const Fingerprint& mistake : known.mistakes) {
    if (explains(mistake, evidence)) found.push_back(&mistake);
  }
  for (const Fingerprint* one : found) {
    if (!agree(one->answers, found[0]->answers)) return {};
  }
  if (found.size() > kMaxNames) return {};
  return found;
}

}  // namespace grader::mistakes
