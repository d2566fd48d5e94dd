// The folder that `export web` writes: whole, the same twice, with the window's trials and no right
// answers.
#include "study/online/page/web_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "stimuli/pictures/attention_image.h"
#include "stimuli/set/manifest_pictures.h"
#include "study/online/messages/shown_names.h"
#include "study/online/page/web_pictures.h"
#include "study/online/serving/site_files.h"
#include "study/trials/participant_trials.h"
#include "study/trials/trial_picture.h"
#include "support/files/assets.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "tests/app/picture_set.h"
#include "tests/complaint.h"
#include "tests/program/run_program.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

constexpr const char* own_consent = "[consent]\ntext = \"Yours.\"\n";

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder).generic_string()] = read_file(entry.path());
  return files;
}

class WebExport : public testing::Test {
 protected:
  TemporaryFolder folder;

  void SetUp() override {
    if (!fs::exists(web_page_folder() / "jspsych.js")) GTEST_SKIP() << "built without the page (jsPsych)";
  }
  RenderedSet make_set(const std::string& session = {},
                       const std::string& more = "[catch]\nattention = 2\nreference = 1\n") {
    return test::write_picture_set(folder / "set", {.width_px = 64,
                                                    .height_px = 48,
                                                    .widths = "64, 128",
                                                    .session = session,
                                                    .more = own_consent + more});
  }
  WebSummary export_to(const std::string& name, WebRequest request = {}) {
    request.set_folder = folder / "set";
    request.out_folder = folder / name;
    if (!request.slots && request.host != Origin::serve) request.slots = 5;
    return export_web(request);
  }
  std::string complaint_of_export(WebRequest request) {
    return test::complaint_of([&] { export_to("refused", request); });
  }
};

