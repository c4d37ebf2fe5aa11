// SPDX-License-Identifier: BSL-1.0
#include "scene/scene_records.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include <carom/collision/expects.hpp>
#include <carom/collision/json/json.hpp>
#include <carom/collision/json/text.hpp>
#include <carom/scene/polyhedra/free_rotation.hpp>
#include <carom/scene/polyhedra/rigid_body.hpp>

namespace carom::tool {
namespace {

using nlohmann::json;
using properties::all_causes;
using properties::Cause;
using scene::Event;

json momentum_json(const Vector3<long double>& p) {
  return json::array({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])});
}

json energies_json(const properties::Energies& energies) {
  return {{"translation", static_cast<double>(energies.translation)},
          {"rotation", static_cast<double>(energies.rotation)},
          {"potential", static_cast<double>(energies.potential)}};
}

/// The longest arc of a tumbling body in a replay. The replay treats the angular velocity on an arc as linear in time.
constexpr double longest_replayed_arc = 1.0 / 60;  // [s]

json arc_json(const scene::Arc& arc) {
  json row = json::array();
  row.push_back(arc.path.start);
  for (const Vector3<double>* vector : {&arc.path.position, &arc.path.velocity, &arc.path.acceleration,
                                        &arc.turning.angular_velocity, &arc.turning.angular_acceleration}) {
    for (int axis = 0; axis < 3; ++axis) {
      row.push_back((*vector)[axis]);
    }
  }
  const bool spins = arc.turning.phase == scene::Phase::resting && !arc.turning.angular_velocity.isZero(0);
  row.push_back(spins ? "spinning" : std::string(name_of(arc.turning.phase)));
  return row;
}

/// Adds a polyhedron's arc in pieces, each with its orientation.
void add_tumbling_arcs(json& arcs, const scene::Arc& arc, const Quaternion<double>& orientation,
                       const Vector3<double>& principal_inertia, double end) {
  const double span = std::max(0.0, end - arc.path.start);
  const auto pieces = static_cast<std::size_t>(std::ceil(span / longest_replayed_arc)) + 1;
  const scene::RotationPath rotation(principal_inertia,
                                     scene::rotation_state(orientation, arc.turning.angular_velocity), span);
  for (std::size_t k = 0; k + 1 < pieces || k == 0; ++k) {
    const double elapsed = span * static_cast<double>(k) / static_cast<double>(pieces - 1 + (pieces == 1 ? 1 : 0));
    const double next = std::min(span, elapsed + longest_replayed_arc);
    const scene::RotationState turned = rotation.at(elapsed).state;
    scene::Arc piece = arc;
    piece.path.start = arc.path.start + elapsed;
    piece.path.position = position_at(arc.path, piece.path.start);
    piece.path.velocity = velocity_at(arc.path, piece.path.start);
    piece.turning.angular_velocity = scene::world_rate(turned);
    if (next > elapsed) {
      piece.turning.angular_acceleration =
          (scene::world_rate(rotation.at(next).state) - piece.turning.angular_velocity) / (next - elapsed);
    }
    json row = arc_json(piece);
    for (int i = 0; i < 4; ++i) {
      row.push_back(turned.orientation[i]);
    }
    arcs.push_back(std::move(row));
  }
}

/// The arcs (motions between two events) of each body, in order.
json replayed_arcs(const SceneRun& run) {
  const scene::Scene& scene = run.scene();
  std::vector<scene::BodyState> present = run.first().bodies;
  json arcs = json::array();
  for (std::size_t body = 0; body < present.size(); ++body) {
    arcs.push_back(json::array());
  }
  const auto add = [&](std::size_t body, double end) {
    const scene::BodyState& state = present[body];
    if (is_sphere(scene, body)) {
      arcs[body].push_back(arc_json(state.arc));
    } else {
      add_tumbling_arcs(arcs[body], state.arc, state.orientation_at_start, state.principal_inertia, end);
    }
  };
  const auto go_on = [&](const scene::Change& change, double time) {
    add(change.body, time);
    present[change.body].arc = change.after;
    present[change.body].orientation_at_start = change.orientation;
  };
  for (const Event& event : *run.replayed()) {
    go_on(event.a, event.time);
    if (event.b) {
      go_on(*event.b, event.time);
    }
  }
  for (std::size_t body = 0; body < present.size(); ++body) {
    add(body, run.replayed_until());
  }
  return arcs;
}

