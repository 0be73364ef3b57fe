#pragma once

#include "grader/explain/record.h"
#include "grader/service/wire/codec.h"
#include "grader/service/wire/finite.h"

// Both ends: the record of a call. Only what the call asked is sent. What it was told would be the worker's word, and the judge
// computes it itself (explain::answer).

namespace grader::wire {

// An event is sent as the members that ask.
template <class Event>
struct Asked;
template <>
struct Asked<explain::TracedRay> {
  static auto of(auto& event) { return std::tie(event.ray); }
};
template <>
struct Asked<explain::LightDraw> {
  static auto of(auto& event) { return std::tie(event.light, event.p, event.before); }
};
template <>
struct Asked<explain::Direction> {
  static auto of(auto& event) { return std::tie(event.albedo, event.wo, event.before); }
};
template <>
struct Asked<explain::DirectLight> {
  static auto of(auto& event) {
    return std::tie(event.by_lights, event.point, event.samples, event.before);
  }
};

template <>
struct Codec<explain::State> {
  static constexpr std::size_t kMinSize = sizeof(explain::State);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 11;
  static void put(Writer& out, const explain::State& state) {
    out.raw(state.data(), sizeof(explain::State));
  }
  static explain::State get(Reader& in) {
    explain::State state;
    for (std::uint64_t& word : state) word = in.number<std::uint64_t>();
    return state;
  }
};

template <class Event>
requires requires(Event& event) { Asked<Event>::of(event); }
struct Codec<Event> {
  static constexpr std::size_t kMinSize =
      []<class... Asks>(std::type_identity<std::tuple<Asks...>>) {
        return (Codec<std::remove_cvref_t<Asks>>::kMinSize + ...);
      }(std::type_identity<decltype(Asked<Event>::of(std::declval<Event&>()))>());
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 12;
  static void put(Writer& out, const Event& event) {
    std::apply([&](const auto&... asked) { (wire::put(out, asked), ...); },
               Asked<Event>::of(event));
  }
  static Event get(Reader& in) {
    Event event;
    std::apply(
        [&](auto&... asked) {
          ((asked = wire::get<std::remove_cvref_t<decltype(asked)>>(in)), ...);
        },
        Asked<Event>::of(event));
    return event;
  }
};

template <>
struct Codec<explain::Told> {
  static constexpr std::size_t kMinSize = sizeof(pt::Rgb);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 13;
  static void put(Writer& out, const explain::Told& told) {
    wire::put(out, told.result);
    wire::put(out, told.after);
    wire::put(out, told.events);
  }
  static explain::Told get(Reader& in) {
    explain::Told told;
    told.result = wire::get<pt::Rgb>(in);
    told.after = wire::get<explain::State>(in);
    told.events = wire::get<std::vector<explain::Event>>(in);
    return told;
  }
};

// The events are compared, and none of their numbers has to be finite.
inline MaybeBad bad_number(const explain::Told& told) { return bad_number(told.result); }

}  // namespace grader::wire
