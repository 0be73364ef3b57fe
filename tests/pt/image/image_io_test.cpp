#include "pt/image/image_io.h"

#include "pt/error.h"
#include "pt/file.h"
#include "pt/image/exr.h"
#include "pt/image/sample_map.h"
#include "pt/image/tone_map.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <future>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pt {
namespace {

namespace fs = std::filesystem;

// Each test has its own folder, which is removed after it.
class ImageIo : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("firstlight_" + std::to_string(getpid()) + "_" +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path in_folder(const std::string& name) const { return folder_ / name; }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder_))
      out.push_back(entry.path().filename());
    return out;
  }

 private:
  fs::path folder_;
};

Film random_film(int width, int height) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> value(0, 3);
  const auto next = [&] { return static_cast<double>(value(random)); };
  Film film(width, height);
  for (FilmPixel& p : film.pixels) {
    p = {{next(), next(), next()},
         {next(), next(), next()},
         next(),
         static_cast<int>(random() % 5000)};
  }
  return film;
}

void expect_equal(const Film& a, const Film& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    EXPECT_EQ(a.pixels[i].mean, b.pixels[i].mean);
    EXPECT_EQ(a.pixels[i].variance, b.pixels[i].variance);
    EXPECT_EQ(a.pixels[i].variance_y, b.pixels[i].variance_y);
    EXPECT_EQ(a.pixels[i].samples, b.pixels[i].samples);
  }
}

// Numbers as files store them, lowest byte first.
template <class T>
std::string raw(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + raw(static_cast<int>(value.size())) + value;
}

std::string exr_header(const std::string& channels, int compression, const std::string& window) {
  std::string file = raw(20000630) + raw(2);
  file += attribute("channels", "chlist", channels + '\0');
  file += attribute("compression", "compression", std::string(1, static_cast<char>(compression)));
  file += attribute("dataWindow", "box2i", window);
  file += attribute("displayWindow", "box2i", window);
  file += attribute("lineOrder", "lineOrder", std::string(1, '\0'));
  file += attribute("pixelAspectRatio", "float", raw(1.0f));
  file += attribute("screenWindowCenter", "v2f", raw(0.0f) + raw(0.0f));
  file += attribute("screenWindowWidth", "float", raw(1.0f));
  return file + '\0';
}

// An uncompressed EXR of 2 x 2 pixels in OpenEXR's file layout: B and G are float, R is half.
// `last_line` is the line number of its second block; 1 is right.
std::string plain_exr(int last_line = 1, const std::string& red = "R", int max_x = 1) {
  std::string channels;
  for (const std::string& name : {std::string("B"), std::string("G"), red}) {
    channels += name + '\0' + raw(name == red ? 1 : 2) + raw(0) + raw(1) + raw(1);
  }
  std::string file = exr_header(channels, 0, raw(0) + raw(0) + raw(max_x) + raw(1));
  const std::size_t first = file.size() + 16;
  file += raw(first) + raw(first + 28);
  const auto half = [](int code) { return raw(static_cast<std::uint16_t>(code)); };
  file += raw(0) + raw(20) + raw(1.0f) + raw(2.0f) + raw(3.0f) + raw(4.0f);
  file += half(0x3c00) + half(0x3800);  // 1, 0.5
  file += raw(last_line) + raw(20) + raw(5.0f) + raw(6.0f) + raw(7.0f) + raw(8.0f);
  file += half(0xc000) + half(0x0001);  // -2, 2^-24
  return file;
}

