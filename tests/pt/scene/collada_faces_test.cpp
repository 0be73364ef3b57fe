// Faces of more than three corners: each covers what its outline encloses, whatever its shape.
#include "collada_text.h"
#include "pt/error.h"
#include "pt/sampling/sampler.h"
#include "pt/scene/collada/triangulate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace pt {
namespace {

using Points = std::vector<Vec3>;

// Twice the area of triangle i along z.
double doubled_area(const Points& face, const Triangulation& cut, std::size_t i) {
  const Vec3 a = face[cut.corners[i]], b = face[cut.corners[i + 1]], c = face[cut.corners[i + 2]];
  return cross(b - a, c - a).z;
}

double area_of(const Points& face) {
  double doubled = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    doubled += cross(face[i], face[(i + 1) % face.size()]).z;
  }
  return doubled / 2;
}

// The triangles use the outline's corners, face +z, and their areas sum up to the outline's. So no
// two of them overlap, and none leaves the outline.
void expect_covered(const Points& face, double area) {
  const Triangulation cut = triangulate(face);
  EXPECT_FALSE(cut.crosses);
  ASSERT_EQ(cut.corners.size(), 3 * (face.size() - 2));
  double sum = 0;
  for (std::size_t i = 0; i < cut.corners.size(); i += 3) {
    EXPECT_GE(doubled_area(face, cut, i), -1e-12) << i;
    sum += doubled_area(face, cut, i) / 2;
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
}

// The same outline from each of its corners on.
void expect_covered_from_everywhere(Points face, double area) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    std::rotate(face.begin(), face.begin() + 1, face.end());
    expect_covered(face, area);
  }
}

TEST(Faces, that_are_not_convex_cover_their_outline) {
  const Points l{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}, {2, 4, 0}, {0, 4, 0}};
  expect_covered_from_everywhere(l, 12);
  const Points arrow{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  expect_covered_from_everywhere(arrow, 1);
  Points comb{{9, 3, 0}, {0, 3, 0}};
  for (int i = 0; i < 9; ++i) comb.push_back({i + .5, i % 2 == 0 ? 0 : 2.5, 0});
  expect_covered_from_everywhere(comb, area_of(comb));
}

// An outline that reaches its hole over a bridge, which it crosses twice: a frame of 4 x 4 with a
// hole of 2 x 2. A fan would be a square of 16.
TEST(Faces, that_reach_a_hole_over_a_bridge_leave_it_open) {
  const Points frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                     {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  expect_covered_from_everywhere(frame, 12);
}

// The triangles face +z, and their areas sum up to `area`: none overlaps another or lies in a hole.
void expect_covered_but_holes(const Points& corners, const std::vector<int>& rings, double area) {
  const Triangulation cut = triangulate_with_holes(corners, rings);
  EXPECT_FALSE(cut.crosses);
  double sum = 0;
  for (std::size_t i = 0; i < cut.corners.size(); i += 3) {
    EXPECT_GE(doubled_area(corners, cut, i), -1e-12) << i;
    sum += doubled_area(corners, cut, i) / 2;
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);
}

TEST(Faces, with_a_hole_leave_it_open_whichever_way_it_runs) {
  Points frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},
               {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(frame.begin(), frame.begin() + 1, frame.begin() + 4);
    expect_covered_but_holes(frame, {4, 4}, 12);
    std::reverse(frame.begin() + 4, frame.end());
    expect_covered_but_holes(frame, {4, 4}, 12);
  }
  // A hole that is not inside.
  for (Vec3& p : frame) p.x += &p >= &frame[4] ? 9 : 0;
  EXPECT_TRUE(triangulate_with_holes(frame, std::vector<int>{4, 4}).crosses);
  EXPECT_EQ(triangulate_with_holes(frame, std::vector<int>{4, 4}).corners.size(), 6u);
}

