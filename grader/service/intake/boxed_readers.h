#pragma once

#include "grader/service/intake/form_table.h"
#include "grader/service/intake/prepare_submission.h"

#include <string>
#include <vector>

namespace grader::intake {

// Reads with the programs `unpack` and `flatten` in the folder `programs`, each in a box: what was
// handed in is somebody else's. `root` and `work` are the project's folder and the judge's folder,
// which probe_isolation needs. Where `unpack` is missing, every archive has this as its problem.
// `table`: the forms of names in an archive of a whole class. Throws pt::Error if nothing isolates, and something must.
Readers boxed_readers(const std::string& root, const std::string& work, const std::string& programs,
                      bool must_isolate, const std::vector<NameForm>& table = {});

}  // namespace grader::intake
