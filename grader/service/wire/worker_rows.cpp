#include "grader/service/wire/worker_rows.h"

#include "grader/service/wire/call.h"

#include <algorithm>

namespace grader::wire {

pt::PictureRows worker_rows(const pt::View& view, const pt::RowsRequest& request) {
  using Signature = SignatureOf<&pt::render_rows>;
  Writer out;
  session().begin();
  Signature::put(out, session(), view, request);
  const std::string_view reply =
      session().call(kFunction<&pt::render_rows>, Signature::code(), CallBatch{}, out);
  auto rows = read_reply<pt::PictureRows>(reply, get<pt::PictureRows>);
  const std::size_t asked = request.only.empty()
                                ? static_cast<std::size_t>(view.width) * request.rows
                                : request.only.size();
  const std::size_t pixels = asked * std::max<std::size_t>(1, request.ranges.size());
  const auto none_or_all = [&](const std::vector<double>& values) {
    return values.empty() || values.size() == pixels;
  };
  if (rows.mean.size() != pixels || rows.counts.size() != (request.adaptive ? pixels : 0) ||
      !none_or_all(rows.measured.variance_y) || !none_or_all(rows.measured.boxes)) {
    session().reject("rows of another size than the picture's");
  }
  const auto& [boxes, triangles, spheres] = rows.measured.tests;
  for (const long long count : {boxes, triangles, spheres, rows.measured.not_finite}) {
    if (count < 0 || count > kMaxCount) session().reject("a count that is impossible");
  }
  return rows;
}

}  // namespace grader::wire
