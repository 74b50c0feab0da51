#include "worker/shared_memory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace etalon {
namespace {

TEST(SharedMemory, IsSeenByBothSidesAndKeepsItsWordsAsItGrows) {
    auto client = SharedMemory::Create();
    ASSERT_TRUE(client);
    SharedMemory worker(Descriptor(dup(client->descriptor())));

    const Batch small{3, 2, 1};
    client->Reserve(small);
    worker.Reserve(small);
    ASSERT_EQ(client->Inputs(small).size(), 6u);
    ASSERT_EQ(client->Outputs(small).size(), 3u);
    client->Inputs(small)[5] = 55;
    EXPECT_EQ(worker.Inputs(small)[5], 55u);
    worker.Outputs(small)[0] = 66;
    EXPECT_EQ(client->Outputs(small)[0], 66u);
    EXPECT_EQ(client->Inputs(small)[5], 55u);

    const Batch large{1u << 20, 3, 2};
    client->Reserve(large);
    worker.Reserve(large);
    EXPECT_EQ(client->Inputs(large)[5], 55u);
    worker.Outputs(large).back() = 77;
    EXPECT_EQ(client->Outputs(large).back(), 77u);
}

TEST(SharedMemory, InputsAndOutputsShareNoWord) {
    auto memory = SharedMemory::Create();
    ASSERT_TRUE(memory);
    for (const std::uint32_t rows : {1u, 1023u, 1024u, 1025u}) {
        const Batch batch{rows, 1, 1};
        memory->Reserve(batch);
        EXPECT_GE(memory->Outputs(batch).data(),
                  memory->Inputs(batch).data() + memory->Inputs(batch).size());
    }
}

TEST(SharedMemory, CannotBeShrunkByAWorker) {
    auto memory = SharedMemory::Create();
    ASSERT_TRUE(memory);
    memory->Reserve({1, 1, 1});
    EXPECT_NE(ftruncate(memory->descriptor(), 0), 0);
}

TEST(SharedMemory, AFreshWorkerDoesNotShrinkIt) {
    auto client = SharedMemory::Create();
    ASSERT_TRUE(client);
    client->Reserve({1u << 20, 4, 4});
    SharedMemory worker(Descriptor(dup(client->descriptor())));
    worker.Reserve({1, 1, 1});
    worker.Inputs({1, 1, 1})[0] = 9;
    EXPECT_EQ(client->Inputs({1, 1, 1})[0], 9u);
}

TEST(SharedMemoryDeathTest, WantsTheBatchReserved) {
    auto memory = SharedMemory::Create();
    ASSERT_TRUE(memory);
    memory->Reserve({1, 1, 1});
    EXPECT_DEATH(memory->Inputs({1u << 30, 1, 1}), "internal error");
}

}  // namespace
}  // namespace etalon
