#pragma once

#include <algorithm>

namespace grader::pictures {

// Calls use(x, y, width, height) for each block of this side in a picture, row by row; 0 is the whole picture as one block. Blocks
// at the right and the bottom may be smaller.
template <class Use>
void for_each_block(int picture_width, int picture_height, int side, const Use& use) {
  const int across = side == 0 ? picture_width : side, down = side == 0 ? picture_height : side;
  for (int y = 0; y < picture_height; y += down) {
    for (int x = 0; x < picture_width; x += across) {
      use(x, y, std::min(across, picture_width - x), std::min(down, picture_height - y));
    }
  }
}

}  // namespace grader::pictures
