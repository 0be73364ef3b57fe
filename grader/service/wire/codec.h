#pragma once

#include "grader/service/wire/bytes.h"
#include "grader/service/wire/fields.h"
#include "pt/sampling/sampler.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// Both ends: convert values to bytes and back; argument.h and call.h build whole calls. get()
// trusts nothing: it compares lengths with the bytes left before it allocates memory, and an
// invalid flag, enum or alternative is a BadMessage. It accepts every number, even NaN: finite.h
// decides which numbers make sense.

namespace grader::wire {

template <class T>
struct Codec;

template <class T>
void put(Writer& out, const T& value) {
  Codec<T>::put(out, value);
}

template <class T>
T get(Reader& in) {
  return Codec<T>::get(in);
}

// Every codec has kMinSize, the minimum number of bytes of a value; kPlain, whether every value is
// encoded as its bytes in memory, so that arrays can be copied; and kCode, a number that two types
// share only if their encodings are the same.
constexpr std::uint64_t mix_code(std::uint64_t a, std::uint64_t b) {
  return (a ^ (b + 0x9e3779b97f4a7c15 + (a << 12) + (a >> 4))) * 0x100000001b3;
}

template <class T>
requires std::is_arithmetic_v<T>
struct Codec<T> {
  static constexpr std::size_t kMinSize = sizeof(T);
  static constexpr bool kPlain = true;
  static constexpr std::uint64_t kCode = mix_code(sizeof(T), std::is_floating_point_v<T> ? 1 : 2);
  static void put(Writer& out, T value) { out.number(value); }
  static T get(Reader& in) { return in.number<T>(); }
};

template <>
struct Codec<bool> {
  static constexpr std::size_t kMinSize = 1;
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 3;
  static void put(Writer& out, bool value) { out.number<std::uint8_t>(value ? 1 : 0); }
  static bool get(Reader& in) {
    const auto value = in.number<std::uint8_t>();
    if (value > 1) throw BadMessage("a flag is neither 0 nor 1");
    return value == 1;
  }
};

template <class T>
requires std::is_enum_v<T>
struct Codec<T> {
  static_assert(kLargest<T> >= 0, "name the largest value in fields.h");
  static constexpr std::size_t kMinSize = sizeof(int);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = mix_code(4, kLargest<T>);
  static void put(Writer& out, T value) { out.number(static_cast<int>(value)); }
  static T get(Reader& in) {
    const int value = in.number<int>();
    if (!(value >= 0 && value <= kLargest<T>)) throw BadMessage("a choice does not exist");
    return static_cast<T>(value);
  }
};

template <HasFields T>
struct Codec<T> {
  template <class... Members>
  static constexpr std::size_t least(std::tuple<Members&...>*) {
    return (Codec<std::remove_cv_t<Members>>::kMinSize + ... + 0);
  }
  template <class... Members>
  static constexpr bool plain(std::tuple<Members&...>*) {
    return (Codec<std::remove_cv_t<Members>>::kPlain && ...);
  }
  template <class... Members>
  static constexpr std::uint64_t code(std::tuple<Members&...>*) {
    std::uint64_t sum = 5;
    ((sum = mix_code(sum, Codec<std::remove_cv_t<Members>>::kCode)), ...);
    return sum;
  }
  using Tuple = decltype(Fields<T>::of(std::declval<T&>()));
  static constexpr std::size_t kMinSize = least(static_cast<Tuple*>(nullptr));
  static constexpr bool kPlain = std::is_trivially_copyable_v<T> && kMinSize == sizeof(T) &&
                                 plain(static_cast<Tuple*>(nullptr));
  static constexpr std::uint64_t kCode = code(static_cast<Tuple*>(nullptr));

