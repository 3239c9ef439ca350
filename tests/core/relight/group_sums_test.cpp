// SPDX-License-Identifier: MIT
#include "core/relight/group_sums.h"

#include "tests/core/relight/rooms.h"

#include <algorithm>
#include <cmath>

namespace soffit::relight {
namespace {

using namespace testing;

class GroupSumsTest : public ::testing::Test {
 protected:
  static constexpr std::size_t kMembers = 6;

  void SetUp() override {
    auto mesh = emptyMesh();
    mesh->materials = {"walls", "red"};
    addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
    addBox(*mesh, {1, 1, 0.3F}, {2, 2.2F, 1.3F}, false, 1);
    solver_ = solverFor(mesh, {dvec3(0.7, 0.65, 0.6), dvec3(0.6, 0.1, 0.1)});
    for (std::size_t i = 0; i < kMembers; ++i) {
      luminaires_.push_back(panel({0.6 + 0.5 * static_cast<double>(i), 2.5, 2.9}, 0.3, 1000));
    }
    lighting_ = std::make_unique<Lighting>(solver_);
    ASSERT_TRUE(lighting_->setLuminaires(luminaires_).ok());
    groups_.assign(kMembers, "A");
  }

  Planes total() {
    Planes sum = sums_.total(*lighting_, groups_, changed_);
    changed_.assign(kMembers, false);
    return sum;
  }

  void dim(std::size_t i, double gain) { lighting_->setMix(i, gain, dvec3(1.0)); }

  /// Against the luminaires mixed one by one.
  void expectSum(const Planes& mixed, float share) const {
    const Planes expected = lighting_->total();
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(mixed[c].size(), expected[c].size());
      const float most = *std::ranges::max_element(expected[c]);
      for (std::size_t s = 0; s < mixed[c].size(); ++s) {
        ASSERT_NEAR(mixed[c][s], expected[c][s], share * most);
      }
    }
  }

  std::shared_ptr<const Solver> solver_;
  std::vector<light::Luminaire> luminaires_;
  std::unique_ptr<Lighting> lighting_;
  std::vector<std::string> groups_;
  std::vector<bool> changed_ = std::vector<bool>(kMembers, true);
  GroupSums sums_;
};

constexpr float kRounding = 16.0F * 6e-8F;  // sums of a few floats in another order

TEST_F(GroupSumsTest, AWholeGroupIsDimmedWithoutItsMembers) {
  expectSum(total(), kRounding);
  EXPECT_EQ(sums_.addedLast(), kMembers);
  for (std::size_t i = 0; i < kMembers; ++i) dim(i, 0.5);
  expectSum(total(), kRounding);  // now they are summed
  for (std::size_t i = 0; i < kMembers; ++i) dim(i, 0.2);
  expectSum(total(), kRounding);
  EXPECT_EQ(sums_.addedLast(), 0U);
}

TEST_F(GroupSumsTest, OneMemberCostsOneMember) {
  (void)total();
  dim(2, 0.7);
  expectSum(total(), kRounding);
  for (int i = 0; i < 150; ++i) {  // beyond the differences after which a sum is renewed
    dim(2, 0.01 * (i % 90));
    (void)total();
    if (i == 3) {
      EXPECT_EQ(sums_.addedLast(), 1U);
    }
  }
  expectSum(total(), 1e-5F);
}

TEST_F(GroupSumsTest, OtherFactorsForAllAreMixedFromTheMembers) {
  for (int run = 0; run < 5; ++run) {
    for (std::size_t i = 0; i < kMembers; ++i) {
      dim(i, 0.1 + 0.13 * static_cast<double>((i * i + 3 * static_cast<std::size_t>(run)) % 7));
    }
    expectSum(total(), 0.0F);
    EXPECT_EQ(sums_.addedLast(), kMembers);
  }
}

TEST_F(GroupSumsTest, DarkIsDark) {
  for (std::size_t i = 0; i < kMembers; ++i) {
    (void)total();
    dim(i, 0.0);
  }
  for (const auto& plane : total()) {
    EXPECT_TRUE(std::ranges::all_of(plane, [](float e) { return e == 0.0F; }));
  }
  dim(1, 1.0);
  expectSum(total(), kRounding);
}

TEST_F(GroupSumsTest, MovesAndOtherGroupsAreNoticed) {
  (void)total();
  (void)total();
  groups_[4] = "B";
  expectSum(total(), kRounding);
  luminaires_[0].position.y += 0.3;
  ASSERT_TRUE(lighting_->setLuminaires(luminaires_).ok());
  changed_[0] = true;
  expectSum(total(), kRounding);
  expectSum(total(), kRounding);
}

TEST_F(GroupSumsTest, OneColumnAtOneSlotIsThatOfThePicture) {
  const WeightedColumn light{&lighting_->column(1), dvec3(0.8, 0.6, 0.4)};
  Planes lux;
  spread({}, {&light, 1}, solver_->operators(), lux);
  for (std::uint32_t s = 0; s < lux[0].size(); s += 7) {
    const dvec3 one = luxAt(light, solver_->operators(), s);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(one[static_cast<int>(c)], lux[c][s], 1e-5 * (1.0 + std::abs(lux[c][s])));
    }
  }
}

}  // namespace
}  // namespace soffit::relight
