// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/prt/bounces.h"
#include "core/prt/set_key.h"
#include "core/prt/shadow_pass.h"
#include "core/prt/texture_receivers.h"
#include "core/prt/transfer_vectors.h"

#include <cstdint>
#include <memory>
#include <vector>

/// Transfer textures from scene to coefficients: layout, shadow pass, bounces.
namespace soffit::prt {

struct TextureBakeOptions {
  TextureOptions textures;
  int bands = 5;
  int directions = 1024;   ///< Hammersley set, whole sphere
  bool one_atlas = false;  ///< one texture for everything instead of a set per object
  bool bounces = true;
  /// Bounces are solved on textures whose texels are so many times as wide and brought to the fine
  /// ones by one more pass: what has been reflected once is smooth. 1: on the fine ones.
  int bounce_coarseness = 8;
  BounceOptions passes;
};

/// What a bake will take, before it is made; from the layout alone.
struct TextureBakeSize {
  std::uint64_t texels = 0;
  std::uint64_t flag_bytes = 0;
  std::uint64_t transfer_bytes = 0;  ///< as evaluated; three channels where surfaces are coloured
  std::uint64_t shadow_rays = 0;     ///< about; a pass of bounces traces those that were blocked
};

struct TextureBake {
  std::shared_ptr<const TextureReceivers> receivers;
  std::vector<SetKey> keys;  ///< per set
  VisibilityFlags flags;
  TransferRows direct;             ///< one channel
  TransferVectors transfer;        ///< with bounces, when asked for
  std::vector<BouncePass> passes;  ///< on the coarse textures
  std::uint64_t shadow_rays = 0;
  std::uint64_t bounce_rays = 0;  ///< and those of the coarse texels' shadow pass
  std::uint64_t replaced = 0;     ///< texels inside of other matter

  /// How much of a set had to be baked again; all of it in a first bake.
  struct Share {
    std::uint64_t texels = 0;  ///< whose direct transfer was computed
    bool new_layout = false;   ///< its own shape or settings changed
  };
  std::vector<Share> redone;  ///< per set
};

TextureBakeSize predictTextureBake(const TextureReceivers& receivers,
                                   const TextureBakeOptions& options);

/// Bakes every set. Errors: cancelled; what reaches the job's observer are the stages' names.
Result<TextureBake> bakeTextures(const std::shared_ptr<const Surfaces>& surfaces,
                                 const TextureBakeOptions& options, const Job& job = {});

/// The same after an edit, from an earlier bake with equal options but for `passes`: sets whose key
/// is unchanged keep their texels, and only those of their rays are traced that cross the bounds of
/// what changed, before or after; direct transfer is recomputed where a flag changed. Bounces are
/// solved again, as light from anywhere may have changed. The result equals bakeTextures()'s.
Result<TextureBake> rebakeTextures(const TextureBake& before,
                                   const std::shared_ptr<const Surfaces>& surfaces,
                                   const TextureBakeOptions& options, const Job& job = {});

}  // namespace soffit::prt
