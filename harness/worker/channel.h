// One end of the socket between a client and its worker, which carries whole messages: requests one
// way, answers the other, never two at a time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worker/descriptor.h"

namespace etalon {

class Channel {
  public:
    // What a step came to; no step blocks, raises a signal or throws.
    enum class Step : std::uint8_t {
        kDone,
        kBlocked,    // call again when poll() says so
        kClosed,     // the other end is gone
        kMalformed,  // the other end sent what is no message, or one beyond the limit
    };

    Channel(Descriptor socket, std::uint64_t limit) : socket_(std::move(socket)), limit_(limit) {}

    int descriptor() const { return socket_.number(); }

    // Sends as much of the framed message (message.h) as goes now and cuts it off its front.
    Step Send(std::string_view& rest);

    // Collects a message; at kDone it stands in `message`, without its frame.
    Step Receive(std::string& message);

  private:
    Descriptor socket_;
    std::uint64_t limit_;   // of a message to be received, in bytes
    std::string received_;  // so far
};

}  // namespace etalon
