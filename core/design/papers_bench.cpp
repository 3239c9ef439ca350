// SPDX-License-Identifier: MIT
#include "core/design/papers_bench.h"

#include "core/design/median_time.h"
#include "core/design/papers_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace soffit::design {
namespace {

constexpr std::size_t kCoefficients = sh::coefficientCount(kPapersBands);
constexpr std::size_t kWide = sh::coefficientCount(2 * kPapersBands - 1);
constexpr double kMega = 1e-6;

const char* const kFujita = "Fujita & Kanai 2";
const char* const kDhawal1 = "Dhawal et al. 1";
const char* const kDhawal2 = "Dhawal et al. 2";

/// Two scenes or shaders each, triple product -> fixed light; of which, and of what machine, is not
/// known here.
const Published kTriple{"5.2, 83.6", 5.2, 83.6, ""};
const Published kFixed{"151, 568", 151.0, 568.0, ""};
const Published kFixedOverTriple{"29, 6.8", 568.0 / 83.6, 151.0 / 5.2, ""};
/// The published texture has 1024^2 texels.
constexpr int kPublishedSide = 1024;
const Published kTexture{"100", 100.0, 100.0, ""};
const Published kMatrixTexture{"2500", 2500.0, 2500.0, ""};
/// From its smallest mesh to its largest; vectors and matrices at vertices.
const Published kVectors{"2.5 - 215", 2.5, 215.0, ""};
const Published kMatrices{"64 - 5200", 64.0, 5200.0, ""};
/// One scene's matrices and vectors, 2.3 GB and 139.3 MB. 25 x 25 numbers for 25 would be 25 times.
const Published kMatricesOverVectors{"16.5", 16.5, 16.5, ""};

/// Measures place after place.
class PapersBench {
 public:
  PapersBench(const PapersBenchOptions& options, const Job& job)
      : options_(options), job_(job), light_(options.cube_side) {}

  Result<std::vector<PapersRow>> run() {
    const std::vector<int> sides{options_.side / 4, options_.side / 2, options_.side};
    tell("vertices", 0.0);
    if (!job_.cancelled()) atVertices(verticesPlace(options_.triangles, options_.directions));
    for (std::size_t i = 0; i < sides.size(); ++i) {
      // Texels grow by four from one to the next.
      tell(fmt::format("texture {}", sides[i]), i == 0 ? 0.1 : (i == 1 ? 0.15 : 0.3));
      if (job_.cancelled()) break;
      atTexels(texturePlace(options_.triangles, sides[i], options_.directions), sides[i]);
    }
    if (job_.cancelled()) return Error{"bench papers", "cancelled", ""};
    std::stable_sort(rows_.begin(), rows_.end(), [](const PapersRow& a, const PapersRow& b) {
      return rankOf(a.table) < rankOf(b.table);
    });
    return rows_;
  }

 private:
  static int rankOf(const std::string& table) {
    return table == kFujita ? 0 : (table == kDhawal1 ? 1 : 2);
  }
  void tell(const std::string& stage, double done) const { job_.report(stage, done); }

  PapersRow& add(const char* table, const std::string& work, const PapersPlace& place) {
    PapersRow row;
    row.table = table;
    row.work = work + ", " + place.name;
    row.triangles = place.triangles;
    row.receivers = place.receivers.size();
    row.coefficients = static_cast<int>(kCoefficients);
    row.bake_s = place.bake_s;
    rows_.push_back(row);
    return rows_.back();
  }

  /// A row of frames per second. work: multiply-adds per receiver.
  PapersRow& addFrames(const char* table, const std::string& what, const PapersPlace& place,
                       const Published& published, std::size_t bytes, double work,
                       const std::function<void()>& frame) {
    PapersRow& row = add(table, what, place);
    row.unit = "frames/s";
    row.published = published;
    row.bytes = bytes;
    row.multiply_adds = work * static_cast<double>(row.receivers);
    const double seconds = medianSeconds(frame, options_.seconds_per_case);
    row.ms = 1e3 * seconds;
    row.ours = 1.0 / seconds;
    return row;
  }

  void addMemory(const std::string& what, const PapersPlace& place, const Published& published,
                 std::size_t bytes) {
    PapersRow& row = add(kDhawal2, what, place);
    row.unit = "MB";
    row.published = published;
    row.bytes = bytes;
    row.ours = kMega * static_cast<double>(bytes);
  }

  void atVertices(const PapersPlace& place) {
    movingLight(place);
    tripleAndFixed(place);
    const std::size_t n = place.receivers.size();
    const auto halves = [n](std::size_t numbers) {
      return halvesInBlocks(n, numbers, glossy::kBlock);
    };
    addMemory("vectors", place, kVectors, place.diffuse.bytes());
    const std::size_t all = kCoefficients * kCoefficients;
    addMemory("matrices", place, kMatrices, halves(all));
    addMemory("matrices, upper triangle", place, kMatrices,
              halves(kCoefficients * (kCoefficients + 1) / 2));
    addMemory("matrices as 81 of visibility", place, kMatrices, halves(kWide));
    PapersRow& row = add(kDhawal2, "matrices over vectors", place);
    row.unit = "times";
    row.published = kMatricesOverVectors;
    row.bytes = halves(all);
    row.ours = static_cast<double>(halves(all)) / static_cast<double>(halves(kCoefficients));
  }

