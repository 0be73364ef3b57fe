// Messages between judge and worker: each encoded value comes back, and no bytes hurt the decoder.
#include "grader/base/sha256.h"
#include "grader/check/language/find_failure.h"
#include "grader/results/promises.h"
#include "grader/service/wire/finite.h"
#include "grader/service/wire/message.h"
#include "grader/service/wire/record.h"
#include "grader/service/wire/session.h"
#include "grader/service/wire/worker_process.h"
#include "grader/tasks/build_bvh/invariants.h"
#include "pt/error.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace grader::wire {
namespace {

pt::Scene a_scene() {
  pt::Scene scene;
  scene.primitives.triangles = {pt::flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0})};
  scene.primitives.spheres = {{{1, 2, 3}, 4}, {{5, 6, 7}, 8}};
  scene.material_of = {1, 0, 0};
  scene.materials = {{"plain", {0.1, 0.2, 0.3}, {}, ""}, {"odd", {}, {4, 5, 6}, "mirror"}};
  scene.lights = {pt::RectangleLight{{1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {7, 8, 9}},
                  pt::SphereLight{{1, 2, 3}, 2, {3, 2, 1}},
                  pt::make_mesh_light({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {1, 2, 3}),
                  pt::PointLight{{3, 2, 1}, {1, 1, 2}},
                  pt::DirectionalLight{{0, -1, 0}, {2, 2, 1}},
                  pt::AmbientLight{{1, 0, 0}}};
  return scene;
}

template <class T>
std::string encode(const T& value) {
  Writer out;
  put(out, value);
  return std::string(out.bytes());
}

template <class T>
void expect_round_trip(const T& value) {
  const std::string bytes = encode(value);
  Reader in(bytes);
  const T back = get<T>(in);
  EXPECT_NO_THROW(in.expect_end());
  EXPECT_EQ(encode(back), bytes);
  EXPECT_GE(bytes.size(), Codec<T>::kMinSize);
}

TEST(remote, values_come_back) {
  const std::string bytes = encode(pt::Ray{{1, 2, 3}, {4, 5, 6}, 7, 8});
  Reader in(bytes);
  const auto ray = get<pt::Ray>(in);
  EXPECT_EQ(ray.origin, (pt::Vec3{1, 2, 3}));
  EXPECT_EQ(ray.direction, (pt::Vec3{4, 5, 6}));
  EXPECT_EQ(ray.t_min, 7);
  EXPECT_EQ(ray.t_max, 8);
}

TEST(remote, encoding_a_decoded_value_gives_the_same_bytes) {
  expect_round_trip(pt::Hit{1.5, {0, 0, 1}, 7});
  expect_round_trip(std::optional<pt::SurfaceHit>());
  expect_round_trip(std::optional<pt::SurfaceHit>({2, {0, 1, 0}}));
  expect_round_trip(pt::Bvh{{{{}, 1, 2, 0, 0}, {{}, -1, -1, 0, 3}}, {2, 1, 0}});
  expect_round_trip(pt::PathSettings{3, pt::PathSettings::Direct::hemisphere, 0.5, 1, 4, true});
  expect_round_trip(pt::Camera{{1, 2, 3}, pt::frame_from_normal({0, 1, 0}), 60, 40, 0.1, 9});
  expect_round_trip(pt::SurfacePoint{});
  expect_round_trip(a_scene().lights);
  expect_round_trip(a_scene().materials);
  expect_round_trip(pt::Sampler(5));
}

TEST(remote, a_scene_comes_back_with_everything_in_it) {
  const pt::Scene scene = a_scene();
  Writer out, again;
  Codec<pt::Scene>::put(out, scene);
  Reader in(out.bytes());
  const pt::Scene back = Codec<pt::Scene>::get(in);
  in.expect_end();
  Codec<pt::Scene>::put(again, back);
  EXPECT_EQ(out.bytes(), again.bytes());
  ASSERT_EQ(back.lights.size(), 6u);
  EXPECT_EQ(back.materials[1].unsupported, "mirror");
  EXPECT_EQ(std::get<pt::PointLight>(back.lights[3]).intensity, (pt::Rgb{1, 1, 2}));
}

TEST(remote, lengths_are_held_against_what_is_there) {
  for (const std::uint64_t length :
       {std::uint64_t{1}, std::uint64_t{1} << 32, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
    const std::string bytes = encode(length);
    Reader list(bytes), text(bytes), scenes(bytes);
    EXPECT_THROW(get<std::vector<pt::BvhNode>>(list), BadMessage);
    EXPECT_THROW(get<std::string>(text), BadMessage);
    EXPECT_THROW(get<std::vector<pt::Light>>(scenes), BadMessage);
  }
}

// Two elements with one byte too few, exactly enough, and one byte too many.
TEST(remote, lengths_are_held_against_the_size_of_an_element) {
  constexpr std::size_t kSize = Codec<double>::kMinSize;
  for (const std::size_t bytes : {2 * kSize - 1, 2 * kSize, 2 * kSize + 1}) {
    const std::string message = encode(std::uint64_t{2}) + std::string(bytes, '\0');
    Reader in(message);
    if (bytes < 2 * kSize) {
      EXPECT_THROW(get_length<double>(in), BadMessage);
    } else {
      EXPECT_EQ(get_length<double>(in), 2U);
    }
  }
}

TEST(remote, flags_and_choices_that_do_not_exist_are_refused) {
  Reader flag("\2"), light("\6");
  EXPECT_THROW(get<bool>(flag), BadMessage);
  EXPECT_THROW(get<pt::Light>(light), BadMessage);
  for (const int choice : {-1, 2}) {
    const std::string bytes = encode(choice);
    Reader in(bytes);
    EXPECT_THROW(get<pt::PathSettings::Direct>(in), BadMessage);
  }
}

// Every prefix and random damage: decoding ends with a value or with BadMessage.
template <class T>
int refused_when_damaged(const T& value) {
  std::mt19937_64 random(7);
  int refused = 0;
  const std::string good = encode(value);
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good.substr(0, i % 3 == 0 ? random() % good.size() : good.size());
    for (int flips = 0; flips < i % 5; ++flips) {
      if (!bytes.empty()) bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    try {
      Reader in(bytes);
      get<T>(in);
      in.expect_end();
    } catch (const BadMessage&) {
      ++refused;
    }
  }
  return refused;
}

// One event of each kind.
explain::Told a_record() {
  explain::Told told{{1, 2, 3}, {}, {5, 6, 7, 8}, {}};
  told.events = {
      explain::TracedRay{{{1, 2, 3}, {0, 0, 1}}, pt::Hit{1, {0, 0, 1}, 2}},
      explain::LightDraw{2, {1, 2, 3}, {1, 2, 3, 4}, {5, 6, 7, 8}, {{0, 0, 1}, 3, {1, 1, 1}}},
      explain::Direction{
          {1, 1, 1}, {0, 0, 1}, {1, 2, 3, 4}, {5, 6, 7, 8}, {{0, 1, 0}, {1, 1, 1}, 2}},
      explain::DirectLight{true, {}, 7, {1, 2, 3, 4}, {5, 6, 7, 8}, {9, 9, 9}}};
  return told;
}

// The answers that a call got would be the worker's word, and are not sent.
TEST(remote, a_record_has_questions_and_no_answers) {
  Writer out;
  put(out, a_record());
  Reader in(out.bytes());
  const auto got = get<explain::Told>(in);
  in.expect_end();
  EXPECT_EQ(got.result, a_record().result);
  EXPECT_EQ(got.after, a_record().after);
  ASSERT_EQ(got.events.size(), 4u);
  const auto& ray = std::get<explain::TracedRay>(got.events[0]);
  EXPECT_EQ(ray.ray.origin, (pt::Vec3{1, 2, 3}));
  EXPECT_FALSE(ray.hit);
  const auto& draw = std::get<explain::LightDraw>(got.events[1]);
  EXPECT_EQ(draw.light, 2);
  EXPECT_EQ(draw.before, (explain::State{1, 2, 3, 4}));
  EXPECT_EQ(draw.after, explain::State{});
  EXPECT_EQ(draw.sample.distance, 0);
  EXPECT_EQ(std::get<explain::Direction>(got.events[2]).sample.pdf, 0);
  const auto& direct = std::get<explain::DirectLight>(got.events[3]);
  EXPECT_TRUE(direct.by_lights);
  EXPECT_EQ(direct.samples, 7);
  EXPECT_EQ(direct.light, pt::Rgb{});
}

TEST(remote, no_bytes_hurt_the_decoder) {
  EXPECT_GT(refused_when_damaged(a_scene().lights), 1000);
  EXPECT_GT(refused_when_damaged(a_scene().materials), 1000);
  EXPECT_GT(refused_when_damaged(a_scene().primitives), 1000);
  EXPECT_GT(refused_when_damaged(pt::Bvh{std::vector<pt::BvhNode>(5), {4, 3, 2, 1, 0}}), 1000);
  EXPECT_GT(refused_when_damaged(std::optional<pt::Hit>({1, {0, 0, 1}, 2})), 1000);
  EXPECT_GT(refused_when_damaged(ReplyHead{1, 2, 3, 4, 5, {{{}}, {{}}, {{}}}}), 1000);
  EXPECT_GT(refused_when_damaged(CallHead{}), 1000);
  EXPECT_GT(refused_when_damaged(a_record()), 300);
  EXPECT_GT(refused_when_damaged(Definition{1, ObjectKind::bvh, "content"}), 1000);
}

TEST(remote, types_that_differ_have_different_codes) {
  const std::set<std::uint64_t> codes{
      SignatureOf<&pt::hit_box>::code(),       SignatureOf<&pt::hit_bvh>::code(),
      SignatureOf<&pt::occluded_bvh>::code(),  SignatureOf<&pt::hit_sphere>::code(),
      SignatureOf<&pt::hit_triangle>::code(),  SignatureOf<&pt::camera_ray>::code(),
      SignatureOf<&pt::build_bvh>::code(),     SignatureOf<&pt::diffuse_f>::code(),
      SignatureOf<&pt::diffuse_pdf>::code(),   SignatureOf<&pt::diffuse_sample>::code(),
      SignatureOf<&pt::direct_lights>::code(), SignatureOf<&pt::trace_path>::code()};
  EXPECT_EQ(codes.size(), 12u);
}

// The way to the first bad number, and the number; empty if there is none.
template <class Answer>
std::string bad(const Answer& answer) {
  const MaybeBad found = bad_number(answer);
  return found ? fmt::format("{} {}", found->member, found->value) : "";
}

TEST(remote, answers_have_numbers) {
  const double inf = pt::kInfinity;
  EXPECT_EQ(bad(pt::Ray{{}, {0, 0, 1}, 0, inf}), "");
  EXPECT_EQ(bad(std::optional<pt::SurfaceHit>()), "");
  EXPECT_EQ(bad(std::optional<pt::Interval>({0, inf})), "");
  EXPECT_EQ(bad(pt::BsdfSample{{0, 0, 1}, {1, 1, 1}, 1}), "");
}

TEST(remote, a_number_that_is_not_allowed_is_named) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = pt::kInfinity;
  EXPECT_EQ(bad(nan), " nan");
  EXPECT_EQ(bad(pt::Rgb{1, nan, 1}), "g nan");
  EXPECT_EQ(bad(pt::BsdfSample{{nan, nan, nan}, {1, 1, 1}, 1}), "wi.x nan");
  EXPECT_EQ(bad(pt::BsdfSample{{0, 0, 1}, {1, 1, inf}, 1}), "f.b inf");
  EXPECT_EQ(bad(pt::BsdfSample{{0, 0, 1}, {1, 1, 1}, -inf}), "pdf -inf");
  EXPECT_EQ(bad(std::optional<pt::SurfaceHit>({inf, {}})), "t inf");
  EXPECT_EQ(bad(std::optional<pt::Hit>({1, {0, 0, nan}, 2})), "n.z nan");
  EXPECT_EQ(bad(std::optional<pt::Interval>({0, nan})), "max nan");
  EXPECT_EQ(bad(std::optional<pt::Interval>({nan, inf})), "min nan");
  EXPECT_EQ(bad(pt::Ray{{0, inf, 0}, {0, 0, 1}, 0, 1}), "origin.y inf");
  EXPECT_EQ(bad(pt::Ray{{}, {0, nan, 1}, 0, 1}), "direction.y nan");
  EXPECT_EQ(bad(pt::Ray{{}, {0, 0, 1}, nan, 1}), "t_min nan");
  EXPECT_EQ(bad(pt::Ray{{}, {0, 0, 1}, 0, nan}), "t_max nan");
  EXPECT_EQ(bad(pt::PixelEstimate{{1, 1, nan}, 8}), "mean.b nan");
  const pt::BvhNode node{{{0, 0, 0}, {}}, 0, 0, 0, 1}, broken{{{0, 0, nan}, {}}, 0, 0, 0, 1};
  EXPECT_EQ(bad(pt::Bvh{{node, broken}, {0}}), "nodes[1].box.min.z nan");
  EXPECT_EQ(bad(std::vector<pt::Vec3>{{}, {0, 0, nan}}), "[1].z nan");
}

bool is_bounded(const pt::Bvh& bvh, std::size_t boxes) {
  try {
    check::build_bvh_inputs::expect_bounded(bvh, boxes);
    return true;
  } catch (const check::CaseFailed&) {
    return false;
  }
}

// A loop over such a leaf would take seconds, and its end is no int.
TEST(remote, trees_have_numbers_that_loops_can_use) {
  constexpr int kMost = std::numeric_limits<int>::max();
  const auto leaf = [](int first, int count) { return pt::BvhNode{{}, -1, -1, first, count}; };
  const std::vector<int> order{0, 1, 2, 3};
  EXPECT_TRUE(is_bounded({{leaf(0, 4)}, order}, 4));
  EXPECT_TRUE(is_bounded({{leaf(-1, 5)}, order}, 4)) << "wrong, and short";
  EXPECT_FALSE(is_bounded({{leaf(0, kMost)}, order}, 4));
  EXPECT_FALSE(is_bounded({{leaf(kMost, 1)}, order}, 4));
  EXPECT_FALSE(is_bounded({{leaf(-kMost, 1)}, order}, 4));
  EXPECT_FALSE(is_bounded({std::vector(1000, leaf(0, 4)), order}, 4));
  EXPECT_FALSE(is_bounded({{leaf(0, 4)}, std::vector(1000, 0)}, 4));
  // Each leaf holds all boxes.
  EXPECT_FALSE(is_bounded({std::vector(4000, leaf(0, 1000)), std::vector(1000, 0)}, 1000));
}

// There are 2^71 ways from the root to the last node.
TEST(remote, trees_are_walked_soon_however_many_ways_there_are) {
  using namespace check::build_bvh_inputs;
  pt::Bvh bvh{{}, std::vector<int>(16)};
  std::iota(bvh.order.begin(), bvh.order.end(), 0);
  for (int i = 0; i < 71; ++i) bvh.nodes.push_back({{}, i + 1, i + 1, 0, 0});
  bvh.nodes.push_back({{}, -1, -1, 0, 16});
  expect_bounded(bvh, 16);
  EXPECT_EQ(depth(bvh), 71);
  EXPECT_NO_THROW(expect_split({Boxes(16), 16}, bvh));
  EXPECT_THROW(expect_one_tree(bvh), check::CaseFailed);
}

// Smaller inputs have their own session, so that the limit of all calls and a submission's variables
// do not depend on their number.
TEST(remote, smaller_inputs_have_a_session_of_their_own) {
  open_session({});
  Session* const usual = &session();
  std::vector<Session*> used;
  const auto fails_from_17_on = [&] {
    const int n = *rc::gen::inRange(0, 1000);
    used.push_back(&session());
    if (n >= 17) check::fail_call(results::Cause::wrong, "more");
  };
  const check::Found found = check::find_failure(fails_from_17_on, {.seed = 1, .cases = 100});
  ASSERT_TRUE(found.failure);
  const auto first_smaller = std::ranges::find_if(used, [&](Session* s) { return s != usual; });
  ASSERT_GT(used.end() - first_smaller, 3);
  EXPECT_GT(first_smaller - used.begin(), 0);
  EXPECT_EQ(std::count(first_smaller, used.end(), *first_smaller), used.end() - first_smaller);
  EXPECT_EQ(&session(), usual);
}

TEST(remote, a_worker_that_does_not_start_is_started_again) {
  std::unique_ptr<WorkerProcess> none;
  int calls = 0;
  const auto starts_at_the_third = [&] {
    if (++calls < 3) throw WorkerNotStarted{"no users"};
    return calls;
  };
  EXPECT_EQ(try_again(none, starts_at_the_third), 3);
  calls = 0;
  const auto never_starts = [&]() -> int {
    ++calls;
    throw WorkerNotStarted{"no users"};
  };
  try {
    try_again(none, never_starts);
    FAIL();
  } catch (const pt::Error& error) {
    EXPECT_STREQ(error.what(), "a worker cannot start: no users");
  }
  EXPECT_EQ(calls, 4);
  // A fault of the submission is reported at once.
  calls = 0;
  const auto crashes = [&]() -> int {
    ++calls;
    throw WorkerFailed{results::Cause::crash, "signal 11", false, false};
  };
  EXPECT_THROW(try_again(none, crashes), WorkerFailed);
  EXPECT_EQ(calls, 1);
}

TEST(sha256, examples) {
  EXPECT_EQ(base::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(base::sha256("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(base::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(base::sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(promises, are_read_from_a_contract) {
  const auto promises = results::promises_of(
      "// Out: a thing.\n//\n// Promises:\n//   - keeps the ray's range: no hit before\n"
      "// t_min,\n//     or beyond t_max.\n//   - never misses (bonus): at all (Someone 2013).\n"
      "//\n// Precision: double.\nint f();\n//   - not this: one.\n");
  ASSERT_EQ(promises.size(), 2u);
  EXPECT_EQ(promises[0].name, "keeps_the_rays_range");
  EXPECT_EQ(promises[0].title, "keeps the ray's range");
  EXPECT_EQ(promises[0].words, "no hit before t_min, or beyond t_max.");
  EXPECT_FALSE(promises[0].bonus);
  EXPECT_EQ(promises[1].name, "never_misses_bonus");
  EXPECT_EQ(promises[1].words, "at all (Someone 2013).");
  EXPECT_TRUE(promises[1].bonus);
}

}  // namespace
}  // namespace grader::wire
