#include "pt/file.h"
#include "pt/image/compare.h"
#include "pt/image/exr.h"
#include "pt/image/film.h"
#include "pt/image/image_io.h"
#include "pt/image/tone_map.h"
#include "pt/math/vec3.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

// The render program from its user's view: exit codes, messages, and the files in the folder
// afterwards.

namespace {

namespace fs = std::filesystem;

// The smallest possible scene: a lit floor, and a camera that looks straight down at it.
const char* const kScene = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><up_axis>Y_UP</up_axis></asset>
 <library_effects><effect id="e"><profile_COMMON/>%EFFECT%</effect></library_effects>
 <library_materials><material id="m" name="paint"><instance_effect url="#e"/></material></library_materials>
 <library_lights><light id="l"><extra><technique profile="CGL"><point><color>9 9 9</color></point></technique></extra></light></library_lights>
 <library_cameras><camera id="c"><optics><technique_common><perspective>
  <xfov>40</xfov><aspect_ratio>1.3333333333333333</aspect_ratio><znear>.1</znear><zfar>100</zfar>
 </perspective></technique_common></optics></camera></library_cameras>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="9">-2 0 2 2 0 2 0 0 -2</float_array>
   <technique_common><accessor source="#a" count="3" stride="3"/></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s">
  <node><instance_geometry url="#g"><bind_material><technique_common>
   <instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node>
  <node><translate>0 3 0</translate><instance_light url="#l"/></node>
  <node><translate>0 2 0</translate><rotate>1 0 0 -90</rotate><instance_camera url="#c"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";

std::string scene_with(const std::string& effect) {
  std::string text = kScene;
  const std::string mark = "%EFFECT%";
  return text.replace(text.find(mark), mark.size(), effect);
}

class RenderProgram : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = fs::temp_directory_path() / "firstlight.XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    write("scene.dae", scene_with(""));
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  // Runs the program in the folder; its output goes to said().
  int run(const std::string& arguments, const std::string& program = RENDER_PROGRAM) const {
    const std::string command = "cd '" + folder_.string() + "' && '" + program + "' " + arguments +
                                " > said 2>&1 < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string contents(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / file, std::ios::binary).rdbuf();
    return text.str();
  }

