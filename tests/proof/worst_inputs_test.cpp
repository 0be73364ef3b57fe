#include "grader/check/language/exact.h"
#include "grader/tasks/hit_sphere/truth.h"
#include "grader/tasks/hit_triangle/truth.h"
#include "pt/scene/scene.h"
#include "pt/tasks/build_bvh.h"
#include "pt/tasks/camera_ray.h"
#include "pt/tasks/diffuse_bsdf.h"
#include "pt/tasks/direct_lights.h"
#include "pt/tasks/hit_box.h"
#include "pt/tasks/hit_sphere.h"
#include "pt/tasks/hit_triangle.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// The inputs with the reference's largest errors, found by ./run stability --search and the curves
// (docs/stability.md). Other code, or the same without a remedy, is much worse on them.
// tests/mutants/mutants.txt undoes each remedy.

namespace pt::proof {
namespace {

using grader::check::Exact;
using grader::check::Exact3;
using grader::check::rounded;
using namespace grader::check::hit_sphere_inputs;
using namespace grader::check::hit_triangle_inputs;

struct AtTriangle {
  Triangle triangle;
  Ray ray;
};

const AtTriangle kTriangles[] = {
    {{{60.36557704191306, 16.907303134909295, 86.7046429643837},
      {60.51107366264933, 16.907303134909295, 86.70464296425112},
      {60.45469207750895, 17.052799755645562, 86.70464296439084},
      {0.11920168206223572, 0.005348818068494709, -0.9928556537275717},
      {0.1474469863216822, 0.020008580781398545, -0.9888675558029841},
      {0.16577652197889098, 0.00010707134365360897, -0.9861633400691338}},
     {{40.46881693900817, 67.08652250638627, 221.82626124785114},
      {1.969663447477527e-09, -4.940684746080715e-09, -1.3319526911998668e-08}}},
    {{{26615.23810762722, -24565.140665690138, 25715.301192179784},
      {26556.694148916682, -24579.567435268582, 25792.92976900444},
      {26609.044387250095, -24477.1663797113, 25770.816728596474},
      {0.37611401397327854, 0.9206314922772303, -0.10476594828620744},
      {-0.9230782950307216, -0.028603535159057333, -0.3835469971458267},
      {-0.9230782951673434, -0.028603534828020936, -0.383546996841708}},
     {{-2858.9812079657822, -41278.51693905998, 59814.65132793578},
      {4.227091999049988e-08, 2.4024713540476308e-08, -4.887508381612272e-08}}},
    // The largest errors of t and of n.
    {{{7115792.423143389, 253032.98981721653, 6432814.5128047},
      {7122912.428153954, 253032.98981721653, 6432814.5128047},
      {7120514.734526242, 253032.98981721653, 6439934.517815266},
      {-0.7237647098471292, 0.2723877025273456, -0.6340107130733481},
      {-0.14584823680381015, 0.5410729685645213, -0.8282320535393425},
      {-0.5309779046179356, -0.4516979276490747, -0.7169598642637381}},
     {{8418954.164881622, -6746847.931112295, 6446907.88588546},
      {-2.007478170740238e-06, 1.0804845991381375e-05, -1.65630370415609e-08}}},
    {{{4830529.687488403, -198969.65458836596, 8925295.787971174},
      {4828207.1247791685, -190943.608206742, 8922157.430848468},
      {4833864.898642328, -187381.74918516164, 8928080.922950247},
      {-0.6761770534527786, -0.6738520180045612, 0.29783896691853257},
      {0.42173484005816, 0.4253980905352741, 0.8007347808419845},
      {0.4217347981611322, 0.42539810599019195, 0.8007347946979365}},
     {{-799820.0286079738, 56684.78804414638, 2004784.1005189735},
      {1.1540293699414282e-07, -5.145880980426865e-09, 1.4183898022567974e-07}}},
};

// The contract's limit for a point, as a length.
double allowed(const AtTriangle& at, double t) {
  const Triangle& triangle = at.triangle;
  const double edge = length(triangle.p1 - triangle.p0), way = t * length(at.ray.direction);
  const Vec3 twice_area = geometric_normal(triangle);
  const double sine = std::abs(dot(normalize(twice_area), normalize(at.ray.direction)));
  const double thin = std::max(1.0, edge * edge / length(twice_area));
  return 1e-9 * std::max({max_abs(at.ray.at(t)), edge, way}) * thin / sine;
}

// The largest error was a millionth of it; a hundred-thousandth leaves room for other compilers.
TEST(WorstInputs, triangles_keep_far_more_digits_than_promised) {
  for (const AtTriangle& at : kTriangles) {
    const auto [t, place] = meet(at.triangle, at.ray);
    const auto hit = hit_triangle(at.triangle, at.ray);
    ASSERT_TRUE(hit);
    const double off_t = std::abs(rounded(hit->t - t)) * length(at.ray.direction);
    EXPECT_LE(off_t, 1e-5 * allowed(at, hit->t));
    EXPECT_LE(length(hit->n - rounded(normal_at(at.triangle, place))), 1e-8);
  }
}

// Three corners on a line, to which rounding has given an area, and a ray that seems to be in their
// plane. If the determinant is not compared with its rounding error, the hit is far off.
const AtTriangle kWithoutArea[] = {
    {{{-10.855446634982577, -0.80610049419177698, -3.405171780123585},
      {-11.226196290336423, -0.80713651856353541, -3.819085770339445},
      {-10.534035577874333, -0.80520234180320915, -3.0463406086685505},
      {0, 0, 1},
      {0, 0, 1},
      {0, 0, 1}},
     {{-12.031460534690479, -1.1133904475278831, -4.5841988753051073},
      {0.6926452300101017, 0.16167955237159418, 0.70292411232591401}}},
    {{{12.168403500018663, 13.226405927448925, -11.706532883876401},
      {12.019399826929172, 14.957798260121063, -11.406472811742065},
      {12.014551656039416, 15.014133018398931, -11.396709679889426},
      {0, 0, 1},
      {0, 0, 1},
      {0, 0, 1}},
     {{13.853698673995998, 7.5996105558743459, -14.779128301096931},
      {-0.24180464600069868, 0.86373179232770003, 0.44215144927372513}}},
    {{{-16.078494482690537, 1.6110833691328672, -6.8468151095652701},
      {-15.623017592226882, 2.1648019443254025, -5.1561002700185332},
      {-16.507660997065216, 1.089350047782605, -8.4398667213631509},
      {0, 0, 1},
      {0, 0, 1},
      {0, 0, 1}},
     {{-10.715858422693081, -1.5546854240695973, -8.689525301015065},
      {-0.79573919449374597, 0.5001104408562872, 0.34159725012501824}}},
};

TEST(WorstInputs, triangles_without_area_are_not_hit_beside_them) {
  for (const AtTriangle& at : kWithoutArea) {
    EXPECT_FALSE(hit_triangle(at.triangle, at.ray).has_value());
  }
}

struct AtSphere {
  Sphere sphere;
  Ray ray;
};

// Spheres at most a thousand radii away. The last two have the worst normals: their centres have
// coordinates of a million radii, so that an ulp of a coordinate is 1e-10 of the radius.
const AtSphere kSpheres[] = {
    {{{-6565417.690410527, 11951187.386336766, -5682787.735812953}, 12009.695186021176},
     {{-18555048.959142637, 11558373.889895052, -5506672.828470255},
      {4.235627537092276e-08, 1.3877087836796897e-09, -6.221685509032903e-10}}},
    {{{-6565417.690410527, 11951187.386336766, -975951.9333196989}, 12009.695186021176},
     {{-18555048.959142637, 11558373.889895052, -799837.0259770015},
      {4.235627537092276e-08, 1.3877087836796897e-09, -6.221685509032903e-10}}},
    {{{-9.303604266543777, 8.339243187461584, 9.342006448847359}, 1e-05},
     {{-9.310749426669078, 8.341108287168776, 9.335278349681321},
      {17989520.655907698, -4696515.243395497, 16942680.86860133}}},
    {{{-4565047694.623078, 4566666239.380042, -4566665556.714742}, 4566.666239380052},
     {{-4565030654.460373, 4566668870.527577, -4566670658.415979},
      {-25.686394501115885, -10.970109659491378, 11.441938257955204}}},
};

// Returns whether an ulp of the centre's coordinates is more than 1e-11 of the radius.
bool is_far_from_the_origin(const Sphere& sphere) {
  return max_abs(sphere.center) > 1e5 * sphere.radius;
}

TEST(WorstInputs, spheres_keep_far_more_digits_than_promised) {
  for (const AtSphere& at : kSpheres) {
    const auto hit = hit_sphere(at.sphere, at.ray);
    ASSERT_TRUE(hit);
    const double limit = is_far_from_the_origin(at.sphere) ? 1e-9 : 1e-11;
    EXPECT_LE(off(at.sphere, at.ray, *hit).point, limit);
    EXPECT_LE(off(at.sphere, at.ray, *hit).normal, limit);
  }
}

// Spheres millions of radii away, where the textbook's discriminant has lost all digits.
const AtSphere kFarSpheres[] = {
    {{{218090.62301635748, -182760.97767448425, -21274.71237564091}, 31586.180302497676},
     {{-301808896413.0452, -22034221978.608856, -39173715220.09016},
      {0.9890925718993354, 0.07221022100311117, 0.12838056004021714}}},
    {{{-0.004124560655327505, -0.051660533361427965, -0.04486238593926827}, 0.0332047326498288},
     {{-290824.72369097994, 123769.05537282082, -31228.874778794783},
      {0.915680042613448, -0.38969484738187254, 0.09832591460776297}}},
};

TEST(WorstInputs, far_spheres_keep_the_promise) {
  for (const AtSphere& at : kFarSpheres) {
    const auto hit = hit_sphere(at.sphere, at.ray);
    ASSERT_TRUE(hit);
    EXPECT_LE(off(at.sphere, at.ray, *hit).point, 2e-8);
    EXPECT_LE(off(at.sphere, at.ray, *hit).normal, 2e-8);
  }
}

struct AtBox {
  Box box;
  Ray ray;
};

// The reference's form with inverse directions, without the wider far planes.
bool is_hit_by_plain_slabs(const AtBox& at) {
  double enter = at.ray.t_min, leave = at.ray.t_max;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / at.ray.direction[axis];
    const double a = (at.box.min[axis] - at.ray.origin[axis]) * inverse;
    const double b = (at.box.max[axis] - at.ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// Rays exactly at an edge or a corner, with the shortest intervals found: four rounding errors.
// Plain slabs miss all of these boxes (Ize 2013).
const AtBox kBoxes[] = {
    {{{219333.65804004669, 289435.78496456146, -197363.4257516861},
      {219339.0747127533, 289435.78496456146, -197360.81970310211}},
     {{219339.23500156403, 289441.34365081787, -197354.27543354034},
      {-5.5769615173339844, -5.5586862564086914, -6.5442695617675781}}},
    {{{831591.61025905609, 373654.75154590607, -78911.387608528137},
      {831595.17796516418, 373655.99387168884, -78911.387608528137}},
     {{831584.03349781036, 373641.61358737946, -78919.111652374268},
      {9.3606147766113281, 13.137958526611328, 7.7240438461303711}}},
    {{{441.16413593292236, -15.398446083068848, 167.37734508514404},
      {443.98058605194092, -15.398446083068848, 173.87109661102295}},
     {{443.23363399505615, -21.529637336730957, 173.04091548919678},
      {0.74695205688476562, 6.1311912536621094, 0.83018112182617188}}},
    {{{-0.025334358215332031, -604.65563869476318, -968.39373779296875},
      {2.4522914886474609, -601.21860980987549, -966.14535713195801}},
     {{-6.4628210067749023, -590.31223583221436, -964.87513732910156},
      {6.4374866485595703, -12.62488842010498, -3.5186004638671875}}},
    {{{985221193.31625175, -372127784.34963512, -14916522.417758942},
      {985221196.37933731, -372127780.67245102, -14916522.417758942}},
     {{985221192.24617195, -372127794.96308327, -14916512.203598976},
      {1.0700798034667969, 14.290632247924805, -10.214159965515137}}},
};

TEST(WorstInputs, boxes_are_hit_at_their_edges) {
  for (const AtBox& at : kBoxes) {
    EXPECT_FALSE(is_hit_by_plain_slabs(at));
    const auto hit = hit_box(at.box, at.ray);
    ASSERT_TRUE(hit);
    EXPECT_LE(hit->min, 1 + 1e-15);
    EXPECT_GE(hit->max, 1 - 1e-15);
  }
}

int levels_below(const Bvh& bvh, int index) {
  const BvhNode& node = bvh.nodes[index];
  if (node.is_leaf()) return 0;
  return 1 + std::max(levels_below(bvh, node.left), levels_below(bvh, node.right));
}

// The deepest tree found: it has 3.4 times the levels of a balanced tree. Planes alone separate one
// point each.
TEST(WorstInputs, points_that_halve_their_distance_do_not_make_a_chain) {
  for (const int points : {32, 1000}) {
    std::vector<Box> boxes;
    for (int i = 0; i < points; ++i) {
      const Vec3 p{0, std::pow(2, -i), 0};
      boxes.push_back({p, p});
    }
    EXPECT_LE(levels_below(build_bvh(boxes, 1), 0), 4 * std::log2(points));
  }
}

// A turned telescope with a field of view of a thousandth of a degree. Its window is 2e-5 high, so
// an ulp of the direction is 1e-11 of it.
TEST(WorstInputs, a_turned_telescope_keeps_its_rays_apart) {
  Camera camera;
  camera.camera_to_world = {{-0.2813723035038376, 0.9319495528352192, -0.22869118433201396},
                            {-0.17074204026545792, 0.1858945144248022, 0.9676209925341406},
                            {0.9442863879707961, 0.3113089469915728, 0.10681740034313214}};
  camera.hfov_deg = 10.000004667773968;
  camera.vfov_deg = 0.001;
  const Exact3 d = camera_ray(camera, 0.9999999742217173, 0.5).direction;
  const Exact up = dot(d, Exact3(camera.camera_to_world.y));
  const Exact ahead = -dot(d, Exact3(camera.camera_to_world.z));
  const double height = 2 * std::tan(0.0005 * kPi / 180);
  EXPECT_LE(std::abs(rounded(up / ahead)), 1e-10 * height);
}

// Their product is 0, so it cannot show whether they are on the same side.
TEST(WorstInputs, cosines_whose_product_is_zero_are_on_one_side) {
  const Vec3 wo{1, 0, 1e-200}, wi{0, 1, 1e-200}, below{0, 1, -1e-200};
  EXPECT_EQ(diffuse_f(gray(0.5), wo, wi).r, 0.5 / kPi);
  EXPECT_EQ(diffuse_f(gray(0.5), wo, below).r, 0);
  EXPECT_GT(diffuse_pdf(wo, wi), 0);
  EXPECT_EQ(diffuse_pdf(wo, below), 0);
}

// A lamp close to the surface, seen at an angle of a thousandth.
TEST(WorstInputs, a_lamp_at_a_flat_angle_keeps_its_cosine) {
  const Vec3 lamp{-0.043391, -0.090096, 0.00010713};
  Scene scene;
  scene.lights.push_back(PointLight{lamp, gray(1e6)});
  SurfacePoint point;
  point.n = point.geometric_normal = {0, 0, 1};
  point.wo = {0.6, 0, 0.8};
  point.albedo = gray(0.25488);
  Sampler sampler(1);
  const Exact3 exact = lamp;
  const double squared = rounded(dot(exact, exact));
  const double expected = 0.25488 / kPi * 1e6 / squared * lamp.z / std::sqrt(squared);
  EXPECT_NEAR(direct_lights(scene, point, 1, sampler).r / expected, 1, 1e-12);
}

}  // namespace
}  // namespace pt::proof
