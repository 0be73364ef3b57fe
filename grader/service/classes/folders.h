#pragma once

#include "grader/service/build/config.h"
#include "grader/service/classes/plan.h"

#include <string>

// The folders of unpacked submissions, below the folder of the reports.

namespace grader::classes {

// A new folder for unpacking. The earlier plan's folder stays: another machine may still need it.
std::string folder_to_unpack(const std::string& out);

// Removes all that was unpacked except the files that the judge reads: archives and what else lies
// in a submission may need gigabytes.
void keep_task_files(const build::Config& config, ClassPlan& plan, const std::string& unpacked);

// Replaces the folders of an anonymous class by links to them: their paths may have learners' names.
void hide_folders(ClassPlan& plan, const std::string& unpacked);

}  // namespace grader::classes