// An EXR of one column with lines from `top` on, in blocks of this many lines. A block that
// compression does not shrink is stored unchanged. Blue is the line number, green is 1 and red 2.
std::string exr_of_blocks(int compression, int lines, int top, int height) {
  std::string channels;
  for (const char* name : {"B", "G", "R"}) {
    channels += std::string(name) + '\0' + raw(2) + raw(0) + raw(1) + raw(1);
  }
  std::string file =
      exr_header(channels, compression, raw(0) + raw(top) + raw(0) + raw(top + height - 1));
  const int blocks = (height + lines - 1) / lines;
  std::string table, data;
  for (int b = 0; b < blocks; ++b) {
    table += raw(file.size() + 8 * static_cast<std::size_t>(blocks) + data.size());
    const int count = std::min(lines, height - b * lines);
    data += raw(top + b * lines) + raw(12 * count);
    for (int i = 0; i < count; ++i) {
      data += raw(static_cast<float>(b * lines + i)) + raw(1.0f) + raw(2.0f);
    }
  }
  return file + table + data;
}

// Files of other programs: each compression has its own number of lines per block, and the picture
// may be part of a larger one, whose lines it counts.
TEST_F(ImageIo, reads_the_blocks_of_every_compression_wherever_they_begin) {
  struct Case {
    int compression, lines;
  };
  for (const auto& [compression, lines] : {Case{0, 1}, {1, 1}, {2, 1}, {3, 16}, {4, 32}}) {
    for (const int top : {0, 5, -3}) {
      const Film film = decode_exr(exr_of_blocks(compression, lines, top, 70), "a");
      ASSERT_EQ(film.height, 70) << compression;
      for (int y = 0; y < 70; ++y) {
        EXPECT_EQ(film.at(0, y).mean, (Rgb{2, 1, 1.0 * y})) << compression << " " << top;
      }
    }
  }
}

TEST_F(ImageIo, exr_gives_every_float_back) {
  const Film film = random_film(37, 53);
  write_image(in_folder("a.EXR"), film);
  expect_equal(read_exr(in_folder("a.EXR")), film);
  EXPECT_EQ(read_image(in_folder("a.EXR")).pixels, mean(film).pixels);
  EXPECT_TRUE(is_exr(in_folder("a.EXR")));
  EXPECT_EQ(names(), std::vector<std::string>{"a.EXR"});
}

TEST_F(ImageIo, exr_names_its_channels_in_order) {
  const std::string bytes = encode_exr(random_film(2, 2));
  std::size_t at = 0;
  for (const std::string name :
       {"B", "G", "R", "Y", "samples", "variance.B", "variance.G", "variance.R", "variance.Y"}) {
    const int type = name == "samples" ? 0 : 2;
    at = bytes.find(name + '\0' + raw(type), at + 1);
    ASSERT_NE(at, std::string::npos) << name;
  }
}

// The channel Y, which nothing here reads, gets the name R.
TEST_F(ImageIo, exr_has_the_luminance_in_its_channel_Y) {
  const Film film = random_film(2, 2);
  std::string bytes = encode_exr(film);
  const auto rename = [&](char from, char to) {
    const std::size_t at = bytes.find('\0' + std::string(1, from) + '\0' + raw(2));
    ASSERT_NE(at, std::string::npos) << from;
    bytes[at + 1] = to;
  };
  rename('R', 'A');
  rename('Y', 'R');
  const Film read = decode_exr(bytes, "a");
  for (std::size_t i = 0; i < film.pixels.size(); ++i) {
    EXPECT_EQ(read.pixels[i].mean.r, static_cast<float>(luminance(film.pixels[i].mean)));
  }
}

TEST_F(ImageIo, exr_rounds_to_float_and_keeps_what_is_not_finite) {
  Film film(1, 1);
  film.set(0, 0, {{0.1, HUGE_VAL, -NAN}, {}, 0, 2000000000});
  write_exr(in_folder("a.exr"), film);
  const FilmPixel pixel = read_exr(in_folder("a.exr")).at(0, 0);
  EXPECT_EQ(pixel.mean.r, 0.1f);
  EXPECT_EQ(pixel.mean.g, HUGE_VAL);
  EXPECT_TRUE(std::isnan(pixel.mean.b));
  EXPECT_EQ(pixel.samples, 2000000000);
}

