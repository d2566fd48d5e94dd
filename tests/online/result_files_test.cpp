// Results are the same however JATOS, a browser or a person packed them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "online_people.h"
#include "study/log/log.h"
#include "study/online/intake/import.h"
#include "study/online/intake/result_values.h"
#include "study/online/intake/zip_file.h"
#include "support/text/printable.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string little_endian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

std::uint32_t crc32_of(const std::string& bytes) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int i = 0; i < 8; ++i) sum = sum >> 1 ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

/// RFC 1951, section 3.2.4: blocks of bytes as they are.
std::string deflated(const std::string& bytes) {
  std::string packed;
  for (std::size_t at = 0;; at += 65535) {
    const std::string block = bytes.substr(at, 65535);
    const bool last = at + block.size() == bytes.size();
    packed += static_cast<char>(last ? 1 : 0);
    packed += little_endian(block.size(), 2) + little_endian(~block.size(), 2) + block;
    if (last) return packed;
  }
}

/// An archive as Java's ZipOutputStream writes it for JATOS: deflated, with sizes behind the bytes and in the
/// table.
std::string archive_of(const std::vector<ZippedFile>& files) {
  std::string bytes, table;
  for (const ZippedFile& file : files) {
    const std::string packed = deflated(file.bytes);
    const std::string sizes = little_endian(crc32_of(file.bytes), 4) + little_endian(packed.size(), 4) +
                              little_endian(file.bytes.size(), 4);
    const std::string common = little_endian(0x0808, 2) + little_endian(8, 2) + little_endian(0, 4);
    const std::string names = little_endian(file.name.size(), 2) + little_endian(0, 2);
    table += "PK\x01\x02" + little_endian(20, 2) + little_endian(20, 2) + common + sizes + names +
             little_endian(0, 10) + little_endian(bytes.size(), 4) + file.name;
    bytes += "PK\x03\x04" + little_endian(20, 2) + common + little_endian(0, 12) + names + file.name +
             packed + "PK\x07\x08" + sizes;
  }
  const std::size_t begin = bytes.size();
  return bytes + table + "PK\x05\x06" + little_endian(0, 4) + little_endian(files.size(), 2) +
         little_endian(files.size(), 2) + little_endian(table.size(), 4) + little_endian(begin, 4) +
         little_endian(0, 2);
}

std::string without_line_ends(std::string text) {
  std::erase(text, '\n');
  return text;
}

class ResultFilesTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  Page one = page_elsewhere(set, 1, Origin::jatos), two = page_elsewhere(set, 2, Origin::jatos);
  std::vector<Message> first = one.whole_stream(), second = two.whole_stream();
  int logs = 0;

  fs::path file(const std::string& text, const std::string& name = "results.txt") const {
    write_file_atomically(folder / name, text);
    return folder / name;
  }
  fs::path new_log() { return folder / fmt::format("{}.sqlite", ++logs); }
  ImportReport import(const std::string& text, Foreign foreign = Foreign::ends_the_import,
                      const std::string& name = "results.txt") {
    return import_messages(set, new_log(), {file(text, name)}, foreign);
  }
  static void expect_both_whole(const ImportReport& report) {
    EXPECT_THAT(report.people, SizeIs(2));
    for (const ImportedPerson& person : report.people) {
      EXPECT_TRUE(person.completed);
      EXPECT_EQ(person.stored, 58);
      EXPECT_THAT(person.refused, IsEmpty());
      EXPECT_THAT(person.gaps, IsEmpty());
    }
    EXPECT_THAT(report.cut_files, IsEmpty());
  }
};