TEST_F(WebExport, TheSameBytesTwiceAndTheListNamesEveryFile) {
  make_set();
  const WebSummary summary = export_to("one");
  export_to("two/");
  const auto one = files_below(folder / "one");
  EXPECT_EQ(one, files_below(folder / "two"));
  EXPECT_EQ(static_cast<int>(one.size()), summary.files);
  const Json index = Json::parse(one.at("files.json"));
  EXPECT_EQ(index.at("format"), "seamline-online-1");
  std::vector<std::string> names;
  for (const Json& file : index.at("files")) {
    const std::string& name = names.emplace_back(file.at("name"));
    EXPECT_EQ(file.at("sha256"), sha256(one.at(name))) << name;
    EXPECT_EQ(file.at("bytes"), one.at(name).size()) << name;
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(names.size() + 1, one.size());
  for (const char* name : {"index.html", "seamline.js", "seamline.css", "icon.svg", "jspsych.js",
                           "jspsych-licence.txt", "study.json"})
    EXPECT_TRUE(one.contains(name)) << name;
  // Others may read it, as they may read a web server's files.
  EXPECT_NE(fs::status(folder / "one").permissions() & fs::perms::others_read, fs::perms::none);
}

TEST_F(WebExport, ASlotHasTheTrialsThatTheWindowHas) {
  const RenderedSet set = make_set();
  export_to("web");
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  EXPECT_EQ(study.at("slots"), 5);
  EXPECT_EQ(study.at("most_trials"), 9);
  const TrialRules rules = make_trial_rules(set);
  const ShownNames names(set);
  for (int slot = 0; slot < 5; ++slot) {
    const Json order = Json::parse(read_file(folder / "web" / fmt::format("orders/{:04}.json", slot)));
    const std::vector<Trial> trials = decided_trials(rules, slot, {});
    ASSERT_EQ(order.size(), trials.size());
    for (std::size_t i = 0; i < trials.size(); ++i) {
      EXPECT_EQ(order[i].at("trial_index"), i);
      EXPECT_EQ(order[i].at("kind"), word(trials[i].kind));
      EXPECT_EQ(order[i].at("stimulus_id"), names.name_of(trials[i]));
      EXPECT_FALSE(order[i].contains("right_index"));
      // The picture is the trial's, code by code, whoever made its file.
      const ByteImage shown = read_bytes_image(folder / "web" / order[i].at("picture").get<std::string>());
      EXPECT_EQ(shown.values, load_trial_picture(set, trials[i]).values);
    }
  }
}

TEST_F(WebExport, StimuliAreTheSetsOwnBytes) {
  const RenderedSet set = make_set();
  export_to("web");
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  ASSERT_EQ(study.at("stimuli").size(), set.manifest.stimuli.size());
  const ShownNames names(set);
  std::map<std::string, Json> shown;
  for (const Json& stimulus : study.at("stimuli")) shown[stimulus.at("id")] = stimulus;
  ASSERT_EQ(shown.size(), set.manifest.stimuli.size());
  for (int i = 0; i < static_cast<int>(set.manifest.stimuli.size()); ++i) {
    const Json& stimulus = shown.at(names.name_of({.stimulus = i}));
    EXPECT_EQ(stimulus.at("sha256"), set.manifest.stimuli[static_cast<std::size_t>(i)].sha256);
    EXPECT_EQ(sha256_of_file(folder / "web" / stimulus.at("file").get<std::string>()), stimulus.at("sha256"));
  }
  // 6 stimuli, 3 attention trials (one an object), 1 reference; all of one scene and so with one map.
  EXPECT_EQ(study.at("pictures").size(), 10U);
  for (const Json& picture : study.at("pictures"))
    EXPECT_EQ(picture.at("map"), study.at("pictures")[0].at("map"));
  EXPECT_EQ(study.at("catches").size(), 12U);
}

TEST_F(WebExport, AMapUnpacksToWhatTheWindowClicksOn) {
  const RenderedSet set = make_set();
  export_to("web");
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  const Json packed =
      Json::parse(read_file(folder / "web" / study.at("pictures")[0].at("map").get<std::string>()));
  const ObjectMap map = make_object_map(load_object_ids(set, {}));
  std::vector<std::uint8_t> nearest;
  for (std::size_t run = 0; run + 1 < packed.at("runs").size(); run += 2)
    nearest.insert(nearest.end(), packed.at("runs")[run].get<std::size_t>(),
                   packed.at("runs")[run + 1].get<std::uint8_t>());
  EXPECT_EQ(nearest, map.nearest);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(packed.at("frames")[i].at("x_px"), map.frames.at(i).x_px);
}

TEST_F(WebExport, EveryWordIsTheStudysAndNothingTellsWhichObjectIsRight) {
  make_set("question = \"Which?\"\nlanguage = \"pt-BR\"\n",
           "[texts]\ncontinue = \"Weiter\"\n[training]\ntrials = 2\n");
  export_to("web");
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  EXPECT_EQ(study.at("question"), "Which?");
  EXPECT_EQ(study.at("language"), "pt-BR");
  EXPECT_EQ(study.at("texts").at("continue"), "Weiter");
  EXPECT_EQ(study.at("texts").at("back"), "Back");
  EXPECT_EQ(study.at("texts").size(), every_phrase().size());
  EXPECT_EQ(study.at("consent").at("sha256"), sha256("Yours."));
  EXPECT_EQ(study.at("form").size(), default_form().size());
  EXPECT_EQ(study.at("training").size(), 2U);
  for (const auto& [name, bytes] : files_below(folder / "web"))
    if (name.ends_with(".json") && name != "study.json") {
      EXPECT_THAT(bytes, Not(HasSubstr("right_index"))) << name;
    }
  EXPECT_FALSE(fs::exists(folder / "web/manifest.json"));
  EXPECT_FALSE(fs::exists(folder / "web/study.toml"));
}

TEST_F(WebExport, WhoReadsThePagesSourceFindsNoNameOfAStimulus) {
  const RenderedSet set = make_set();
  export_to("web");
  for (const auto& [name, bytes] : files_below(folder / "web"))
    for (const ManifestStimulus& stimulus : set.manifest.stimuli) {
      EXPECT_THAT(bytes, Not(HasSubstr(stimulus.id))) << name;
      EXPECT_THAT(name, Not(HasSubstr(stimulus.id)));
    }
  // Nor does the order of a list tell: it is that of the shown names.
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  for (const auto& [list, key] : {std::pair("stimuli", "id"), std::pair("catches", "stimulus_id")}) {
    std::vector<std::string> names;
    for (const Json& one : study.at(list)) names.push_back(one.at(key));
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end())) << list;
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << list;
  }
}

TEST_F(WebExport, NoTimeOfAFileTellsTheSetsOrder) {
  make_set();
  export_to("web");
  std::set<fs::file_time_type> times = {fs::last_write_time(folder / "web")};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "web"))
    times.insert(entry.last_write_time());
  EXPECT_EQ(times.size(), 1U);
}

