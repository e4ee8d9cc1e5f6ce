// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/channel.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>

namespace patina {
namespace {

union AttachmentSpace {
    cmsghdr alignment;
    std::array<char, CMSG_SPACE(sizeof(int))> bytes;
};

msghdr messageOf(iovec& text, AttachmentSpace& space) {
    msghdr message{};
    message.msg_iov = &text;
    message.msg_iovlen = 1;
    message.msg_control = space.bytes.data();
    message.msg_controllen = space.bytes.size();
    return message;
}

void attach(msghdr& message, int descriptor) {
    cmsghdr* part = CMSG_FIRSTHDR(&message);
    part->cmsg_level = SOL_SOCKET;
    part->cmsg_type = SCM_RIGHTS;
    part->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(part), &descriptor, sizeof descriptor);
}

FileHandle attachmentOf(msghdr& message) {
    const cmsghdr* part = CMSG_FIRSTHDR(&message);
    if (part == nullptr || part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS ||
        part->cmsg_len != CMSG_LEN(sizeof(int))) {
        return FileHandle();
    }
    int descriptor = -1;
    std::memcpy(&descriptor, CMSG_DATA(part), sizeof descriptor);
    return FileHandle(descriptor);
}

} // namespace

std::pair<FileHandle, FileHandle> Channel::pair() {
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return {};
    }
    return {FileHandle(ends[0]), FileHandle(ends[1])};
}

bool Channel::send(const Message& message, int attachment) const {
    std::string bytes = encoded(message);
    iovec text{bytes.data(), bytes.size()};
    AttachmentSpace space{};
    msghdr packet = messageOf(text, space);
    if (attachment >= 0) {
        attach(packet, attachment);
    } else {
        packet.msg_control = nullptr;
        packet.msg_controllen = 0;
    }
    ssize_t sent = -1;
    do {
        sent = ::sendmsg(socket_.get(), &packet, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent == static_cast<ssize_t>(bytes.size());
}

tl::expected<std::optional<Channel::Delivery>, Channel::Fault>
Channel::receive(std::chrono::milliseconds patience) const {
    pollfd waiting{socket_.get(), POLLIN, 0};
    const int timeout = patience.count() < 0 ? -1 : static_cast<int>(patience.count());
    if (::poll(&waiting, 1, timeout) <= 0) {
        return std::optional<Delivery>();
    }
    std::string bytes(maxMessageBytes, '\0');
    iovec text{bytes.data(), bytes.size()};
    AttachmentSpace space{};
    msghdr packet = messageOf(text, space);
    const ssize_t size = ::recvmsg(socket_.get(), &packet, MSG_CMSG_CLOEXEC);
    if (size <= 0) {
        return tl::unexpected(Fault::closed);
    }
    FileHandle attachment = attachmentOf(packet);
    auto message = decodedMessage(std::as_bytes(std::span(bytes).first(std::size_t(size))));
    if (!message || (packet.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0) {
        return tl::unexpected(Fault::malformed);
    }
    return Delivery{std::move(*message), std::move(attachment)};
}

} // namespace patina