json replayed_bodies(const scene::Scene& scene) {
  json bodies = json::array();
  for (const scene::Sphere& sphere : scene.spheres) {
    bodies.push_back({{"name", sphere.name}, {"kind", "sphere"}, {"radius", sphere.radius}});
  }
  for (const scene::Polyhedron& polyhedron : scene.polyhedra) {
    const auto body = rigid_body(polyhedron);
    const scene::ConvexPolyhedron& core = std::get<scene::RigidBody>(body).shape.core;
    json vertices = json::array();
    for (const Vector3<double>& vertex : core.vertices) {
      vertices.push_back(vector_to_json(vertex));
    }
    bodies.push_back(
        {{"name", polyhedron.name}, {"kind", "polyhedron"}, {"vertices", vertices}, {"faces", core.faces}});
  }
  return bodies;
}

std::string count_text(unsigned long long count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// For each polyhedron, the properties that follow from its shape, and its principal axes in its own frame. The
/// orientations in events.csv are those of the principal axes.
json bodies_json(const SceneRun& run) {
  json bodies = json::array();
  for (const scene::Polyhedron& polyhedron : run.scene().polyhedra) {
    scene::Polyhedron own = polyhedron;
    own.position.setZero();
    own.orientation = {1, 0, 0, 0};
    const auto made = rigid_body(own);
    const auto& body = std::get<scene::RigidBody>(made);
    const Quaternion<double>& q = body.orientation;
    bodies.push_back({{"name", polyhedron.name},
                      {"mass", body.mass},
                      {"centre_of_mass", vector_to_json(body.position)},
                      {"principal_inertia", vector_to_json(body.principal_inertia)},
                      {"principal_axes", {q[0], q[1], q[2], q[3]}}});
  }
  return bodies;
}

json validity_json(const SceneRun& run) {
  if (!run.validity()) {
    return nullptr;
  }
  json invalid = json::array();
  for (const properties::Invalidity& one : run.validity()->invalid) {
    invalid.push_back({{"body", kind_and_number(run.scene(), one.body)},
                       {"other", one.other},
                       {"begin", one.begin},
                       {"end", one.end},
                       {"what", one.what}});
  }
  return {{"invalid", run.validity()->count},
          {"pairs", run.validity()->pairs},
          {"exact_pairs", run.validity()->exact_pairs},
          {"planes", run.validity()->planes},
          {"largest_jump", run.validity()->largest_jump},
          {"unseen", run.validity()->unseen},
          {"checked_until", run.checked_until()},
          {"first", invalid}};
}

json impulses_json(const SceneRun& run) {
  json times_held;
  for (const auto& [name, count] : run.judge().times_held()) {
    times_held[std::string(name)] = count;
  }
  json record = {{"all", run.judge().impulses()},
                 {"judged", run.judge().judged()},
                 {"violated", run.judge().violated()},
                 {"worst_backward_error", number_to_json(run.judge().worst_backward_error())},
                 {"held", times_held}};
  if (const auto& bad = run.judge().first_bad()) {
    record["first_violated"] = {
        {"time", bad->time}, {"invariant", bad->invariant}, {"collision", collision_to_json(bad->collision)}};
  }
  return record;
}

json ledger_json(const SceneRun& run) {
  const properties::Ledger& ledger = run.ledger();
  json causes;
  for (const Cause cause : all_causes) {
    causes[std::string(name_of(cause))] = static_cast<double>(ledger.energy(cause));
  }
  return {{"initial", energies_json(ledger.initial())},
          {"final", energies_json(ledger.present())},
          {"causes", causes},
          {"work_of_gravity", static_cast<double>(ledger.gravity_work())},
          {"scale", static_cast<double>(ledger.scale())},
          {"added", ledger.added()},
          {"relative_rounding", run.ledger().relative_rounding()},
          {"rounding_limit", run.ledger().rounding_limit()},
          {"worst_rounding", number_to_json(run.ledger().worst_rounding())},
          {"rounding_without_signs", static_cast<double>(ledger.rounding_without_signs())},
          {"momentum",
           {{"initial", momentum_json(ledger.initial_momentum())},
            {"gravity", momentum_json(ledger.gravity_impulse())},
            {"planes", momentum_json(ledger.plane_impulse())},
            {"rounding", momentum_json(ledger.momentum_rounding())}}},
          {"angular_momentum_rounding", static_cast<double>(ledger.angular_momentum_rounding())},
          {"angular_momentum_scale", static_cast<double>(ledger.angular_momentum_scale())}};
}

}  // namespace

