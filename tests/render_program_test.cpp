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

// The render program as a person meets it: exit codes, what it says, and what lies in the folder
// after.

namespace {

namespace fs = std::filesystem;

// A lit floor, as small as a scene can be.
const char* const kScene = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><up_axis>Y_UP</up_axis></asset>
 <library_effects><effect id="e"><profile_COMMON/>%EFFECT%</effect></library_effects>
 <library_materials><material id="m" name="paint"><instance_effect url="#e"/></material></library_materials>
 <library_lights><light id="l"><technique_common><point><color>9 9 9</color></point></technique_common></light></library_lights>
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

  // Runs the program in the folder; what it says goes to said().
  int run(const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && " + RENDER_PROGRAM + " " +
                                arguments + " > said 2>&1 < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder_ / "said").rdbuf();
    return text.str();
  }

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
  EXPECT_EQ(run("scene.dae -f b.exr -s 4 -l 2 -m 2 -t 2 -H -r 16 12"), 0) << said();
  EXPECT_EQ(files(), (Names{"a.png", "b.exr"}));
  EXPECT_NE(said().find("tests a ray"), std::string::npos) << said();
}

TEST_F(RenderProgram, names_the_picture_after_the_scene_where_no_name_is_given) {
  EXPECT_EQ(run("scene.dae -s 1 -r 8 6"), 0) << said();
  EXPECT_EQ(files(), Names{"scene.png"});
}

TEST_F(RenderProgram, writes_the_sample_rates_of_an_adaptive_render) {
  EXPECT_EQ(run("scene.dae -f a.png -s 64 -a 8 0.1 -r 16 12"), 0) << said();
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

// One sentence and exit code 2, before anything is rendered, and no file.
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
                  "scene.dae --show nothing",
                  "scene.dae --exposure 0",
                  "scene.dae --unknown",
                  ""};
  for (const std::string& arguments : bad) {
    EXPECT_EQ(run(arguments), 2) << arguments << ": " << said();
    const std::string text = said();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << arguments << ": " << text;
  }
  EXPECT_EQ(files(), Names{});
}

// Glass can be shown, not lit, unless it is asked to be matt.
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

// Whether a process has installed its handler of Ctrl-C yet (or is gone).
bool catches_interrupts(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) == 0) {
      return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    }
  }
  return true;
}

// A render that would take hours ends soon after Ctrl-C and leaves nothing behind.
TEST_F(RenderProgram, leaves_nothing_behind_when_interrupted) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    fs::current_path(folder_);
    std::freopen("said", "w", stdout);
    std::freopen("said", "w", stderr);
    execl(RENDER_PROGRAM, RENDER_PROGRAM, "scene.dae", "-s", "1000000", "-f", "a.png", nullptr);
    _exit(99);
  }
  while (!catches_interrupts(child)) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(files(), Names{});
}

}  // namespace
