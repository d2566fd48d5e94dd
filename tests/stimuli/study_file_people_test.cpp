// What a study file says about participants: consent, form, instructions, training, catch trials, texts.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "stimuli/settings/people/form_settings.h"
#include "stimuli/study_file/carried_files.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/complaint.h"
#include "tests/stimuli/study_of_no_files.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

StudyDefinition read_people(const std::string& tables, const std::string& top = "") {
  return read_study_text(test::study_of_no_files(top, tables), "study.toml");
}

std::string complaint_of_people(const std::string& tables, const std::string& top = "") {
  return test::complaint_of([&] { (void)read_people(tables, top); });
}

TEST(StudyFilePeople, WithoutAWordThereAreTheShippedTexts) {
  const StudyDefinition study = read_people("");
  EXPECT_TRUE(is_default_consent(study.consent));
  ASSERT_EQ(study.form.size(), 4U);
  EXPECT_EQ(study.form[0].name, "age");
  EXPECT_EQ(study.form[3].name, "technical_background");
  EXPECT_EQ(study.instructions, default_instructions());
  EXPECT_EQ(study.training.trials, 3);
  EXPECT_EQ(study.catches, CatchDefinition{});
  EXPECT_EQ(study.session.resume, ResumePolicy::resume);
  EXPECT_TRUE(study.texts.empty());
}

TEST(StudyFilePeople, ReadsConsent) {
  const ConsentDefinition consent =
      read_people("[consent]\ntext = \"Nur zu.\"\naccept = \"Ja\"\ndecline = \"Nein\"").consent;
  EXPECT_EQ(consent, (ConsentDefinition{"Nur zu.", "Ja", "Nein"}));
  EXPECT_FALSE(is_default_consent(consent));
  EXPECT_THAT(complaint_of_people("[consent]\ntexst = \"x\""), HasSubstr("did you mean \"text\""));
  EXPECT_THAT(complaint_of_people("[consent]\ntext = \"\""), HasSubstr("consent.text"));
}

/// The shipped text is known again when somebody copied it into their file with other line ends; any edit of
/// its words makes it theirs.
TEST(StudyFilePeople, KnowsTheShippedConsentByItsWords) {
  ConsentDefinition consent = default_consent();
  consent.accept = "OK";
  std::string spread;
  for (const char letter : consent.text) spread += letter == ' ' ? "\n  " : std::string(1, letter);
  consent.text = "  " + spread + "\n";
  EXPECT_TRUE(is_default_consent(consent));
  consent.text += "Dr. Example";
  EXPECT_FALSE(is_default_consent(consent));
}

TEST(StudyFilePeople, ReadsFormFields) {
  const std::vector<FormField> form = read_people(R"(
[[form_field]]
name = "shoe_size"
label = "Größe der Schuhe"
kind = "number"
least = 20
most = 60.5
whole = false
required = false
[[form_field]]
name = "hand"
label = "Hand"
kind = "choice"
options = ["left", "right"]
)")
                                          .form;
  ASSERT_EQ(form.size(), 2U);
  EXPECT_EQ(form[0].label, "Größe der Schuhe");
  EXPECT_FALSE(form[0].required);
  const auto& number = std::get<NumberField>(form[0].kind);
  EXPECT_TRUE(number.least == 20 && number.most == 60.5 && !number.whole);
  EXPECT_THAT(std::get<ChoiceField>(form[1].kind).options, ElementsAre("left", "right"));
  EXPECT_TRUE(form[1].required);
  EXPECT_TRUE(read_people("", "participant_form = false").form.empty());
}

