// Containers, views and algorithms.
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <deque>
#include <forward_list>
#include <functional>
#include <iterator>
#include <list>
#include <map>
#include <numeric>
#include <queue>
#include <ranges>
#include <set>
#include <span>
#include <stack>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <valarray>
#include <vector>

namespace pt {

namespace {

double containers() {
  std::map<std::string, double> map{{"a", 1}, {"b", 2}};
  std::multimap<int, int> many{{1, 1}, {1, 2}};
  std::set<std::pair<int, int>> set{{1, 2}, {3, 4}};
  std::unordered_map<std::string, std::vector<int>> table;
  table["one"].push_back(1);
  table.reserve(1000);
  std::unordered_set<int> numbers{1, 2, 3};
  std::list<int> list{3, 1, 2};
  list.sort();
  list.splice(list.begin(), std::list<int>{7});
  std::forward_list<int> forward{1, 2};
  std::deque<double> deque(100, 1.5);
  deque.push_front(2);
  std::stack<int> stack;
  stack.push(4);
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>>
      queue;
  queue.emplace(1.5, 3);
  std::queue<int> line;
  line.push(1);
  auto node = map.extract("a");
  node.key() = "z";
  map.insert(std::move(node));
  std::bitset<200> bits("1011");
  std::vector<bool> flags(70, true);
  flags.flip();
  std::valarray<double> values{1, 2, 3};
  values = std::sqrt(values * values + 1.0)[std::slice(0, 2, 1)];
  return map.at("z") + static_cast<double>(many.count(1) + set.size() + table.at("one").size()) +
         static_cast<double>(numbers.size() + bits.count()) + list.front() + forward.front() +
         deque.front() + stack.top() + queue.top().first + line.front() + values.sum() + flags[3];
}

double algorithms() {
  std::vector<double> v(100);
  std::iota(v.begin(), v.end(), 0.0);
  std::stable_sort(v.begin(), v.end(), std::greater<>());
  std::nth_element(v.begin(), v.begin() + 50, v.end());
  std::partial_sort(v.begin(), v.begin() + 10, v.end());
  std::stable_partition(v.begin(), v.end(), [](double x) { return x > 20; });
  std::inplace_merge(v.begin(), v.begin() + 50, v.end());
  std::rotate(v.begin(), v.begin() + 3, v.end());
  std::make_heap(v.begin(), v.end());
  std::sort_heap(v.begin(), v.end());
  const auto [low, high] = std::minmax_element(v.begin(), v.end());
  const double sum = std::accumulate(v.begin(), v.end(), 0.0) + std::reduce(v.begin(), v.end()) +
                     std::transform_reduce(v.begin(), v.end(), v.begin(), 0.0);
  std::vector<double> sums;
  std::partial_sum(v.begin(), v.end(), std::back_inserter(sums));
  return sum + *low + *high + sums.back() + std::gcd(12, 18) + std::clamp(3.0, 0.0, 1.0) +
         std::midpoint(1.0, 2.0) + std::lerp(0.0, 1.0, 0.5);
}

double views() {
  const std::array<int, 6> numbers{1, 2, 3, 4, 5, 6};
  double sum = 0;
  for (const int x : numbers | std::views::filter([](int n) { return n % 2 == 0; }) |
                         std::views::transform([](int n) { return n * n; }) | std::views::take(2)) {
    sum += x;
  }
  for (const int x : std::views::iota(0, 5) | std::views::reverse) sum += x;
  const std::span<const int> all(numbers);
  std::vector<std::pair<int, double>> pairs{{2, 1}, {1, 2}};
  std::ranges::sort(pairs, {}, &std::pair<int, double>::first);
  try {
    sum += std::vector<int>(3).at(7) + std::array<int, 2>{}.at(all.size());
  } catch (const std::out_of_range&) {
    sum += 1;
  }
  return sum + all.subspan(1, 2).back() + pairs[0].second +
         static_cast<double>(std::ranges::count(numbers, 3));
}

}  // namespace

double task() { return containers() + algorithms() + views(); }

}  // namespace pt
