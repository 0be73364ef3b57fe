// Messages of a worker: its replies to calls of each function, and its own calls back. The first
// byte chooses the function, and a reply or a call. Answers go on to what the promises do with them.
#include "grader/check/generators/cameras.h"
#include "grader/check/generators/points_in_pixel.h"
#include "grader/check/language/fail.h"
#include "grader/check/mocks/scripted_radiance.h"
#include "grader/service/wire/finite.h"
#include "grader/service/wire/session.h"
#include "grader/tasks/adaptive_pixel/counts.h"
#include "grader/tasks/build_bvh/invariants.h"
#include "grader/tasks/diffuse_bsdf/density.h"
#include "tests/fuzz/input.h"

namespace grader::wire {
namespace {

// A judgement that may fail a case, and nothing else.
template <class Judge>
void judge_by(const Judge& judge) {
  try {
    judge();
  } catch (const check::CaseFailed&) {
  }
}

template <class Result>
void judge(const Result&) {}

// A tree, as for a few boxes.
void judge(const pt::Bvh& bvh) {
  using namespace check::build_bvh_inputs;
  static const Input input = halving_points(0, 16);
  judge_by([&] {
    expect_bounded(bvh, input.boxes.size());
    expect_nodes(bvh);
    judge_by([&] { depth(bvh); });
    judge_by([&] { expect_one_tree(bvh); });
    for (const auto invariant : {expect_covered, expect_every_primitive_once, expect_divided}) {
      judge_by([&] { invariant(input, bvh); });
    }
  });
}

void judge(const pt::PixelEstimate& estimate) {
  using namespace check::adaptive_pixel_inputs;
  Case c;
  c.settings = {8, 2, 0.05};
  c.seen = std::vector<pt::Rgb>(8, {1, 1, 1});
  judge_by([&] { expect_right_count(c, {estimate, {}, pt::Sampler(1)}); });
}

void judge(const std::vector<pt::BsdfSample>& samples) {
  using namespace check;
  using namespace check::diffuse_bsdf_inputs;
  std::vector<DirectionCell> cells(std::size_t{kHeights} * kSectors);
  count_samples(cells, samples);
  judge_by([&] { expect_different_samples(samples); });
}

// Where rays go through the picture.
void judge(const std::vector<pt::Ray>& rays) {
  check::Points points;
  for (const pt::Ray& ray : rays) {
    points.push_back(check::on_picture(pt::Camera{}, ray.direction));
  }
  if (!points.empty()) judge_by([&] { check::expect_even(points); });
}

// Looks at a result as the judge does. Rows of a picture have their own test (grader/pictures).
template <class Result>
void look_at(const Result& result) {
  if constexpr (!std::is_same_v<Result, pt::PictureRows>) {
    if (!bad_number(result)) judge(result);
    if constexpr (std::is_same_v<Result, pt::Ray>) judge(std::vector<pt::Ray>(3, result));
  }
}

// Reads a reply like call() of grader/service/wire/call.h and Session::take_head.
template <auto Function>
void read_reply(std::string_view bytes) {
  using Signature = SignatureOf<Function>;
  Reader in(bytes);
  const auto head = get<ReplyHead>(in);
  bad_number(head.tests.boxes);
  const auto result = get<typename Signature::Result>(in);
  if constexpr (Signature::kDraws) get<pt::Sampler>(in);
  in.expect_end();
  look_at(result);
}

template <auto Function>
void read_replies(std::string_view bytes) {
  Reader in(bytes);
  get<ReplyHead>(in);
  using Result = typename SignatureOf<Function>::Result;
  const auto results = get<std::vector<Result>>(in);
  for (const auto& each : results) look_at(static_cast<const Result&>(each));
  in.expect_end();
  judge(results);
}

void read_reply_of(int function, std::string_view bytes) {
  int number = 0;
#define FIRSTLIGHT_READ(result, function_, parameters, names)  \
  if (number++ == function) read_reply<&pt::function_>(bytes); \
  if (number++ == function) read_replies<&pt::function_>(bytes);
  FIRSTLIGHT_TASKS(FIRSTLIGHT_ROWS, FIRSTLIGHT_READ, FIRSTLIGHT_READ)
  FIRSTLIGHT_CALLS_render_rows(FIRSTLIGHT_READ, FIRSTLIGHT_READ)
}

// Puts correct type codes into the message, because every question would be refused without them.
void answer_question(int which, std::string_view bytes) {
  static const pt::Scene scene;
  Session session({});
  session.begin();
  const Handle handle = session.name(scene);
  Writer out;
  const auto ask = [&](Function function, std::uint64_t code) {
    put(out, AskHead{static_cast<std::uint32_t>(function), code});
  };
  if (which == 0) ask(Function::hit_box, SignatureOf<&pt::hit_box>::code());
  if (which == 1) ask(Function::hit_triangle, SignatureOf<&pt::hit_triangle>::code());
  if (which == 2) ask(Function::hit_sphere, SignatureOf<&pt::hit_sphere>::code());
  if (which == 3) ask(Function::radiance, SignatureOf<&pt::radiance>::code());
  if (which == 3 && bytes.size() % 2 == 1) put(out, handle);
  out.raw(bytes.data(), bytes.size());
  check::script_radiance({.of_call = [](int, const pt::Ray& ray) {
    judge(std::vector<pt::Ray>(3, ray));
    return pt::Rgb{1, 1, 1};
  }});
  answer(which == 3 ? "estimate_pixel" : "hit_bvh", out.bytes(), session);
}

}  // namespace
}  // namespace grader::wire

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view rest = fuzz::as_text(bytes + 1, size - 1);
  try {
    if (bytes[0] < 128) {
      grader::wire::read_reply_of(bytes[0], rest);
    } else {
      grader::wire::answer_question(bytes[0] % 8, rest);
    }
  } catch (const grader::wire::BadMessage& bad) {
    fuzz::expect_sentence(bad.what());
  } catch (const grader::check::CaseFailed&) {
  }
  return 0;
}
