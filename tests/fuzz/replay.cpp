// replay CORPUS [N]: calls a fuzz target with each file of the folder, and with N damaged copies of
// these files. The damage is the same in every run. Targets run this way if there is no libFuzzer.
#include "pt/error.h"
#include "pt/file.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

std::vector<std::string> texts_in(const fs::path& corpus) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(corpus)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw pt::Error(corpus.string() + " is empty: a target needs an input to begin with");
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(pt::read_file(file, kMaxBytes));
  return texts;
}

// Changes, removes or doubles some bytes, or inserts some from another input. Runs of digits become
// unexpected numbers.
std::string damaged(const std::vector<std::string>& texts, std::mt19937_64& random) {
  static const std::vector<std::string> odd{"0",
                                            "-1",
                                            "4294967295",
                                            "18446744073709551615",
                                            "99999999999999999999",
                                            "1e999",
                                            "-1e-9",
                                            "nan",
                                            "",
                                            "1 1",
                                            "0x1"};
  std::string text = texts[random() % texts.size()];
  for (std::size_t changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
    const std::size_t at = random() % text.size(), length = 1 + random() % 32;
    const std::size_t digits = text.find_first_of("0123456789", at);
    const std::string& other = texts[random() % texts.size()];
    switch (random() % 6) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(random() % text.size(), length));
        break;
      case 3:
        text.resize(at);
        break;
      case 4:
        if (!other.empty()) text.replace(at, length, other.substr(random() % other.size(), length));
        break;
      default:
        if (digits == text.npos) break;
        text.replace(digits, text.find_first_not_of("0123456789.", digits) - digits,
                     odd[random() % odd.size()]);
    }
  }
  return text;
}

void feed(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2 || argc > 3) throw pt::Error("say which corpus: CORPUS [N]");
    const std::vector<std::string> texts = texts_in(argv[1]);
    for (const std::string& text : texts) feed(text);
    const int copies = argc > 2 ? std::stoi(argv[2]) : 0;
    std::mt19937_64 random(1);
    for (int i = 0; i < copies; ++i) feed(damaged(texts, random));
    std::printf("%zu inputs and %d damaged copies\n", texts.size(), copies);
    return 0;
  } catch (const pt::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
