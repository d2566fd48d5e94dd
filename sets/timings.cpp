#include "sets/timings.h"

#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"
#include "support/running/machine.h"

namespace seamline::renderer {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void Timings::write(double total_seconds) const {
  Json json = std::filesystem::exists(path_) ? Json::parse(read_file(path_), nullptr, false) : Json();
  if (!json.is_object() || (json.contains("pieces") && !json["pieces"].is_object())) json = Json::object();
  json["threads"] = threads_;
  json["machine"] = processor_name();
  if (!pieces_.empty()) json["seconds"] = total_seconds;
  for (const Piece& piece : pieces_) {
    Json& line = json["pieces"][piece.name] = {{"seconds", piece.seconds}, {"rays", piece.rays}};
    if (piece.notes.worst_tile) line["worst_tile"] = *piece.notes.worst_tile;
    if (piece.notes.rare_light) line["rare_light"] = *piece.notes.rare_light;
    if (!piece.notes.changes.empty()) line["changes"] = piece.notes.changes;
  }
  write_file_atomically(path_, json.dump(1) + "\n");
}

}  // namespace seamline::renderer
