// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/console.h"
#include "io/read_mesh.h"
#include "mesh/check_mesh.h"

namespace inkflate::cli {

/// What a model's file is meant for.
enum class MeshPurpose {
  Model,  // parts may pass through each other, as those of a layered character do
  Print,  // one shell that nowhere passes through itself
};

/// One thing that a good mesh is or has not.
struct MeshProperty {
  std::string key;    // in the report: "closed"
  std::string words;  // for people: "closed"
  bool holds = false;
  bool is_asked = true;  // whether it counts for this purpose
  std::string why_not;   // with figures; empty where it holds
};

/// A model's file, looked at.
struct MeshReport {
  MeshReading reading;
  TriMesh mesh;  // with vertices at one place made one
  MeshCheck check;
  int self_crossings = 0;
  std::vector<MeshProperty> properties;
  bool is_ok = false;  // all that is asked holds
};

MeshReport report_mesh(MeshReading reading, MeshPurpose purpose);

/// One boolean for each property, all counts and figures, and "ok".
Json mesh_report_json(MeshReport const& report);

/// A headline, a line for each property, and a line of figures.
std::string mesh_report_text(MeshReport const& report, std::string const& file);

}  // namespace inkflate::cli
