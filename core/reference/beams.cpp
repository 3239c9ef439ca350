// SPDX-License-Identifier: MIT
#include "core/reference/beams.h"

#include "core/base/parallel.h"

#include <atomic>

namespace soffit::reference {

std::vector<BeamEstimate> traceBeams(const ReferenceScene& scene, std::span<const Beam> beams,
                                     const BeamOptions& options, const Job& job) {
  std::vector<BeamEstimate> estimates(beams.size());
  std::atomic<std::size_t> done{0};
  parallelFor(beams.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !job.cancelled(); ++i) {
      Beam beam = beams[i];
      beam.origin -= scene.mesh().origin;
      Tracer tracer(scene, beam);
      for (std::size_t half = 0; half < 2; ++half) {
        const std::uint64_t seed = mixBits(options.seed * 0x10001U + 2 * i + half);
        const Tally tally = tracer.run(options.paths, seed);
        estimates[i].halves[half] = tally.indirect;
        estimates[i].direct[half] = tally.once;
      }
    }
    done += end - begin;
    job.report("tracing paths", static_cast<double>(done) / static_cast<double>(beams.size()));
  });
  return estimates;
}

}  // namespace soffit::reference
