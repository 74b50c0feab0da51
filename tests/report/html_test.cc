#include "report/html.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "report/json.h"
#include "report/records.h"
#include "report/sweep_record.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HtmlTest : public testing::Test {
  protected:
    std::filesystem::path Dir() const { return folder_.path() / "report"; }
    std::string Read(const std::string& name) { return folder_.Read("report/" + name); }
    json Report() { return json::parse(Read("report.json")); }
    std::string Complaint(const Status<>& status) { return status ? "" : status.error().message; }

    Folder folder_;
};

std::string SomeRun(const std::string& name = "optics/fresnel") {
    RunRecord run;
    run.version = "1.2.3";
    run.devices = {Llvmpipe()};
    run.records = {Passed(), Refused()};
    run.records[0].case_path = name;
    return RunJson(run);
}

TEST_F(HtmlTest, MakesTheFolderAndItsFiles) {
    ASSERT_EQ(Complaint(AddToReport(Dir(), ReportSection::kRun, "", SomeRun())), "");
    const json report = Report();
    EXPECT_EQ(report["format"], "etalon report 1");
    EXPECT_EQ(report["processor"], ProcessorName());
    EXPECT_EQ(report["run"], json::parse(SomeRun()));
    EXPECT_EQ(report["charts"], json::object());
    EXPECT_EQ(json::parse(Read("report.schema.json"))["title"], "etalon report");
    const std::string page = Read("index.html");
    EXPECT_THAT(page, AllOf(HasSubstr("optics/fresnel"), HasSubstr("Etalon.startPage()"),
                            Not(HasSubstr("<!--DATA-->")), Not(HasSubstr("<!--SCRIPT-->"))));
}

TEST_F(HtmlTest, AddsAndReplacesOnlyItsOwnSection) {
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kCharts, "a/b", R"({"family": "a/b"})"));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kMaps, "m", R"({"case": "m"})"));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kRun, "", SomeRun("first")));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kCharts, "c", R"({"family": "c"})"));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kCharts, "a/b", R"({"family": "new"})"));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kRun, "", SomeRun("second")));
    const json report = Report();
    EXPECT_EQ(report["charts"], json::parse(R"({"a/b": {"family": "new"}, "c": {"family": "c"}})"));
    EXPECT_EQ(report["maps"], json::parse(R"({"m": {"case": "m"}})"));
    EXPECT_EQ(report["run"]["records"][0]["case"], "second");
    EXPECT_THAT(Read("index.html"), AllOf(HasSubstr("second"), Not(HasSubstr("\"first\""))));
}

TEST_F(HtmlTest, LetsNoTextEndTheScript) {
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kRun, "", SomeRun("</script><!--DATA--><b>")));
    EXPECT_EQ(Report()["run"]["records"][0]["case"], "</script><!--DATA--><b>");
    const std::string page = Read("index.html");
    const std::string mark = "type=\"application/json\">";
    const std::size_t begin = page.find(mark) + mark.size();
    const std::string data = page.substr(begin, page.find("</script>", begin) - begin);
    EXPECT_EQ(json::parse(data)["run"]["records"][0]["case"], "</script><!--DATA--><b>");
    EXPECT_EQ(data.find('<'), std::string::npos);
}

TEST_F(HtmlTest, KeepsAllOfARecordThatIsNotAsItShouldBe) {
    RunRecord run;
    run.records = {Outside(), Outside()};
    run.records[1].verdict = Verdict::kPass;
    const std::string page =
        ReportPage(R"({"format": "etalon report 1", "run": )" + RunJson(run) + "}");
    const std::string mark = "type=\"application/json\">";
    const std::size_t begin = page.find(mark) + mark.size();
    const json records =
        json::parse(page.substr(begin, page.find("</script>", begin) - begin))["run"]["records"];
    EXPECT_TRUE(records[0]["worst_parts"]["driver"].contains("inputs"));
    EXPECT_FALSE(records[1]["worst_parts"]["driver"].contains("inputs"));
    EXPECT_EQ(records[0]["worst"], records[1]["worst"]);
    EXPECT_TRUE(records[1].contains("repeat"));
}

TEST_F(HtmlTest, OverwritesNothingThatIsNotItsOwn) {
    const std::string whole = [this] {
        EXPECT_TRUE(AddToReport(Dir(), ReportSection::kRun, "", SomeRun()));
        return Read("report.json");
    }();
    const std::pair<std::string, std::string> wrong[] = {
        {whole.substr(0, whole.size() / 2), "report.json: is no report: it is cut, or no JSON"},
        {"", "report.json: is no report: it is cut, or no JSON"},
        {"[1, 2]", "report.json: is no report of etalon"},
        {R"({"records": []})", "report.json: is no report of etalon"},
        {R"({"format": "etalon report 2"})",
         "report.json: is an 'etalon report 2', not an 'etalon report 1'"},
        {R"({"format": "etalon report 1", "charts": []})",
         "report.json: is no report of etalon: 'charts' is no object"},
    };
    for (const auto& [content, complaint] : wrong) {
        folder_.Write("report/report.json", content);
        const std::string page = Read("index.html");
        EXPECT_THAT(Complaint(CheckReport(Dir())), HasSubstr(complaint));
        EXPECT_THAT(Complaint(AddToReport(Dir(), ReportSection::kRun, "", SomeRun())),
                    HasSubstr(complaint));
        EXPECT_EQ(Read("report.json"), content);
        EXPECT_EQ(Read("index.html"), page);
    }
}

