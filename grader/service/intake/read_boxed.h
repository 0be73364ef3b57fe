#pragma once

#include "grader/service/sandbox/probe.h"

#include <cstdint>
#include <string>
#include <vector>

namespace grader::intake {

// A program of ours that reads what somebody handed in, in a box.
struct BoxedReader {
  std::vector<std::string> command{};
  std::vector<std::string> visible{};  // besides its program
  int input = -1;                      // its standard input, which it reads
  std::string folder{};                // it writes here; it is made
  std::uint64_t seconds = 60;          // of processor time
  std::string name{}, done{};          // for messages: 'work.zip' cannot be "unpacked"
};

// The tier for such programs. Throws pt::Error if it must isolate, and nothing does.
sandbox::Tier tier_for_reading(const std::string& root, const std::string& work, bool must_isolate);

// Runs it. Returns why it failed because of what it read, in one sentence: it was refused, took too
// long, or made the program crash. Empty: it did not fail. Throws pt::Error if the machine is at
// fault.
std::string read_boxed(const BoxedReader& reader, sandbox::Tier tier);

}  // namespace grader::intake
