#pragma once

#include "pt/render/render_rows.h"

namespace grader::pictures {

// The rows as the worker of this program's session renders them; its give_up() ends a call that
// comes to nothing.
pt::PictureRows worker_rows(const pt::View& view, const pt::RowsRequest& request);

}  // namespace grader::pictures