TEST_F(ImageIo, reads_a_plain_exr_top_row_first) {
  write_file(in_folder("a.exr"), plain_exr());
  const Film film = read_exr(in_folder("a.exr"));
  EXPECT_EQ(film.at(0, 0).mean, (Rgb{1, 3, 1}));
  EXPECT_EQ(film.at(1, 0).mean, (Rgb{0.5, 4, 2}));
  EXPECT_EQ(film.at(0, 1).mean, (Rgb{-2, 7, 5}));
  EXPECT_EQ(film.at(1, 1).mean, (Rgb{std::ldexp(1, -24), 8, 6}));
  EXPECT_EQ(film.at(1, 1).samples, 0);
}

TEST_F(ImageIo, refuses_an_exr_that_lacks_something) {
  EXPECT_THROW(decode_exr(plain_exr(0), "a"), Error);
  EXPECT_THROW(decode_exr(plain_exr(1, "red"), "a"), Error);
  Film film(1, 1);
  film.set(0, 0, {{}, {}, 0, -1});
  EXPECT_THROW(decode_exr(encode_exr(film), "a"), Error);
}

TEST_F(ImageIo, refuses_an_exr_of_an_absurd_size) {
  for (const int max_x : {1 << 25, -1, 2147483647}) {
    try {
      decode_exr(plain_exr(1, "R", max_x), "a");
      FAIL() << max_x;
    } catch (const Error& error) {
      const std::string size = std::to_string(max_x + 1L) + " x 2";
      EXPECT_NE(std::string(error.what()).find(size), std::string::npos) << error.what();
    }
  }
}

TEST_F(ImageIo, png_holds_the_codes_of_the_tone_map) {
  Film film(256, 2);
  for (int x = 0; x < 256; ++x) {
    film.set(x, 0, {gray(decode(static_cast<std::uint8_t>(x)) / 4), {}, 0, 1});
    film.set(x, 1, {{x / 1024.0, 0, 1}, {}, 0, 1});
  }
  write_image(in_folder("a.png"), film, 4);
  const Image image = read_image(in_folder("a.png"));
  ASSERT_EQ(image.width, 256);
  ASSERT_EQ(image.height, 2);
  for (int x = 0; x < 256; ++x) {
    EXPECT_EQ(image.at(x, 0), gray(std::pow(x / 255.0, 2.2)));
    EXPECT_EQ(image.at(x, 1).r, decode(encode(x / 256.0)));
    EXPECT_EQ(image.at(x, 1).g, 0);
    EXPECT_EQ(image.at(x, 1).b, 1);
  }
  EXPECT_FALSE(is_exr(in_folder("a.png")));
  EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

// Bitmaps begin with the bottom row and store blue first.
TEST_F(ImageIo, reads_a_bmp_top_row_first) {
  std::string file = "BM" + raw(54 + 16) + raw(0) + raw(54);
  file += raw(40) + raw(2) + raw(2) + raw(std::int16_t{1}) + raw(std::int16_t{24}) + raw(0);
  file += raw(16) + raw(0) + raw(0) + raw(0) + raw(0);
  file += std::string("\xff\0\0\0\xff\0\0\0", 8);  // bottom: blue, green
  file += std::string("\0\0\xff\0\x80\0\0\0", 8);  // top: red, half green
  write_file(in_folder("a.bmp"), file);
  const Image image = read_image(in_folder("a.bmp"));
  EXPECT_EQ(image.at(0, 0), (Rgb{1, 0, 0}));
  EXPECT_EQ(image.at(1, 0), (Rgb{0, std::pow(128 / 255.0, 2.2), 0}));
  EXPECT_EQ(image.at(0, 1), (Rgb{0, 0, 1}));
  EXPECT_EQ(image.at(1, 1), (Rgb{0, 1, 0}));
}

// Two pixels below two, as Debevec describes the format: the lowest row first, the byte order in the sign of the scale.
TEST_F(ImageIo, reads_a_pfm_of_either_byte_order) {
  for (const bool little : {true, false}) {
    std::string bytes = little ? "PF\n2 2\n-1.0\n" : "PF\n2 2\n1.0\n";
    for (int i = 0; i < 12; ++i) {
      const float value = static_cast<float>(i) + 0.5f;
      char raw[4];
      std::memcpy(raw, &value, 4);  // these machines are little-endian
      if (!little) std::reverse(raw, raw + 4);
      bytes.append(raw, 4);
    }
    write_file(in_folder("a.pfm"), bytes);
    const Image image = read_image(in_folder("a.pfm"));
    EXPECT_EQ(image.at(0, 1), (Rgb{0.5, 1.5, 2.5}));
    EXPECT_EQ(image.at(1, 0), (Rgb{9.5, 10.5, 11.5}));
    for (const std::size_t length : {std::size_t{3}, std::size_t{9}, bytes.size() - 1}) {
      write_file(in_folder("cut.pfm"), bytes.substr(0, length));
      EXPECT_THROW(read_image(in_folder("cut.pfm")), Error) << length;
    }
  }
}

// A pixel of RGBE is three mantissas and their common exponent: 128 2^(e - 136) is 1 for e = 129.
TEST_F(ImageIo, reads_an_hdr_in_linear_radiance) {
  write_file(in_folder("a.hdr"), std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                                     "\x80\x40\x20\x81" + "\x80\x80\x80\x83");
  const Image image = read_image(in_folder("a.hdr"));
  EXPECT_EQ(image.at(0, 0), (Rgb{1, 0.5, 0.25}));
  EXPECT_EQ(image.at(1, 0), (Rgb{4, 4, 4}));
}

TEST_F(ImageIo, refuses_every_beginning_of_an_exr) {
  const std::string whole = encode_exr(random_film(3, 20));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(decode_exr(whole.substr(0, size), "a"), Error) << size;
  }
}

