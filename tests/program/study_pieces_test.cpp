// The pieces of study files that pages show are read: put into a whole study as a reader would put them, each
// alone, or with the pieces that stand before it on its page.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "pages.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"

namespace seamline {
namespace {

/// A table of a study file: its header with brackets (none: what stands before the first), and its lines.
struct StudyTable {
  std::string header;
  std::vector<std::string> lines;
};

std::string key_of(const std::string& line) {
  return line.substr(0, line.find_first_of(" ="));
}

std::vector<StudyTable> tables_of_study(const std::string& text) {
  std::vector<StudyTable> tables = {{}};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("["))
      tables.push_back({.header = line.substr(0, line.find_last_of(']') + 1), .lines = {}});
    else if (!line.empty() && !line.starts_with("#"))
      tables.back().lines.push_back(line);
  }
  return tables;
}

std::string text_of_study(const std::vector<StudyTable>& tables) {
  std::string text;
  for (const StudyTable& table : tables) {
    text += table.header + "\n";
    for (const std::string& line : table.lines) text += line + "\n";
  }
  return text;
}

void drop_line(StudyTable& table, const std::string& key) {
  std::erase_if(table.lines, [&](const std::string& line) { return key_of(line) == key; });
}

/// The table that a piece's table changes: the one of that name, of objects the one of its name or else the
/// first.
StudyTable* changed_table(std::vector<StudyTable>& study, const StudyTable& piece) {
  const bool is_list = piece.header.starts_with("[[") && !piece.header.starts_with("[[scene");
  StudyTable* first = nullptr;
  for (StudyTable& table : study) {
    if (table.header != piece.header || is_list) continue;
    if (first == nullptr) first = &table;
    for (const std::string& line : table.lines)
      if (key_of(line) == "name" &&
          std::find(piece.lines.begin(), piece.lines.end(), line) != piece.lines.end())
        return &table;
  }
  return first;
}

void put_table(std::vector<StudyTable>& study, const StudyTable& piece) {
  if (StudyTable* table = changed_table(study, piece)) {
    for (const std::string& line : piece.lines) {
      drop_line(*table, key_of(line));
      table->lines.push_back(line);
    }
    return;
  }
  auto place = study.end();
  if (piece.header.starts_with("[scene."))
    place = std::find_if(study.begin(), study.end(),
                         [](const StudyTable& table) { return table.header == "[[scene.object]]"; });
  study.insert(place, piece);
}

/// As many objects as the piece says; the paper's widths and a form; for depth that is no panorama another
/// level; for people of a panel attention trials.
std::vector<StudyTable> study_for(const std::string& piece) {
  const bool has_source = piece.find("\nsource = ") != std::string::npos;
  const bool has_level = piece.find("[level]") != std::string::npos;
  std::string text = "format = \"seamline study 1\"\nname = \"pieces\"\nwidth_px = 96\nheight_px = 54\n";
  if (!has_source && !has_level) text += "depth_width_px = [64, 128, 256, 512, 1024, 2048, 4096]\n";
  if (has_source && !has_level) text += "[level]\nquantity = \"sun_radius_deg\"\nvalues = [0.5, 1, 2]\n";
  if (piece.find("[recruitment]") != std::string::npos) text += "[catch]\nattention = 3\n";
  text +=
      "[[form_field]]\nname = \"age\"\nlabel = \"Age\"\nkind = \"number\"\nleast = 18\nmost = 99\n"
      "[[form_field]]\nname = \"gender\"\nlabel = \"Gender\"\nkind = \"choice\"\noptions = [\"female\", "
      "\"male\", \"other\"]\n"
      "[[scene]]\nname = \"room\"\nfile = \"builtin:gazebo\"\n"
      "artifacts = [\"receiver\", \"shadow\", \"occlusion\", \"overlap\"]\n";
  constexpr std::array<const char*, 8> names = {"statue", "beast",  "teapot", "second",
                                                "third",  "fourth", "fifth",  "sixth"};
  const std::size_t stated = piece.find("\nobjects = ");
  const std::size_t objects = stated == std::string::npos ? 3 : std::stoul(piece.substr(stated + 11));
  for (std::size_t i = 0; i < objects; ++i)
    text += std::string("[[scene.object]]\nname = \"") + names.at(i) +
            "\"\nfile = \"builtin:" + names.at(i < 3 ? i : 0) + "\"\n";
  return tables_of_study(text);
}

/// What the reader says to the pieces in a study; empty where it takes them.
std::string refusal_of_study(std::vector<StudyTable> study, const std::string& pieces) {
  for (const StudyTable& table : tables_of_study(pieces)) put_table(study, table);
  try {
    (void)read_study_text(text_of_study(study), "page");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Documentation, EveryPieceOfAStudyFileIsRead) {
  int pieces_read = 0;
  for (const auto& [name, page] : test::pages()) {
    std::string before;
    for (const test::PageBlock& block : page.blocks) {
      const bool is_of_study = block.text.find("format = \"seamline ") == std::string::npos &&
                               !block.text.starts_with("[[object]]") &&
                               !block.text.starts_with("[virtual_light]");
      const std::string of_file = block.kind.starts_with("toml stimuli/") ? block.kind.substr(5) : "";
      if ((block.kind != "toml" && of_file.empty()) || !is_of_study) continue;
      const std::filesystem::path file = std::filesystem::path(SEAMLINE_SOURCE_DIR) / of_file;
      const auto study_of = [&](const std::string& text) {
        return of_file.empty() ? study_for(text) : tables_of_study(test::read_text(file));
      };
      std::string refusal = refusal_of_study(study_of(block.text), block.text);
      const std::string together = before + block.text;
      if (!refusal.empty() && refusal_of_study(study_of(together), together).empty()) refusal = "";
      EXPECT_EQ(refusal, "") << name << ":\n" << block.text;
      before = together;
      ++pieces_read;
    }
  }
  EXPECT_GE(pieces_read, 20);
}

}  // namespace
}  // namespace seamline
