#include "worker/channel.h"

#include <sys/socket.h>

#include <cerrno>

#include "worker/message.h"

namespace etalon {

Channel::Step Channel::Send(std::string_view& rest) {
    while (!rest.empty()) {
        const ssize_t sent =
            send(socket_.number(), rest.data(), rest.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
        if (sent >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(sent));
        } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
            return Step::kBlocked;
        } else if (errno != EINTR) {
            return Step::kClosed;
        }
    }
    return Step::kDone;
}

Channel::Step Channel::Receive(std::string& message) {
    char block[1 << 16];
    for (;;) {
        const ssize_t got = recv(socket_.number(), block, sizeof block, MSG_DONTWAIT);
        if (got == 0) {
            return Step::kClosed;
        }
        if (got < 0) {
            if (errno == EINTR) {
                continue;
            }
            return errno == EAGAIN || errno == EWOULDBLOCK ? Step::kBlocked : Step::kClosed;
        }
        received_.append(block, static_cast<std::size_t>(got));
        if (received_.size() < kFrameBytes) {
            continue;
        }
        const std::uint64_t size = FramedSize(received_);
        const std::uint64_t body = received_.size() - kFrameBytes;
        if (size > limit_ || body > size) {
            return Step::kMalformed;
        }
        if (body == size) {
            message.assign(received_, kFrameBytes);
            received_.clear();
            return Step::kDone;
        }
    }
}

}  // namespace etalon
