// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_report.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace inkflate::cli {
namespace {

constexpr int kMostCrossings = 1000;

/// "3 edges with one triangle"; nothing for none.
std::string figure(long long count, char const* singular, char const* plural) {
  if (count == 0) return {};
  return std::to_string(count) + ' ' + (count == 1 ? singular : plural);
}

std::string joined(std::string const& a, std::string const& b) {
  return a.empty() || b.empty() ? a + b : a + " and " + b;
}

std::string crossings(int count) {
  std::string const more = count >= kMostCrossings ? " or more" : "";
  return count == 0 ? ""
                    : std::to_string(count) + more + " pairs of triangles pass through each other";
}

std::vector<MeshProperty> properties_of(MeshCheck const& check, int self_crossings,
                                        MeshPurpose purpose) {
  std::vector<MeshProperty> list;
  auto const add = [&](char const* key, char const* words, bool holds, std::string why_not) {
    list.push_back({key, words, holds, true, std::move(why_not)});
  };
  add("finite", "only finite coordinates", check.is_finite(),
      figure(check.non_finite_points, "vertex is not", "vertices are not"));
  add("indices", "triangles of three different vertices", check.bad_indices == 0,
      figure(check.bad_indices, "triangle is not", "triangles are not"));
  add("closed", "closed", check.is_closed(),
      figure(check.boundary_edges, "edge has one triangle", "edges have one triangle"));
  add("manifold", "a surface everywhere (2-manifold)", check.is_manifold(),
      joined(figure(check.non_manifold_edges, "edge has more than two triangles",
                    "edges have more than two triangles"),
             figure(check.non_manifold_vertices, "vertex joins several sheets",
                    "vertices join several sheets")));
  add("oriented", "oriented, outside out", check.is_oriented(),
      joined(figure(check.misoriented_edges, "edge's triangles turn different ways",
                    "edges' triangles turn different ways"),
             check.is_inside_out ? "it is inside out" : ""));
  add("no_zero_area", "no triangle without area", check.zero_area_triangles == 0,
      figure(check.zero_area_triangles, "has none", "have none"));
  add("no_flipped", "no triangle folded back", check.flipped_triangles == 0,
      figure(check.flipped_triangles, "is folded back", "are folded back"));
  add("no_self_crossing", "nowhere through itself", self_crossings == 0, crossings(self_crossings));
  add("one_shell", "one piece", check.shells == 1, figure(check.shells, "piece", "pieces"));
  for (std::size_t i = list.size() - 2; i < list.size(); ++i) {
    list[i].is_asked = purpose == MeshPurpose::Print;
  }
  return list;
}

Json point_json(Vec3 point) { return Json::array({point.x, point.y, point.z}); }

/// To four digits, for people.
std::string rounded(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

std::string size_text(MeshCheck const& check) {
  Vec3 const size = check.max - check.min;
  return rounded(size.x) + " x " + rounded(size.y) + " x " + rounded(size.z);
}

}  // namespace

MeshReport report_mesh(MeshReading reading, MeshPurpose purpose) {
  MeshReport report;
  report.mesh = weld_vertices(reading.mesh);
  // Welding leaves out what no triangle uses, but a coordinate that is none is a fault there, too.
  report.check = check_mesh(report.mesh);
  for (auto const point : reading.mesh.points) {
    if (!is_finite(point) && report.check.is_finite()) report.check.non_finite_points = 1;
  }
  report.self_crossings = count_self_crossings(report.mesh, kMostCrossings);
  report.reading = std::move(reading);
  report.properties = properties_of(report.check, report.self_crossings, purpose);
  report.is_ok = true;
  for (auto const& property : report.properties) {
    report.is_ok = report.is_ok && (property.holds || !property.is_asked);
  }
  return report;
}

Json mesh_report_json(MeshReport const& report) {
  auto const& check = report.check;
  Json json;
  json["format"] = file_format_name(report.reading.format);
  json["names"] = report.reading.names;
  json["texture"] = report.reading.has_texture;
  json["vertices"] = report.mesh.points.size();
  json["triangles"] = report.mesh.triangles.size();
  for (auto const& property : report.properties) json[property.key] = property.holds;
  json["non_finite_points"] = check.non_finite_points;
  json["bad_indices"] = check.bad_indices;
  json["boundary_edges"] = check.boundary_edges;
  json["non_manifold_edges"] = check.non_manifold_edges;
  json["non_manifold_vertices"] = check.non_manifold_vertices;
  json["misoriented_edges"] = check.misoriented_edges;
  json["inside_out"] = check.is_inside_out;
  json["zero_area_triangles"] = check.zero_area_triangles;
  json["flipped_triangles"] = check.flipped_triangles;
  json["self_crossings"] = report.self_crossings;
  json["shells"] = check.shells;
  json["genus"] = check.genus;
  json["euler"] = check.euler;
  json["volume"] = check.volume;
  json["bounding_box"] = {{"min", point_json(check.min)}, {"max", point_json(check.max)}};
  json["ok"] = report.is_ok;
  return json;
}

std::string mesh_report_text(MeshReport const& report, std::string const& file) {
  auto const& check = report.check;
  std::string text = file + ": " + file_format_name(report.reading.format) + ", " +
                     std::to_string(report.mesh.points.size()) + " vertices, " +
                     std::to_string(report.mesh.triangles.size()) + " triangles" +
                     (report.reading.has_texture ? ", textured: " : ": ") +
                     (report.is_ok ? "ok\n" : "NOT ok\n");
  for (auto const& property : report.properties) {
    text += property.holds ? "  yes  " : property.is_asked ? "  NO   " : "  no   ";
    text += property.words;
    if (!property.holds) text += ": " + property.why_not;
    if (!property.holds && !property.is_asked) text += " (asked only with --print)";
    text += '\n';
  }
  text += "  " + figure(check.shells, "shell", "shells") + ", genus " +
          std::to_string(check.genus) + ", V - E + F = " + std::to_string(check.euler) +
          ", volume " + rounded(check.volume) + ", size " + size_text(check) + '\n';
  return text;
}

}  // namespace inkflate::cli