TEST(StudyFilePeople, RefusesFormFieldsThatCannotBe) {
  const auto field = [](const std::string& rest) {
    return complaint_of_people("[[form_field]]\nname = \"x\"\nlabel = \"X\"\n" + rest);
  };
  EXPECT_THAT(field(""), HasSubstr("form_field[0].kind"));
  EXPECT_THAT(field("kind = \"text\""), HasSubstr("\"number\" or \"choice\""));
  EXPECT_THAT(field("kind = \"choice\"\noptions = [\"a\"]"), HasSubstr("at least two"));
  EXPECT_THAT(field("kind = \"choice\"\noptions = [\"a\", \"a\"]"), HasSubstr("at least two"));
  EXPECT_THAT(field("kind = \"number\"\nleast = 3\nmost = 2"), HasSubstr("at least 3"));
  EXPECT_THAT(field("kind = \"number\"\noptions = [\"a\", \"b\"]"), HasSubstr("options"));
  EXPECT_THAT(field("kind = \"number\"\n[[form_field]]\nname = \"x\"\nlabel = \"Y\"\nkind = \"number\""),
              HasSubstr("no other field"));
  EXPECT_THAT(complaint_of_people("[[form_field]]\nname = \"My Name\"\nlabel = \"X\"\nkind = \"number\""),
              HasSubstr("lower-case"));
  EXPECT_THAT(complaint_of_people("[[form_field]]\nname = \"x\"\nlabel = \"X\"\nkind = \"number\"",
                                  "participant_form = false"),
              HasSubstr("participant_form"));
}

TEST(StudyFilePeople, JudgesFormAnswers) {
  const FormField age{.name = "age", .label = "", .kind = NumberField{18, 120, true}, .required = true};
  for (const char* good : {"18", "120", "33", "4e1"}) EXPECT_EQ(fault_of(age, good), std::nullopt) << good;
  for (const char* odd : {"old", "33 ", " 33", "33.5", "nan", "inf", "0x20", "33years", "+33"})
    EXPECT_EQ(fault_of(age, odd), FormFault::not_a_number) << odd;
  for (const char* far : {"17", "121", "-30", "1e9"})
    EXPECT_EQ(fault_of(age, far), FormFault::out_of_range) << far;
  EXPECT_EQ(fault_of(age, ""), FormFault::missing);
  FormField hand{.name = "hand", .label = "", .kind = ChoiceField{{"left", "right"}}, .required = false};
  EXPECT_EQ(fault_of(hand, "left"), std::nullopt);
  EXPECT_EQ(fault_of(hand, ""), std::nullopt);
  EXPECT_EQ(fault_of(hand, "Left"), FormFault::not_an_option);
}

