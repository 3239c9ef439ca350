// SPDX-License-Identifier: MIT
#include "core/transfer/operator_arrays.h"

namespace soffit::transfer {

Records recordsOf(const Operators& operators) {
  Records records;
  for (const Chart& chart : operators.texels.charts.charts) {
    const auto& [planar, sides, material, origin, t, b, normal, size, area, first, count] = chart;
    records.charts.push_back({planar ? std::uint8_t{1} : std::uint8_t{0}, sides, 0, material,
                              origin, t, b, normal, size, area, first, count});
  }
  records.scalars.push_back({operators.texels.cell, operators.nodes.functions,
                             operators.nodes.stride, operators.coarse ? 1U : 0U,
                             static_cast<double>(operators.conserve)});
  return records;
}

std::string applyRecords(const Records& records, Operators& operators) {
  if (records.scalars.size() != 1 || records.scalars[0].coarse > 1) return "scalars";
  if (!(records.scalars[0].conserve >= 0.0 && records.scalars[0].conserve <= 1.0)) return "scalars";
  operators.texels.cell = records.scalars[0].cell;
  operators.nodes.functions = records.scalars[0].functions;
  operators.nodes.stride = records.scalars[0].stride;
  operators.conserve = static_cast<float>(records.scalars[0].conserve);
  operators.coarse = records.scalars[0].coarse != 0;
  std::vector<Chart>& charts = operators.texels.charts.charts;
  charts.clear();
  for (const ChartRecord& r : records.charts) {
    if (r.planar > 1 || r.zero != 0) return "charts";
    charts.push_back({r.planar != 0, r.sides, r.material, r.origin, r.t, r.b, r.normal, r.size,
                      r.area, r.first_triangle, r.triangle_count});
  }
  return {};
}

}  // namespace soffit::transfer