TEST_F(WebExport, NamesAreOfTheSetAndOfTheKindOfTrial) {
  const RenderedSet set = make_set();
  const ShownNames names(set);
  const Trial trial{.kind = TrialKind::stimulus, .stimulus = 1};
  EXPECT_EQ(names.name_of(trial), ShownNames(set).name_of(trial));
  const std::string& id = set.manifest.stimuli[1].id;  // as older pages say
  EXPECT_TRUE(names.is_name_of(trial, id, KnownNames::also_of_the_set));
  EXPECT_FALSE(names.is_name_of(trial, id, KnownNames::shown));
  for (const KnownNames known : {KnownNames::shown, KnownNames::also_of_the_set}) {
    EXPECT_TRUE(names.is_name_of(trial, names.name_of(trial), known));
    for (const Trial& other :
         {Trial{.kind = TrialKind::attention, .stimulus = 1}, {.kind = TrialKind::stimulus, .stimulus = 2}})
      EXPECT_FALSE(names.is_name_of(trial, names.name_of(other), known));
  }
  Manifest other = set.manifest;  // another set of the same study
  other.stimuli.back().rays += 1;
  fs::create_directories(folder / "other");
  write_manifest(folder / "other", other);
  RenderedSet of_other = set;
  of_other.folder = folder / "other";
  EXPECT_NE(ShownNames(of_other).name_of(trial), names.name_of(trial));
}

TEST_F(WebExport, NothingLeavesTheHost) {
  make_set();
  export_to("web");
  for (const auto& [name, bytes] : files_below(folder / "web")) {
    if (name == "jspsych.js") {
      EXPECT_THAT(bytes, Not(HasSubstr("sourceMappingURL")));
      continue;
    }
    if (name.ends_with(".png") || name == "jspsych-licence.txt") continue;
    std::string text = bytes;
    const std::string name_of_svg = "\"http://www.w3.org/2000/svg\"";  // a name, not an address
    if (const std::size_t at = text.find(name_of_svg); at != std::string::npos)
      text.erase(at, name_of_svg.size());
    EXPECT_THAT(text, Not(testing::ContainsRegex("https?://"))) << name;
    EXPECT_THAT(bytes, Not(HasSubstr("innerHTML"))) << name;
    EXPECT_THAT(bytes, Not(HasSubstr("eval("))) << name;
  }
  const std::string page = read_file(folder / "web/index.html");
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'self' 'sha256-"));
  EXPECT_THAT(page, HasSubstr("'; style-src 'self';"));
  EXPECT_THAT(page, Not(HasSubstr("unsafe")));
  EXPECT_THAT(page, Not(HasSubstr("style=")));
}

TEST_F(WebExport, APageIsOfItsHostAndSaysSo) {
  make_set();
  for (const Origin host : every_web_origin) {
    const std::string name(word(host));
    export_to(name, {.slots = 5, .host = host});
    EXPECT_EQ(Json::parse(read_file(folder / name / "study.json")).at("host"), name);
  }
  const auto bytes_of = [&](const char* name) { return files_below(folder / name); };
  EXPECT_NE(bytes_of("serve"), bytes_of("static"));
  EXPECT_NE(bytes_of("jatos"), bytes_of("static"));
  EXPECT_EQ(bytes_of("jatos").size(), bytes_of("static").size() + 1);  // JATOS's end page
  // Nothing but `seamline serve` gives answers to a log: it takes no other page.
  EXPECT_EQ(read_site_files(folder / "serve").slots, 5);
  EXPECT_THAT(test::complaint_of([&] { (void)read_site_files(folder / "static"); }),
              HasSubstr("study.json: host: wanted \"serve\" (export the page with serve), found \"static\""));
  EXPECT_THAT(test::complaint_of([&] { (void)read_site_files(folder / "jatos"); }),
              HasSubstr("found \"jatos\""));
}

TEST_F(WebExport, AClassAsksForFewFilesBeforeTheConsent) {
  make_set();
  export_to("web");
  std::vector<std::string> asked;
  for (const auto& [name, bytes] : files_below(folder / "web"))
    if (name.find('/') == std::string::npos && name != "files.json" && name != "jspsych-licence.txt")
      asked.push_back(name);
  EXPECT_THAT(asked, testing::ElementsAre("icon.svg", "index.html", "jspsych.js", "seamline.css",
                                          "seamline.js", "study.json"));
  EXPECT_THAT(read_file(folder / "web/seamline.js"), Not(testing::ContainsRegex("(^|\n)import ")));
}

TEST_F(WebExport, TheFirstPageSpeaksTheStudysLanguageAndNamesItsScript) {
  make_set("language = \"pt-BR\"\n", "[texts]\nonline_wait = \"Um <momento>\"\n");
  export_to("web");
  const std::string page = read_file(folder / "web/index.html");
  EXPECT_THAT(page, HasSubstr("<html lang=\"pt-BR\">"));
  EXPECT_THAT(page, HasSubstr("Um &lt;momento&gt;"));
  EXPECT_THAT(page, Not(testing::ContainsRegex("@[a-z]+@")));
  const std::size_t begin = page.find("<script>") + 8;
  const std::string start = page.substr(begin, page.find("</script>") - begin);
  EXPECT_EQ(start, read_file(web_page_folder() / "start.js"));
  // By Python, which we did not write.
  const test::Outcome hash = test::run_program(
      "python3",
      "-c 'import base64,hashlib,sys; print(base64.b64encode(hashlib.sha256(open(sys.argv[1],"
      "\"rb\").read()).digest()).decode(),end=\"\")' " +
          (web_page_folder() / "start.js").string());
  EXPECT_EQ(hash.status, 0) << hash.output;
  EXPECT_THAT(page, HasSubstr("'sha256-" + hash.output + "'"));
}