json scene_record(const SceneRun& run) {
  const scene::Counts& counts = run.simulation().counts();
  json record;
  record["title"] = run.scene().title;
  record["law"] = name_of(run.scene().law);
  record["precision"] = name_of(run.scene().precision);
  record["duration"] = run.scene().duration;
  record["simulated"] = run.simulation().time();
  record["ended_early"] = run.ended_early().empty() ? json(nullptr) : json(run.ended_early());
  record["spheres"] = run.scene().spheres.size();
  record["polyhedra"] = run.scene().polyhedra.size();
  record["planes"] = run.scene().planes.size();
  record["moved_apart"] = {{"bodies", run.scene().moved_apart.bodies}, {"farthest", run.scene().moved_apart.farthest}};
  record["holds"] = run.verdict() == SceneVerdict::holds;
  record["violated"] = run.verdict() == SceneVerdict::violated;
  record["events"] = {{"all", counts.events},
                      {"impacts", counts.impacts},
                      {"plane_impacts", counts.plane_impacts},
                      {"captures", counts.captures},
                      {"phases", counts.phases},
                      {"renewals", counts.renewals},
                      {"slow_contacts", counts.slow},
                      {"most_at_one_instant", counts.at_one_instant}};
  record["order"] = {{"decided_exactly", counts.exact.orders},
                     {"ties", counts.exact.ties},
                     {"contacts_decided_exactly", counts.exact.predictions},
                     {"gaps_decided_exactly", counts.exact.gaps},
                     {"moved_clear", counts.moved_clear},
                     {"gaps_asked_for", counts.advances}};
  if (!run.scene().polyhedra.empty()) {
    record["bodies"] = bodies_json(run);
  }
  record["spins_changed"] = run.spins_changed();
  record["validity"] = validity_json(run);
  record["impulses"] = impulses_json(run);
  record["ledger"] = ledger_json(run);
  record["seconds"] = run.seconds();
  return record;
}

std::string scene_verdict(const SceneRun& run) {
  const auto text = [&]() -> std::string {
    const std::string until = fmt::format("until {:g} s of {:g} s", run.simulation().time(), run.scene().duration);
    switch (run.verdict()) {
      case SceneVerdict::holds:
        return "holds";
      case SceneVerdict::violated:
        return run.ended_early().empty() ? "VIOLATED" : "VIOLATED " + until;
      case SceneVerdict::not_run_to_its_end:
        return "NOT RUN TO ITS END; " + until;
      case SceneVerdict::not_certified:
        break;
    }
    return "NOT CERTIFIED";
  }();
  std::string what;
  const auto add = [&](const std::string& part) { what += (what.empty() ? "" : ", ") + part; };
  if (const auto& validity = run.validity()) {
    const std::string until = validity->is_complete ? "" : fmt::format(" until {:g} s", run.checked_until());
    add(validity->count == 0 ? "nothing overlaps" + until
                             : count_text(validity->count, "invalid state", "invalid states"));
  }
  if (run.judge().judged() > 0) {
    add(run.judge().violated() == 0 ? fmt::format("{} impulses pass", run.judge().judged())
                                    : count_text(run.judge().violated(), "impulse fails", "impulses fail"));
  } else {
    add("no impulse was judged");
  }
  add(run.ledger().is_closed() ? "the ledger closes" : "the ledger does not close");
  if (const double added = run.ledger().added(); added > 0) {
    add(fmt::format("slow contacts added {:.2g} J, {:.2g} of the first energy",
                    static_cast<double>(run.ledger().energy(Cause::slow_contacts)), added) +
        (added > most_added_energy ? fmt::format(" (at most {:g})", most_added_energy) : ""));
  }
  return fmt::format("{}: {}", text, what);
}

std::string shown_title(const scene::Scene& scene) {
  constexpr std::size_t longest = 400;
  return scene.title.empty() ? "scene" : carom::printable_line(scene.title, longest);
}

