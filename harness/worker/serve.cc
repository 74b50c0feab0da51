#include "worker/serve.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "device/backends.h"
#include "worker/channel.h"
#include "worker/message.h"
#include "worker/process.h"
#include "worker/shared_memory.h"

namespace etalon {
namespace {

// How far allocations may go beyond the limit of resident memory: what is reserved and never used,
// such as the stacks of a driver's threads.
constexpr std::uint64_t kReserve = 1ull << 30;

// Ends this process with its parent. False if no client started it.
bool BindToParent() {
    ucred parent = {};
    socklen_t size = sizeof parent;
    if (getsockopt(kWorkerSocket, SOL_SOCKET, SO_PEERCRED, &parent, &size) != 0) {
        return false;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // It may have died before that call.
    return getppid() == parent.pid;
}

void LowerLimit(__rlimit_resource resource, std::uint64_t value) {
    rlimit limit = {};
    getrlimit(resource, &limit);
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, value);
    setrlimit(resource, &limit);
}

// Where memory grows faster than the client looks, the allocation fails, and if the machine's
// memory ends, this process is the one to go.
void LimitMemory(std::uint64_t bytes) {
    std::ofstream("/proc/self/oom_score_adj") << 1000;
    // Data and not the address space: a graphics driver maps much that is no memory. On top of
    // what there is: a sanitizer's shadow counts as data.
    std::uint64_t pages = 0;
    std::ifstream statistics("/proc/self/statm");
    for (int field = 0; field < 6; ++field) {
        statistics >> pages;
    }
    if (statistics && bytes < RLIM_INFINITY / 2) {
        const auto page_size = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
        LowerLimit(RLIMIT_DATA, pages * page_size + bytes + kReserve);
    }
}

void WaitFor(const Channel& channel, short events) {
    pollfd watched = {channel.descriptor(), events, 0};
    poll(&watched, 1, -1);
}

// False where the client is gone.
bool Receive(Channel& channel, std::string& message) {
    for (;;) {
        const Channel::Step step = channel.Receive(message);
        if (step != Channel::Step::kBlocked) {
            return step == Channel::Step::kDone;
        }
        WaitFor(channel, POLLIN);
    }
}

bool Send(Channel& channel, std::string_view message) {
    for (;;) {
        const Channel::Step step = channel.Send(message);
        if (step != Channel::Step::kBlocked) {
            return step == Channel::Step::kDone;
        }
        WaitFor(channel, POLLOUT);
    }
}

// One answer for each kind of request.
class Server {
  public:
    explicit Server(SharedMemory memory) : memory_(std::move(memory)) {}

    std::string operator()(const OpenRequest& request) {
        LimitMemory(request.memory_bytes);
        auto opened = OpenDevice(request.candidate);
        if (!opened) {
            return EncodeAnswer<DeviceInfo>(opened.error());
        }
        device_ = std::move(*opened);
        return EncodeAnswer<DeviceInfo>(device_->info());
    }

    std::string operator()(const Program& program) {
        ETALON_CHECK(device_ != nullptr);
        const DeviceResult<std::uint32_t> handle = device_->Load(program);
        if (handle) {
            widths_[*handle] = {program.input_words, program.output_words};
        }
        return EncodeAnswer(handle);
    }

    std::string operator()(const RunRequest& request) {
        const Batch& batch = request.batch;
        ETALON_CHECK(device_ != nullptr && batch.rows <= device_->info().max_rows);
        ETALON_CHECK(widths_.contains(request.handle));
        ETALON_CHECK(widths_.at(request.handle) ==
                     std::pair(batch.input_words, batch.output_words));
        memory_.Reserve(batch);
        RunTime time;
        const DeviceResult<Nothing> done =
            device_->Run(request.handle, batch.rows, memory_.Inputs(batch), memory_.Outputs(batch),
                         request.is_timed ? &time : nullptr);
        return EncodeAnswer<RunTime>(done ? DeviceResult<RunTime>(time) : done.error());
    }

  private:
    SharedMemory memory_;
    std::unique_ptr<Device> device_;
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> widths_;  // by handle
};

}  // namespace

int ServeWorker(int argc, char** argv) {
    if (!BindToParent()) {
        std::fprintf(stderr, "%s worker: is for this program's own use\n",
                     argc > 0 ? argv[0] : "etalon");
        return 2;
    }
    // Not for what a driver may start.
    fcntl(kWorkerSocket, F_SETFD, FD_CLOEXEC);
    fcntl(kWorkerMemory, F_SETFD, FD_CLOEXEC);
    // 1 and not 0, which a core pattern that names a program ignores.
    LowerLimit(RLIMIT_CORE, 1);

    Channel channel(Descriptor(kWorkerSocket), std::numeric_limits<std::uint64_t>::max());
    Server server{SharedMemory(Descriptor(kWorkerMemory))};
    std::string message;
    while (Receive(channel, message)) {
        const auto request = DecodeRequest(message);
        ETALON_CHECK(request);
        if (!Send(channel, std::visit(server, *request))) {
            break;
        }
    }
    return 0;
}

}  // namespace etalon
