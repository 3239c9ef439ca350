// SPDX-License-Identifier: MIT
#include "core/prt/texture_bake.h"

#include "core/prt/direct_transfer.h"

#include <algorithm>
#include <map>
#include <utility>

namespace soffit::prt {
namespace {

TextureReceivers receiversOf(const std::shared_ptr<const Surfaces>& surfaces,
                             const TextureOptions& options, bool one_atlas, const Job& job) {
  return one_atlas ? TextureReceivers::atlas(surfaces, options, job)
                   : TextureReceivers::perObject(surfaces, options, job);
}

/// All triangles of each set, whether they receive light or only block it.
std::vector<std::vector<std::uint32_t>> trianglesOf(const TextureReceivers& receivers) {
  std::vector<std::vector<std::uint32_t>> triangles(receivers.sets().size());
  for (std::uint32_t t = 0; t < receivers.surfaces().triangleCount(); ++t) {
    triangles[receivers.setOf(t)].push_back(t);
  }
  return triangles;
}

Box boundsOf(const Surfaces& s, const std::vector<std::uint32_t>& triangles) {
  Box box;
  for (const std::uint32_t t : triangles) {
    for (int k = 0; k < 3; ++k) box.add(s.corner(t, k));
  }
  return box;
}

std::vector<SetKey> keysOf(const TextureReceivers& receivers, const TextureOptions& options) {
  std::vector<SetKey> keys;
  for (const auto& triangles : trianglesOf(receivers)) {
    keys.push_back(setKey(receivers.surfaces(), triangles, options));
  }
  return keys;
}

/// What of an earlier bake still holds: per new set the old one with the same content.
struct Match {
  std::vector<std::size_t> old_set;  ///< kNone for none
  std::vector<Box> edited;           ///< of what has gone and of what has come
  static constexpr std::size_t kNone = ~std::size_t{0};
};

Match matched(const TextureBake& before, const TextureReceivers& now,
              const std::vector<SetKey>& keys) {
  std::multimap<SetKey, std::size_t> old;
  for (std::size_t k = 0; k < before.keys.size(); ++k) old.emplace(before.keys[k], k);
  Match match;
  const auto triangles = trianglesOf(now);
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const auto it = old.find(keys[k]);
    match.old_set.push_back(it == old.end() ? Match::kNone : it->second);
    if (it == old.end()) {
      match.edited.push_back(boundsOf(now.surfaces(), triangles[k]));
    } else {
      old.erase(it);
    }
  }
  const auto gone = trianglesOf(*before.receivers);
  for (const auto& [key, k] : old) {
    match.edited.push_back(boundsOf(before.receivers->surfaces(), gone[k]));
  }
  return match;
}

/// Old flags and rows at their new places; receivers that had none are fresh.
struct Carried {
  VisibilityFlags flags;
  TransferRows direct;
  std::vector<std::uint8_t> fresh;
};

Carried carryOver(const TextureBake& before, const TextureReceivers& now, const Match& match) {
  const std::size_t count = now.receivers().size();
  Carried out{VisibilityFlags(count, before.flags.directions()),
              TransferRows(count, before.direct.bands(), 1), std::vector<std::uint8_t>(count, 1)};
  std::vector<std::uint32_t> first{0};
  std::vector<VisibilityFlags::Dimmed> dimmed;
  for (std::size_t k = 0; k < now.sets().size(); ++k) {
    const TextureSet& set = now.sets()[k];
    for (std::uint32_t i = set.first; i < set.first + set.count; ++i) {
      if (match.old_set[k] != Match::kNone) {
        const std::uint32_t j = before.receivers->sets()[match.old_set[k]].first + i - set.first;
        // A receiver that stood for itself before and does now; its flags are there.
        if (before.receivers->receivers().standsForItself(j) &&
            now.receivers().standsForItself(i)) {
          out.fresh[i] = 0;
          std::copy(before.flags.words(j).begin(), before.flags.words(j).end(),
                    out.flags.words(i).begin());
          std::copy(before.direct.row(j).begin(), before.direct.row(j).end(),
                    out.direct.row(i).begin());
          const auto old = before.flags.dimmed(j);
          dimmed.insert(dimmed.end(), old.begin(), old.end());
        }
      }
      first.push_back(static_cast<std::uint32_t>(dimmed.size()));
    }
  }
  if (!before.flags.firstDimmed().empty()) out.flags.setDimmed(std::move(first), std::move(dimmed));
  return out;
}

void countRedone(const std::vector<std::uint8_t>& changed, const Match& match, TextureBake& bake) {
  const auto& sets = bake.receivers->sets();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    const auto begin = changed.begin() + sets[k].first;
    const auto texels = std::count(begin, begin + sets[k].count, std::uint8_t{1});
    bake.redone.push_back({static_cast<std::uint64_t>(texels), match.old_set[k] == Match::kNone});
  }
}