/// What a kind of question costs: the files that CONTRIBUTING.md names. All others ask what it stores
/// (`number_of`, `options_of`).
TEST(StudyFilePeople, AKindOfQuestionIsNamedWhereItIsDescribedAndDrawn) {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  std::set<std::string> naming, contributing;
  for (const char* folder : {"stimuli", "study", "analysis", "sets", "laboratory", "commands", "python"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && read_file(entry.path()).find("hoiceField") != std::string::npos)
        naming.insert(fs::relative(entry.path(), root).generic_string());
  naming.erase("stimuli/definition/form_definition.cpp");  // the usual form has choices
  const std::string page = read_file(root / "CONTRIBUTING.md");
  const std::size_t row = page.find("| a kind of question in the form |");
  const std::string line = page.substr(row, page.find('\n', row) - row);
  const std::regex file("`([^`]+)`");
  for (std::sregex_iterator it(line.begin(), line.end(), file), end; it != end; ++it)
    contributing.insert((*it)[1]);
  EXPECT_EQ(naming, contributing);
  const std::string drawn = read_file(root / "study/online/page/web/screens/form.js");
  for (const std::string_view word : words_of<decltype(FormField::kind)>)
    EXPECT_THAT(drawn, HasSubstr(fmt::format("{}: {}Field", word, word)));
}

TEST(StudyFilePeople, ReadsInstructionsAndTraining) {
  const StudyDefinition study = read_people(R"(
[[instructions.page]]
text = "Look."
pictures = ["a.png", "deep/b.jpg"]
[[instructions.page]]
pictures = ["page2.png"]
[training]
stimuli = ["room-receiver-a-0064"]
feedback_right = "Ja: {object}"
)");
  ASSERT_EQ(study.instructions.size(), 2U);
  EXPECT_EQ(study.instructions[0].text, "Look.");
  EXPECT_TRUE(study.instructions[1].text.empty());
  EXPECT_EQ(study.training.trials, 1);
  EXPECT_EQ(study.training.feedback_right, "Ja: {object}");
  EXPECT_EQ(carried_files(study), (std::vector<std::string>{"a.png", "deep/b.jpg", "page2.png"}));
  EXPECT_THAT(complaint_of_people("[instructions]\n"), HasSubstr("at least one"));
  EXPECT_THAT(complaint_of_people("[[instructions.page]]\n"), HasSubstr("neither"));
  EXPECT_THAT(complaint_of_people("[[instructions.page]]\npicture = \"a.png\""), HasSubstr("pictures"));
  EXPECT_THAT(complaint_of_people("[training]\ntrials = 2\nstimuli = [\"x\"]"), HasSubstr("both"));
  EXPECT_THAT(complaint_of_people("[training]\ntrials = -1"), HasSubstr("training.trials"));
}

/// A set carries the files, so they must not lie elsewhere; and where the study is rendered they must be
/// there.
TEST(StudyFilePeople, FilesOfASessionLieBesideTheStudy) {
  for (const char* file : {"/etc/a.png", "../a.png", "deep/../../a.png"})
    EXPECT_THAT(complaint_of_people(fmt::format("[[instructions.page]]\npictures = [\"{}\"]", file)),
                HasSubstr("beside the study file"));
  EXPECT_THAT(complaint_of_people("[session]\nfont = \"/usr/a.ttf\""), HasSubstr("session.font"));
  const TemporaryFolder folder;
  write_file_atomically(folder / "none.glb", "x");
  write_file_atomically(folder / "study.toml",
                        test::study_of_no_files("",
                                                "[session]\nfont = \"a.ttf\"\n[[instructions.page]]\n"
                                                "pictures = [\"deep/b.png\"]\n"));
  EXPECT_THROW((void)read_study(folder / "study.toml"), InputError);
  EXPECT_NO_THROW((void)read_study(folder / "study.toml", AssetCheck::not_needed));
  write_file_atomically(folder / "a.ttf", "letters");
  EXPECT_THROW((void)read_study(folder / "study.toml"), InputError);
  std::filesystem::create_directories(folder / "deep");
  write_file_atomically(folder / "deep/b.png", "picture");
  const StudyDefinition study = read_study(folder / "study.toml");
  EXPECT_EQ(study.session.font, "a.ttf");
  copy_carried_files(study, folder / "set");
  EXPECT_EQ(read_file(folder / "set/a.ttf"), "letters");
  EXPECT_EQ(read_file(folder / "set/deep/b.png"), "picture");
}

TEST(StudyFilePeople, ReadsCatchTrialsAndPace) {
  const StudyDefinition study = read_people(
      "[catch]\nattention = 4\nreference = 6\n[session]\nminimum_viewing_s = 0.5\ninter_trial_s = 1\n"
      "resume = \"refuse\"\norders = 12\ntext_scale = 1.5\n");
  EXPECT_EQ(study.catches, (CatchDefinition{4, 6}));
  EXPECT_EQ(study.session.minimum_viewing_s, 0.5);
  EXPECT_EQ(study.session.inter_trial_s, 1);
  EXPECT_EQ(study.session.resume, ResumePolicy::refuse);
  EXPECT_EQ(study.session.orders, 12);
  EXPECT_EQ(study.session.text_scale, 1.5);
  EXPECT_THAT(complaint_of_people("[catch]\nattention = -1"), HasSubstr("catch.attention"));
  EXPECT_THAT(complaint_of_people("[catch]\natention = 1"), HasSubstr("did you mean \"attention\""));
  EXPECT_THAT(complaint_of_people("[session]\nresume = \"maybe\""),
              HasSubstr("\"resume\" or \"restart\" or \"refuse\""));
  EXPECT_THAT(complaint_of_people("[session]\ntext_scale = 9"), HasSubstr("text_scale"));
}

TEST(StudyFilePeople, EveryPhraseStandsOnceInTheTableInOrder) {
  std::set<std::string_view> keys;
  for (std::size_t i = 0; i < every_phrase().size(); ++i) {
    const PhraseEntry& entry = every_phrase()[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.phrase), i) << entry.key;
    EXPECT_TRUE(keys.insert(entry.key).second) << entry.key;
    EXPECT_FALSE(entry.english.empty()) << entry.key;
  }
  EXPECT_EQ(every_phrase().back().phrase, Phrase::online_host) << "a phrase is missing at the end";
}

