// SPDX-License-Identifier: MIT
// Three tests keep the house in order: the include graph obeys the module picture, no file is over
// 400 lines, and third-party headers stay in the .cpp files of the one module that owns them.
#include "tests/architecture/source_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace soffit::architecture {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t kMaxLines = 400;

/// The picture: each module and the modules directly to its left. `app` sees everything.
const std::map<std::string, std::set<std::string>> kLeftOf{
    {"core/base", {}},
    {"core/math", {"core/base"}},
    {"core/color", {"core/math"}},
    {"core/sh", {"core/math"}},
    {"core/geometry", {"core/math"}},
    {"core/photometry", {"core/color", "core/sh", "core/geometry"}},
    {"core/light", {"core/photometry"}},
    {"core/scene", {"core/light"}},
    {"core/daylight", {"core/scene"}},
    {"core/transfer", {"core/daylight"}},
    {"core/reference", {"core/daylight"}},
    {"core/prt", {"core/transfer"}},
    {"core/glossy", {"core/transfer"}},
    {"core/relight", {"core/glossy", "core/prt"}},
    {"core/design", {"core/render", "core/reference", "core/prt"}},
    {"core/render", {"core/relight"}},
    {"core/io", {"core/relight"}},
    {"ui/document", {"core/io"}},
    {"ui/jobs", {"ui/document", "core/design", "core/render"}},
    {"ui/widgets", {"core/color"}},
    {"ui/viewport", {"ui/jobs", "ui/widgets"}},
    {"ui/panels", {"ui/viewport"}},
    {"ui/actions", {"ui/panels"}},
    {"ui/main_window", {"ui/actions"}},
    {"app", {"ui/main_window"}},
};

bool mayInclude(const std::string& from, const std::string& to) {
  if (from == to || from == "tests") return true;
  const auto direct = kLeftOf.find(from);
  if (direct == kLeftOf.end()) return false;
  return std::any_of(direct->second.begin(), direct->second.end(),
                     [&](const std::string& left) { return mayInclude(left, to); });
}

/// Third-party headers that have one owner; `pattern` matches the include's path.
struct Library {
  std::string name;
  std::regex pattern;
  std::string owner;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> list{
      {"Qt", std::regex("^(Qt[A-Za-z0-9]*/|Q[A-Z])"), "ui"},
      {"VTK", std::regex("^vtk"), "ui/viewport"},
      {"Embree", std::regex("^embree[0-9]*/"), "core/geometry"},
      {"Eigen", std::regex("^(Eigen|unsupported/Eigen)/"), "core/transfer"},
      {"oneTBB", std::regex("^(tbb|oneapi)/"), "core/base"},
      {"OpenColorIO", std::regex("^OpenColorIO/"), "core/color"},
      {"OpenImageIO", std::regex("^OpenImageIO/"), "core/io"},
      {"Assimp", std::regex("^assimp/"), "core/io"},
      {"JSON", std::regex("^nlohmann/"), "core/io"},
  };
  return list;
}

bool isHeader(const std::string& path) {
  return path.ends_with(".h") || path.ends_with(".hpp");
}

/// Headers of core show the standard library's and GLM's types alone. Standard headers have
/// neither a folder nor an ending.
bool isAllowedInCoreHeader(const std::string& include) {
  return include.starts_with("glm/") || include.find_first_of("/.") == std::string::npos;
}

std::vector<std::string> graphFaults(const SourceFile& file) {
  std::vector<std::string> faults;
  const std::string from = moduleOf(file.path);
  if (from.empty()) return faults;
  const bool modular = from.starts_with("core/") || from.starts_with("ui/");
  if (modular && !kLeftOf.contains(from)) {
    faults.push_back(fmt::format("{}: '{}' is not a module of the picture", file.path, from));
  }
  for (const Include& include : includesOf(file.text)) {
    const std::string to = moduleOf(include.path);
    if (include.angle || to.empty() || mayInclude(from, to)) continue;
    faults.push_back(fmt::format("{}:{}: {} may not include \"{}\"", file.path, include.line, from,
                                 include.path));
  }
  return faults;
}

std::vector<std::string> bannedIncludes(const SourceFile& file) {
  std::vector<std::string> faults;
  const std::string module = moduleOf(file.path);
  if (module.empty() || module == "tests") return faults;
  const bool core_header = module.starts_with("core/") && isHeader(file.path);
  for (const Include& include : includesOf(file.text)) {
    const auto fault = [&](const std::string& why) {
      faults.push_back(fmt::format("{}:{}: <{}>: {}", file.path, include.line, include.path, why));
    };
    if (core_header && include.angle && !isAllowedInCoreHeader(include.path)) {
      fault("headers of core include the standard library and GLM only");
    }
    for (const Library& library : libraries()) {
      const bool owned = module == library.owner || module.starts_with(library.owner + "/");
      if (!owned && std::regex_search(include.path, library.pattern)) {
        fault(fmt::format("{} belongs to {}", library.name, library.owner));
      }
    }
  }
  return faults;
}

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> files = readSources(SOFFIT_SOURCE_DIR);
  return files;
}