/// On the bake's own texels.
Result<void> solveFine(const Surfaces& surfaces, const Directions& directions,
                       const TextureBakeOptions& options, const Job& job, TextureBake& bake) {
  auto bounced = addBounces(surfaces, *bake.receivers, directions, bake.flags, bake.direct,
                            options.passes, job);
  if (!bounced) return bounced.error();
  bake.passes = std::move(bounced->passes);
  bake.bounce_rays += bounced->rays;
  bake.transfer = TransferVectors(bounced->transfer);
  return {};
}

/// On coarse texels, and one more bounce to the bake's own.
Result<void> solveCoarse(const std::shared_ptr<const Surfaces>& surfaces,
                         const Directions& directions, const TextureBakeOptions& options,
                         const Job& job, TextureBake& bake) {
  TextureOptions wide = options.textures;
  wide.texel *= options.bounce_coarseness;
  if (wide.side > 0) wide.side = std::max(wide.side / options.bounce_coarseness, 16);
  // Nobody looks at these: neither coarser levels nor dilation.
  wide.levels = 1;
  wide.dilation = 0;
  TextureReceivers coarse = receiversOf(surfaces, wide, options.one_atlas, job);
  const auto valid = findUncovered(*surfaces, coarse.receivers(), job);
  if (!valid) return valid.error();
  coarse.replaceInvalid(*valid);
  const auto pass = traceShadows(*surfaces, coarse.receivers(), directions, job);
  if (!pass) return pass.error();
  const auto direct = shadowedTransfer(coarse.receivers(), directions, pass->flags, job);
  if (!direct) return direct.error();
  auto bounced =
      addBounces(*surfaces, coarse, directions, pass->flags, *direct, options.passes, job);
  if (!bounced) return bounced.error();
  const auto last = gatherBounce(*surfaces, coarse, bounced->transfer, bake.receivers->receivers(),
                                 directions, bake.flags, bake.direct, job);
  if (!last) return last.error();
  bake.passes = std::move(bounced->passes);
  bake.bounce_rays += pass->rays + bounced->rays + last->rays;
  bake.transfer = TransferVectors(last->transfer);
  return {};
}

}  // namespace

TextureBakeSize predictTextureBake(const TextureReceivers& receivers,
                                   const TextureBakeOptions& options) {
  TextureBakeSize size;
  size.texels = receivers.receivers().size();
  const auto directions = static_cast<std::uint64_t>(options.directions);
  size.flag_bytes = VisibilityFlags::predictBytes(size.texels, directions);
  const bool colored = options.bounces && !receivers.receivers().grey();
  size.transfer_bytes = TransferVectors::predictBytes(size.texels, options.bands, colored ? 3 : 1);
  size.shadow_rays = size.texels * directions / 2;
  return size;
}

Result<TextureBake> rebakeTextures(const TextureBake& before,
                                   const std::shared_ptr<const Surfaces>& surfaces,
                                   const TextureBakeOptions& options, const Job& job) {
  TextureReceivers made = receiversOf(surfaces, options.textures, options.one_atlas, job);
  const auto valid = findUncovered(*surfaces, made.receivers(), job);
  if (!valid) return valid.error();
  made.replaceInvalid(*valid);
  TextureBake bake;
  bake.receivers = std::make_shared<const TextureReceivers>(std::move(made));
  const Receivers& receivers = bake.receivers->receivers();
  bake.replaced = static_cast<std::uint64_t>(std::count(valid->begin(), valid->end(), 0));
  bake.keys = keysOf(*bake.receivers, options.textures);
  const Match match = matched(before, *bake.receivers, bake.keys);
  const Directions directions(sh::hammersleySamples(options.directions), options.bands);
  Carried carried = carryOver(before, *bake.receivers, match);
  auto update = retraceShadows(carried.flags, *surfaces, receivers, directions, match.edited,
                               carried.fresh, job);
  if (!update) return update.error();
  bake.flags = std::move(update->flags);
  bake.shadow_rays = update->rays;
  countRedone(update->changed, match, bake);
  auto direct = shadowedTransfer(receivers, directions, bake.flags, update->changed,
                                 std::move(carried.direct), job);
  if (!direct) return direct.error();
  bake.direct = std::move(*direct);
  if (!options.bounces) {
    bake.transfer = TransferVectors(bake.direct);
    return bake;
  }
  const auto solved = options.bounce_coarseness <= 1
                          ? solveFine(*surfaces, directions, options, job, bake)
                          : solveCoarse(surfaces, directions, options, job, bake);
  if (!solved) return solved.error();
  return bake;
}

Result<TextureBake> bakeTextures(const std::shared_ptr<const Surfaces>& surfaces,
                                 const TextureBakeOptions& options, const Job& job) {
  // Nothing was there before, and everything has come.
  TextureBake nothing;
  nothing.receivers = std::make_shared<const TextureReceivers>(
      TextureReceivers::atlas(makeSurfaces(std::make_shared<const geometry::Mesh>(), {}), {}));
  nothing.flags = VisibilityFlags(0, static_cast<std::size_t>(options.directions));
  nothing.direct = TransferRows(0, options.bands, 1);
  return rebakeTextures(nothing, surfaces, options, job);
}

}  // namespace soffit::prt
