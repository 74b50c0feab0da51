#include "run/sweep_journal.h"

#include <gmock/gmock.h>

#include <limits>

#include "numeric/ulp.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

SweepHeader Header() {
    SweepHeader header;
    header.version = "1";
    header.case_path = "a b/c";
    header.content = "0123";
    header.device = "null:echo";
    header.driver = "of nobody, null 1";
    header.fingerprint = "abc";
    header.recipe = "spirv";
    header.columns = {{"n", Scalar::kInt}, {"x", Scalar::kFloat}};
    header.swept = 1;
    header.from = ToBits(-1.0f);
    header.to = ToBits(1.0f);
    header.fixed = "n: 3 values";
    header.settings = 3;
    header.block_rows = 1u << 28;
    header.outputs = {{"result", Scalar::kFloat, "ulp 16"}};
    return header;
}

// What was found of a block: one error of its own, others as everywhere.
SweptColumn Found(const SweepHeader& header, std::uint64_t block) {
    SweptColumn column;
    const std::uint64_t first = header.FirstRow(block);
    const std::uint64_t rows = header.FirstRow(block + 1) - first;
    const double own = block % 3 == 0 ? 40.25 : static_cast<double>(block);
    column.summary.judged = rows;
    column.histogram.counts()[0] = rows - 1;
    column.histogram.Add(own);
    SweptValue value;
    value.row = first + 7;
    value.inputs = {block == 0 ? 0xffffffffu : 5u, ToBits(0.1f)};
    value.actual = ToBits(std::numeric_limits<float>::quiet_NaN());
    value.expected = 1.0 / 3;
    value.judgement.error = std::numeric_limits<double>::infinity();
    value.judgement.ulp_error = own;
    value.judgement.used = own / 16;
    column.summary.worst_ulp_error = own;
    column.summary.worst_used = own / 16;
    column.summary.worst_ulp_at = column.summary.worst_used_at = value.row;
    column.worst_ulp = column.worst_used = value;
    if (own > 16) {
        column.summary.refused = 1;
        column.summary.first_refused = value.row;
        column.first_refused = value;
    }
    return column;
}

SweepJournal Journal(SweepShard shard, std::uint64_t left = 0) {
    SweepJournal journal = *NewJournal(Header(), shard);
    for (; journal.next < journal.end - left; ++journal.next) {
        journal.found[0].Add(Found(journal.header, journal.next));
    }
    return journal;
}

TEST(SweepHeader, SharesRowsOutToBlocks) {
    const SweepHeader header = Header();
    // Both signs of 1, of all smaller floats and of 0.
    EXPECT_EQ(header.Floats(), 2 * (std::uint64_t{0x3f800000} + 1));
    EXPECT_EQ(header.BlocksPerSetting(), 8u);
    EXPECT_EQ(header.Blocks(), 24u);
    EXPECT_EQ(header.FirstRow(0), 0u);
    EXPECT_EQ(header.FirstRow(7), 7u << 28);
    EXPECT_EQ(header.FirstRow(8), header.Floats());
    EXPECT_EQ(header.FirstRow(24), 3 * header.Floats());
}

TEST(SweepJournal, ReadsBack) {
    for (const std::uint64_t left : {0u, 4u, 24u}) {
        const SweepJournal journal = Journal({}, left);
        const std::string text = JournalText(journal);
        const auto read = ParseJournal("j", text);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(JournalText(*read), text);
        EXPECT_EQ(SweepText(RecordOf(*read)), SweepText(RecordOf(journal)));
        EXPECT_EQ(Difference(read->header, journal.header), "");
    }
}

// Whatever is cut off, and whichever character is another, it is noticed.
TEST(SweepJournal, KnowsThatItWasCutOrChanged) {
    const std::string text = JournalText(Journal({}));
    for (std::size_t length = 0; length < text.size(); ++length) {
        EXPECT_FALSE(ParseJournal("j", text.substr(0, length))) << length;
    }
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string changed = text;
        changed[at] = changed[at] == '3' ? '4' : '3';
        EXPECT_FALSE(ParseJournal("j", changed)) << at;
    }
    EXPECT_EQ(ParseJournal("j", text.substr(0, 500)).error().message,
              "j: is a journal that was cut or changed; remove it to begin anew");
    EXPECT_EQ(ParseJournal("j", "no journal").error().message, "j: is no journal of a sweep");
    EXPECT_FALSE(ParseJournal("j", text + "\n"));
}

// A kill between two blocks: what is read goes on as what was never written.
TEST(SweepJournal, GoesOn) {
    const std::string whole = JournalText(Journal({}));
    for (std::uint64_t left = 1; left <= 24; ++left) {
        SweepJournal journal = *ParseJournal("j", JournalText(Journal({}, left)));
        for (; journal.next < journal.end; ++journal.next) {
            journal.found[0].Add(Found(journal.header, journal.next));
        }
        EXPECT_EQ(JournalText(journal), whole);
    }
}

