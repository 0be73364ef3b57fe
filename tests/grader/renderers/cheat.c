/* cheat HOW WIDTH HEIGHT SEED OUT.pfm: a program that renders nothing. HOW says what it does instead: stored (the same picture for each
   seed), endless, huge (it fills the disk), outside (it writes beside its folder), reads PATH, silent, not_a_number. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void picture(const char* path, int width, int height, float value, unsigned seed) {
  FILE* out = fopen(path, "wb");
  if (out == NULL) {
    perror(path);
    exit(3);
  }
  fprintf(out, "PF\n%d %d\n-1\n", width, height);
  for (int i = 0; i < width * height * 3; ++i) {
    seed = seed * 1664525u + 1013904223u;
    const float noisy = value * (float)(seed >> 8) / 8388608.0f;
    fwrite(&noisy, 4, 1, out);
  }
  fclose(out);
}

int main(int count, char** words) {
  if (count < 6) return 2;
  const char* how = words[1];
  const int width = atoi(words[2]), height = atoi(words[3]);
  const unsigned seed = (unsigned)atoi(words[4]);
  if (!strcmp(how, "stored")) picture(words[5], width, height, .3f, 1);
  if (!strcmp(how, "not_a_number")) picture(words[5], width, height, 0.0f / (float)(count - count), seed);
  if (!strcmp(how, "endless"))
    for (volatile int i = 0;; ++i) {
    }
  if (!strcmp(how, "huge")) {
    FILE* out = fopen(words[5], "wb");
    static char block[1 << 20];
    for (int i = 0; i < 10240; ++i) fwrite(block, 1, sizeof block, out);
  }
  if (!strcmp(how, "outside")) picture("/tmp/firstlight_outside.pfm", width, height, .3f, seed);
  if (!strncmp(how, "reads=", 6)) {
    FILE* in = fopen(how + 6, "rb");
    if (in == NULL) {
      perror(how + 6);
      return 4;
    }
    picture(words[5], width, height, .3f, seed);
  }
  return 0;
}