  std::string said() const { return contents("said"); }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename();
      if (name != "said" && entry.path().extension() != ".dae") names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(RenderProgram, writes_the_picture_asked_for) {
  EXPECT_EQ(run("scene.dae -f a.png -s 2 -r 16 12"), 0) << said();
  EXPECT_EQ(run("-r 16 12 -f b.exr -s 4 -l 2 -m 2 -t 2 -H scene.dae"), 0) << said();
  EXPECT_EQ(files(), (Names{"a.png", "b.exr"}));
  EXPECT_NE(said().find("tests per ray"), std::string::npos) << said();
}

// Stubs are called by many threads, some of them before the render begins.
TEST_F(RenderProgram, names_the_tasks_that_are_not_written_in_one_line) {
  const auto lines = [&] {
    std::istringstream text(said());
    Names found;
    for (std::string line; std::getline(text, line);) {
      if (line.find("not written") != std::string::npos) found.push_back(line);
    }
    return found;
  };
  EXPECT_EQ(run("scene.dae -s 2 -t 4 -r 8 6", STUBS_RENDER_PROGRAM), 0) << said();
  EXPECT_EQ(lines(), Names{"not written yet: build_bvh, estimate_pixel, hit_bvh (traced without "
                           "a tree)"});
  EXPECT_EQ(run("scene.dae -s 2 -t 4 -r 8 6 --engine linear", STUBS_RENDER_PROGRAM), 0) << said();
  EXPECT_EQ(lines(), Names{"not written yet: estimate_pixel"});
  EXPECT_EQ(run("scene.dae -s 2 -t 4 -r 8 6"), 0) << said();
  EXPECT_EQ(lines(), Names{});
}

TEST_F(RenderProgram, names_the_picture_after_the_scene_where_no_name_is_given) {
  EXPECT_EQ(run("scene.dae -s 1 -r 8 6"), 0) << said();
  EXPECT_EQ(files(), Names{"scene.png"});
}

TEST_F(RenderProgram, writes_the_sample_rates_of_an_adaptive_render) {
  EXPECT_EQ(run("-r 16 12 -a 8 0.1 scene.dae -f a.png -s 64"), 0) << said();
  EXPECT_EQ(files(), (Names{"a.png", "a_rate.csv", "a_rate.png"}));
}

TEST_F(RenderProgram, shows_every_view) {
  for (const char* view : {"full", "direct", "indirect", "bounce --bounce 2", "normals"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 2 -r 8 6 --show ") + view), 0) << said();
  }
  for (const char* engine : {"task", "linear"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 2 -r 8 6 --engine ") + engine), 0) << said();
  }
  for (const char* camera : {"course", "fit", "file"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 2 -r 8 6 --camera ") + camera), 0) << said();
  }
}

TEST_F(RenderProgram, without_a_size_makes_one_of_480_by_360) {
  EXPECT_EQ(run("scene.dae -s 1 -m 0 -f a.exr"), 0) << said();
  EXPECT_EQ(pt::read_exr(folder_ / "a.exr").width, 480);
  EXPECT_EQ(pt::read_exr(folder_ / "a.exr").height, 360);
}

TEST_F(RenderProgram, without_a_framing_takes_that_of_the_course) {
  std::vector<std::string> pictures;
  for (const char* camera : {"", "--camera course", "--camera fit", "--camera file"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 1 -m 1 -r 16 12 -f a.exr ") + camera), 0) << said();
    pictures.push_back(contents("a.exr"));
  }
  EXPECT_TRUE(pictures[0] == pictures[1]);
  EXPECT_FALSE(pictures[0] == pictures[2]);
  EXPECT_FALSE(pictures[0] == pictures[3]);
}

// A batch may contain all the samples.
TEST_F(RenderProgram, takes_a_batch_of_all_samples) {
  EXPECT_EQ(run("scene.dae -s 8 -a 8 0.1 -r 8 6"), 0) << said();
  EXPECT_EQ(run("scene.dae -s 8 -a 9 0.1 -r 8 6"), 2) << said();
  EXPECT_EQ(run("scene.dae -s 8 -a 2 0.1 -r 8 6"), 0) << said();
}

// All 16 x 12 x 4 camera rays hit the floor and sample two lights there: 2304 rays in all.
TEST_F(RenderProgram, says_how_many_rays_there_were) {
  std::string two = scene_with("");
  const std::string light = "<instance_light url=\"#l\"/>";
  two.insert(two.find(light), light);
  write("two.dae", two);
  EXPECT_EQ(run("two.dae -s 4 -m 1 -r 16 12"), 0) << said();
  EXPECT_NE(said().find(" 0.0023 M rays (67 % shadow)"), std::string::npos) << said();
  EXPECT_NE(said().find("1 primitives, 2 lights, engine task, "), std::string::npos) << said();
}

TEST_F(RenderProgram, lights_a_scene_that_has_no_light_and_says_so) {
  std::string dark = scene_with("");
  const std::string light = "<instance_light url=\"#l\"/>";
  dark.erase(dark.find(light), light.size());
  write("dark.dae", dark);
  const auto brightness = [&](const std::string& options) {
    EXPECT_EQ(run("dark.dae -s 64 -m 1 -r 8 6 --camera file -f a.exr " + options), 0) << said();
    return pt::read_exr(folder_ / "a.exr").at(4, 3).mean.g;
  };
  // The floor has albedo .5. The sky sends radiance 1 from everywhere, the lamp as much light from straight above.
  EXPECT_NEAR(brightness(""), .5, .1);
  EXPECT_NE(said().find("no light"), std::string::npos) << said();
  for (const char* choice : {"sky", "camera"}) {
    EXPECT_NEAR(brightness(std::string("--light ") + choice), .5, .1) << choice;
    EXPECT_EQ(said().find("no light"), std::string::npos) << said();
  }
  EXPECT_EQ(run("scene.dae -s 1 -r 8 6"), 0) << said();
  EXPECT_EQ(said().find("no light"), std::string::npos) << said();
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), by);
}

const std::string kLightOfScene = "<instance_light url=\"#l\"/>";

TEST_F(RenderProgram, lets_the_emission_of_other_programs_shine_if_it_is_asked_to) {
  std::string glowing = replaced(
      scene_with(""), "<profile_COMMON/>",
      "<profile_COMMON><technique sid=\"c\"><constant><emission><color>2 2 2 1</color></emission>"
      "</constant></technique></profile_COMMON>");
  write("glowing.dae", replaced(glowing, kLightOfScene, ""));
  EXPECT_EQ(run("glowing.dae -s 1 -r 8 6 -f a.exr"), 0) << said();
  EXPECT_NE(said().find("emission colours in profile_COMMON are ignored; --common-emission makes"),
            std::string::npos)
      << said();
  EXPECT_EQ(run("glowing.dae -s 1 -r 8 6 -f a.exr --common-emission --camera file"), 0) << said();
  EXPECT_EQ(said().find("ignored"), std::string::npos) << said();
  EXPECT_EQ(pt::read_exr(folder_ / "a.exr").at(4, 3).mean.g, 2);
}

// The camera looks down at the floor from a height of 2; the light is at a height of 3.
TEST_F(RenderProgram, says_why_a_picture_is_black) {
  const auto note = [&](const std::string& old, const std::string& by,
                        const std::string& options = "--camera file") {
    write("black.dae", replaced(scene_with(""), old, by));
    EXPECT_EQ(run("black.dae -s 1 -r 8 6 " + options), 0) << said();
    const std::string text = said();
    return text.substr(std::min(text.find("the picture is"), text.size()));
  };
  const auto begins = [](const std::string& text, const std::string& with) {
    EXPECT_EQ(text.substr(0, with.size()), with);
  };
  begins(note("9 9 9", "9 9 9"), "");
  begins(note("9 9 9", ".001 .001 .001"),
         "the picture is too dark to see: its brightest pixel has the radiance 1.8e-05; give "
         "--exposure 5.");
  begins(
      note("<profile_COMMON/>",
           "<profile_COMMON><technique sid=\"c\"><phong><diffuse><color>0 0 0 1</color></diffuse>"
           "</phong></technique></profile_COMMON>"),
      "the picture is black: the surfaces in view reflect nothing");
  // Too thin for any ray, also of the camera that --camera file falls back to.
  const std::string small = "-2 0 -1 2 0 1.3 2 0 1.3000001";
  const std::string large = "-2 0 2 2 0 2 0 0 -2";
  begins(note(large, small), "the picture is black: the camera looks past all surfaces");
  begins(note(large, small, "--show normals --camera file"),
         "the picture is black: the camera looks past all surfaces");
  begins(note("1 0 0 -90", "1 0 0 -90", "-m 0"),
         "the picture is black: no light reaches the surfaces in view");
  // A lamp of radius .5 around (0, .9, 0), and the camera in it.
  const std::string lamp = pt::read_file(FIRSTLIGHT_SCENES "/glowing_sphere.dae", 1 << 20);
  write("inside.dae", replaced(lamp, "0 .5 2.2", "0 .8 .1"));
  EXPECT_EQ(run("inside.dae -s 4 -m 1 -r 8 6 --camera file"), 0) << said();
  EXPECT_NE(said().find("the camera stands inside an emitting sphere"), std::string::npos)
      << said();
}

// Lamps shine to one side where they have faces. Below its plane the light of a point does not reach the floor.
TEST_F(RenderProgram, names_the_side_of_a_lamp_where_a_lamp_has_faces) {
  const std::string side = "only to the side from which their corners run anticlockwise";
  EXPECT_EQ(run("scene.dae -s 1 -r 8 6 -m 0 --camera file"), 0) << said();
  EXPECT_NE(said().find("no light reaches the surfaces"), std::string::npos) << said();
  EXPECT_EQ(said().find(side), std::string::npos) << said();
  write("panel.dae", replaced(scene_with(""), "<point><color>9 9 9</color></point>",
                              "<area><color>9 9 9</color></area>"));
  EXPECT_EQ(run("panel.dae -s 1 -r 8 6 -m 0 --camera file"), 0) << said();
  EXPECT_NE(said().find(side), std::string::npos) << said();
}

// The camera looks down at the floor from a height of 2.
TEST_F(RenderProgram, frames_the_scene_where_the_files_camera_sees_nothing) {
  const std::string sentence = "the file's camera sees no surface from where it stands, or clips";
  const std::string all = scene_with("");
  EXPECT_EQ(run("scene.dae -s 1 -m 1 -r 16 12 -f fit.exr --camera fit --light camera"), 0)
      << said();
  for (const auto& [old, by] : {std::pair("<zfar>100", "<zfar>1.5"),
                                {"<znear>.1", "<znear>50"},
                                {"1 0 0 -90", "1 0 0 90"}}) {
    write("blind.dae", replaced(all, old, by));
    EXPECT_EQ(run("blind.dae -s 1 -m 1 -r 16 12 -f a.exr --camera file --light camera"), 0)
        << said();
    EXPECT_NE(said().find(sentence), std::string::npos) << by << said();
    EXPECT_EQ(said().find("the picture is black"), std::string::npos) << by << said();
    // The camera that looks up sees the floor from below.
    const auto pixels = [&](const char* file) { return mean(pt::read_exr(folder_ / file)).pixels; };
    EXPECT_EQ(pixels("a.exr") == pixels("fit.exr"), std::string(by) != "1 0 0 90") << by;
  }
  EXPECT_EQ(run("scene.dae -s 1 -m 1 -r 16 12 --camera file"), 0) << said();
  EXPECT_EQ(said().find(sentence), std::string::npos) << said();
}

// Stubs come first, also where the camera looks past all surfaces.
TEST_F(RenderProgram, asks_of_a_black_picture_first_what_is_not_written) {
  for (const char* options : {"", "--show normals", "-m 0", "-H --engine linear"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 1 -r 8 6 ") + options, STUBS_RENDER_PROGRAM), 0);
    EXPECT_NE(said().find("the picture is black: write estimate_pixel before"), std::string::npos)
        << options << said();
    EXPECT_EQ(said().find("smaller than a pixel"), std::string::npos) << options << said();
  }
  write("past.dae", replaced(scene_with(""), "-2 0 2 2 0 2 0 0 -2", "-2 0 2 -2 0 3 -3 0 2"));
  EXPECT_EQ(run("past.dae -s 1 -r 8 6 --camera file", STUBS_RENDER_PROGRAM), 0) << said();
  EXPECT_NE(said().find("the picture is black: write estimate_pixel"), std::string::npos) << said();
}

// All is written here, and hit_triangle finds nothing. The triangle in small.dae is narrower than a pixel.
TEST_F(RenderProgram, says_of_a_black_picture_that_a_task_is_wrong_where_our_rays_see_light) {
  const auto says = [&](const std::string& words, const std::string& program,
                        const char* sentence) {
    EXPECT_EQ(run(words + " -r 8 6 --camera file", program), 0) << said();
    EXPECT_NE(said().find(sentence), std::string::npos) << words << said();
  };
  says("scene.dae -s 4 --show normals", BLIND_RENDER_PROGRAM, "a task of part 1 or 2 is wrong");
  says("scene.dae -s 4", BLIND_RENDER_PROGRAM, "though light reaches the surfaces in view");
  says("scene.dae -s 4 -m 0", BLIND_RENDER_PROGRAM, "no light reaches the surfaces in view");
  // Hemisphere sampling never finds a point.
  says("scene.dae -s 4 -H", RENDER_PROGRAM, "give more samples (-s) and leave out -H");
  write("small.dae", replaced(scene_with(""), "-2 0 2 2 0 2 0 0 -2", "0 0 1 .02 0 1 0 0 -2"));
  says("small.dae -s 1 --show normals", RENDER_PROGRAM, "are smaller than a pixel");
}

// As ./run render --from reference --from hit_bvh=first_child_that_hits.
TEST_F(RenderProgram, makes_the_handbooks_picture_of_a_mistake) {
  const std::string words = std::string(FIRSTLIGHT_SCENES) +
                            "/box_coil.dae -r 240 180 --camera file --show normals -s 8 -f a.png";
  const auto differs = [&](const std::string& program) {
    EXPECT_EQ(run(words, program), 0) << said();
    const auto shown =
        pt::read_image(fs::path(FIRSTLIGHT_HANDBOOK) / "pictures/mistake_first_child.png");
    return pt::compare(pt::read_image(folder_ / "a.png"), shown).rel_mse;
  };
  EXPECT_LT(differs(MISTAKE_RENDER_PROGRAM), 1e-3);
  EXPECT_GT(differs(RENDER_PROGRAM), 1e-2);
}

TEST_F(RenderProgram, says_in_its_help_that_the_courses_camera_crops) {
  EXPECT_EQ(run("--help"), 0) << said();
  EXPECT_NE(said().find("cut a window"), std::string::npos) << said();
}

TEST_F(RenderProgram, refuses_a_survival_that_is_not_a_chance) {
  for (const char* chance : {"0", "1.1", "-0.5", "nan", "often"}) {
    EXPECT_EQ(run(std::string("scene.dae -s 1 -r 8 6 --survival ") + chance), 2) << chance;
    EXPECT_NE(said().find("--survival"), std::string::npos) << said();
  }
  EXPECT_EQ(run("scene.dae -s 1 -r 8 6 --survival 1"), 0) << said();
}

// The effect of the options on the picture. The floor is diffuse with albedo .5. The only light is
// a point light of intensity 9, 3 above its middle. A point of the floor at distance d reflects .5
// / pi * 9 / d^2 * 3 / d, at most .5 / pi.
class Options : public RenderProgram {
 protected:
  pt::Film rendered(const std::string& options, const std::string& scene = "scene.dae") {
    EXPECT_EQ(run(scene + " --camera file -f a.exr -r 16 12 " + options), 0)
        << options << ": " << said();
    return pt::read_exr(folder_ / "a.exr");
  }
  static double brightest(const pt::Film& film) {
    double most = 0;
    for (const pt::FilmPixel& pixel : film.pixels) most = std::max(most, pixel.mean.g);
    return most;
  }
  static double mean(const pt::Film& film) {
    double sum = 0;
    for (const pt::FilmPixel& pixel : film.pixels) sum += pixel.mean.g;
    return sum / static_cast<double>(film.pixels.size());
  }
  // Two numbers from the program's last report.
  double triangles_per_ray() const {
    const std::string text = said();
    return std::stod(text.substr(text.find("boxes, ") + 7));
  }
  double million_rays() const {
    const std::string text = said();
    return std::stod(text.substr(text.find("CPU s; ") + 7));
  }
  static double noise(const pt::Film& film) {
    double sum = 0;
    for (const pt::FilmPixel& pixel : film.pixels) sum += pixel.variance_y;
    return sum;
  }
};

TEST_F(Options, count_bounces_and_choose_those_shown) {
  EXPECT_EQ(brightest(rendered("-s 1 -m 0")), 0);
  const double direct = brightest(rendered("-s 1 -m 1"));
  EXPECT_LE(direct, 0.5 / pt::kPi * (1 + 1e-6));
  EXPECT_GE(direct, 0.8 * 0.5 / pt::kPi);
  // From a floor alone, no other surface is visible.
  EXPECT_EQ(brightest(rendered("-s 1 -m 4 --show direct")), direct);
  EXPECT_EQ(brightest(rendered("-s 1 -m 4 --show bounce --bounce 1")), direct);
  EXPECT_EQ(brightest(rendered("-s 1 -m 4 --show indirect")), 0);
  EXPECT_EQ(brightest(rendered("-s 1 -m 4 --show bounce --bounce 2")), 0);
  // The floor's normal is (0, 1, 0), shown as (n + 1) / 2.
  EXPECT_NEAR(brightest(rendered("-s 1 --show normals")), 1, 1e-6);
}

// This program links fast/, the other one the plain reference.
TEST_F(Options, give_the_pictures_of_the_plain_reference) {
  for (const char* scene : {"two_lights", "sheet", "box_gems", "coloured_lights"}) {
    for (const char* options : {"-s 2 -l 3 -m 1", "-s 1 -l 20 -m 4"}) {
      const std::string arguments =
          std::string(FIRSTLIGHT_SCENES "/") + scene + ".dae -r 48 36 " + options;
      ASSERT_EQ(run(arguments + " -f fast.exr"), 0) << said();
      ASSERT_EQ(run(arguments + " -f plain.exr", PLAIN_RENDER_PROGRAM), 0) << said();
      EXPECT_EQ(contents("fast.exr"), contents("plain.exr")) << arguments;
    }
  }
}

// A closed room whose walls reflect most of the light, so later bounces add to it.
TEST_F(Options, count_the_bounces_of_indirect_light) {
  const std::string room = FIRSTLIGHT_SCENES "/pale_room.dae";
  const double one = mean(rendered("-s 64 -m 1", room));
  const double four = mean(rendered("-s 64 -m 4", room));
  EXPECT_GT(four, 1.2 * one);
  EXPECT_GT(mean(rendered("-s 64 -m 6", room)), 1.02 * four);
  EXPECT_NEAR(mean(rendered("-s 64 -m 4 --show indirect", room)), four - one, 0.05 * four);
}

// Directions over the hemisphere never hit a point light. They hit a lamp with an area, and its
// light is the same as by light sampling, with more noise.
TEST_F(Options, H_samples_the_hemisphere) {
  EXPECT_EQ(brightest(rendered("-s 4 -m 1 -H")), 0);
  const std::string room = FIRSTLIGHT_SCENES "/box_spheres.dae";
  const pt::Film lights = rendered("-s 256 -m 1 --show bounce --bounce 1", room);
  const pt::Film hemisphere = rendered("-s 256 -m 1 --show bounce --bounce 1 -H", room);
  EXPECT_GT(mean(lights), 0.01);
  EXPECT_NEAR(mean(hemisphere), mean(lights), 0.2 * mean(lights));
  EXPECT_GT(noise(hemisphere), 2 * noise(lights));
}

// The mean stays the same; paths that end sooner make more noise.
TEST_F(Options, survival_is_the_chance_to_go_on) {
  const std::string options = "-s 128 -m 6 --show indirect --survival ";
  const std::string room = FIRSTLIGHT_SCENES "/pale_room.dae";
  const pt::Film all = rendered(options + "1", room);
  const double tested = million_rays();
  const pt::Film few = rendered(options + ".3", room);
  EXPECT_NEAR(mean(few), mean(all), 0.1 * mean(all));
  EXPECT_GT(noise(few), 1.5 * noise(all));
  EXPECT_LT(million_rays(), 0.8 * tested);
}

TEST_F(Options, leaf_and_engine_say_how_much_is_tested_and_change_no_pixel) {
  const std::string scene = FIRSTLIGHT_SCENES "/box_gems.dae";  // 150 triangles
  rendered("-s 2 -m 1 --leaf 1", scene);
  const std::string picture = contents("a.exr");
  const double small = triangles_per_ray();
  rendered("-s 2 -m 1 --leaf 64", scene);
  EXPECT_EQ(contents("a.exr"), picture);
  EXPECT_GT(triangles_per_ray(), 4 * small);
  rendered("-s 2 -m 1 --engine linear", scene);
  EXPECT_EQ(contents("a.exr"), picture);
  EXPECT_NEAR(triangles_per_ray(), 150, 2);  // a shadow ray ends at its first hit
}

// The floor is a triangle, which is darker away from the lamp above its middle. The file's camera
// sees most of it, the course's cuts a small window out of a large picture, and the fitted camera
// also sees the black around it.
TEST_F(Options, camera_frames_the_scene) {
  const auto darkest_to_brightest = [&](const std::string& camera) {
    EXPECT_EQ(run("scene.dae -f a.exr -r 16 12 -s 4 -m 1 --camera " + camera), 0) << said();
    const pt::Film film = pt::read_exr(folder_ / "a.exr");
    double least = brightest(film);
    for (const pt::FilmPixel& pixel : film.pixels) least = std::min(least, pixel.mean.g);
    return least / brightest(film);
  };
  const double file = darkest_to_brightest("file");
  EXPECT_GT(file, 0.5);
  EXPECT_LT(file, 0.95);
  EXPECT_GT(darkest_to_brightest("course"), 0.98);
  EXPECT_EQ(darkest_to_brightest("fit"), 0);
}

TEST_F(Options, exposure_multiplies_what_is_shown) {
  const pt::Film film = rendered("-s 1 -m 1");
  for (const double exposure : {1.0, 2.5}) {
    ASSERT_EQ(run("scene.dae --camera file -f a.png -r 16 12 -s 1 -m 1 --exposure " +
                  std::to_string(exposure)),
              0);
    const pt::Image shown = pt::read_image(folder_ / "a.png");
    for (std::size_t i = 0; i < film.pixels.size(); ++i) {
      const auto code = pt::encode(film.pixels[i].mean.g, exposure);
      EXPECT_EQ(shown.pixels[i].g, pt::decode(code));
    }
  }
}

TEST_F(Options, a_seed_names_the_noise) {
  const auto means = [&](const std::string& options) {
    return pt::mean(rendered("-s 2 " + options)).pixels;
  };
  const auto one = means("--seed 1");
  EXPECT_TRUE(means("--seed 1 -t 2") == one);
  EXPECT_TRUE(means("--seed 2") != one);
}

// A light is so near that the received light exceeds the largest float. These samples are black. The first one from the bottom left is named, so that it can be rendered again.
TEST_F(Options, a_sample_that_is_not_finite_is_named_by_its_pixel) {
  std::string bright = scene_with("");
  const auto change = [&](const std::string& from, const std::string& to) {
    bright.replace(bright.find(from), from.size(), to);
  };
  change("9 9 9", "1.89e38 1.89e38 1.89e38");
  change("0 3 0", ".3 .1 .2");
  write("bright.dae", bright);
  const pt::Film plain = rendered("-s 1 -m 1");
  const pt::Film film = rendered("-s 1 -m 1", "bright.dae");
  int count = 0, first_x = 0, first_y = 0;
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      const int from_top = film.height - 1 - y;
      if (film.at(x, from_top).mean.g > 0 || plain.at(x, from_top).mean.g == 0) continue;
      if (count++ == 0) first_x = x, first_y = y;
    }
  }
  ASSERT_GT(count, 0);
  ASSERT_NE(first_x, first_y);
  const std::string expected =
      std::to_string(count) + " samples were not finite and are left out; the first at pixel x " +
      std::to_string(first_x) + " y " + std::to_string(first_y) + " (from the bottom left)";
  EXPECT_NE(said().find(expected), std::string::npos) << said() << expected;
}

// One light with an area: the variance of direct light falls with the number of light samples,
// except for the part from the position in the pixel.
TEST_F(Options, l_is_the_number_of_samples_of_an_area_light) {
  const std::string scene = FIRSTLIGHT_SCENES "/box_spheres.dae";
  const double one = noise(rendered("-s 64 -m 1 -l 1 --show direct", scene));
  const double many = noise(rendered("-s 64 -m 1 -l 64 --show direct", scene));
  EXPECT_LT(many, 0.8 * one);
  EXPECT_GT(many, 0);
}

// A wrong call gives one sentence and exit code 2 before anything is rendered, and no file.
TEST_F(RenderProgram, refuses_what_it_cannot_use) {
  write("broken.dae", "<COLLADA>");
  write("empty.dae", "");
  fs::create_directory(folder_ / "folder.dae");
  const Names bad{"missing.dae",
                  "broken.dae",
                  "empty.dae",
                  "folder.dae",
                  "scene.dae -f a.tiff",
                  "scene.dae -f missing/a.png",
                  "scene.dae -s 0",
                  "scene.dae -s nan",
                  "scene.dae -r 0 5",
                  "scene.dae -r 5",
                  "scene.dae -m -1",
                  "scene.dae -t 0",
                  "scene.dae -s 16 -a 32 0.05",
                  "scene.dae -a 8 0",
                  "scene.dae -a 8.5 0.1",
                  "scene.dae -a 1 0.1",
                  "scene.dae -a 8 inf",
                  "scene.dae -a 8 nan",
                  "scene.dae --show nothing",
                  "scene.dae --exposure 0",
                  "scene.dae --exposure nan",
                  "scene.dae --exposure inf",
                  "scene.dae --exposure 1e400",
                  "scene.dae --exposure 1,5",
                  "scene.dae --seed -1",
                  "scene.dae --seed 1.5",
                  "scene.dae --seed 18446744073709551616",
                  "scene.dae --unknown",
                  ""};
  for (const std::string& arguments : bad) {
    EXPECT_EQ(run(arguments), 2) << arguments << ": " << said();
    const std::string text = said();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << arguments << ": " << text;
    EXPECT_LT(text.size(), 200) << arguments << ": " << text;
  }
  EXPECT_EQ(files(), Names{});
}

// Glass can be shown but not lit, unless it is treated as diffuse.
TEST_F(RenderProgram, names_a_material_outside_the_model) {
  write("glass.dae",
        scene_with("<extra><technique profile='CGL'><glass>"
                   "<transmittance>1 1 1</transmittance></glass></technique></extra>"));
  EXPECT_EQ(run("glass.dae -s 1 -r 8 6"), 2);
  EXPECT_NE(said().find("glass.dae"), std::string::npos) << said();
  EXPECT_NE(said().find("paint"), std::string::npos) << said();
  EXPECT_EQ(run("glass.dae -s 1 -r 8 6 --show normals"), 0) << said();
  EXPECT_EQ(run("glass.dae -s 1 -r 8 6 --lambertian"), 0) << said();
}

// Returns whether a process has installed its Ctrl-C handler (or has ended).
bool catches_interrupts(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) == 0) {
      return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    }
  }
  return true;
}

