// SPDX-License-Identifier: Apache-2.0
#include "support/models.h"

#include "geometry/trig.h"

namespace inkflate {
namespace {

constexpr double kCanvasPx = 400;

void finish(RestModel& model, std::string const& name) {
  model.width_px = model.height_px = kCanvasPx;
  model.layer_names = {name};
  for (auto const point : model.mesh.points) {
    model.canvas.push_back({point.x + kCanvasPx / 2, kCanvasPx / 2 - point.y});
  }
}

/// Two triangles for a quad whose corners are counter-clockwise as seen from outside.
void add_quad(RestModel& model, std::array<int, 4> const& q, Side side) {
  model.mesh.triangles.push_back({q[0], q[1], q[2]});
  model.mesh.triangles.push_back({q[0], q[2], q[3]});
  model.faces.insert(model.faces.end(), 2, Face{0, side});
}

}  // namespace

RestModel ball_model(Vec3 centre, double radius, int rings) {
  RestModel model;
  int const around = 4 * rings;
  auto const add = [&](Vec3 normal) {
    model.mesh.points.push_back(centre + normal * radius);
    model.normals.push_back(normal);
  };
  add({0, 0, 1});
  for (int r = 1; r < 2 * rings; ++r) {
    auto const tilt = sin_cos(kPi * r / (2 * rings));
    for (int i = 0; i < around; ++i) {
      auto const turn = sin_cos(2 * kPi * i / around);
      add({tilt.sin * turn.cos, tilt.sin * turn.sin, r == rings ? 0 : tilt.cos});
    }
  }
  add({0, 0, -1});
  int const last = static_cast<int>(std::ssize(model.mesh.points)) - 1;
  auto const at = [&](int r, int i) { return 1 + (r - 1) * around + i % around; };
  for (int i = 0; i < around; ++i) {
    model.mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
    model.faces.push_back({0, Side::Front});
  }
  for (int r = 1; r < 2 * rings - 1; ++r) {
    auto const side = r < rings ? Side::Front : Side::Back;
    for (int i = 0; i < around; ++i) {
      add_quad(model, {at(r, i), at(r + 1, i), at(r + 1, i + 1), at(r, i + 1)}, side);
    }
  }
  for (int i = 0; i < around; ++i) {
    model.mesh.triangles.push_back({last, at(2 * rings - 1, i + 1), at(2 * rings - 1, i)});
    model.faces.push_back({0, Side::Back});
  }
  finish(model, "ball");
  return model;
}

RestModel torus_model(double major_radius, double minor_radius, int segments) {
  RestModel model;
  int const around = 2 * segments;
  for (int i = 0; i < around; ++i) {
    auto const turn = sin_cos(2 * kPi * i / around);
    for (int j = 0; j < segments; ++j) {
      auto const roll = sin_cos(2 * kPi * j / segments);
      double const height = 2 * j % segments == 0 ? 0 : roll.sin;
      Vec3 const normal = {roll.cos * turn.cos, roll.cos * turn.sin, height};
      Vec3 const middle = Vec3{turn.cos, turn.sin, 0} * major_radius;
      model.mesh.points.push_back(middle + normal * minor_radius);
      model.normals.push_back(normal);
    }
  }
  auto const at = [&](int i, int j) { return i % around * segments + j % segments; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < segments; ++j) {
      auto const side = 2 * j < segments ? Side::Front : Side::Back;
      add_quad(model, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, side);
    }
  }
  finish(model, "ring");
  return model;
}

void add_layer(RestModel& model, RestModel const& part, std::string const& name) {
  int const first = static_cast<int>(std::ssize(model.mesh.points));
  int const layer = static_cast<int>(std::ssize(model.layer_names));
  auto const append = [](auto& to, auto const& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(model.mesh.points, part.mesh.points);
  append(model.normals, part.normals);
  append(model.canvas, part.canvas);
  for (auto const& t : part.mesh.triangles) {
    model.mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for (auto const& face : part.faces) model.faces.push_back({layer, face.side});
  model.layer_names.push_back(name);
}

RestModel two_layer_model() {
  auto model = ball_model({}, 150, 12);
  model.layer_names = {"body"};
  add_layer(model, ball_model({20, 30, 140}, 40, 6), "nose");
  return model;
}

Texture sheet_texture(RestModel const& model, Picture const& picture) {
  Texture texture = {picture, {}};
  for (std::size_t i = 0; i < model.mesh.triangles.size(); ++i) {
    double const shift = model.faces[i].side == Side::Front ? 0 : 0.5;
    std::array<Vec2, 3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
      auto const place = model.canvas[static_cast<std::size_t>(model.mesh.triangles[i][c])];
      corners[c] = {shift + place.x / model.width_px / 2, place.y / model.height_px};
    }
    texture.corners.push_back(corners);
  }
  return texture;
}

Picture red_over_blue(int size) {
  Picture picture(2 * size, size, {220, 30, 30, 255});
  for (int y = size / 2; y < size; ++y) {
    for (int x = 0; x < 2 * size; ++x) picture.at(x, y) = {30, 30, 220, 255};
  }
  return picture;
}

}  // namespace inkflate
