// naive SCENE.txt WIDTH HEIGHT SAMPLES DEPTH SEED OUT.pfm [MISTAKE]: a path tracer written from the physics alone, which shares no line with
// the project. It finds light only by running into it. SCENE.txt is what `./run export --to plain` writes. MISTAKE is a word that
// makes it wrong: /pi, uniform, shallow, both_sides, upside_down.
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

struct Vec {
  double x = 0, y = 0, z = 0;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit(Vec a) { return a * (1 / std::sqrt(dot(a, a))); }
std::istream& operator>>(std::istream& in, Vec& v) { return in >> v.x >> v.y >> v.z; }

struct Shape {
  bool is_sphere = false;
  Vec a, b, c, na, nb, nc;  // a sphere: its centre a and its radius
  double radius = 0;
  Vec albedo, emission;
};
struct Hit {
  double t = 1e300;
  Vec face, normal;  // outwards; `normal` is interpolated
  const Shape* shape = nullptr;
};

struct Renderer {
  Vec position, right, up, back;
  double hfov = 0, vfov = 0;
  std::vector<Shape> shapes;
  std::string mistake;
  std::mt19937_64 random;
  double next() { return std::uniform_real_distribution<double>(0, 1)(random); }

  explicit Renderer(const std::string& file) {
    std::ifstream lines(file);
    for (std::string line, kind; std::getline(lines, line);) {
      std::istringstream in(line);
      Shape s;
      in >> kind;
      if (kind == "camera") in >> position >> right >> up >> back >> hfov >> vfov;
      if (kind == "triangle")
        in >> s.a >> s.b >> s.c >> s.na >> s.nb >> s.nc >> s.albedo >> s.emission;
      if (kind == "sphere") s.is_sphere = true, in >> s.a >> s.radius >> s.albedo >> s.emission;
      if (kind == "triangle" || kind == "sphere") shapes.push_back(s);
    }
  }

  void hit_sphere(const Shape& s, Vec o, Vec d, Hit& hit) const {
    const Vec m = o - s.a;
    const double b = dot(m, d), root = b * b - dot(m, m) + s.radius * s.radius;
    for (const double sign : {-1., 1.}) {
      const double t = -b + sign * std::sqrt(root);
      if (!(t > 1e-6) || t >= hit.t) continue;
      const Vec n = unit(o + d * t - s.a);
      hit = {t, n, n, &s};
      return;
    }
  }
  void hit_triangle(const Shape& s, Vec o, Vec d, Hit& hit) const {
    const Vec n = cross(s.b - s.a, s.c - s.a);
    const double t = dot(s.a - o, n) / dot(d, n);
    if (!(t > 1e-6) || t >= hit.t) return;
    const Vec p = o + d * t;
    const double whole = dot(n, n), u = dot(cross(s.c - s.b, p - s.b), n) / whole,
                 v = dot(cross(s.a - s.c, p - s.c), n) / whole, w = 1 - u - v;
    if (u < 0 || v < 0 || w < 0) return;
    hit = {t, unit(n), unit(s.na * u + s.nb * v + s.nc * w), &s};
  }

  Vec light(Vec o, Vec d, int depth) {
    Vec sum, weight{1, 1, 1};
    for (int bounce = 0; bounce <= depth; ++bounce) {
      Hit hit;
      for (const Shape& s : shapes)
        s.is_sphere ? hit_sphere(s, o, d, hit) : hit_triangle(s, o, d, hit);
      if (hit.shape == nullptr) break;
      const bool front = dot(hit.face, d) < 0;
      if (front || mistake == "both_sides") sum = sum + weight * hit.shape->emission;
      const Vec n = dot(hit.normal, d) < 0 ? hit.normal : hit.normal * -1;
      // A direction on the hemisphere, in proportion to its cosine: then only the albedo is left of f cos / pdf.
      const double r2 = next(), angle = 2 * M_PI * next();
      const double z = mistake == "uniform" ? r2 : std::sqrt(1 - r2), r = std::sqrt(1 - z * z);
      const Vec side = unit(cross(std::abs(n.x) < .9 ? Vec{1, 0, 0} : Vec{0, 1, 0}, n));
      weight = weight * hit.shape->albedo * (mistake == "/pi" ? 1 / M_PI : 1);
      o = o + d * hit.t;
      d = unit(side * (r * std::cos(angle)) + cross(n, side) * (r * std::sin(angle)) + n * z);
    }
    return sum;
  }
};

int main(int count, char** words) {
  Renderer renderer(words[1]);
  const int width = std::stoi(words[2]), height = std::stoi(words[3]),
            samples = std::stoi(words[4]);
  renderer.random.seed(std::stoul(words[6]));
  if (count > 8) renderer.mistake = words[8];
  const int depth = std::stoi(words[5]) - (renderer.mistake == "shallow");
  const double tan_h = std::tan(renderer.hfov * M_PI / 360),
               tan_v = std::tan(renderer.vfov * M_PI / 360);
  std::ofstream out(words[7], std::ios::binary);
  out << "PF\n" << width << " " << height << "\n-1\n";
  for (int row = 0; row < height; ++row) {  // from the bottom, as PFM has them
    const int y = renderer.mistake == "upside_down" ? height - 1 - row : row;
    for (int x = 0; x < width; ++x) {
      Vec sum;
      for (int i = 0; i < samples; ++i) {
        const double u = (2 * (x + renderer.next()) / width - 1) * tan_h;
        const double v = (2 * (y + renderer.next()) / height - 1) * tan_v;
        sum =
            sum + renderer.light(renderer.position,
                                 unit(renderer.right * u + renderer.up * v - renderer.back), depth);
      }
      for (const double each : {sum.x, sum.y, sum.z}) {
        const float value = static_cast<float>(each / samples);
        out.write(reinterpret_cast<const char*>(&value), 4);
      }
    }
  }
}
