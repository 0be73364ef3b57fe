// writeup_render SPEC.json BAND: renders some rows of one render, and goes on where the band's file
// ends. It is a separate program, so that a crash or an endless loop in a learner's code ends
// nothing else.
#include "measure/renders/band.h"
#include "pt/end_of_program.h"
#include "pt/error.h"

int main(int argc, char** argv) {
  return pt::run_program([&] {
    if (argc != 3) throw pt::Error("writeup_render SPEC.json FOLDER/FIRST+ROWS");
    measure::make_band(argv[1], measure::band_of(argv[2]));
    return 0;
  });
}