template <class Check>
std::vector<std::string> faultsOfAll(Check check) {
  std::vector<std::string> all;
  for (const SourceFile& file : sources()) {
    const std::vector<std::string> faults = check(file);
    all.insert(all.end(), faults.begin(), faults.end());
  }
  return all;
}

TEST(House, IncludeGraphObeysTheModulePicture) {
  ASSERT_GT(sources().size(), 20U) << "sources were not found below " << SOFFIT_SOURCE_DIR;
  EXPECT_THAT(faultsOfAll(graphFaults), IsEmpty());
}

TEST(House, NoFileIsOver400Lines) {
  for (const SourceFile& file : sources()) {
    EXPECT_LE(lineCount(file.text), kMaxLines) << file.path << ": split it";
  }
}

TEST(House, ThirdPartyHeadersStayWithTheirOwner) {
  EXPECT_THAT(faultsOfAll(bannedIncludes), IsEmpty());
}

// The checks themselves, on texts that break each rule.

TEST(HouseChecks, IncludesAreFoundAndCommentsAreNot) {
  EXPECT_THAT(
      includesOf("#include \"core/math/vec.h\"\n"
                 "// #include \"core/x.h\"\n/* a\n#include <b>\n*/\n  # include <vector>\n"),
      ElementsAre(Include{"core/math/vec.h", false, 1}, Include{"vector", true, 6}));
}

TEST(HouseChecks, LinesAreCountedWithAndWithoutAFinalBreak) {
  EXPECT_EQ(lineCount(""), 0U);
  EXPECT_EQ(lineCount("a\nb\n"), 2U);
  EXPECT_EQ(lineCount("a\nb"), 2U);
}

TEST(HouseChecks, ModulesAreTheSecondFolderOfCoreAndUi) {
  EXPECT_EQ(moduleOf("core/light/detail/mask.cpp"), "core/light");
  EXPECT_EQ(moduleOf("ui/panels/log_panel.cpp"), "ui/panels");
  EXPECT_EQ(moduleOf("app/commands/bake.cpp"), "app");
  EXPECT_EQ(moduleOf("projects/generate.py"), "");
}

TEST(HouseChecks, LeftMayNotIncludeRight) {
  EXPECT_THAT(graphFaults({"core/math/a.cpp", "#include \"core/light/emitter.h\"\n"}),
              ElementsAre("core/math/a.cpp:1: core/math may not include \"core/light/emitter.h\""));
  EXPECT_THAT(graphFaults({"core/io/a.cpp", "#include \"core/render/film.h\"\n"}),
              ElementsAre("core/io/a.cpp:1: core/io may not include \"core/render/film.h\""));
  EXPECT_THAT(graphFaults({"core/reference/a.cpp", "#include \"core/transfer/bake.h\"\n"}),
              ElementsAre("core/reference/a.cpp:1: core/reference may not include "
                          "\"core/transfer/bake.h\""));
  EXPECT_THAT(graphFaults({"core/utils/a.h", ""}),
              ElementsAre("core/utils/a.h: 'core/utils' is not a module of the picture"));
  EXPECT_THAT(graphFaults({"ui/widgets/a.cpp", "#include \"ui/document/document.h\"\n"}),
              ElementsAre("ui/widgets/a.cpp:1: ui/widgets may not include "
                          "\"ui/document/document.h\""));
  EXPECT_THAT(graphFaults({"core/relight/a.cpp", "#include \"core/base/result.h\"\n"}), IsEmpty());
}

TEST(HouseChecks, ThirdPartyHeadersOutsideTheirOwnerAreFound) {
  EXPECT_THAT(bannedIncludes({"core/light/a.cpp", "#include <QWidget>\n"}),
              ElementsAre("core/light/a.cpp:1: <QWidget>: Qt belongs to ui"));
  EXPECT_THAT(bannedIncludes({"ui/panels/a.cpp", "#include <QWidget>\n#include <vtkActor.h>\n"}),
              ElementsAre("ui/panels/a.cpp:2: <vtkActor.h>: VTK belongs to ui/viewport"));
  EXPECT_THAT(bannedIncludes({"core/transfer/a.cpp", "#include <embree4/rtcore.h>\n"}),
              ElementsAre("core/transfer/a.cpp:1: <embree4/rtcore.h>: Embree belongs to "
                          "core/geometry"));
  EXPECT_THAT(bannedIncludes({"core/io/a.h", "#include <nlohmann/json.hpp>\n"}),
              ElementsAre("core/io/a.h:1: <nlohmann/json.hpp>: headers of core include the "
                          "standard library and GLM only"));
  EXPECT_THAT(bannedIncludes({"core/io/a.cpp", "#include <nlohmann/json.hpp>\n"}), IsEmpty());
  EXPECT_THAT(bannedIncludes({"core/math/a.h", "#include <glm/vec3.hpp>\n#include <cmath>\n"}),
              IsEmpty());
}

}  // namespace
}  // namespace soffit::architecture
