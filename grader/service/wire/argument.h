#pragma once

#include "grader/service/wire/codec.h"
#include "pt/scene/scene.h"
#include "pt/scene/view.h"

#include <span>
#include <tuple>

// Both ends: how the parameters of contracts are sent: by value, except for scenes, primitives and
// trees, which are sent once and then named. `names` gives the name of an object to write,
// `objects` the object for a name that was read.

namespace grader::wire {

// The content hash of an object that both sides know.
using Handle = std::uint64_t;

// Parameter: a type of a contract, such as const Ray& or Sampler&. Held: the object that the other
// side keeps while the function runs.
template <class Parameter>
struct Argument {
  using Value = std::remove_cvref_t<Parameter>;
  using Held = Value;
  static constexpr std::uint64_t kCode = Codec<Value>::kCode;
  static void put(Writer& out, auto&, const Value& value) { wire::put(out, value); }
  static Held get(Reader& in, const auto&) { return wire::get<Value>(in); }
  static Parameter use(Held& held) { return held; }
};

template <class Object>
struct NamedArgument {
  using Held = const Object*;
  static constexpr std::uint64_t kCode = Codec<Handle>::kCode;
  static void put(Writer& out, auto& names, const Object& object) {
    wire::put<Handle>(out, names.name(object));
  }
  static Held get(Reader& in, const auto& objects) {
    return &objects.template find<Object>(wire::get<Handle>(in));
  }
  static const Object& use(Held held) { return *held; }
};

template <>
struct Argument<const pt::Scene&> : NamedArgument<pt::Scene> {};
template <>
struct Argument<const pt::Primitives&> : NamedArgument<pt::Primitives> {};
template <>
struct Argument<const pt::Bvh&> : NamedArgument<pt::Bvh> {};

template <>
struct Argument<const pt::View&> {
  using Held = pt::View;
  static constexpr std::uint64_t kCode =
      mix_code(Codec<pt::Camera>::kCode, Codec<pt::PathSettings>::kCode);
  static void put(Writer& out, auto& names, const pt::View& view) {
    const auto& [scene, camera, settings, width, height] = view;
    wire::put<Handle>(out, names.name(scene));
    wire::put(out, camera);
    wire::put(out, settings);
    wire::put(out, width);
    wire::put(out, height);
  }
  static Held get(Reader& in, const auto& objects) {
    return {objects.template find<pt::Scene>(wire::get<Handle>(in)), wire::get<pt::Camera>(in),
            wire::get<pt::PathSettings>(in), wire::get<int>(in), wire::get<int>(in)};
  }
  static const pt::View& use(Held& held) { return held; }
};

template <class Element>
struct Argument<std::span<const Element>> {
  using List = std::vector<Element>;
  using Held = std::span<const Element>;
  static constexpr std::uint64_t kCode = Codec<List>::kCode;
  static void put(Writer& out, auto&, Held list) { wire::put(out, List(list.begin(), list.end())); }
  // All lists lie in one place, so that a task that remembers a list by its place does not get a new one each time.
  static Held get(Reader& in, const auto&) {
    static List place;
    const List list = wire::get<List>(in);
    place.assign(list.begin(), list.end());
    return place;
  }
  static Held use(Held held) { return held; }
};

// The parts of the type of a contract's function.
template <class Function>
struct Signature;

template <class R, class... Parameters>
struct Signature<R (*)(Parameters...)> {
  using Result = R;
  using Held = std::tuple<typename Argument<Parameters>::Held...>;

  // True if the last parameter is a Sampler&, whose state is also sent back.
  static constexpr bool kDraws = (std::is_same_v<Parameters, pt::Sampler&> || ...);

  // A hash that shows whether both sides use the same types.
  static constexpr std::uint64_t code() {
    std::uint64_t sum = Codec<R>::kCode;
    ((sum = mix_code(sum, Argument<Parameters>::kCode)), ...);
    return sum;
  }

  static void put(Writer& out, auto& names, const std::remove_cvref_t<Parameters>&... arguments) {
    (Argument<Parameters>::put(out, names, arguments), ...);
  }
  static Held get(Reader& in, const auto& objects) {
    return Held{Argument<Parameters>::get(in, objects)...};  // braces: from left to right
  }
  static R apply(R (*function)(Parameters...), Held& held) {
    return std::apply([&](auto&... each) { return function(Argument<Parameters>::use(each)...); },
                      held);
  }
  static pt::Sampler& sampler(Held& held) requires kDraws {
    return std::get<sizeof...(Parameters) - 1>(held);
  }
};

template <auto Function>
using SignatureOf = Signature<decltype(Function)>;

}  // namespace grader::wire
