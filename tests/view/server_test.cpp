// The server of the view: only the person with the token, on this machine, is answered; and it survives its child.
#include "view/server.h"

#include "pt/error.h"
#include "pt/image/exr.h"
#include "view/page.h"

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <unistd.h>

namespace view {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

// A child that is a script: it answers everything alike, but for a few words.
constexpr const char* kScript = R"(
while read -r line <&3; do
  case $line in
    *crash*) kill -SEGV $$ ;;
    *wrong*) printf '{"size":0,"error":"that is wrong"}\n' >&4 ;;
    *endless*) sleep 100 ;;
    *garbage*) printf 'printed by a task\n' >&4 ;;
    *bytes*) printf '{"size":5,"state":{"width":1}}\nabcde' >&4 ;;
    *) printf '{"size":0,"state":{"seen":"yes"}}\n' >&4 ;;
  esac
done)";

class ServerTest : public testing::Test {
 protected:
  ServerTest()
      : child_({{"/bin/bash", "-c", kScript}}, std::chrono::milliseconds(1000)),
        server_({page_with({{"live", true}}), kToken, &child_, nullptr}),
        port_(server_.bind(0)),
        listening_([this] { server_.listen(); }),
        client_("127.0.0.1", port_) {}
  ~ServerTest() override { server_.stop(); }

  // The status of a request and its text.
  std::pair<int, std::string> get(const std::string& path, const httplib::Headers& headers = {}) {
    const httplib::Result result = client_.Get(path, headers);
    if (!result) return {0, ""};
    return {result->status, result->body};
  }

  static constexpr const char* kToken = "00112233445566778899aabbccddeeff";
  const std::string with_token_ = std::string("?token=") + kToken;
  Child child_;
  Server server_;
  int port_;
  std::jthread listening_;
  httplib::Client client_;
};

TEST_F(ServerTest, answers_with_the_token) {
  EXPECT_EQ(get("/scene" + with_token_), std::pair(200, std::string(R"({"seen":"yes"})")));
  EXPECT_THAT(get("/" + with_token_).second, HasSubstr("<title>Light and paths</title>"));
  const std::string local = "localhost:" + std::to_string(port_);
  EXPECT_EQ(get("/scene" + with_token_, {{"Host", local}}).first, 200);
  EXPECT_EQ(get("/scene" + with_token_, {{"Origin", "http://" + local}}).first, 200);
  const httplib::Result bytes = client_.Get("/picture" + with_token_ + "&show=bytes");
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->body, "abcde");
  EXPECT_EQ(bytes->get_header_value("X-State"), R"({"width":1})");
  EXPECT_EQ(get("/exr" + with_token_ + "&show=bytes").first, 400);  // no whole picture
}

TEST_F(ServerTest, refuses_whoever_has_no_token_or_comes_from_elsewhere) {
  const std::string port = std::to_string(port_);
  for (const char* place :
       {"/", "/scene", "/picture", "/exr", "/paths", "/disk", "/depth", "/nothing"}) {
    const std::string path = place;
    for (const std::string query :
         {"", "?token=", "?token=00112233445566778899aabbccddeefe", "?token=00112233445566778899",
          "?token=00112233445566778899aabbccddeefe&token=00112233445566778899aabbccddeeff"}) {
      EXPECT_EQ(get(path + query).first, 403) << path << query;
    }
    for (const std::string& host : {std::string("evil.example"), "evil.example:" + port,
                                    std::string("127.0.0.1"), "127.0.0.1.evil.example:" + port}) {
      EXPECT_EQ(get(path + with_token_, {{"Host", host}}).first, 403) << host;
    }
    for (const std::string& origin :
         {std::string("http://evil.example"), std::string("null"), "https://127.0.0.1:" + port,
          std::string("http://127.0.0.1:1"), "http://127.0.0.1:" + port + ".evil.example"}) {
      EXPECT_EQ(get(path + with_token_, {{"Origin", origin}}).first, 403) << origin;
    }
    for (const char* site : {"cross-site", "same-site"}) {
      EXPECT_EQ(get(path + with_token_, {{"Sec-Fetch-Site", site}}).first, 403) << site;
    }
  }
  const httplib::Result posted = client_.Post("/scene" + with_token_, "x", "text/plain");
  ASSERT_TRUE(posted);
  EXPECT_EQ(posted->status, 403);
}