class Stopped : public RenderProgram {
 protected:
  // Starts a render that would take hours and sends it the signal. Returns its exit code.
  int run_until(int signal, const char* size) const {
    const pid_t child = fork();
    if (child == 0) {
      fs::current_path(folder_);
      std::freopen("said", "w", stdout);
      dup2(STDOUT_FILENO, STDERR_FILENO);
      execl(RENDER_PROGRAM, RENDER_PROGRAM, "scene.dae", "-s", "16000000", "-m", "1", "-r", size,
            "12", "-f", "a.exr", nullptr);
      _exit(99);
    }
    while (!catches_interrupts(child)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    kill(child, signal);
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  // The least and the most samples of a pixel.
  std::pair<int, int> samples() const {
    const pt::Film film = pt::read_exr(folder_ / "a.exr");
    int least = film.at(0, 0).samples, most = least;
    for (const pt::FilmPixel& pixel : film.pixels) {
      least = std::min(least, pixel.samples);
      most = std::max(most, pixel.samples);
    }
    return {least, most};
  }
};

TEST_F(Stopped, writes_what_is_there_and_goes_on_with_the_same_bits) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EQ(run_until(signal, "16"), 128 + signal) << said();
    EXPECT_EQ(files(), Names{"a.exr"});
    const auto [least, most] = samples();
    EXPECT_NE(said().find("interrupted: the picture has " + std::to_string(least)),
              std::string::npos)
        << said();
    const std::string wanted = " -m 1 -r 16 12 -s " + std::to_string(most + 100);
    EXPECT_EQ(run("scene.dae --resume a.exr -t 3" + wanted), 0) << said();
    EXPECT_EQ(samples(), std::pair(most + 100, most + 100));
    EXPECT_EQ(run("scene.dae -f whole.exr" + wanted), 0) << said();
    EXPECT_TRUE(contents("a.exr") == contents("whole.exr")) << signal;
    fs::remove(folder_ / "a.exr");
    fs::remove(folder_ / "whole.exr");
  }
}