TEST_F(ResultFilesTest, WhatLiesBetweenMessagesDoesNotMatter) {
  const std::string a = lines_of(first), b = lines_of(second);
  const std::string mark = "\xEF\xBB\xBF";
  std::string windows, list = "[", pretty = "[\n  ";
  for (const std::string& text : {a, b})
    for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
      const std::string line = text.substr(at, end - at);
      windows += line + "\r\n";
      list += (list.size() > 1 ? "," : "") + line;
      pretty += (pretty.size() > 4 ? ",\n  " : "") + line;
    }
  const std::vector<std::pair<const char*, std::string>> ways = {
      {"lines", a + b},
      {"JATOS issue 285: no line ends within a result", without_line_ends(a) + "\n" + without_line_ends(b)},
      {"JATOS issue 330: no line end behind a result", a.substr(0, a.size() - 1) + b},
      {"no line ends at all", without_line_ends(a + b)},
      {"line ends of Windows", windows},
      {"a byte order mark", mark + a + b},
      {"a byte order mark in the middle", mark + a + mark + b},
      {"an array", list + "]"},
      {"an array on lines", pretty + "\n]\n"},
      {"spaces", "  \n\t" + a + "\n\n   " + b + " \n "}};
  for (const auto& [way, text] : ways) {
    SCOPED_TRACE(way);
    expect_both_whole(import(text));
  }
}

TEST_F(ResultFilesTest, AnArchiveOfJatosIsItsResults) {
  const std::string meta = R"({"apiVersion":"1.0.1","data":[{"studyId":3,"studyResults":[{"id":12}]}]})";
  const std::string archive =
      archive_of({{"study_result_12/comp-result_34/data.txt", lines_of(first)},
                  {"study_result_12/comp-result_34/files/uploaded.txt", "a participant's own file"},
                  {"study_result_13/comp-result_35/data.txt", without_line_ends(lines_of(second))},
                  {"metadata.json", meta}});
  expect_both_whole(import(archive, Foreign::ends_the_import, "results.jrzip"));
  EXPECT_THAT(complaint_of([&] {
                (void)import(archive_of({{"metadata.json", meta}}));
              }),
              HasSubstr("data.txt"));
  const std::string foreign = archive_of({{"study_result_12/comp-result_34/data.txt", "rt,answer\n1,2\n"}});
  EXPECT_THAT(complaint_of([&] { (void)import(foreign); }),
              HasSubstr("results.txt/study_result_12/comp-result_34/data.txt:1"));
}

TEST_F(ResultFilesTest, ADamagedArchiveIsRefusedOrSaysTheSame) {
  const std::string text = "0123456789", archive = archive_of({{"a.txt", text}});
  const auto all = [](const std::string&) { return true; };
  ASSERT_EQ(unzip(archive, "a.zip", all).at(0).bytes, text);
  for (std::size_t length = 0; length < archive.size(); ++length)
    EXPECT_THAT(complaint_of([&] { (void)unzip(archive.substr(0, length), "a.zip", all); }),
                HasSubstr("a.zip: wanted a whole ZIP archive"));
  for (std::size_t at = 0; at < archive.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = archive;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      const std::string said = complaint_of([&] {
        for (const ZippedFile& unpacked : unzip(damaged, "a.zip", all)) EXPECT_EQ(unpacked.bytes, text);
      });
      EXPECT_TRUE(said == "no complaint" || said.find("a.zip: wanted") == 0) << said;
    }
}

TEST_F(ResultFilesTest, WhatIsForeignEndsTheImportOrIsLeftOutByName) {
  const RenderedSet other_set = write_set_of_text(folder / "other", online_study_text("64, 1024"));
  Page stranger = page_elsewhere(other_set, 3);
  std::string damaged = lines_of({first[6]});
  damaged.replace(damaged.find("\"rating\":"), 9, "\"grating\":");
  const std::string a = lines_of(first), b = lines_of(second);
  const std::vector<std::pair<std::string, int>> foreign = {
      {"{\"questionnaire\":{\"q1\":\"yes\"}}\n", 1},
      {"{\"nested\":[{\"format\":\"png\"},\"a } brace\"]}\n", 1},
      {"participant,answer\n1,\"with {braces}\n", 2},
      {"[1,2,3]\n", 1},
      {"{\"trials\":[{\"rt\":1},{\n", 1},
      {lines_of(stranger.whole_stream()), 58},
      {damaged, 1},
      {std::string("\0\xFF\xFE\n", 4), 1}};
  for (const auto& [text, values] : foreign)
    for (const bool at_the_end : {false, true}) {
      SCOPED_TRACE(printable(text, 60));
      const std::string results = at_the_end ? a + b + text + "\n\n" : a + text + b;
      const std::string place = fmt::format("results.txt:{}", at_the_end ? 117 : 59);
      const bool cut = at_the_end && text.starts_with("{\"trials\"");
      if (!cut) {
        const std::string said = complaint_of([&] { (void)import(results); });
        EXPECT_THAT(said, testing::AllOf(HasSubstr(place + ":"), HasSubstr("skip_foreign")));
        EXPECT_FALSE(fs::exists(folder / fmt::format("{}.sqlite", logs)));
      }
      const ImportReport report = import(results, Foreign::left_out);
      EXPECT_EQ(report.cut_files.size(), cut ? 1U : 0U);
      if (cut) continue;
      expect_both_whole(report);
      ASSERT_EQ(report.foreign.size(), 1U);
      EXPECT_THAT(report.foreign[0], HasSubstr(place));
      EXPECT_THAT(report.foreign[0], HasSubstr(values > 1 ? fmt::format("{} values", values) : place));
      EXPECT_THAT(import_text(report, "log"), HasSubstr("left out: "));
    }
  EXPECT_THAT(complaint_of([&] { (void)import("{\"q1\":1}", Foreign::left_out); }),
              HasSubstr("wanted lines of messages"));
  EXPECT_THAT(complaint_of([&] { (void)import("\xFF\xFE{\0", Foreign::left_out); }), HasSubstr("UTF-16"));
}