std::string scene_text(const SceneRun& run) {
  const scene::Counts& counts = run.simulation().counts();
  const properties::Ledger& ledger = run.ledger();
  const std::string polyhedra =
      run.scene().polyhedra.empty() ? "" : count_text(run.scene().polyhedra.size(), "polyhedron", "polyhedra") + ", ";
  std::string text = fmt::format("{}: {}{}, {}, law {} in {}, {:g} s of {:g} s\n", shown_title(run.scene()), polyhedra,
                                 count_text(run.scene().spheres.size(), "sphere", "spheres"),
                                 count_text(run.scene().planes.size(), "plane", "planes"), name_of(run.scene().law),
                                 name_of(run.scene().precision), run.simulation().time(), run.scene().duration);
  if (!run.ended_early().empty()) {
    text += fmt::format("  ended early: {}\n", run.ended_early());
  }
  if (const scene::MovedApart& moved = run.scene().moved_apart; moved.bodies > 0) {
    text += fmt::format("moved     {} by at most {:.2g} m before the start, because of overlaps within rounding\n",
                        count_text(moved.bodies, "body", "bodies"), moved.farthest);
  }
  text +=
      fmt::format("events    {}: {} of bodies, {} with planes, {} captures, {} changes of phase{}\n", counts.events,
                  count_text(counts.impacts, "impact", "impacts"), counts.plane_impacts, counts.captures, counts.phases,
                  counts.renewals > 0 ? fmt::format(", {} renewals of rotations", counts.renewals) : "");
  text += fmt::format("          {} slow contacts; at most {} at one instant; {:.3g} s of wall time\n", counts.slow,
                      counts.at_one_instant, run.seconds());
  if (!run.scene().polyhedra.empty()) {
    text += fmt::format("order     by certified times of contact; {} gaps computed\n", counts.advances);
  } else {
    text += fmt::format(
        "order     certified; {} decided exactly, {} ties; {} contacts and {} gaps decided exactly, {} positions "
        "moved\n",
        counts.exact.orders, counts.exact.ties, counts.exact.predictions, counts.exact.gaps, counts.moved_clear);
  }
  if (const auto& validity = run.validity()) {
    if (run.scene().polyhedra.empty()) {
      text +=
          fmt::format("validity  {} overlaps or gaps in paths; {} pairs of paths near each other, {} of them exactly\n",
                      validity->count, validity->pairs, validity->exact_pairs);
    } else {
      text += fmt::format("validity  {} overlaps, gaps in paths or impacts without contact; {} checks of pairs\n",
                          validity->count, validity->pairs);
      text += fmt::format("          the check may miss an overlap of {:.2g} m\n", validity->unseen);
    }
    if (!validity->is_complete) {
      text += fmt::format("          checked until {:g} s; the stop ended the last check\n", run.checked_until());
    }
    for (const properties::Invalidity& one : validity->invalid) {
      text += fmt::format("          {} and {}, from {} s to {} s: {}\n", kind_and_number(run.scene(), one.body),
                          one.other, one.begin, one.end, one.what);
    }
  } else {
    text += "validity  not checked\n";
  }
  text += fmt::format("impulses  {} of {} judged, {} violated", run.judge().judged(), run.judge().impulses(),
                      run.judge().violated());
  if (run.judge().judged() > 0 && determines_outcome(run.scene().law)) {
    text += fmt::format(", worst backward error {:.3g} ulps", run.judge().worst_backward_error());
  }
  text += '\n';
  if (const auto& bad = run.judge().first_bad()) {
    text += fmt::format("          first at t = {} s: {}\n", bad->time, bad->invariant);
  }
  if (run.is_replay_cut()) {
    text +=
        fmt::format("replay    of the first {} events, up to {:.4g} s\n", run.replayed()->size(), run.replayed_until());
  }
  text += fmt::format("spin      changed of {} of {} bodies\n", run.spins_changed(), run.simulation().size());
  const properties::Energies final = ledger.present();
  text += fmt::format("energy    {:.9g} J at first, {:.9g} J at last\n", static_cast<double>(ledger.initial().total()),
                      static_cast<double>(final.total()));
  for (const Cause cause : all_causes) {
    text += fmt::format("  {:<22}{:>16.9g} J\n", name_of(cause), static_cast<double>(ledger.energy(cause)));
  }
  text +=
      fmt::format("          rounding is {:.2g} of the energy, and at most {:.2g} of the bound of an event or arc\n",
                  ledger.relative_rounding(), ledger.worst_rounding());
  return text + scene_verdict(run) + '\n';
}

