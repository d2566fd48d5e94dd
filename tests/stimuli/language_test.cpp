// Several languages over one study: what is read, what is missing, what is refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/people/language_definition.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/study/temporary_set.h"

namespace seamline {
namespace {

using test::complaint_of;

class Languages : public testing::Test {
 protected:
  TemporaryFolder folder;
  StudyDefinition study_of(const std::string& more) const {
    write_file_atomically(folder / "study.toml", study::study_text("talk", "64, 512") + more);
    return read_study(folder / "study.toml", AssetCheck::not_needed);
  }
  StudyTexts texts_of(const std::string& text, const std::string& more = {}) const {
    write_file_atomically(folder / "own.toml", text);
    const StudyDefinition study = study_of(more + "[[language]]\ntag = \"de\"\ntexts = \"own.toml\"\n");
    return read_study_texts(study, study.languages->languages.at(0));
  }
};

constexpr const char* head = "format = \"seamline texts 1\"\nlanguage = \"de\"\n";

TEST_F(Languages, AreNoPartOfTheHash) {
  const StudyDefinition one = study_of(""),
                        two = study_of("[[language]]\ntag = \"de\"\ntexts = \"builtin:de\"\n");
  EXPECT_EQ(one.languages, nullptr);
  ASSERT_NE(two.languages, nullptr);
  EXPECT_EQ(study_hash(one), study_hash(two));
}

TEST_F(Languages, EveryBuiltinTranslatesAllThatSeamlineSays) {
  for (const std::string tag : {"de", "fr", "es", "zh", "ja", "ar"}) {
    const StudyDefinition study = study_of("[recruitment]\nmost_people = 5\n[[language]]\ntag = \"" + tag +
                                           "\"\ntexts = \"builtin:" + tag + "\"\n");
    const StudyTexts texts = read_study_texts(study, study.languages->languages.at(0));
    EXPECT_TRUE(texts.is_draft) << tag;
    EXPECT_EQ(missing_texts(study, texts), std::vector<std::string>{}) << tag;
    const StudyDefinition read = in_language(study, texts);
    EXPECT_EQ(read.session.language, tag);
    EXPECT_NE(read.session.question, study.session.question);
    EXPECT_NE(page_texts_of(read).at("recruitment_code"), page_texts_of(study).at("recruitment_code"));
  }
}

TEST_F(Languages, EveryBuiltinTranslatesTheTasks) {
  const std::string references = "[catch]\nreference = 9\n";
  for (const std::string& task :
       {references + "[task]\nkind = \"pair\"\n", references + "[task]\nkind = \"pair\"\nasks = \"same\"\n",
        references + "[task]\nkind = \"interval\"\n", references + "[task]\nkind = \"yes_no\"\n",
        references + "[task]\nkind = \"rating\"\n",
        references + "[task]\nkind = \"rating\"\nscale = \"slider\"\n"})
    for (const std::string tag : {"de", "fr", "es", "zh", "ja", "ar"}) {
      const StudyDefinition study =
          study_of(task + "[[language]]\ntag = \"" + tag + "\"\ntexts = \"builtin:" + tag + "\"\n");
      const StudyTexts texts = read_study_texts(study, study.languages->languages.at(0));
      EXPECT_EQ(missing_texts(study, texts), std::vector<std::string>{}) << tag << " " << task;
      const StudyDefinition read = in_language(study, texts);
      EXPECT_NE(read.session.question, study.session.question) << tag << " " << task;
      EXPECT_NE(read.instructions.at(0).text, study.instructions.at(0).text) << tag << " " << task;
      EXPECT_EQ(read.task->answers.size(), study.task->answers.size());
      EXPECT_TRUE(read.task->answers.empty() || read.task->answers != study.task->answers)
          << tag << " " << task;
      EXPECT_TRUE(read.task->labels.empty() || read.task->labels != study.task->labels) << tag << " " << task;
      EXPECT_EQ(study_hash(study), study_hash(study_of(task)));
    }
}

TEST_F(Languages, AnswersOfATaskAreTranslatedOneByOne) {
  const std::string task = "[task]\nkind = \"pair\"\n";
  EXPECT_EQ(texts_of(head + std::string("[task]\nanswers = [\"links\", \"rechts\"]\n"), task).answers,
            (std::vector<std::string>{"links", "rechts"}));
  EXPECT_NE(complaint_of([&] {
              (void)texts_of(head + std::string("[task]\nanswers = [\"links\"]\n"), task);
            }).find("2 texts that differ"),
            std::string::npos);
  EXPECT_NE(complaint_of([&] {
              (void)texts_of(head + std::string("[task]\nanswers = [\"a\", \"b\"]\n"));
            }).find("[task]"),
            std::string::npos);
  const StudyDefinition study = study_of(task + "[[language]]\ntag = \"de\"\ntexts = \"builtin:de\"\n");
  EXPECT_NE(texts_to_translate(study, read_study_texts(study, study.languages->languages.at(0)))
                .find("answers = [\"Links\", \"Rechts\"]"),
            std::string::npos);
}

TEST_F(Languages, ABuiltinDoesNotCountWhereTheStudySpeaksForItself) {
  const StudyDefinition study = study_of(
      "[consent]\ntext = \"Ours.\"\n[texts]\nthanks_text = \"Bye.\"\n"
      "[[language]]\ntag = \"de\"\ntexts = \"builtin:de\"\n");
  const std::vector<std::string> missing =
      missing_texts(study, read_study_texts(study, study.languages->languages.at(0)));
  EXPECT_EQ(missing, (std::vector<std::string>{"consent.text", "texts.thanks_text"}));
}

TEST_F(Languages, WhatIsPrintedToBeTranslatedIsReadAsItIs) {
  const StudyDefinition study =
      study_of("[consent]\ntext = \"Our \\\"own\\\" text.\\n\\nTwo paragraphs.\"\n");
  const StudyTexts read = texts_of(texts_to_translate(study, {.tag = "de", .consent = {}}),
                                   "[consent]\ntext = \"Our \\\"own\\\" text.\\n\\nTwo paragraphs.\"\n");
  EXPECT_EQ(read.consent, study.consent.text);
  std::vector<std::string> missing = missing_texts(study, read);
  EXPECT_EQ(missing, std::vector<std::string>{});
  EXPECT_EQ(study_hash(in_language(study, read)), study_hash(study));  // the same words
}

TEST_F(Languages, AnswersToATranslatedFormAreTheStudysOwn) {
  const StudyDefinition study = study_of("");
  const StudyDefinition read =
      in_language(study, texts_of(std::string(head) +
                                  "[[form_field]]\nname = \"gender\"\nlabel = \"Geschlecht\"\noptions = "
                                  "[\"weiblich\", \"männlich\", \"anderes\", \"keine Angabe\"]\n"));
  const std::vector<FormAnswer> answers = {{"age", "33"}, {"gender", "männlich"}};
  EXPECT_EQ(answers_of_study(study.form, read.form, answers),
            (std::vector<FormAnswer>{{"age", "33"}, {"gender", "male"}}));
}

TEST_F(Languages, WrongFilesAreRefusedByName) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"format = \"seamline texts 2\"\nlanguage = \"de\"\n", "format"},
      {"format = \"seamline texts 1\"\nlanguage = \"fr\"\n", "language"},
      {std::string(head) + "[texts]\nprogress = \"{fertig}\"\n", "texts.progress"},
      {std::string(head) + "[texts]\nprogres = \"{done}\"\n", "texts.progres"},
      {std::string(head) + "[session]\nrating_labels = [\"a\"]\n", "session.rating_labels"},
      {std::string(head) + "[[form_field]]\nname = \"shoes\"\nlabel = \"x\"\n", "form_field[0].name"},
      {std::string(head) + "[[form_field]]\nname = \"gender\"\noptions = [\"a\", \"a\", \"b\", \"c\"]\n",
       "form_field[0].options"}};
  for (const auto& [text, field] : cases) {
    const std::string complaint = complaint_of([&] { (void)texts_of(text); });
    EXPECT_NE(complaint.find(field), std::string::npos) << text << complaint;
  }
  for (const std::string wrong :
       {"tag = \"en\"\ntexts = \"builtin:de\"", "tag = \"d e\"\ntexts = \"builtin:de\"",
        "tag = \"de\"\ntexts = \"../own.toml\"", "tag = \"de\""})
    EXPECT_NE(complaint_of([&] { (void)study_of("[[language]]\n" + wrong + "\n"); }).find("language[0]"),
              std::string::npos)
        << wrong;
  const StudyDefinition study = study_of("[[language]]\ntag = \"de\"\ntexts = \"missing.toml\"\n");
  EXPECT_NE(complaint_of([&] {
              (void)read_study_texts(study, study.languages->languages.at(0));
            }).find("missing.toml"),
            std::string::npos);
}

}  // namespace
}  // namespace seamline
