// Owners, polymorphism and allocation.
#include <any>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <typeindex>
#include <typeinfo>
#include <variant>
#include <vector>

namespace pt {

namespace {

struct Shape : std::enable_shared_from_this<Shape> {
  virtual ~Shape() = default;
  virtual double area() const = 0;
};
struct Square : Shape {
  double side = 2;
  double area() const override { return side * side; }
};
struct Disk final : virtual Shape {
  double area() const override { return 3; }
};

double owners() {
  std::shared_ptr<Shape> shared = std::make_shared<Square>();
  const std::weak_ptr<Shape> weak = shared;
  const auto another = shared->shared_from_this();
  const std::shared_ptr<const double> inside(shared, &static_cast<Square&>(*shared).side);
  std::unique_ptr<Shape, std::function<void(Shape*)>> unique(new Disk, [](Shape* s) { delete s; });
  const auto list = std::make_unique<double[]>(8);
  const std::shared_ptr<int[]> numbers(new int[4]{1, 2, 3, 4});
  return weak.lock()->area() + *inside + unique->area() + list[3] +
         static_cast<double>(another.use_count()) + numbers[2];
}

double types() {
  const Square square;
  const Shape& shape = square;
  const bool cast = dynamic_cast<const Square*>(&shape) != nullptr;
  try {
    dynamic_cast<const Disk&>(shape);
  } catch (const std::bad_cast& error) {
    if (error.what() == nullptr) return -1;
  }
  return std::string(typeid(shape).name()).empty() ||
                 std::type_index(typeid(int)) == std::type_index(typeid(shape)) || !cast
             ? -1
             : 1;
}

double sums() {
  using Value = std::variant<int, double, std::string, std::monostate>;
  double sum = 0;
  for (const Value& value : {Value(1), Value(2.5), Value("three"), Value()}) {
    sum += std::visit(
        [](const auto& x) {
          if constexpr (std::is_arithmetic_v<std::decay_t<decltype(x)>>) return double(x);
          return 0.5;
        },
        value);
  }
  std::any any = std::vector<int>{1, 2};
  any = std::string("text");
  sum += static_cast<double>(std::any_cast<std::string>(any).size());
  try {
    sum += std::any_cast<int>(any) + std::get<int>(Value(1.5)) + std::optional<int>().value();
  } catch (const std::bad_any_cast&) {
    sum += 1;
  } catch (const std::bad_variant_access&) {
  } catch (const std::bad_optional_access&) {
  }
  const auto [a, b] = std::tuple(1, 2.0);
  return sum + std::optional<double>(2).value_or(1) + a + b;
}

double resources() {
  std::array<std::byte, 1024> buffer;
  std::pmr::monotonic_buffer_resource pool(buffer.data(), buffer.size());
  std::pmr::vector<std::pmr::string> words(&pool);
  words.emplace_back("a word that is too long for the small string");
  std::pmr::unsynchronized_pool_resource blocks;
  std::pmr::vector<int> numbers({1, 2, 3}, &blocks);
  struct alignas(64) Line {
    double x[8];
  };
  const auto line = std::make_unique<Line>();
  const std::vector<Line> lines(3);
  int* none = new (std::nothrow) int(5);
  const double sum = *none + static_cast<double>(words.size() + numbers.size() + lines.size());
  delete none;
  return sum + (reinterpret_cast<std::uintptr_t>(line.get()) % 64 == 0 ? 1 : -100);
}

double calls() {
  const std::function<double(double)> twice = [](double x) { return 2 * x; };
  const auto plus = std::bind(std::plus<>(), std::placeholders::_1, 3.0);
  const auto member = std::mem_fn(&Shape::area);
  double value = 1;
  std::reference_wrapper<double> reference = value;
  std::invoke([](double& x) { x += 1; }, reference);
  try {
    std::function<void()>()();
  } catch (const std::bad_function_call&) {
    value += 1;
  }
  return twice(plus(value)) + member(Square()) + std::hash<std::string>()("x") % 2;
}

}  // namespace

double task() { return owners() + types() + sums() + resources() + calls(); }

}  // namespace pt