TEST_F(ResultFilesTest, AMessageThatIsCutTakesNothingElseWithIt) {
  const std::vector<Message> begun(first.begin(), first.begin() + 3);
  const std::string whole = lines_of({begun[0], begun[1]}), last = lines_of({begun[2]}),
                    rest = lines_of(second);
  for (std::size_t length = 1; length < last.size() - 1; ++length) {
    for (const bool goes_on : {false, true}) {
      const std::string text = whole + last.substr(0, length) + (goes_on ? rest : "");
      ResultValues values(text);
      std::map<ResultValue::Kind, int> counts;
      for (ResultValue value; values.next(value);) ++counts[value.kind];
      EXPECT_EQ(counts[ResultValue::Kind::whole], goes_on ? 60 : 2);
      EXPECT_EQ(counts[ResultValue::Kind::cut], goes_on ? 0 : 1);
      EXPECT_EQ(counts[ResultValue::Kind::foreign], goes_on ? 1 : 0);
    }
  }
  const std::string begin = last.substr(0, last.size() / 2);
  const ImportReport report = import(whole + begin);
  EXPECT_THAT(report.cut_files, SizeIs(1));
  EXPECT_EQ(report.people.at(0).stored, 2);
  const ImportReport both = import(whole + begin + rest, Foreign::left_out);
  EXPECT_THAT(both.foreign, SizeIs(1));
  ASSERT_THAT(both.people, SizeIs(2));
  EXPECT_EQ(both.people[0].stored, 2);
  EXPECT_TRUE(both.people[1].completed);
}

/// A study whose option has a line break is refused by `render` today; one that was rendered before has
/// people.
TEST_F(ResultFilesTest, AnAnswerIsReadAsTheStudyHasIt) {
  const std::string option = "line\nbreak and " + std::string(5000, 'x');
  set = write_set_of_text(folder / "odd",
                          online_study_text() +
                              "[[form_field]]\nname = \"odd\"\nlabel = \"Q\"\nkind = \"choice\"\n" +
                              "options = [\"line\\nbreak and " + std::string(5000, 'x') + "\", \"b\"]\n");
  Page page = page_elsewhere(set, 1);
  const fs::path log = new_log();
  const ImportReport report = import_messages(set, log, {file(lines_of(page.whole_stream()))});
  EXPECT_TRUE(report.people.at(0).completed);
  EXPECT_THAT(report.people.at(0).refused, IsEmpty());
  EXPECT_EQ(read_log(log).participants.at(0).form.at(0).value, option);
  Page other = page_elsewhere(set, 2);
  Message form = other.say(FormBody{{{"odd", "line\nbreak"}}});
  form.sequence = 1;
  Message enrolment = page_elsewhere(set, 2).enrol();
  EXPECT_THAT(import_messages(set, log, {file(lines_of({enrolment, form}))}).people.at(0).refused, SizeIs(1));
}

}  // namespace
}  // namespace seamline::study::online
