#pragma once

namespace pt {

// Some bounces in a row, both included.
struct BounceRange {
  int from = 0;
  int to = 0;

  bool operator==(const BounceRange&) const = default;
};

}  // namespace pt