TEST_F(HtmlTest, LeavesAnotherPageAlone) {
    folder_.Write("report/index.html", "<h1>My site</h1>");
    EXPECT_THAT(Complaint(AddToReport(Dir(), ReportSection::kRun, "", SomeRun())),
                HasSubstr("index.html: is a page that etalon did not write"));
    EXPECT_EQ(Read("index.html"), "<h1>My site</h1>");
    EXPECT_FALSE(std::filesystem::exists(Dir() / "report.json"));
}

TEST_F(HtmlTest, NamesAFolderThatCannotBe) {
    folder_.Write("file", "text");
    EXPECT_THAT(Complaint(CheckReport(folder_.path() / "file")), HasSubstr("file: "));
    EXPECT_THAT(Complaint(CheckReport(folder_.path() / "file" / "below")), HasSubstr("below: "));
    EXPECT_THAT(Complaint(CheckReport("/proc/report")), HasSubstr("/proc/report: "));
    std::filesystem::create_directories(Dir() / "report.json");
    EXPECT_THAT(Complaint(CheckReport(Dir())), HasSubstr("report.json: is a folder, not a file"));
}

TEST_F(HtmlTest, LosesNothingWhereSeveralAddAtOnce) {
    constexpr int kEach = 6;
    std::vector<pid_t> children;
    for (int child = 0; child < 4; ++child) {
        children.push_back(fork());
        if (children.back() == 0) {
            bool good = true;
            for (int part = 0; part < kEach; ++part) {
                good = good && AddToReport(Dir(), ReportSection::kCharts,
                                           std::to_string(child) + "/" + std::to_string(part), "{}")
                                   .ok();
            }
            _exit(good ? 0 : 1);
        }
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(Report()["charts"].size(), 4u * kEach);
    // Nothing but the three files is left.
    std::size_t files = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(Dir())) {
        ++files;
    }
    EXPECT_EQ(files, 3u);
}

TEST_F(HtmlTest, SurvivesTextThatIsNoUtf8) {
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kRun, "", SomeRun("a\xff\xfe")));
    ASSERT_TRUE(AddToReport(Dir(), ReportSection::kCharts, "c", "{}"));
    EXPECT_EQ(Report()["run"]["records"][0]["case"], "a\ufffd\ufffd");
}

TEST_F(HtmlTest, DrawsPictures) {
    RunRecord run;
    run.devices = {Llvmpipe()};
    run.records = {Outside()};
    run.records[0].verdict = Verdict::kPass;
    run.records[0].device = run.devices[0].name;
    std::filesystem::create_directories(Dir());
    ASSERT_EQ(Complaint(WritePictures(Dir(), ReportSection::kRun, "", RunJson(run))), "");
    const std::string svg = Read("budget.svg");
    EXPECT_THAT(svg, AllOf(testing::StartsWith("<svg"), HasSubstr("optics/fresnel"),
                           HasSubstr("osmesa:llvmpipe"), testing::EndsWith("</svg>\n")));
}

TEST_F(HtmlTest, SaysWhatPicturesNeed) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder_.path().c_str(), 1);
    EXPECT_THAT(Complaint(CheckPictures()), HasSubstr("the program 'node' is needed"));
    folder_.Write("node", "#!/bin/sh\necho 'Error: no memory' >&2\nexit 3\n");
    chmod((folder_.path() / "node").c_str(), 0755);
    EXPECT_EQ(Complaint(CheckPictures()), "the program 'node' failed: Error: no memory");
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(Complaint(CheckPictures()), "");
}

TEST(SweepKey, TellsSweepsApart) {
    SweepRecord sweep;
    sweep.case_path = "a/b";
    sweep.device = "cpu";
    sweep.recipe = "spirv";
    sweep.input = "x";
    sweep.from = {"0", "0x0p+0"};
    sweep.to = {"1", "0x1p+0"};
    EXPECT_EQ(SweepKey(sweep), "a/b over x=0..1 on cpu (spirv)");
    sweep.fixed = "y=2";
    sweep.shard = "1/4";
    EXPECT_EQ(SweepKey(sweep), "a/b over x=0..1 at y=2 on cpu (spirv), 1/4");
}

}  // namespace
}  // namespace etalon
