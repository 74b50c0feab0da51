#include "report/text.h"

#include <gmock/gmock.h>

#include "report/records.h"

namespace etalon {
namespace {

using testing::HasSubstr;

TEST(ShortNumber, IsShort) {
    EXPECT_EQ(ShortNumber(0), "0");
    EXPECT_EQ(ShortNumber(-0.0), "0");
    EXPECT_EQ(ShortNumber(3.2149), "3.21");
    EXPECT_EQ(ShortNumber(15'000'000), "1.5e+07");
    EXPECT_EQ(ShortNumber(1e-300), "1e-300");
    EXPECT_EQ(ShortNumber(std::numeric_limits<double>::infinity()), "infinite");
    EXPECT_EQ(ShortNumber(-std::numeric_limits<double>::infinity()), "-infinite");
}

TEST(WorstText, IsOneLine) {
    EXPECT_EQ(WorstText(*Passed().worst),
              "result.x: 4 ulp, 25 % of the tolerance, at n1=1.5, steps=3");
}

TEST(FailureText, TellsAllThatRepeatsIt) {
    Record record = Refused();
    record.worst->ulp_error = 40;
    record.worst->error = 7.45e-8;
    record.worst->used = 2.5;
    record.worst->actual = {"0.10000026", "0x1.9999eap-4"};
    EXPECT_EQ(FailureText(record),
              "optics/fresnel on osmesa:llvmpipe (glsl): fail\n"
              "  refused   2 of 300 values (100 rows, seed 7); the worst:\n"
              "  input     n1=1.5, steps=3\n"
              "            n1=0x1.8p+0, steps=3\n"
              "  output    result.x\n"
              "  actual    0.10000026 = 0x1.9999eap-4\n"
              "  expected  0.10000001 = 0x1.99999cp-4\n"
              "  error     40 ulp, 7.45e-08 absolute, 2.5 times the tolerance\n"
              "  rule      ulp 16 or absolute 1e-09\n"
              "  repeat    etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'");
}

TEST(FailureText, TellsOfANan) {
    EXPECT_EQ(FailureText(Refused()),
              "optics/fresnel on osmesa:llvmpipe (glsl): fail\n"
              "  refused   2 of 300 values (100 rows, seed 7); the worst:\n"
              "  input     n1=1.5, steps=3\n"
              "            n1=0x1.8p+0, steps=3\n"
              "  output    result.x\n"
              "  actual    nan = nan\n"
              "  expected  0.10000001 = 0x1.99999cp-4\n"
              "  error     infinite ulp, infinite absolute, infinite times the tolerance\n"
              "  rule      ulp 16 or absolute 1e-09\n"
              "  repeat    etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'");
}

TEST(FailureText, NamesTheCulprit) {
    Record record = Refused();
    record.profile = "vulkan-1.3";
    record.worst->budget = {"rounding", false, PartSeen{0, 0}, {7e-8, 39.5}, {1e-9, 0.5}};
    record.culprits = {{"rounding", 2}};
    EXPECT_THAT(FailureText(record),
                HasSubstr("\n  rule      ulp 16 or absolute 1e-09\n"
                          "  culprit   rounding\n"
                          "  parts     method 0 ulp, rounding 39.5 ulp, driver 0.5 ulp\n"
                          "  repeat "));
    record.culprits = {{"rounding", 1}, {"driver, within the specification", 1}};
    record.held = 300;
    record.outside = 4;
    EXPECT_THAT(
        FailureText(record),
        HasSubstr("\n  culprit   rounding (of all that was refused: rounding 1; driver, within "
                  "the specification 1)\n"
                  "  parts     method 0 ulp, rounding 39.5 ulp, driver 0.5 ulp\n"
                  "  outside   4 of 300 values are not what vulkan-1.3 allows\n"
                  "  repeat "));
    record.worst->budget.reset();
    record.unevaluated = "OpArrayLength is not known";
    EXPECT_THAT(FailureText(record),
                HasSubstr("\n  culprit   not known: OpArrayLength is not known\n  repeat "));
}

TEST(FailureText, TellsWhoBreaksALaw) {
    Record record = Refused();
    record.worst->budget = {"rounding", true, PartSeen{}, {1e-7, 3}, {2e-7, 4}};
    EXPECT_THAT(FailureText(record),
                HasSubstr("\n  culprit   rounding\n  parts     method holds, strict evaluation "
                          "breaks it by 3 ulp, device breaks it by 4 ulp\n"));
}

TEST(FailureText, ShowsWhatTheSpecificationAllows) {
    EXPECT_EQ(FailureText(Outside()),
              "optics/fresnel on osmesa:llvmpipe (glsl): nonconforming\n"
              "  outside   3 of 300 values (100 rows, seed 7) are not what vulkan-1.3 allows; the "
              "furthest:\n"
              "  input     n1=1.5, steps=3\n"
              "            n1=0x1.8p+0, steps=3\n"
              "  output    result.x\n"
              "  actual    0.2 = 0x1.99999ap-3\n"
              "  expected  0.10000001 = 0x1.99999cp-4\n"
              "  allowed   0.1 = 0x1.99999ap-4 to 0.11 = 0x1.c28f5cp-4\n"
              "  error     12 ulp outside\n"
              "  culprit   driver\n"
              "  parts     method 0.25 ulp, rounding 0 ulp, driver 12 ulp\n"
              "  repeat    etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'");
}

TEST(FailureText, OfASpecificationNeedsNoTruth) {
    Record record = Outside();
    record.verdict = Verdict::kFail;
    record.refused = 3;
    record.worst = record.worst_outside;
    record.worst->expected.reset();
    record.worst->allowed->high = record.worst->allowed->low;
    record.worst->budget->method.reset();
    EXPECT_THAT(FailureText(record), HasSubstr("\n  actual    0.2 = 0x1.99999ap-3\n"
                                               "  allowed   0.1 = 0x1.99999ap-4\n"
                                               "  error     12 ulp outside\n"
                                               "  rule      spec vulkan-1.3\n"
                                               "  culprit   driver\n"
                                               "  parts     rounding 0 ulp, driver 12 ulp\n"));
}

TEST(FailureText, TellsOfTheQuantumThatAResultMisses) {
    Record record = Outside();
    record.worst_outside->allowed->quantum = Value{"0.125", "0x1p-3"};
    EXPECT_THAT(FailureText(record),
                HasSubstr(" to 0.11 = 0x1.c28f5cp-4, in multiples of 0x1p-3\n"));
}

TEST(PartsText, TellsTheWorstOfEach) {
    EXPECT_EQ(PartsText(Outside()), "parts at most method 0.25 ulp, driver 12 ulp");
    EXPECT_EQ(PartsText(Passed()), "");
}

TEST(FailureText, TellsOfACrash) {
    Record record = Without(Verdict::kCrash, "ended by signal 11 (Segmentation fault)");
    record.repeat = "etalon run optics/fresnel";
    EXPECT_EQ(FailureText(record),
              "optics/fresnel on osmesa:llvmpipe (glsl): crash\n"
              "  reason    ended by signal 11 (Segmentation fault)\n"
              "  repeat    etalon run optics/fresnel");
    record.known_cause = "bug: the driver divides (https://example.org/1)";
    EXPECT_EQ(FailureText(record),
              "optics/fresnel on osmesa:llvmpipe (glsl): crash\n"
              "  reason    ended by signal 11 (Segmentation fault)\n"
              "  known     bug: the driver divides (https://example.org/1)\n"
              "  repeat    etalon run optics/fresnel");
}

TEST(FailureText, ShowsNoRefusedValueWhereNoneWasRefused) {
    Record record = Passed();
    record.verdict = Verdict::kFail;
    record.reason =
        "passes, but is expected to fail (bug: old); take the expectation out of the case";
    EXPECT_EQ(FailureText(record),
              "optics/fresnel on osmesa:llvmpipe (glsl): fail\n"
              "  reason    passes, but is expected to fail (bug: old); take the expectation out of "
              "the case\n"
              "  repeat    etalon run optics/fresnel --at 'n1=0x1.8p+0,steps=3'");
}

ShareCount Searched() {
    ShareCount count;
    count.output = "result";
    count.search = true;
    count.rows = 1000;
    count.wrong = 4;
    count.wrong_allowed = 0.01;
    count.hits = 900;
    count.missed = 3;
    count.missed_allowed = 0.01;
    count.worst_right = 0.013;
    return count;
}

TEST(ShareText, CountsWhatIsOff) {
    ShareCount count = Searched();
    EXPECT_EQ(ShareText(count),
              "result: missed 3 of 900 (0.333 %, 1 % allowed), wrong 4 of 1000 (0.4 %, 1 % "
              "allowed), worst right hit off by 0.013");
    count.search = false;
    count.undecided = 2;
    EXPECT_EQ(ShareText(count), "result: wrong 4 of 1000 (0.4 %, 1 % allowed), undecided 2");
    EXPECT_EQ(ShareText({.output = "layer"}), "layer: wrong 0 of 0 (0 %, 0 % allowed)");
}

TEST(FailureText, CountsWhatIsOffBeforeTheWorst) {
    Record record = Refused();
    record.shares = {Searched()};
    EXPECT_NE(FailureText(record).find(": fail\n  shares    result: missed 3 of 900 (0.333 %, 1 % "
                                       "allowed), wrong 4 of 1000 (0.4 %, 1 % allowed), worst "
                                       "right hit off by 0.013\n  refused   2 of 300"),
              std::string::npos)
        << FailureText(record);
}

TEST(SummaryText, CountsByDevice) {
    RunRecord run;
    run.devices = {Llvmpipe(), Silent()};
    Record closer = Passed();
    closer.case_path = "optics/snell";
    closer.worst->used = 0.875;
    Record known = Refused();
    known.known_cause = "method: cancels";
    Record flaky = Passed();
    flaky.flake = "ended by signal 9 (Killed)";
    Record skipped = Without(Verdict::kSkip, "no fragment stage");
    skipped.device = "vulkan:silent@new";
    Record hung = Without(Verdict::kTimeout, "no answer within 10 s");
    hung.device = "vulkan:silent@new";
    Record known_crash = Without(Verdict::kCrash, "signal 11");
    known_crash.known_cause = "method: cancels";
    Record strange = Passed();
    strange.profile = "vulkan-1.3";
    strange.unevaluated = "OpArrayLength is not known";
    run.records = {Passed(),  closer,  Refused(), known,       flaky,
                   skipped,   skipped, hung,      known_crash, Without(Verdict::kCrash, "x"),
                   Outside(), strange};
    EXPECT_EQ(
        SummaryText(run),
        "device                        pass  fail nonconforming known  skip crash timeout  least "
        "margin\n"
        "osmesa:llvmpipe                  4     1             1     2     0     1       0  12.5 %  "
        "optics/snell "
        "(glsl)\n"
        "vulkan:silent@new                0     0             0     0     2     0       1  -\n"
        "held to vulkan-1.3: 300 values, 20 unbounded, 3 outside\n"
        "not evaluated, 1 times: OpArrayLength is not known\n"
        "known failure, 2 times: method: cancels\n"
        "skipped, 2 times: no fragment stage\n"
        "failed once and not again:\n"
        "  optics/fresnel on osmesa:llvmpipe (glsl): ended by signal 9 (Killed)\n");
}

TEST(SummaryText, OwnsUpToWrongBounds) {
    RunRecord run;
    run.records = {Outside()};
    run.records[0].void_bounds = 2;
    EXPECT_THAT(SummaryText(run),
                HasSubstr("\na fault of Etalon's own: 2 bounds by vulkan-1.3 leave out the strict "
                          "evaluation\n"));
}

TEST(SummaryText, IsATableWithoutRecordsToo) {
    RunRecord run;
    run.devices = {Llvmpipe()};
    EXPECT_EQ(
        SummaryText(run),
        "device                        pass  fail nonconforming known  skip crash timeout  least "
        "margin\n"
        "osmesa:llvmpipe                  0     0             0     0     0     0       0  -\n");
}

TEST(DevicesText, ShowsWhatADeviceTells) {
    RunRecord run;
    run.devices = {Llvmpipe(), Silent()};
    run.absent = {{"egl:zink", "libEGL.so.1 is not installed"}};
    const std::string devices =
        "osmesa:llvmpipe\n"
        "  implementation  llvmpipe (LLVM 15.0.6, 256 bits)\n"
        "  driver          Mesa 22.3.6\n"
        "  api             OpenGL 4.5 core, GLSL 450\n"
        "  compiler        LLVM 15.0.6, 256 bits\n"
        "  features        glsl, compute\n"
        "  float controls  RoundingModeRTE\n"
        "  fingerprint     " +
        Fingerprint(Llvmpipe()) +
        "\n"
        "vulkan:silent@new\n"
        "  implementation  Silent\n"
        "  driver          silent 1\n"
        "  api             Vulkan 1.3.0\n"
        "  compiler        not told\n"
        "  features        \n"
        "  float controls  not told\n"
        "  fingerprint     " +
        Fingerprint(Silent()) + "\n";
    EXPECT_EQ(DevicesText(run, false), devices);
    EXPECT_EQ(DevicesText(run, true),
              devices + "not here: egl:zink: libEGL.so.1 is not installed\n");
}

TEST(SlowestText, SumsOverDevicesAndPreparation) {
    RunRecord run;
    run.records = {Passed(), Passed(), Refused()};
    run.records[1].case_path = "a/quick";
    run.records[1].seconds = 0.05;
    run.records[2].device = "vulkan:silent@new";
    run.cases.resize(2);
    run.cases[0].path = "a/quick";
    run.cases[0].seconds = 0.025;
    run.cases[1].path = "optics/fresnel";
    run.cases[1].seconds = 0.175;
    EXPECT_EQ(SlowestText(run, 1),
              " seconds    share  prepared  slowest of 2 cases, 0.5 s in all\n"
              "   0.425   85.0 %     0.175  optics/fresnel\n");
    EXPECT_THAT(SlowestText(run, 9), HasSubstr("\n   0.075   15.0 %     0.025  a/quick\n"));
    EXPECT_EQ(SlowestText({}, 3),
              " seconds    share  prepared  slowest of 0 cases, 0.0 s in all\n");
}

TEST(FiguresText, NamesWhatWasExpectedAndSeen) {
    EXPECT_EQ(FiguresText(Passed()), "");
    Record record = Refused();
    EXPECT_EQ(FiguresText(record), "figure ulp 4 within 0.01, saw inf");
    record.figures.push_back({"value 1 within 0.01", "1.001", true});
    EXPECT_EQ(FiguresText(record),
              "figure ulp 4 within 0.01, saw inf; figure value 1 within 0.01, saw 1.001");
}

TEST(FailureText, TellsHowManyRowsAQuickRunHasLeftOut) {
    Record record = Refused();
    record.all_rows = 5000;
    EXPECT_THAT(FailureText(record), HasSubstr("(100 of 5000 rows, seed 7)"));
}

}  // namespace
}  // namespace etalon