TEST_F(ImageIo, refuses_every_beginning_of_a_png) {
  write_png(in_folder("whole"), mean(random_film(3, 20)));
  const std::string whole = read_file(in_folder("whole"), 1 << 20);
  // The last four bytes are the check sum of an empty chunk, so nothing is missing without them.
  for (std::size_t size = 0; size < whole.size() - 4; ++size) {
    write_file(in_folder("part"), whole.substr(0, size));
    EXPECT_THROW(read_image(in_folder("part")), Error) << size;
  }
}

// Damaged bytes give a picture of an accepted size or a pt::Error; the sanitisers detect the rest.
TEST_F(ImageIo, survives_damaged_files) {
  write_png(in_folder("whole"), mean(random_film(3, 20)));
  const std::string sources[] = {encode_exr(random_film(3, 20)), plain_exr(),
                                 read_file(in_folder("whole"), 1 << 20)};
  std::mt19937 random(3);
  for (int i = 0; i < 1500; ++i) {
    std::string bytes = sources[i % 3];
    for (int k = 0; k < 1 + i % 4; ++k)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    write_file(in_folder("damaged"), bytes);
    try {
      const Image image = read_image(in_folder("damaged"));
      EXPECT_TRUE(is_image_size(image.width, image.height)) << i;
    } catch (const Error&) {
    }
  }
}

TEST_F(ImageIo, refuses_what_is_no_picture) {
  for (const std::string& bytes :
       {std::string(), std::string(100000, '\0'), std::string("hello"), std::string(9999, 'x')}) {
    write_file(in_folder("a"), bytes);
    EXPECT_THROW(read_image(in_folder("a")), Error);
    EXPECT_THROW(read_exr(in_folder("a")), Error);
  }
  EXPECT_THROW(read_image(in_folder("missing.png")), Error);
  EXPECT_THROW(read_image(in_folder("")), Error);
  EXPECT_THROW(read_image("/dev/zero"), Error);
}

