#include "peers_bench.hpp"

/// The library beside other programs: on the same meshes, in the same run, in turns. Times are
/// processor time on one thread, medians over the iterations.
int main(int argc, char** argv) {
  if (*CLEAVE_PEERS_MISSING != '\0')
    benchmark::AddCustomContext("peers left out (packages missing)", CLEAVE_PEERS_MISSING);
  cleave::bench::register_peer_assembly();
  cleave::bench::register_peer_cuts();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