// Stars in the cells of a grid, some of them in line, around them a star that holds the grid.
TEST(Faces, with_many_holes_of_any_shape_leave_all_open) {
  Sampler sampler(69);
  for (int k = 0; k < 200; ++k) {
    Points corners;
    std::vector<int> rings;
    double area = 0;
    const auto add_star = [&](Vec3 center, double least, double most) {
      const int n = 3 + static_cast<int>(sampler.next_1d() * 9);
      Points star;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * kPi * i / n, radius = least + sampler.next_1d() * (most - least);
        star.push_back(center + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0});
      }
      area += rings.empty() ? area_of(star) : -area_of(star);
      if (sampler.next_1d() < .5 && !rings.empty()) std::reverse(star.begin(), star.end());
      corners.insert(corners.end(), star.begin(), star.end());
      rings.push_back(n);
    };
    add_star({1.5, 1.5, 0}, 8, 20);
    for (int i = 0; i < 16; ++i) {
      const int x = i % 4, y = i / 4;
      if (sampler.next_1d() < .6) add_star({double(x), double(y), 0}, .05, .45);
    }
    expect_covered_but_holes(corners, rings, area);
  }
}

// The angle grows from corner to corner, and the radius is any.
TEST(Faces, of_any_star_shape_cover_their_outline) {
  Sampler sampler(46);
  for (int k = 0; k < 300; ++k) {
    const int n = 4 + static_cast<int>(sampler.next_1d() * 40);
    Points star;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * kPi * i / n, radius = .05 + sampler.next_1d();
      star.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    expect_covered(star, area_of(star));
  }
}