TEST(SweepJournal, ShardsTakeEachBlockOnce) {
    for (const std::uint64_t count : {1u, 2u, 5u, 7u, 24u}) {
        std::uint64_t next = 0;
        for (std::uint64_t index = 1; index <= count; ++index) {
            const SweepJournal journal = *NewJournal(Header(), {index, count});
            EXPECT_EQ(journal.first, next);
            next = journal.end;
        }
        EXPECT_EQ(next, 24u);
    }
    EXPECT_EQ(NewJournal(Header(), {1, 25}).error().message,
              "--shard 1/25: there are 24 blocks to share out, and none for this one");
}

class MergeTest : public testing::Test {
  protected:
    std::filesystem::path Write(const std::string& name, const SweepJournal& journal) const {
        return folder_.Write(name, JournalText(journal));
    }
    std::vector<std::filesystem::path> Shards(std::uint64_t count) const {
        std::vector<std::filesystem::path> paths;
        for (std::uint64_t index = 1; index <= count; ++index) {
            paths.push_back(Write("j" + std::to_string(index), Journal({index, count})));
        }
        return paths;
    }
    static std::string Why(const std::vector<std::filesystem::path>& paths) {
        const auto merged = MergeJournals(paths);
        return merged ? "" : merged.error().message;
    }

    Folder folder_;
};

TEST_F(MergeTest, IsTheSameAsOneRun) {
    const SweepJournal whole = Journal({});
    for (const std::uint64_t count : {1u, 2u, 5u, 24u}) {
        auto paths = Shards(count);
        std::rotate(paths.begin(), paths.begin() + static_cast<std::ptrdiff_t>(count / 2),
                    paths.end());
        const auto merged = MergeJournals(paths);
        ASSERT_TRUE(merged) << merged.error().message;
        EXPECT_EQ(JournalText(*merged), JournalText(whole));
        EXPECT_EQ(SweepText(RecordOf(*merged)), SweepText(RecordOf(whole)));
        EXPECT_EQ(SweepJson(RecordOf(*merged)), SweepJson(RecordOf(whole)));
    }
}

TEST_F(MergeTest, SaysWhatIsWrong) {
    auto paths = Shards(4);
    EXPECT_THAT(Why({paths[0], paths[1], paths[3]}),
                EndsWith("the shard of the blocks 13 to 18 of 24 is missing"));
    EXPECT_THAT(Why({paths[1], paths[2], paths[3]}),
                EndsWith("the shard of the blocks 1 to 6 of 24 is missing"));
    EXPECT_THAT(Why({paths[0], paths[1], paths[2]}),
                EndsWith("the shard of the blocks 19 to 24 of 24 is missing"));
    const auto wide = Write("wide", Journal({1, 3}));
    EXPECT_EQ(Why({wide, paths[1], paths[2], paths[3]}),
              paths[1].string() + ": has blocks that " + wide.string() + " has too");
    const auto open = Write("open", Journal({2, 4}, 2));
    EXPECT_EQ(Why({paths[0], open, paths[2], paths[3]}),
              open.string() + ": is not finished (4 of 6 blocks); run its sweep again");
    SweepJournal other = Journal({2, 4});
    other.header.fingerprint = "def";
    const auto foreign = Write("foreign", other);
    EXPECT_EQ(Why({paths[0], foreign}), foreign.string() + ": is of another sweep than " +
                                            paths[0].string() +
                                            ": 'fingerprint' is 'def', not 'abc'");
    EXPECT_THAT(Why({folder_.path() / "none"}), HasSubstr("No such file"));
}

TEST(SweepRecord, TellsTheWorstAndItsInput) {
    const SweepRecord record = RecordOf(Journal({}));
    EXPECT_EQ(record.verdict, Verdict::kFail);
    EXPECT_EQ(record.outputs[0].refused, 8u + 5u);
    const std::string text = SweepText(record);
    EXPECT_THAT(text, HasSubstr("a b/c on null:echo (spirv): fail\n"));
    EXPECT_THAT(text, HasSubstr("  swept     x, every float from -1 to 1: 2130706434, 3 times\n"));
    // Of equal errors the first.
    EXPECT_THAT(text, HasSubstr("    input     n=-1, x=0.1\n"));
    EXPECT_THAT(text, HasSubstr("--at n=-1,x=0x1.99999ap-4\n"));
    EXPECT_THAT(text, HasSubstr("    up to 64                    8    0.0000 %\n"));
}

}  // namespace
}  // namespace etalon