// The picture is so large that not all pixels have samples.
TEST_F(Stopped, shows_a_part_of_the_first_round) {
  EXPECT_EQ(run_until(SIGTERM, "16384"), 143) << said();
  EXPECT_EQ(samples().first, 0);
  EXPECT_NE(said().find("interrupted: the picture has 0 "), std::string::npos) << said();
  EXPECT_NE(said().find("the same command with --resume a.exr goes on"), std::string::npos);
}

TEST_F(Stopped, ends_in_time_after_whole_rounds) {
  const std::string options = "scene.dae -m 1 -r 16 12 -f a.exr --time ";
  EXPECT_EQ(run(options + "0.2s"), 0) << said();
  EXPECT_NE(said().find("the time is over: the picture has "), std::string::npos) << said();
  EXPECT_EQ(samples().first, samples().second);
  EXPECT_EQ(samples().first % 64, 0);
  EXPECT_EQ(run(options + "1h -s 100"), 0) << said();
  EXPECT_EQ(samples(), std::pair(100, 100));
  for (const char* time : {"0", "-1", "5x", "m", "nan", "1,5m", "1s -a 8 .1"}) {
    EXPECT_EQ(run(options + time), 2) << time;
  }
}

TEST_F(Stopped, goes_on_only_with_what_the_same_options_made) {
  EXPECT_EQ(run("scene.dae -s 4 -m 1 -r 16 12 -f a.exr"), 0) << said();
  EXPECT_EQ(run("scene.dae -s 4 -m 1 -r 16 12 -f a.png"), 0) << said();
  pt::write_exr(folder_ / "other.exr", pt::read_exr(folder_ / "a.exr"));
  const std::string before = contents("a.exr");
  write("other.dae", scene_with(" "));
  for (const char* changed :
       {"scene.dae -m 2 -r 16 12 --resume a.exr", "scene.dae -m 1 -r 12 16 --resume a.exr",
        "scene.dae -m 1 -r 16 12 --seed 1 --resume a.exr", "other.dae -m 1 -r 16 12 --resume a.exr",
        "scene.dae -m 1 -r 16 12 -l 2 --resume a.exr",
        "scene.dae -m 1 -r 16 12 --light sky --resume a.exr",
        "scene.dae -m 1 -r 16 12 --resume a.png", "scene.dae -m 1 -r 16 12 --resume other.exr",
        "scene.dae -m 1 -r 16 12 --resume none.exr"}) {
    EXPECT_EQ(run(std::string(changed) + " -s 8"), 2) << changed << said();
    EXPECT_NE(said().find("cannot "), std::string::npos) << said();
  }
  EXPECT_TRUE(contents("a.exr") == before);
  // All samples are there.
  EXPECT_EQ(run("scene.dae -m 1 -r 16 12 -s 4 --resume a.exr"), 0) << said();
  EXPECT_TRUE(contents("a.exr") == before);
}

