#include "worker/channel.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "worker/message.h"

namespace etalon {
namespace {

using Step = Channel::Step;

struct Ends {
    explicit Ends(std::uint64_t limit) : Ends(limit, Pair()) {}
    Ends(std::uint64_t limit, std::pair<int, int> pair)
        : near(Descriptor(pair.first), limit), far(pair.second) {}

    static std::pair<int, int> Pair() {
        int ends[2] = {-1, -1};
        EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
        return {ends[0], ends[1]};
    }
    void Write(std::string_view text) const {
        EXPECT_EQ(write(far.number(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }

    Channel near;
    Descriptor far;
};

std::string Frame(std::string_view body) {
    const std::uint64_t size = body.size();
    return std::string(reinterpret_cast<const char*>(&size), sizeof size).append(body);
}

TEST(Channel, CollectsAMessageFromPieces) {
    Ends ends(100);
    std::string message;
    for (const char c : Frame("hello")) {
        EXPECT_EQ(ends.near.Receive(message), Step::kBlocked);
        ends.Write({&c, 1});
    }
    EXPECT_EQ(ends.near.Receive(message), Step::kDone);
    EXPECT_EQ(message, "hello");
    ends.Write(Frame(""));
    EXPECT_EQ(ends.near.Receive(message), Step::kDone);
    EXPECT_EQ(message, "");
}

TEST(Channel, RefusesWhatIsNoMessage) {
    std::string message;
    Ends longer(4);
    longer.Write(Frame("hello"));
    EXPECT_EQ(longer.near.Receive(message), Step::kMalformed);
    Ends two(100);
    two.Write(Frame("hello") + Frame("hello"));
    EXPECT_EQ(two.near.Receive(message), Step::kMalformed);
}

TEST(Channel, SeesTheOtherEndGo) {
    Ends ends(100);
    ends.Write(Frame("hello").substr(0, 10));
    ends.far = Descriptor();
    std::string message;
    EXPECT_EQ(ends.near.Receive(message), Step::kClosed);
    std::string_view rest = "into the void";
    EXPECT_EQ(ends.near.Send(rest), Step::kClosed);  // and no SIGPIPE
}

TEST(Channel, SendsInStepsWhereTheOtherEndIsSlow) {
    Ends ends(0);
    const std::string much(4u << 20, 'x');
    std::string_view rest = much;
    EXPECT_EQ(ends.near.Send(rest), Step::kBlocked);
    EXPECT_LT(rest.size(), much.size());
    EXPECT_GT(rest.size(), 0u);
    std::size_t read_so_far = 0;
    char block[1 << 16];
    while (read_so_far < much.size()) {
        const ssize_t got = read(ends.far.number(), block, sizeof block);
        ASSERT_GT(got, 0);
        read_so_far += static_cast<std::size_t>(got);
        ends.near.Send(rest);
    }
    EXPECT_TRUE(rest.empty());
}

}  // namespace
}  // namespace etalon
