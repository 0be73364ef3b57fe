#pragma once

#include "pt/render/render_rows.h"

namespace grader::wire {

// The rows, rendered by the worker of this program's session. Its give_up() ends a call that fails.
pt::PictureRows worker_rows(const pt::View& view, const pt::RowsRequest& request);

}  // namespace grader::wire
