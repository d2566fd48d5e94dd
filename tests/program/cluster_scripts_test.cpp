// The scripts of a job run what they name, whatever its folder is called. Stubs stand for sbatch, scontrol
// and GNU parallel; they write down what they were given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <set>

#include "run_program.h"
#include "sets/cluster/job_scripts.h"
#include "support/text/error.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using renderer::JobPlace;
using renderer::RenderJob;
using test::read_text;

/// Each would run something, name other files or end a line where a script is careless.
const std::vector<std::string> awful_names = {"job$(touch made)",
                                              "job`touch made`",
                                              "job;touch made;",
                                              "job&&touch made",
                                              "job|touch made",
                                              "job\ntouch made\n",
                                              "job\"$(touch made)\"",
                                              "job'$(touch made)'",
                                              "job's",
                                              "a job",
                                              " job ",
                                              "job*",
                                              "job?[a-z]",
                                              "-job",
                                              "--wrap=touch made",
                                              "~",
                                              "job%A%a%%",
                                              "job\\n\\",
                                              "job#1",
                                              "job{1..3}{}",
                                              "job$HOME${x:=touch}",
                                              "job!!",
                                              "job\t1",
                                              "job<made>made",
                                              "J\xC3\xB6"
                                              "b-\xE6\xA1\x88",
                                              "job\xE2\x80\xAE",
                                              "job\xFF",
                                              "(job)"};

/// Those whose folder Slurm's own lines can hold.
const std::set<std::string> plain_names = {"-job", "~",
                                           "J\xC3\xB6"
                                           "b-\xE6\xA1\x88"};

void write_program(const fs::path& file, const std::string& text) {
  test::write_text(file, "#!/bin/bash\n" + text);
  fs::permissions(file, fs::perms::owner_all);
}

std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

class ClusterScripts : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = test::fresh_folder("cluster-scripts");
    for (const char* part : {"bin", "here", "jobs"}) fs::create_directory(folder_ / part);
    // What a script is given is written down a line each; a job runs as Slurm does it, from a copy.
    write_program(folder_ / "bin" / "sbatch",
                  "printf '%q\\n' \"sbatch ${@: -1}\" >>\"$SAID\"\n"
                  "cp -- \"${@: -1}\" \"$COPY\"\n"
                  "SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=1 bash \"$COPY\" >/dev/null\n"
                  "echo '7;cluster'\n");
    write_program(folder_ / "bin" / "scontrol", "printf '%q\\n' \"scontrol $*\" >>\"$SAID\"\n");
    write_program(folder_ / "bin" / "parallel",
                  "while [ $# -gt 2 ]; do\n"
                  "  if [ \"$1\" = --wd ]; then cd -- \"$2\" || exit; fi\n"
                  "  shift\n"
                  "done\n"
                  "while read -r number; do \"$1\" \"${2//\\{\\}/$number}\" </dev/null; done\n");
  }

  /// The job's scripts, with a `task` that writes down what it was given.
  void write_job(const fs::path& folder, bool for_slurm) const {
    const JobPlace place{.folder = folder, .set_folder = folder_ / "set", .study = folder_ / "study.toml"};
    const RenderJob job{.study_name = "tiny",
                        .program_version = "1",
                        .instruction_set = "x",
                        .inputs = "0",
                        .truths = {{"bedroom", 1}},
                        .elements = {{"bedroom", {"a"}, 1}}};
    if (for_slurm)
      write_slurm_scripts(place, job);
    else
      write_parallel_scripts(place, job);
    write_program(folder / "task",
                  "me=$0\n"
                  "[[ $0 == ./* ]] && me=$PWD/${0#./}\n"
                  "printf '%q\\n' \"$me $*\" >>\"$SAID\"\n" +
                      task_);
  }

  /// Where the stubs are, and where they write to.
  [[nodiscard]] std::string surroundings() const {
    return "cd " + (folder_ / "here").string() + " && export PATH=" + (folder_ / "bin").string() +
           ":$PATH SAID=" + (folder_ / "said").string() + " COPY=" + (folder_ / "copy").string() + " && ";
  }

  /// Runs a script in an empty folder; what it and the stubs said.
  [[nodiscard]] std::string said_by(const fs::path& script) const {
    fs::remove(folder_ / "said");
    const test::Outcome outcome = test::run_program(surroundings() + "bash", in_quotes(script.string()));
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return read_text(folder_ / "said");
  }

  void expect_nothing_made(const std::string& name) const {
    EXPECT_TRUE(fs::is_empty(folder_ / "here")) << name;
    EXPECT_FALSE(fs::exists(folder_ / "jobs" / "made")) << name;
    EXPECT_FALSE(fs::exists(folder_ / "jobs" / name / "made")) << name;
  }

  fs::path folder_;
  std::string task_;
};

/// As bash's printf %q has it, without asking how: the same printf writes both.
std::string in_bash(const std::string& text) {
  return test::run_program("bash -c 'printf \"%q\" \"$1\"' bash", in_quotes(text)).output;
}

std::string line_of(const fs::path& program, const std::string& piece) {
  return in_bash(program.string() + " " + piece) + "\n";
}