  void atTexels(const PapersPlace& place, int side) {
    tripleAndFixed(place);
    const bool same = side == kPublishedSide;
    const std::size_t n = place.receivers.size();
    addMemory("vectors", place, same ? kTexture : Published{},
              halvesInBlocks(n, kCoefficients, glossy::kBlock));
    if (side != options_.side) return;
    addMemory("matrices (counted)", place, same ? kMatrixTexture : Published{},
              halvesInBlocks(n, kCoefficients * kCoefficients, glossy::kBlock));
    addMemory("matrices as 81 of visibility (counted)", place, same ? kMatrixTexture : Published{},
              halvesInBlocks(n, kWide, glossy::kBlock));
  }

  /// Fujita & Kanai's frames: cube map to coefficients, coefficients through all transfer.
  void movingLight(const PapersPlace& place) {
    const double of_light = light_.work() / static_cast<double>(place.receivers.size());
    prt::Illuminances lux;
    addFrames(kFujita, "diffuse", place, {}, place.diffuse.bytes(), 3.0 * kCoefficients + of_light,
              [&] { prt::evaluate(place.diffuse, prt::LightVector(light_.project()), lux); });
    const auto lobes = papersLobes(place.receivers, options_.seed);
    glossy::FloatBlocks arriving(place.receivers.size(), 3 * kCoefficients);
    std::vector<vec3> radiance(place.receivers.size());
    const auto glossyFrames = [&](const char* what, const auto& set, std::size_t numbers) {
      const double work = 3.0 * static_cast<double>(numbers + kCoefficients);
      addFrames(kFujita, what, place, {}, set.bytes(), work + of_light, [&] {
        set.apply(light_.project(), arriving);
        glossy::shade(arriving, lobes, radiance);
      });
    };
    glossyFrames("glossy, 25 x 25", papersMatrices(place, false), kCoefficients * kCoefficients);
    glossyFrames("glossy, 25 x 81 of visibility", halvesOf(place.wide), kCoefficients * kWide);
  }

  /// Dhawal et al.'s frames: light and view free, then the view alone.
  void tripleAndFixed(const PapersPlace& place) {
    const auto lobes = papersLobes(place.receivers, options_.seed);
    const sh::RgbCoefficients light = light_.project();
    glossy::FloatBlocks arriving(place.receivers.size(), 3 * kCoefficients);
    std::vector<vec3> radiance(place.receivers.size());
    const double of_view = 3.0 * kCoefficients;
    const double triple =
        addFrames(kDhawal1, "triple product", place, kTriple, place.visibility.bytes(),
                  3.0 * tripleWork(kPapersBands) + of_view,
                  [&] {
                    multiplyTriple(light, place.visibility, arriving);
                    glossy::shade(arriving, lobes, radiance);
                  })
            .ours;
    const glossy::VisibilitySet set = halvesOf(place.visibility);
    const double fixed = addFrames(kDhawal1, "fixed light", place, kFixed, set.bytes(),
                                   3.0 * kCoefficients * kCoefficients + of_view,
                                   [&] {
                                     set.apply(light, arriving);
                                     glossy::shade(arriving, lobes, radiance);
                                   })
                             .ours;
    PapersRow& row = add(kDhawal1, "fixed light over triple product", place);
    row.unit = "times";
    row.published = kFixedOverTriple;
    row.ours = fixed / triple;
  }

  const PapersBenchOptions& options_;
  const Job& job_;
  CubeLight light_;
  std::vector<PapersRow> rows_;
};

std::string numberOrNothing(double value) {
  return value > 0.0 ? fmt::format("{:.6g}", value) : "";
}

}  // namespace

Result<std::vector<PapersRow>> measurePapers(const PapersBenchOptions& options, const Job& job) {
  return PapersBench(options, job).run();
}

std::string formatPapersRows(const std::vector<PapersRow>& rows) {
  std::string text =
      "table,work,unit,published,published_low,published_high,machine,ours,ratio_low,ratio_high,"
      "triangles,receivers,coefficients,bytes,multiply_adds,ms,bake_s\n";
  for (const PapersRow& r : rows) {
    text += fmt::format(
        "\"{}\",\"{}\",{},\"{}\",{},{},\"{}\",{:.6g},{},{},{},{},{},{},{},{},{:.6g}\n", r.table,
        r.work, r.unit, r.published.text, numberOrNothing(r.published.low),
        numberOrNothing(r.published.high), r.published.machine, r.ours,
        numberOrNothing(r.leastRatio()), numberOrNothing(r.mostRatio()), r.triangles, r.receivers,
        r.coefficients, r.bytes, numberOrNothing(r.multiply_adds), numberOrNothing(r.ms), r.bake_s);
  }
  return text;
}

}  // namespace soffit::design