TEST_F(ImageIo, refuses_a_png_that_claims_an_absurd_size) {
  // A file with only an IHDR: 17000 x 17000 pixels of 8 bits in r, g, b.
  write_file(in_folder("a.png"),
             std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x42\x68\0\0\x42\x68"
                         "\x08\x02\0\0\0\0\0\0\0",
                         33));
  try {
    read_image(in_folder("a.png"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("17000 x 17000"), std::string::npos) << error.what();
  }
}

TEST_F(ImageIo, says_which_extensions_there_are) {
  for (const std::string name : {"a.jpg", "a", ".png", "a.png.tmp"}) {
    try {
      write_image(in_folder(name), random_film(1, 1));
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(".png or .exr"), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(names().empty());
}

TEST_F(ImageIo, leaves_nothing_where_it_cannot_write) {
  fs::create_directory(in_folder("folder.png"));
  write_file(in_folder("file"), "x");
  const Film film = random_film(1, 1);
  for (const fs::path& path :
       {in_folder("folder.png"), in_folder("missing/a.png"), in_folder("file/a.exr"),
        in_folder(std::string(300, 'a') + ".png")}) {
    EXPECT_THROW(write_image(path, film), Error) << path;
  }
  EXPECT_THROW(write_file("/dev/null", "x"), Error);
  EXPECT_THROW(write_file(in_folder(""), "x"), Error);
  EXPECT_EQ(names().size(), 2u);
}

TEST_F(ImageIo, a_full_disk_leaves_the_old_file) {
  write_file(in_folder("a"), "old");
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  bool thrown = false;
  try {
    write_file(in_folder("a"), std::string(100000, 'x'));
  } catch (const Error&) {
    thrown = true;
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(thrown);
  EXPECT_EQ(read_file(in_folder("a"), 10), "old");
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(ImageIo, threads_may_write_the_same_file) {
  const std::string texts[] = {std::string(5000, 'a'), std::string(5000, 'b')};
  std::vector<std::future<void>> writers;
  for (const std::string& text : texts) {
    writers.push_back(std::async(std::launch::async, [&] {
      for (int i = 0; i < 500; ++i) write_file(in_folder("a"), text);
    }));
  }
  for (std::future<void>& writer : writers) EXPECT_NO_THROW(writer.get());
  const std::string left = read_file(in_folder("a"), 5000);
  EXPECT_TRUE(left == texts[0] || left == texts[1]);
  EXPECT_EQ(names(), std::vector<std::string>{"a"});
}

TEST_F(ImageIo, a_link_stays_a_link) {
  write_file(in_folder("target"), "old");
  fs::create_symlink("target", in_folder("link"));
  write_file(in_folder("link"), "new");
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(read_file(in_folder("target"), 10), "new");
  EXPECT_THROW(read_file(in_folder("target"), 2), Error);
}

TEST_F(ImageIo, counts_come_back) {
  const SampleMap map{3, 2, {16, 32, 48, 0, 2147483647, 5}, 99};
  write_counts(in_folder("a.csv"), map);
  EXPECT_EQ(read_file(in_folder("a.csv"), 100), "16,32,48\n0,2147483647,5\n");
  const SampleMap back = read_counts(in_folder("a.csv"));
  EXPECT_EQ(back.width, 3);
  EXPECT_EQ(back.height, 2);
  EXPECT_EQ(back.counts, map.counts);
  EXPECT_EQ(back.max, 2147483647);
}

TEST_F(ImageIo, refuses_what_are_no_counts) {
  for (const std::string text : {"", "\n", "1,2\n3\n", "1,2\n3,4", "1,\n", "1,2,", "-1\n", "1.5\n",
                                 "a\n", "99999999999\n", "1\n\n1\n", "1 ,2\n"}) {
    write_file(in_folder("a.csv"), text);
    EXPECT_THROW(read_counts(in_folder("a.csv")), Error) << text;
  }
}

}  // namespace
}  // namespace pt