TEST_F(ClusterScripts, RunInFoldersOfEveryName) {
  for (const std::string& name : awful_names) {
    SCOPED_TRACE(name);
    const fs::path job = folder_ / "jobs" / name, task = job / "task";
    fs::create_directory(job);
    if (plain_names.contains(name)) {
      write_job(job, true);
      EXPECT_EQ(said_by(job / "submit"),
                in_bash("sbatch " + (job / "truths.sbatch").string()) + "\n" + line_of(task, "truth-1") +
                    in_bash("sbatch " + (job / "stimuli.sbatch").string()) + "\n" +
                    line_of(task, "stimuli-1") + in_bash("sbatch " + (job / "join.sbatch").string()) + "\n" +
                    line_of(task, "join"));
    } else {
      EXPECT_THROW(write_job(job, true), InputError);
      EXPECT_TRUE(fs::is_empty(job));
    }
    if (name.find_first_of("{}") == std::string::npos) {
      write_job(job, false);
      EXPECT_EQ(said_by(job / "run"),
                line_of(task, "truth-1") + line_of(task, "stimuli-1") + line_of(task, "join"));
    } else {
      EXPECT_THROW(write_job(job, false), InputError);
    }
    EXPECT_TRUE(fs::is_empty(folder_ / "here"));
    EXPECT_FALSE(fs::exists(job / "made"));
  }
  EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_ / "jobs"), {})),
            awful_names.size());
}

TEST_F(ClusterScripts, ATaskHandsOnWhatItsJobWasMadeWith) {
  const fs::path job = folder_ / "jobs" / "job's $(touch made)";
  for (const std::string& name : awful_names) {
    SCOPED_TRACE(name);
    RenderJob described;
    described.threads = 2;
    renderer::write_parallel_scripts({.folder = job,
                                      .set_folder = folder_ / ("set" + name),
                                      .study = folder_ / (name + ".toml"),
                                      .options = {"--only=" + name}},
                                     described);
    // What would start the program prints its arguments instead.
    std::string task = read_text(job / "task");
    const std::size_t at = task.find("exec '");
    ASSERT_NE(at, std::string::npos);
    task.replace(at, task.find(" job piece ", at) - at, "printf '%s\\0'");
    test::write_text(job / "task", task);
    std::string wanted;
    for (const std::string& word :
         {std::string("job"), std::string("piece"), (folder_ / (name + ".toml")).string(),
          "--out=" + (folder_ / ("set" + name)).string(), std::string("--threads=2"), "--only=" + name,
          "--job=" + job.string(), std::string("--element=truth-1")})
      wanted += word + '\0';
    EXPECT_EQ(test::run_program(surroundings() + in_quotes((job / "task").string()), "truth-1").output,
              wanted);
  }
  EXPECT_TRUE(fs::is_empty(folder_ / "here"));
}

TEST_F(ClusterScripts, PutBackIntoTheQueueWhatWasStoppedAndNotWhatIsWrong) {
  const fs::path job = folder_ / "jobs" / "job";
  // A piece that ends by itself, and one that Slurm warns of its time limit.
  const auto said_after = [&](const std::string& task, bool is_warned, int restarts) {
    task_ = task;
    write_job(job, true);
    EXPECT_THAT(read_text(job / "truths.sbatch"), testing::HasSubstr("\n#SBATCH --signal=B:USR1@60\n"));
    fs::remove(folder_ / "said");
    const std::string warn = "until [ -e started ]; do sleep 0.01; done; rm started; kill -USR1 $batch; ";
    const std::string script =
        surroundings() +
        "export SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=1 SLURM_RESTART_COUNT=" + std::to_string(restarts) +
        "; bash " + (job / "truths.sbatch").string() + " & batch=$!; " + (is_warned ? warn : std::string()) +
        "wait $batch";
    (void)test::run_program("bash -c " + in_quotes(script), "");
    return read_text(folder_ / "said");
  };
  const std::string begun = line_of(job / "task", "truth-1"), again = in_bash("scontrol requeue 7_1") + "\n";
  EXPECT_EQ(said_after("exit 0\n", false, 0), begun);
  EXPECT_EQ(said_after("exit 1\n", false, 0), begun);
  EXPECT_EQ(said_after("kill -9 $$\n", false, 0), begun + again);
  EXPECT_EQ(said_after("kill -9 $$\n", false, 3), begun);
  const std::string long_work = "trap 'exit 130' TERM\n: >started\nwhile :; do sleep 0.02; done\n";
  EXPECT_EQ(said_after(long_work, true, 0), begun + again);
  EXPECT_EQ(said_after(long_work, true, 3), begun);
  // The warning may come before the script knows its piece: here the piece sends it as its first act.
  const std::string warned_at_once = "trap 'exit 130' TERM\nkill -USR1 $PPID\nwhile :; do sleep 0.02; done\n";
  for (int i = 0; i < 10; ++i) EXPECT_EQ(said_after(warned_at_once, false, 0), begun + again);
  // It ends well though it was warned.
  EXPECT_EQ(said_after("trap 'exit 0' TERM\n: >started\nwhile :; do sleep 0.02; done\n", true, 0), begun);
}

}  // namespace
}  // namespace seamline
