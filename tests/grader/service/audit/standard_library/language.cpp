// The language itself: exceptions, statics, thread-local variables, locks, atomics, coroutines.
#include <atomic>
#include <compare>
#include <concepts>
#include <condition_variable>
#include <coroutine>
#include <csetjmp>
#include <exception>
#include <initializer_list>
#include <mutex>
#include <shared_mutex>
#include <source_location>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace pt {

namespace {

struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double exceptions() {
  double sum = 0;
  try {
    try {
      throw Failure("inner");
    } catch (const std::exception&) {
      std::throw_with_nested(std::logic_error("outer"));
    }
  } catch (const std::exception& error) {
    try {
      std::rethrow_if_nested(error);
    } catch (const Failure& inner) {
      sum += static_cast<double>(std::string(inner.what()).size());
    }
  }
  try {
    std::rethrow_exception(std::make_exception_ptr(3));
  } catch (int three) {
    sum += three;
  }
  return sum + std::uncaught_exceptions();
}

const std::vector<double>& table() {
  static const std::vector<double> all = [] {
    std::vector<double> values;
    for (int i = 0; i < 10; ++i) values.push_back(i * i);
    return values;
  }();
  return all;
}

double of_this_thread() {
  thread_local std::vector<int> scratch;
  thread_local const std::string name = "a name that is longer than a small string";
  scratch.clear();
  scratch.push_back(3);
  return scratch.back() + static_cast<double>(name.size());
}

double locks() {
  std::mutex mutex;
  std::recursive_mutex recursive;
  std::shared_mutex shared;
  std::timed_mutex timed;
  static std::once_flag once;
  std::call_once(once, [] {});
  double sum = 0;
  {
    const std::lock_guard lock(mutex);
    const std::scoped_lock both(recursive, timed);
    const std::shared_lock reading(shared);
    std::unique_lock writing(mutex, std::defer_lock);
    sum += writing.owns_lock() ? 1 : 0;
  }
  std::condition_variable changed;
  changed.notify_all();
  std::atomic<int> counter{0};
  std::atomic<double> total{1};
  counter.fetch_add(2, std::memory_order_relaxed);
  std::atomic_flag flag;
  flag.test_and_set();
  double expected = 1;
  total.compare_exchange_strong(expected, 2.5);
  std::this_thread::yield();
  return sum + counter + total + (std::this_thread::get_id() == std::thread::id() ? 100 : 1);
}

struct Numbers {
  struct promise_type {
    int value = 0;
    Numbers get_return_object() {
      return {std::coroutine_handle<promise_type>::from_promise(*this)};
    }
    std::suspend_always initial_suspend() noexcept { return {}; }
    std::suspend_always final_suspend() noexcept { return {}; }
    std::suspend_always yield_value(int next) {
      value = next;
      return {};
    }
    void return_void() {}
    void unhandled_exception() { throw; }
  };
  std::coroutine_handle<promise_type> handle;
};

Numbers up_to(int n) {
  for (int i = 1; i <= n; ++i) co_yield i;
}

double coroutines() {
  const Numbers numbers = up_to(3);
  double sum = 0;
  for (numbers.handle.resume(); !numbers.handle.done(); numbers.handle.resume()) {
    sum += numbers.handle.promise().value;
  }
  numbers.handle.destroy();
  return sum;
}

template <std::integral... Integer>
double total(Integer... each) {
  return (static_cast<double>(each) + ...);
}

struct Version {
  int major = 1, minor = 2;
  auto operator<=>(const Version&) const = default;
};

double the_rest() {
  double sum = total(1, 2L, 3u) + (Version{} < Version{1, 3} ? 1 : 0);
  for (const double x : std::initializer_list<double>{1, 2}) sum += x;
  std::vector<double> list(static_cast<std::size_t>(sum));
  double variable[4]{1, 2, 3, 4};
  for (double& x : variable) x += list.front();
  return sum + variable[3] + std::source_location::current().line() * 0.0;
}

}  // namespace

double task() {
  return exceptions() + table()[3] + of_this_thread() + locks() + coroutines() + the_rest();
}

}  // namespace pt