TEST_F(Stopped, adaptive_pixels_are_kept) {
  const std::string options = "scene.dae -m 1 -r 16 12 -s 64 -a 8 .1";
  EXPECT_EQ(run(options + " -f whole.exr"), 0) << said();
  const pt::Film whole = pt::read_exr(folder_ / "whole.exr");
  // Half of it is missing.
  const std::string bytes = contents("whole.exr");
  pt::Film half = whole;
  for (int x = 0; x < 16; ++x) half.set(x, 3, {});
  const std::string settings = pt::exr_settings(bytes, "whole.exr");
  pt::write_file(folder_ / "half.exr", pt::encode_exr(half, settings));
  EXPECT_EQ(run(options + " --resume half.exr"), 0) << said();
  EXPECT_TRUE(contents("half.exr") == bytes);
}

// Nobody waits for hours to hear it.
TEST_F(RenderProgram, refuses_a_place_that_it_cannot_write_to_before_it_renders) {
  EXPECT_EQ(run("scene.dae -s 16000000 -f /proc/self/a.png"), 2) << said();
  EXPECT_NE(said().find("cannot write '/proc/self/a.png'"), std::string::npos) << said();
  fs::create_directory(folder_ / "a_rate.csv");
  EXPECT_EQ(run("scene.dae -s 16000000 -a 8 .1 -f a.png"), 2) << said();
  fs::remove(folder_ / "a_rate.csv");
  EXPECT_EQ(files(), Names{});
#ifndef FIRSTLIGHT_SANITIZED  // a sanitiser needs more address space than any limit
  const std::string limited = "ulimit -v 4000000; '" RENDER_PROGRAM "'";
  EXPECT_EQ(run("-c \"" + limited + " scene.dae -s 16000000 -t 1 -r 16384 16384\"", "/bin/bash"),
            2);
  EXPECT_NE(said().find("a picture of 16384 x 16384 needs 28 GB, and "), std::string::npos)
      << said();
  EXPECT_EQ(files(), Names{});
#endif
}

}  // namespace