TEST_F(ServerTest, says_in_one_sentence_what_is_wrong) {
  EXPECT_EQ(get("/scene" + with_token_ + "&show=wrong"),
            std::pair(400, std::string("that is wrong\n")));
  EXPECT_EQ(get("/nothing" + with_token_).first, 404);
  EXPECT_EQ(get("/scene" + with_token_ + "&w=1&w=2").first, 400);
  const auto [status, sentence] = get("/scene" + with_token_ + "&from=reference");
  EXPECT_EQ(status, 400);
  EXPECT_THAT(sentence, HasSubstr("no reference"));
}

TEST_F(ServerTest, survives_a_crash_of_the_tasks) {
  const auto [status, sentence] = get("/picture" + with_token_ + "&show=crash");
  EXPECT_EQ(status, 503);
  EXPECT_THAT(sentence, HasSubstr("the tasks crashed: signal 11"));
  EXPECT_EQ(get("/scene" + with_token_).first, 200);
}

TEST_F(ServerTest, survives_an_endless_loop_and_what_tasks_print) {
  const auto [status, sentence] = get("/picture" + with_token_ + "&show=endless");
  EXPECT_EQ(status, 503);
  EXPECT_THAT(sentence, HasSubstr("no answer for 1 s, as in an endless loop"));
  EXPECT_EQ(get("/scene" + with_token_).first, 200);
  EXPECT_EQ(get("/picture" + with_token_ + "&show=garbage").first, 503);
  EXPECT_EQ(get("/scene" + with_token_).first, 200);
}

TEST(Live, compiles_what_is_saved_and_starts_the_tasks_anew) {
  const fs::path folder = fs::temp_directory_path() / ("view_live_" + std::to_string(getpid()));
  fs::create_directories(folder / "1_rays");
  const fs::path task = folder / "1_rays" / "hit_box.cpp";
  std::ofstream(task) << "first";
  Child child({{"/bin/bash", "-c", kScript}});
  child.ask("scene", {});
  // A compiler that finds an error in what is saved second.
  Live live(folder,
            {"/bin/bash", "-c",
             "! grep -q wrong " + task.string() + " || { echo 'x.cpp:1: error: no'; exit 1; }"},
            child);
  const auto save = [&](const char* text, int saves) {
    std::ofstream(task) << text;
    for (int i = 0; i < 600 && live.state().saves < saves; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return live.state();
  };
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_EQ(live.state().saves, 0);
  const Live::State wrong = save("wrong", 1);
  EXPECT_EQ(wrong.saves, 1);
  EXPECT_EQ(wrong.error, "x.cpp:1: error: no");
  const Live::State right = save("better", 2);
  EXPECT_EQ(right.saves, 2);
  EXPECT_EQ(right.error, "");
  EXPECT_EQ(child.ask("scene", {}).state.at("seen"), "yes");
  fs::remove_all(folder);
}

TEST(Live, a_question_in_an_endless_loop_is_answered_by_the_new_program) {
  const fs::path changed = fs::temp_directory_path() / ("view_new_" + std::to_string(getpid()));
  Child child({{"/bin/bash", "-c",
                "while read -r line <&3; do [ -e " + changed.string() +
                    R"( ] || sleep 100; printf '{"size":0,"state":{"seen":"new"}}\n' >&4; done)"}});
  const std::jthread saving([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    std::ofstream(changed) << "new";
    child.restart();
  });
  EXPECT_EQ(child.ask("scene", {}).state.at("seen"), "new");
  fs::remove(changed);
}

TEST(Tokens, differ_and_are_long) {
  EXPECT_EQ(random_token().size(), 32U);
  EXPECT_NE(random_token(), random_token());
}

TEST(Pictures, become_exr_files_if_they_are_whole) {
  const std::vector<float> values{0.25f, 1, 3, 0, 1e-3f, 7};
  const std::string bytes(reinterpret_cast<const char*>(values.data()),
                          sizeof(float) * values.size());
  const pt::Film film = pt::decode_exr(exr_of({{{"width", 2}, {"height", 1}}, bytes}), "a picture");
  EXPECT_EQ(film.at(0, 0).mean, (pt::Rgb{0.25, 1, 3}));
  EXPECT_EQ(film.at(1, 0).mean.b, 7);
  // Tasks may have written it.
  for (const auto& [width, height] :
       {std::pair(3, 1), {-2, -1}, {0, 0}, {2, 2}, {1 << 30, 1 << 30}}) {
    EXPECT_THROW(exr_of({{{"width", width}, {"height", height}}, bytes}), pt::Error) << width;
  }
  EXPECT_THROW(exr_of({{{"width", 2}, {"height", 1}}, bytes + "a"}), pt::Error);
}

TEST(Page, keeps_texts_as_texts) {
  const std::string page = page_with({{"scene_file", "</script><script>alert(1)</script>"}});
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
}

}  // namespace
}  // namespace view