TEST(Faces, that_are_convex_stay_fans_bit_for_bit) {
  const Points pentagon{{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 2, 0}, {-1, 1, 0}};
  EXPECT_EQ(triangulate(pentagon).corners, (std::vector<int>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
  // A corner on a straight side, and a corner that is there twice.
  const Points straight{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {2, 2, 0}};
  EXPECT_EQ(triangulate(straight).corners, (std::vector<int>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(Faces, that_cross_themselves_are_named_and_stay_fans) {
  const Points bow_tie{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  const Points lopsided{{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}};
  Points pentagram;
  for (int i = 0; i < 5; ++i) {
    pentagram.push_back({std::cos(.8 * kPi * i), std::sin(.8 * kPi * i), 0});
  }
  for (const Points& face : {bow_tie, lopsided, pentagram}) {
    EXPECT_TRUE(triangulate(face).crosses);
    EXPECT_EQ(triangulate(face).corners[3], 0);
  }
  // Without an area, nothing crosses.
  EXPECT_FALSE(triangulate(Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).crosses);
  EXPECT_FALSE(triangulate(Points(4)).crosses);
}

TEST(Faces, that_are_too_intricate_end_all_the_same) {
  Points zigzag;
  for (int i = 0; i < 20'000; ++i) {
    zigzag.push_back({double(i), (i % 2 == 0 ? 1 : 2) - 1e-9 * i * i, 0});
  }
  for (int i = 20'000; i-- > 0;) {
    zigzag.push_back({double(i), (i % 2 == 0 ? -1 : 0) - 1e-9 * i * i, 0});
  }
  EXPECT_EQ(triangulate(zigzag).corners.size(), 3 * (zigzag.size() - 2));
}

// In a file: an L in a tilted plane, whose corners have normals of their own.
TEST(Faces, keep_their_side_and_their_normals_in_a_file) {
  SceneText text;
  text.geometries =
      mesh("l", "0 0 0 4 0 4 4 2 4 2 2 2 2 4 2 0 4 0", 18, "polygons", "count=\"1\"",
           "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/><p>0 0 1 1 2 2 3 3 4 4 5 5</p>",
           float_source("n", "-9 0 9 -5 0 13 -5 2 13 -7 2 11 -7 4 11 -9 4 9", 18));
  text.nodes = node(instance("l"));
  const LoadedScene loaded = load(text);
  ASSERT_EQ(loaded.scene.primitives.triangles.size(), 4u);
  double area = 0;
  for (const Triangle& t : loaded.scene.primitives.triangles) {
    EXPECT_GT(dot(geometric_normal(t), Vec3{-1, 0, 1}), 0);
    area += length(geometric_normal(t)) / 2;
    expect_near(t.n0, normalize(t.p0 + Vec3{-9, 0, 9}));
    expect_near(t.n1, normalize(t.p1 + Vec3{-9, 0, 9}));
    expect_near(t.n2, normalize(t.p2 + Vec3{-9, 0, 9}));
  }
  EXPECT_NEAR(area, 12 * std::sqrt(2), 1e-12);
  text.geometries = mesh("l", "0 0 0 1 1 0 1 0 0 0 1 0", 12, "polylist", "",
                         "<vcount>4 4</vcount><p>0 1 2 3 0 1 2 3</p>");
  EXPECT_TRUE(has_note(load(text), "geometry 'l' has 2 faces that cross themselves"));
}

// A frame of 4 x 4 around a hole of 2 x 2, between two triangles.
TEST(Faces, with_a_hole_are_read_from_a_file) {
  const std::string corners = "0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 1 3 0 3 3 0 3 1 0";
  const auto areas = [&](const std::string& faces) {
    SceneText text;
    text.geometries = mesh("f", corners, 24, "polygons", "count=\"3\"", faces);
    text.nodes = node(instance("f"));
    const LoadedScene loaded = load(text);
    double area = 0;
    for (const Triangle& t : loaded.scene.primitives.triangles) area += geometric_normal(t).z / 2;
    return std::pair(area, has_note(loaded, "or without its holes"));
  };
  EXPECT_EQ(areas("<p>1 2 5</p><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph><p>1 2 4</p>"),
            std::pair(6. + 12 + 6, false));
  // Two corners are no hole. One that reaches out of its outline is named.
  EXPECT_EQ(areas("<p>1 2 5</p><ph><p>0 1 2 3</p><h>4 5</h></ph><p>1 2 4</p>"),
            std::pair(6. + 16 + 6, false));
  EXPECT_EQ(areas("<p>1 2 5</p><ph><p>4 7 6 5</p><h>0 1 2</h></ph><p>1 2 4</p>"),
            std::pair(6. + 4 + 6, true));
  EXPECT_THROW(areas("<p>1 2 5</p><ph><p>0 1 2 3</p><h>4 5 60</h></ph><p>1 2 4</p>"), Error);
}

LoadedScene load_set(const std::string& kind, const std::string& count, const std::string& lists) {
  SceneText text;
  text.geometries =
      mesh("s", "0 0 0 0 1 0 1 0 0 1 1 0 2 0 0 2 1 0", 18, kind, "count=\"" + count + "\"", lists);
  text.nodes = node(instance("s"));
  return load(text);
}

// Triangles of a strip turn round every second time; they all face one way.
TEST(Faces, of_strips_and_fans_are_triangles) {
  const auto corners = [](const LoadedScene& loaded) {
    std::vector<std::string> all;
    for (const Triangle& t : loaded.scene.primitives.triangles) {
      std::string text;
      for (const Vec3 p : {t.p0, t.p1, t.p2}) text += fmt::format("{:g}{:g} ", p.x, p.y);
      all.push_back(text);
    }
    return fmt::format("{}", fmt::join(all, "; "));
  };
  EXPECT_EQ(corners(load_set("tristrips", "1", "<p>1 0 3 2 5</p>")),
            "01 00 11 ; 11 00 10 ; 11 10 21 ");
  EXPECT_EQ(corners(load_set("tristrips", "2", "<p>0 2 1</p><p>2 4 3 5</p>")),
            "00 10 01 ; 10 20 11 ; 11 20 21 ");
  EXPECT_EQ(corners(load_set("trifans", "1", "<p>0 2 3 1</p>")), "00 10 11 ; 00 11 01 ");
  EXPECT_EQ(corners(load_set("trifans", "2", "<p>0 2 3 1</p><p>2 4 5</p>")),
            "00 10 11 ; 00 11 01 ; 10 20 21 ");
  const LoadedScene loaded = load_set("tristrips", "2", "<p>0 2</p><p>0 2 1</p>");
  EXPECT_EQ(loaded.scene.primitives.triangles.size(), 1u);
  EXPECT_TRUE(has_note(loaded, "1 faces of fewer than three corners"));
}

TEST(Faces, of_empty_sets_need_no_inputs) {
  SceneText text;
  text.geometries = triangle_mesh();
  text.geometries.insert(text.geometries.find("</mesh>"),
                         "<triangles count=\"0\"/><polylist count=\"0\"><vcount/><p/></polylist>"
                         "<polygons/><tristrips count=\"0\"/>");
  text.nodes = node(instance("tri"));
  const LoadedScene loaded = load(text);
  EXPECT_EQ(loaded.scene.primitives.triangles.size(), 1u);
  EXPECT_TRUE(has_note(loaded, "geometry 'tri' has a set of no faces, which is left out."));
}

}  // namespace
}  // namespace pt
