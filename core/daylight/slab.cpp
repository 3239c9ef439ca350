// SPDX-License-Identifier: MIT
#include "core/daylight/slab.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soffit::daylight {
namespace {

Slab::Shares throughFaces(double face, double pass) {
  const double inner = face * pass;
  const double transmitted = (1.0 - face) * (1.0 - face) * pass / (1.0 - inner * inner);
  return {transmitted, face * (1.0 + pass * transmitted)};
}

}  // namespace

Slab::Slab(const scene::Glass& glass) : index_(std::max(glass.index, 1.0)) {
  const double amplitude = (index_ - 1.0) / (index_ + 1.0);
  const double r = amplitude * amplitude;
  const double t = glass.transmittance;
  // T = (1-r)^2 a / (1 - r^2 a^2) solved for a, in the form that does not cancel for small r.
  const double faces = (1.0 - r) * (1.0 - r);
  const double pass = 2.0 * t / (faces + std::sqrt(faces * faces + 4.0 * r * r * t * t));
  log_pass_ = pass > 0.0 ? std::log(std::min(pass, 1.0)) : -std::numeric_limits<double>::infinity();
}

Slab::Shares Slab::at(double cos_incidence) const {
  const double ci = std::min(std::abs(cos_incidence), 1.0);
  const double sine = std::sqrt(std::max(0.0, 1.0 - ci * ci)) / index_;
  const double ct = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  if (!(ci > 0.0)) return index_ > 1.0 ? Shares{0.0, 1.0} : Shares{0.0, 0.0};
  const double pass = ct > 0.0 ? std::exp(log_pass_ / ct) : 0.0;
  const double s = (ci - index_ * ct) / (ci + index_ * ct);
  const double p = (index_ * ci - ct) / (index_ * ci + ct);
  const Shares across = throughFaces(s * s, pass);
  const Shares along = throughFaces(p * p, pass);
  return {0.5 * (across.transmitted + along.transmitted),
          0.5 * (across.reflected + along.reflected)};
}

}  // namespace soffit::daylight
