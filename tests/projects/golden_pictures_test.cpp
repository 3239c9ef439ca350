// SPDX-License-Identifier: MIT
// Each sample through the program's own path, from its files to display code values, against
// stored pictures; golden/README.md says how those were made and what the limits mean.
#include "tests/projects/golden_pictures.h"

#include "core/io/image/read_image.h"
#include "core/io/project/project.h"
#include "tests/app/cli/run_program.h"
#include "tests/projects/picture_difference.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>

namespace soffit {

std::ostream& operator<<(std::ostream& out, const PictureDifference& d) {
  return out << "Delta E mean " << d.mean << ", 95 % " << d.p95 << ", 99 % " << d.p99
             << ", median of Delta L " << d.lightness;
}

namespace {

/// What a coarse bake may look different by: golden/README.md says where this comes from.
constexpr PictureDifference kMost{.mean = 2.0, .p95 = 6.0, .p99 = 12.0, .lightness = 0.5};

bool alike(const PictureDifference& d) {
  return d.mean < kMost.mean && d.p95 < kMost.p95 && d.p99 < kMost.p99 &&
         std::abs(d.lightness) < kMost.lightness;
}

class GoldenPictures : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    // One bake for all pictures of a sample, and none from elsewhere.
    ::setenv("SOFFIT_CACHE", (folder_.path() / "cache").c_str(),
             1);  // NOLINT(concurrency-mt-unsafe)
  }
  [[nodiscard]] std::string shownFile(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  /// Renders coarsely and compares with the stored picture `against`.
  PictureDifference difference(const GoldenPicture& picture, const GoldenPicture& against,
                               const std::vector<std::string>& changes = {}) const {
    const std::string shown = shownFile(picture.file);
    auto command = renderCommand(picture, shown);
    for (const char* setting :
         {"quality=draft", "quality.texels=26000", "quality.field_rays=16", "quality.list_rays=32",
          "quality.max_rank=32", "quality.tolerance=0.01"}) {
      command.insert(command.end(), {"--set", setting});
    }
    command.insert(command.end(), {"--samples", "16"});
    command.insert(command.end(), changes.begin(), changes.end());
    const ProgramResult result = runSoffit(folder_, command);
    EXPECT_EQ(result.status, 0) << result.err;
    const auto a = io::readImage(shown);
    const auto b = io::readImage(goldenFolder() + "/" + against.file);
    EXPECT_TRUE(a.ok() && b.ok());
    if (!a.ok() || !b.ok()) return {};
    EXPECT_EQ(a->width, b->width);
    EXPECT_EQ(a->height, b->height);
    return pictureDifference(*a, *b);
  }
  /// Keeps a picture that failed, to be looked at.
  void keep(const GoldenPicture& picture) const {
    const std::filesystem::path folder = std::filesystem::path(SOFFIT_BINARY_DIR) / "golden";
    std::filesystem::create_directories(folder);
    std::filesystem::copy_file(shownFile(picture.file), folder / picture.file,
                               std::filesystem::copy_options::overwrite_existing);
    ADD_FAILURE() << "shown: " << (folder / picture.file).string() << "\nstored: " << goldenFolder()
                  << "/" << picture.file;
  }
  static double exposureOf(const GoldenPicture& picture) {
    const auto project =
        io::loadProject(std::string(SOFFIT_SOURCE_DIR) + "/projects/" + picture.sample, {});
    EXPECT_TRUE(project.ok());
    return project->scene.view.exposure;
  }

 private:
  TemporaryFolder folder_;
};

TEST_P(GoldenPictures, LookAsStoredAndNotWhenSomethingChanged) {
  std::vector<GoldenPicture> pictures;
  for (const GoldenPicture& p : kGoldenPictures) {
    if (p.sample == std::string(GetParam())) pictures.push_back(p);
  }
  ASSERT_EQ(pictures.size(), 2U);
  for (const GoldenPicture& p : pictures) {
    const PictureDifference d = difference(p, p);
    std::cout << p.file << ": " << d << '\n';
    if (!alike(d)) keep(p);
  }
  // A tenth of a stop, and another layout seen by the same camera, are noticed.
  const GoldenPicture& first = pictures[0];
  for (const double ev : {-0.1, 0.1}) {
    const PictureDifference d =
        difference(first, first, {"--exposure", std::to_string(exposureOf(first) + ev)});
    std::cout << ev << " EV: " << d << '\n';
    EXPECT_FALSE(alike(d)) << ev << " EV";
  }
  GoldenPicture other = first;
  other.layout = pictures[1].layout;
  const PictureDifference d = difference(other, first);
  std::cout << other.layout << ": " << d << '\n';
  EXPECT_FALSE(alike(d));
}

INSTANTIATE_TEST_SUITE_P(Samples, GoldenPictures,
                         testing::Values("cornell", "flat", "gallery", "office"),
                         [](const auto& sample) { return std::string(sample.param); });

}  // namespace
}  // namespace soffit
