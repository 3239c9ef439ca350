// SPDX-License-Identifier: MIT
#pragma once

/// The first 25 real spherical harmonics as polynomials of x, y, z on the unit sphere, unrolled:
/// Fujita & Kanai 2004, Table 3 (checked term by term against the recurrence; index.h has the sign
/// convention). Where a factor of x^2 + y^2 + z^2 is free to choose it is 1.
namespace soffit::sh {

/// y_lm(x, y, z) at index l(l + 1) + m for l < Bands, 1 <= Bands <= 5; (x, y, z) unit.
template <int Bands, class Real>
constexpr void polynomials(Real x, Real y, Real z, Real* out) {
  static_assert(Bands >= 1 && Bands <= 5);
  out[0] = Real(0.28209479177387814);  // 1 / sqrt(4 pi)
  if constexpr (Bands > 1) {
    constexpr auto k = Real(0.48860251190291992);  // sqrt(3 / 4 pi)
    out[1] = k * y;
    out[2] = k * z;
    out[3] = k * x;
  }
  if constexpr (Bands > 2) {
    constexpr auto k = Real(1.0925484305920792);  // sqrt(15 / 4 pi)
    out[4] = k * x * y;
    out[5] = k * y * z;
    out[6] = Real(0.94617469575756008) * z * z - Real(0.31539156525252005);  // sqrt(5 / 16 pi)
    out[7] = k * x * z;
    out[8] = Real(0.54627421529603959) * (x * x - y * y);
  }
  if constexpr (Bands > 3) {
    const Real xx = x * x, yy = y * y, zz = z * z;
    const Real five = Real(0.45704579946446577) * (Real(5) * zz - Real(1));  // sqrt(21 / 32 pi)
    out[9] = Real(0.59004358992664352) * y * (Real(3) * xx - yy);            // sqrt(35 / 32 pi)
    out[10] = Real(2.8906114426405538) * x * y * z;                          // sqrt(105 / 4 pi)
    out[11] = five * y;
    out[12] = Real(0.37317633259011546) * z * (Real(5) * zz - Real(3));  // sqrt(7 / 16 pi)
    out[13] = five * x;
    out[14] = Real(1.4453057213202769) * z * (xx - yy);
    out[15] = Real(0.59004358992664352) * x * (xx - Real(3) * yy);
  }
  if constexpr (Bands > 4) {
    const Real xx = x * x, yy = y * y, zz = z * z;
    const Real c2 = xx - yy, s2 = Real(2) * x * y;
    const Real seven = Real(0.47308734787878004) * (Real(7) * zz - Real(1));  // sqrt(45 / 64 pi)
    const Real three =
        Real(0.66904654355728921) * z * (Real(7) * zz - Real(3));      // sqrt(45 / 32 pi)
    out[16] = Real(1.2516714708983523) * s2 * c2;                      // sqrt(315 / 64 pi)
    out[17] = Real(1.7701307697799304) * z * y * (Real(3) * xx - yy);  // sqrt(315 / 32 pi)
    out[18] = seven * s2;
    out[19] = three * y;
    out[20] = Real(0.10578554691520431) * (Real(35) * zz * zz - Real(30) * zz + Real(3));
    out[21] = three * x;
    out[22] = seven * c2;
    out[23] = Real(1.7701307697799304) * z * x * (xx - Real(3) * yy);
    out[24] = Real(0.62583573544917614) * (c2 * c2 - s2 * s2);  // sqrt(315 / 256 pi)
  }
}

}  // namespace soffit::sh