  static void put(Writer& out, const T& value) {
    if constexpr (kPlain) {
      out.raw(&value, sizeof value);
    } else {
      std::apply([&](const auto&... members) { (wire::put(out, members), ...); },
                 Fields<T>::of(value));
    }
  }
  static T get(Reader& in) {
    T value{};
    if constexpr (kPlain) {
      std::memcpy(static_cast<void*>(&value), in.raw(sizeof value).data(), sizeof value);
    } else {
      std::apply(
          [&](auto&... members) {
            ((members = wire::get<std::remove_cvref_t<decltype(members)>>(in)), ...);
          },
          Fields<T>::of(value));
    }
    return value;
  }
};

// Reads a length, which the bytes left must be able to hold.
template <class Element>
std::size_t get_length(Reader& in) {
  const auto length = in.number<std::uint64_t>();
  if (length > in.left() / Codec<Element>::kMinSize) throw BadMessage("a list is cut short");
  return static_cast<std::size_t>(length);
}

template <class Element>
struct Codec<std::vector<Element>> {
  static constexpr std::size_t kMinSize = sizeof(std::uint64_t);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = mix_code(6, Codec<Element>::kCode);
  static void put(Writer& out, const std::vector<Element>& list) {
    out.number<std::uint64_t>(list.size());
    if constexpr (Codec<Element>::kPlain) {
      out.raw(list.data(), list.size() * sizeof(Element));
    } else {
      for (const Element& element : list) wire::put(out, element);
    }
  }
  static std::vector<Element> get(Reader& in) {
    const std::size_t length = get_length<Element>(in);
    std::vector<Element> list;
    if constexpr (Codec<Element>::kPlain) {
      list.resize(length);
      const std::string_view bytes = in.raw(length * sizeof(Element));
      if (length > 0) std::memcpy(static_cast<void*>(list.data()), bytes.data(), bytes.size());
    } else {
      list.reserve(length);
      for (std::size_t i = 0; i < length; ++i) list.push_back(wire::get<Element>(in));
    }
    return list;
  }
};

template <>
struct Codec<std::string> {
  static constexpr std::size_t kMinSize = sizeof(std::uint64_t);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 7;
  static void put(Writer& out, const std::string& text) {
    out.number<std::uint64_t>(text.size());
    out.raw(text.data(), text.size());
  }
  static std::string get(Reader& in) { return std::string(in.raw(get_length<char>(in))); }
};

template <class T>
struct Codec<std::optional<T>> {
  static constexpr std::size_t kMinSize = 1;
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = mix_code(8, Codec<T>::kCode);
  static void put(Writer& out, const std::optional<T>& value) {
    wire::put(out, value.has_value());
    if (value) wire::put(out, *value);
  }
  static std::optional<T> get(Reader& in) {
    if (!wire::get<bool>(in)) return std::nullopt;
    return wire::get<T>(in);
  }
};

template <class... Alternatives>
struct Codec<std::variant<Alternatives...>> {
  using Variant = std::variant<Alternatives...>;
  static constexpr std::size_t kMinSize = 1 + std::min({Codec<Alternatives>::kMinSize...});
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 9;
  static void put(Writer& out, const Variant& value) {
    out.number(static_cast<std::uint8_t>(value.index()));
    std::visit([&](const auto& alternative) { wire::put(out, alternative); }, value);
  }
  static Variant get(Reader& in) {
    static constexpr std::array kDecoders{
        +[](Reader& from) -> Variant { return wire::get<Alternatives>(from); }...};
    const auto index = in.number<std::uint8_t>();
    if (index >= kDecoders.size()) throw BadMessage("an alternative does not exist");
    return kDecoders[index](in);
  }
};

template <>
struct Codec<pt::Sampler> {
  static constexpr std::size_t kMinSize = sizeof(pt::Sampler::State);
  static constexpr bool kPlain = false;
  static constexpr std::uint64_t kCode = 10;
  static void put(Writer& out, const pt::Sampler& sampler) {
    out.raw(sampler.state().data(), sizeof(pt::Sampler::State));
  }
  static pt::Sampler get(Reader& in) {
    pt::Sampler::State state;
    for (std::uint64_t& word : state) word = in.number<std::uint64_t>();
    return pt::Sampler(state);
  }
};

}  // namespace grader::wire