TEST(StudyFilePeople, EveryPhraseCanBeTranslated) {
  std::string table = "[texts]\n";
  for (const PhraseEntry& entry : every_phrase())
    table += fmt::format("{} = \"ü {}\"\n", entry.key, entry.key);
  const InterfaceTexts texts = read_people(table).texts;
  for (const PhraseEntry& entry : every_phrase()) {
    EXPECT_EQ(phrase_text(texts, entry.phrase), fmt::format("ü {}", entry.key));
    EXPECT_EQ(phrase_text({}, entry.phrase), entry.english);
  }
  EXPECT_THAT(complaint_of_people("[texts]\nbrake_title = \"x\""), HasSubstr("did you mean \"break_title\""));
  EXPECT_THAT(complaint_of_people("[texts]\nprogress = \"{erledigt} von {all}\""), HasSubstr("{erledigt}"));
  EXPECT_EQ(phrase_text(read_people("[texts]\nprogress = \"{all}\"").texts, Phrase::progress), "{all}");
}

TEST(StudyFilePeople, FillsPlacesIn) {
  EXPECT_EQ(fill_in("{done} of {all}, {done}", {{"done", "3"}, {"all", "{done}"}}), "3 of {done}, 3");
  EXPECT_EQ(fill_in("{other} {", {{"done", "3"}}), "{other} {");
}

/// Texts can be edited in a rendered set; what decides what people are shown cannot.
TEST(StudyFilePeople, OnlyWhatPeopleAreShownIsInTheHash) {
  const std::string usual = study_hash(read_people(""));
  for (const char* text :
       {"[consent]\ntext = \"mine\"", "[[form_field]]\nname = \"x\"\nlabel = \"X\"\nkind = \"number\"",
        "[[instructions.page]]\ntext = \"x\"", "[training]\nfeedback_wrong = \"No\"", "[texts]\nback = \"x\"",
        "[session]\nresume = \"restart\"", "[session]\ntext_scale = 2", "[catch]\nattention = 0",
        "[training]\ntrials = 3", "[session]\norders = 0"})
    EXPECT_EQ(study_hash(read_people(text)), usual) << text;
  std::set<std::string> hashes = {usual};
  for (const char* shown : {"[catch]\nattention = 1", "[catch]\nreference = 1", "[training]\ntrials = 4",
                            "[training]\nstimuli = [\"a\", \"b\", \"c\"]", "[session]\norders = 2",
                            "[session]\nminimum_viewing_s = 1", "[session]\ninter_trial_s = 0"})
    EXPECT_TRUE(hashes.insert(study_hash(read_people(shown))).second) << shown;
}

/// Sets that were rendered before all this could be said are still good. (quick.toml got other widths since.)
TEST(StudyFilePeople, ShippedStudiesKeepTheirHash) {
  const auto hash = [](const char* name) {
    return study_hash(
        read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / name, AssetCheck::not_needed));
  };
  EXPECT_EQ(hash("quick.toml"), "f5c491d8f27a66c48fc65b07769da733bf4a114c4c09bcc4e8fb253be8448a28");
  EXPECT_EQ(hash("depth_resolution.toml"),
            "2ceb090d27fe77b341a1f84027240fa6c417311802dddbd929e18eae2a77aba6");
}

}  // namespace
}  // namespace seamline
