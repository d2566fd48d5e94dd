// Texts of a study file that pages, messages, logs or tables could not carry are refused before anything is
// rendered.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/stimuli/study_of_no_files.h"

namespace seamline {
namespace {

using testing::HasSubstr;

class CarriedTexts : public testing::Test {
 protected:
  /// What rendering says of a study with these tables.
  std::string complaint_of_study(const std::string& tables, const std::string& top = "") const {
    write_file_atomically(folder / "none.glb", "there");
    write_file_atomically(folder / "study.toml", test::study_of_no_files(top, tables));
    return test::complaint_of([&] { (void)read_study(folder / "study.toml"); });
  }
  TemporaryFolder folder;
};

constexpr const char* question = "[[form_field]]\nname = \"vision\"\nkind = \"choice\"\n";

/// A field, and the tables in which its text stands; {} is the text's place.
struct TextField {
  const char* field;
  const char* tables;
  bool may_have_lines = false;
};

const TextField text_fields[] = {
    {"form_field[0].options",
     "[[form_field]]\nname = \"v\"\nkind = \"choice\"\nlabel = \"Q\"\noptions = [\"one\", \"{}\"]"},
    {"form_field[0].label", "[[form_field]]\nname = \"v\"\nkind = \"number\"\nlabel = \"{}\"", true},
    {"consent.text", "[consent]\ntext = \"{}\"", true},
    {"consent.accept", "[consent]\naccept = \"{}\""},
    {"consent.decline", "[consent]\ndecline = \"{}\""},
    {"instructions.page[0].text", "[[instructions.page]]\ntext = \"{}\"", true},
    {"session.question", "[session]\nquestion = \"{}\"", true},
    {"session.rating_labels", "[session]\nrating_labels = [\"a\", \"b\", \"{}\", \"d\"]"},
    {"training.feedback_right", "[training]\nfeedback_right = \"{}\"", true},
    {"texts.thanks_text", "[texts]\nthanks_text = \"{}\"", true},
};

TEST_F(CarriedTexts, EveryTextIsRefusedWithWhatNothingCarriesAndReadWithEverythingElse) {
  for (const TextField& known : text_fields) {
    SCOPED_TRACE(known.field);
    const auto said_of = [&](const std::string& text) {
      return complaint_of_study(fmt::format(fmt::runtime(known.tables), text));
    };
    for (const char* good :
         {"plain", "Größe, 大きさ, حجم", "a \\\"quoted\\\" \\\\ word", "marks \\u200E \\u200F", "👁"})
      EXPECT_EQ(said_of(good), "no complaint") << good;
    // NUL, a control of ASCII and of Latin 1, DEL, separators, overrides and isolates of direction, a mark of
    // order.
    for (const char* bad : {"a\\u0000b", "a\\u001Bb", "a\\u0085b", "a\\u007Fb", "a\\u2028b", "a\\u2029b",
                            "a\\u202Eb", "a\\u2066b", "\\uFEFFa"}) {
      EXPECT_THAT(said_of(bad), HasSubstr(std::string("study.toml: ") + known.field + ": wanted a text"))
          << bad;
      EXPECT_THAT(said_of(bad), HasSubstr("without control characters")) << bad;
    }
    for (const char* lines : {"a\\nb", "a\\r\\nb", "a\\tb"})
      EXPECT_EQ(said_of(lines) == "no complaint", known.may_have_lines) << lines;
  }
}

TEST_F(CarriedTexts, AnswersOfAFormFitIntoOneMessage) {
  const std::string label = "label = \"Q\"\n";
  const auto options = [](std::size_t letters) {
    return fmt::format("options = [\"{}\", \"b\"]\n", std::string(letters, 'a'));
  };
  EXPECT_EQ(complaint_of_study(question + label + options(50'000)), "no complaint");
  EXPECT_THAT(complaint_of_study(question + label + options(60'000)), HasSubstr("at most 60000 bytes"));
  std::string many;
  for (int i = 0; i < 200; ++i)
    many += fmt::format("[[form_field]]\nname = \"f{}\"\nlabel = \"Q\"\nkind = \"number\"\n", i);
  EXPECT_EQ(complaint_of_study(many), "no complaint");
  EXPECT_THAT(complaint_of_study(many + question + label + options(1)), HasSubstr("at most 200 questions"));
}

TEST_F(CarriedTexts, NamesFitIntoFileNames) {
  const std::string name(61, 'a');
  EXPECT_THAT(complaint_of_study("", ""), "no complaint");
  EXPECT_THAT(complaint_of_study("[[form_field]]\nkind = \"number\"\nlabel = \"Q\"\nname = \"" + name + "\""),
              HasSubstr("form_field[0].name: wanted at most 60 letters, found 61"));
}

/// A set or a log of before is read as it is: its people have answered.
TEST_F(CarriedTexts, AStudyThatWasRenderedIsReadAsItIs) {
  const std::string text = test::study_of_no_files(
      "", std::string(question) + "label = \"Q\"\noptions = [\"one\", \"line\\nbreak\"]\n");
  EXPECT_EQ(std::get<ChoiceField>(read_study_text(text, "study.toml").form[0].kind).options[1],
            "line\nbreak");
}

}  // namespace
}  // namespace seamline