/// JATOS shows a file of this name when a run has ended; then it gives out no other file of the study.
TEST_F(WebExport, AtJatossEndThereAreTheStudysThanks) {
  make_set("language = \"de\"\n",
           "[texts]\nthanks_title = \"@text@ & Dank\"\nthanks_text = \"<b>Fertig.</b>\"\n");
  export_to("web", {.host = Origin::jatos});
  const std::string page = read_file(folder / "web/endPage.html");
  EXPECT_THAT(page, HasSubstr("<html lang=\"de\">"));
  EXPECT_THAT(page, HasSubstr("<title>@text@ &amp; Dank</title>"));
  EXPECT_THAT(page, HasSubstr("&lt;b&gt;Fertig.&lt;/b&gt;"));
  EXPECT_THAT(page, Not(testing::ContainsRegex("src=|href=|@(language|title)@")));
}

TEST_F(WebExport, FontAndPicturesOfTheInstructionsComeAlong) {
  make_set("font = \"own.ttf\"\n", "[[instructions.page]]\ntext = \"Look.\"\npictures = [\"how.png\"]\n");
  write_file_atomically(folder / "set/own.ttf", "letters");
  fs::copy_file(folder / "set/room.png", folder / "set/how.png");
  export_to("web");
  const Json study = Json::parse(read_file(folder / "web/study.json"));
  EXPECT_EQ(read_file(folder / "web" / study.at("font").get<std::string>()), "letters");
  EXPECT_EQ(study.at("instructions")[0].at("text"), "Look.");
  EXPECT_EQ(sha256_of_file(folder / "web" / study.at("instructions")[0].at("pictures")[0].get<std::string>()),
            sha256_of_file(folder / "set/how.png"));
}

TEST_F(WebExport, WholeOrNotAtAll) {
  const RenderedSet set = make_set();
  fs::remove(folder / "set" / set.manifest.stimuli.back().image);
  EXPECT_THAT(complaint_of_export({}), HasSubstr("no such file"));
  EXPECT_FALSE(fs::exists(folder / "refused"));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().filename(), "set") << "left behind";
}

TEST_F(WebExport, WhatHoldsSomethingIsNotTouched) {
  make_set();
  fs::create_directories(folder / "refused");
  write_file_atomically(folder / "refused/mine.txt", "mine");
  EXPECT_THAT(complaint_of_export({}), HasSubstr("empty or not there yet"));
  EXPECT_EQ(files_below(folder / "refused").size(), 1U);
  fs::create_directories(folder / "empty");
  export_to("empty");
  EXPECT_TRUE(fs::exists(folder / "empty/index.html"));
}

TEST_F(WebExport, WhatCannotBeShownThereIsRefusedWithOneSentence) {
  test::write_picture_set(folder / "set", {.width_px = 64, .height_px = 48});
  EXPECT_THAT(complaint_of_export({}), HasSubstr("consent.text: wanted your own consent text"));
  EXPECT_EQ(export_to("pilot", {.pilot = true}).slots, 5);
  EXPECT_TRUE(Json::parse(read_file(folder / "pilot/study.json")).at("pilot"));

  fs::remove_all(folder / "set");
  make_set("orders = 3\n");
  EXPECT_THAT(complaint_of_export({.slots = 4}), HasSubstr("slots: wanted at most 3"));
  EXPECT_EQ(export_web({.set_folder = folder / "set", .out_folder = folder / "three"}).slots, 3);

  fs::remove_all(folder / "set");
  test::write_picture_set(folder / "set",
                          {.width_px = 64,
                           .height_px = 48,
                           .top = "procedure = \"quest_plus\"",
                           .more = std::string(own_consent) + "[quest_plus]\nmax_shows_per_image = 2\n"});
  EXPECT_THAT(complaint_of_export({}), HasSubstr("procedure: wanted constant stimuli"));
  EXPECT_TRUE(export_to("adaptive", {.host = Origin::serve}).adaptive);
  const Json study = Json::parse(read_file(folder / "adaptive/study.json"));
  EXPECT_TRUE(study.at("adaptive"));
  EXPECT_FALSE(fs::exists(folder / "adaptive/orders"));
}

}  // namespace
}  // namespace seamline::study::online