json replay_record(const SceneRun& run) {
  CAROM_EXPECTS(run.replayed().has_value());
  const scene::Scene& scene = run.scene();
  json record;
  record["title"] = scene.title;
  record["law"] = name_of(scene.law);
  record["duration"] = run.replayed_until();
  if (run.is_replay_cut()) {
    record["of_duration"] = run.simulation().time();
  }
  record["gravity"] = vector_to_json(scene.gravity);
  record["bodies"] = replayed_bodies(scene);
  record["arcs"] = replayed_arcs(run);
  record["planes"] = json::array();
  for (const scene::Plane& plane : scene.planes) {
    record["planes"].push_back(
        {{"name", plane.name}, {"normal", vector_to_json(plane.normal)}, {"point", vector_to_json(plane.point)}});
  }
  record["room"] = nullptr;
  record["impacts"] = json::array();
  for (const Event& event : *run.replayed()) {
    if (event.has_impulse) {
      const Vector3<double> impulse =
          run.first().bodies[event.a.body].mass * (event.outcome.a.velocity - event.collision.a.velocity);
      const Vector3<double> point = event.a.after.path.position - event.collision.a.position;
      const auto other = event.b ? static_cast<long long>(event.b->body) : -1 - static_cast<long long>(event.plane);
      record["impacts"].push_back(
          {event.time, event.a.body, other, point[0], point[1], point[2], impulse[0], impulse[1], impulse[2]});
    }
  }
  json series{{"t", json::array()},
              {"kinetic", json::array()},
              {"potential", json::array()},
              {"lost", json::array()},
              {"spin", json::array()}};
  for (const Sample& sample : run.samples()) {
    if (sample.time > run.replayed_until()) {
      break;
    }
    series["t"].push_back(sample.time);
    series["kinetic"].push_back(sample.translation + sample.rotation);
    series["potential"].push_back(sample.potential);
    series["lost"].push_back(run.samples().front().total() - sample.total());
    series["spin"].push_back(sample.rotation);
  }
  record["series"] = series;
  return record;
}

std::string events_csv_header(const scene::Scene& scene) {
  std::string header = "event,time,kind,a,b,plane,restitution,slow";
  for (const char* body : {"a", "b"}) {
    header += fmt::format(",{}_phase", body);
    for (const char* vector : {"position", "velocity", "acceleration", "angular_velocity", "angular_acceleration"}) {
      for (const char axis : {'x', 'y', 'z'}) {
        header += fmt::format(",{}_{}_{}", body, vector, axis);
      }
    }
  }
  if (!scene.polyhedra.empty()) {
    for (const char* body : {"a", "b"}) {
      for (const char part : {'w', 'x', 'y', 'z'}) {
        header += fmt::format(",{}_orientation_{}", body, part);
      }
    }
  }
  return header + '\n';
}

std::string events_csv_line(const scene::Scene& scene, std::uint64_t number, const Event& event) {
  const auto body = [](const scene::Arc& arc) {
    std::string text = fmt::format(",{}", name_of(arc.turning.phase));
    for (const Vector3<double>* vector : {&arc.path.position, &arc.path.velocity, &arc.path.acceleration,
                                          &arc.turning.angular_velocity, &arc.turning.angular_acceleration}) {
      text += fmt::format(",{},{},{}", (*vector)[0], (*vector)[1], (*vector)[2]);
    }
    return text;
  };
  std::string line = fmt::format("{},{},{},{},", number, event.time, name_of(event.kind), event.a.body);
  const bool is_of_plane = !event.b && event.kind != scene::EventKind::renewal;
  line += event.b ? fmt::format("{},,", event.b->body) : is_of_plane ? fmt::format(",{},", event.plane) : ",,";
  line += event.has_impulse ? fmt::format("{}", event.collision.restitution) : "";
  line += event.was_slow ? ",1" : ",0";
  line += body(event.a.after);
  line += event.b ? body(event.b->after) : std::string(16, ',');
  if (!scene.polyhedra.empty()) {
    const auto orientation = [](const Quaternion<double>& q) {
      return fmt::format(",{},{},{},{}", q[0], q[1], q[2], q[3]);
    };
    line += orientation(event.a.orientation) + (event.b ? orientation(event.b->orientation) : ",,,,");
  }
  return line + '\n';
}

std::string series_csv(const SceneRun& run) {
  std::string text = "time,translation,rotation,potential,total,momentum_x,momentum_y,momentum_z,mean_spin\n";
  for (const Sample& sample : run.samples()) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{}\n", sample.time, sample.translation, sample.rotation, sample.potential,
                    sample.total(), sample.momentum[0], sample.momentum[1], sample.momentum[2], sample.mean_spin);
  }
  return text;
}

}  // namespace carom::tool
