#include "app/serve/listener.h"

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "app/cli/usage_error.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace {

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

int port_of(int socket) {
  sockaddr_in address{};
  socklen_t bytes = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &bytes);
  return ntohs(address.sin_port);
}

bool listens(int socket, int port) {
  // Not SO_REUSEPORT: two programs that share a port get half of the requests each.
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const sockaddr_in address = loopback(port);
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
         ::listen(socket, SOMAXCONN) == 0;
}

}  // namespace

Listener::Listener(int port)
    : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  if (socket_ < 0)
    throw model::ResourceError(std::string("limitgauge: error: there is no socket to listen on: ") +
                               std::strerror(errno));
  if (!listens(socket_, port)) {
    ::close(socket_);
    throw UsageError("cannot listen on 127.0.0.1" + (port == 0 ? "" : ":" + std::to_string(port)) +
                     "; expected a port that is free and allowed");
  }
  port_ = port_of(socket_);
}

Listener::~Listener() {
  ::close(socket_);
}

Listener::Accepted Listener::accept() const {
  const int client = ::accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (client >= 0) {
    // The end of an answer is not held back for what may follow.
    const int yes = 1;
    ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    return {client, false};
  }
  if (errno == EBADF || errno == EINVAL || errno == ENOTSOCK)
    throw std::runtime_error(std::string("the server on 127.0.0.1 has ended: ") +
                             std::strerror(errno));
  // Nobody there any more; whatever else it is, it may be there again at once.
  const bool nobody =
      errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR || errno == ECONNABORTED;
  return {-1, !nobody};
}

}  // namespace limitgauge::app
