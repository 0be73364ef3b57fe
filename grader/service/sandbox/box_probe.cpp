// box_probe FILE USER FOLDER: prints the protections of its box, one word per line.
#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

bool can_read(const char* path) {
  const int file = open(path, O_RDONLY);
  if (file >= 0) close(file);
  return file >= 0;
}

bool can_write() {
  const int file = open("written", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  return file >= 0 && write(file, "x", 1) == 1;
}

bool can_start_processes() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  if (child > 0) waitpid(child, nullptr, 0);
  return child > 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  if (!can_read(argv[1])) std::puts("root");
  if (!can_read("/etc/passwd")) std::puts("files");
  if (socket(AF_INET, SOCK_DGRAM, 0) < 0) std::puts("sockets");
  if (getuid() != std::strtoul(argv[2], nullptr, 10)) std::puts("user");
  if (!can_start_processes()) std::puts("processes");
  if (can_write()) std::puts("write");
  if (can_read(argv[3])) std::puts("kept");
  return 0;
}
