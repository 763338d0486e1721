#include "app/serve/report_server.h"

#include <httplib.h>
#include <sys/socket.h>

#include <stdexcept>
#include <thread>

#include "app/cli/usage_error.h"
#include "app/output/folder_files.h"

namespace limitgauge::app {
namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kChunk = std::size_t{1} << 18;
constexpr std::size_t kThreads = 8;

/// Nothing is kept, guessed, framed or told to others. What is no page can do nothing at all.
void secure(httplib::Response& response, bool is_page) {
  response.set_header("Cache-Control", "no-store");
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  // The page brings its own policy for scripts and styles; both hold.
  response.set_header("Content-Security-Policy",
                      is_page ? "frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
                              : "default-src 'none'; frame-ancestors 'none'; sandbox");
}

void refuse(httplib::Response& response, int status, const std::string& why) {
  response.status = status;
  secure(response, false);
  response.set_content(why + "\n", "text/plain; charset=utf-8");
}

void send(std::shared_ptr<const OpenFile> file, const std::string& path,
          httplib::Response& response) {
  const std::string type = media_type(path);
  secure(response, path.ends_with(".html"));
  if (file->bytes() == 0) {
    response.set_content("", type);
    return;
  }
  const std::size_t bytes = file->bytes();
  response.set_content_provider(
      bytes, type,
      [file = std::move(file)](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        const std::string part = file->read(offset, std::min(length, kChunk));
        return !part.empty() && sink.write(part.data(), part.size());
      });
}

}  // namespace

class ReportServer::Impl {
 public:
  Impl(const std::filesystem::path& folder, int port);
  int port() const { return port_; }
  void serve(const std::atomic<bool>& stop);

 private:
  using Answered = httplib::Server::HandlerResponse;
  void answer(const httplib::Request& request, httplib::Response& response) const;
  /// Says no before anything is looked up.
  Answered admit(const httplib::Request& request, httplib::Response& response) const;

  FolderFiles files_;
  httplib::Server server_;
  int port_ = 0;
};

ReportServer::Impl::Impl(const std::filesystem::path& folder, int port) : files_(folder) {
  // The library's own choice lets two programs share a port; then each gets half of the requests.
  server_.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server_.set_payload_max_length(0);
  server_.set_tcp_nodelay(true);
  // Whoever is silent is not waited for, so that Ctrl-C ends it soon.
  server_.set_keep_alive_timeout(1);
  server_.set_read_timeout(2);
  server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server_.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        return admit(request, response);
      });
  server_.Get(".*", [this](const httplib::Request& request, httplib::Response& response) {
    answer(request, response);
  });
  port_ = port == 0 ? server_.bind_to_any_port(kLoopback) : port;
  const bool bound = port == 0 ? port_ > 0 : server_.bind_to_port(kLoopback, port);
  if (!bound) {
    throw UsageError("cannot listen on " + std::string(kLoopback) +
                     (port == 0 ? "" : ":" + std::to_string(port)) +
                     "; expected a port that is free and allowed");
  }
}

ReportServer::Impl::Answered ReportServer::Impl::admit(const httplib::Request& request,
                                                       httplib::Response& response) const {
  const std::string host = request.get_header_value("Host");
  const std::string port = ":" + std::to_string(port_);
  if (request.get_header_value_count("Host") != 1 ||
      (host != kLoopback + port && host != "localhost" + port)) {
    refuse(response, 403, "This server answers to 127.0.0.1 only.");
    return Answered::Handled;
  }
  if (request.method == "GET" || request.method == "HEAD") return Answered::Unhandled;
  refuse(response, 405, "This server only shows files.");
  response.set_header("Allow", "GET, HEAD");
  return Answered::Handled;
}

void ReportServer::Impl::answer(const httplib::Request& request,
                                httplib::Response& response) const {
  // Anything but a path from the root is none of this folder's names.
  const bool rooted = request.path.starts_with('/');
  const std::string path =
      request.path == "/" ? "report.html" : request.path.substr(rooted ? 1 : 0);
  std::shared_ptr<const OpenFile> file = rooted ? files_.open(path) : nullptr;
  if (file) {
    send(std::move(file), path, response);
  } else {
    refuse(response, 404, "There is no such file in this report.");
  }
}

void ReportServer::Impl::serve(const std::atomic<bool>& stop) {
  constexpr std::chrono::milliseconds kLook{50};
  std::atomic<bool> ended = false;
  std::thread listener([&] {
    server_.listen_after_bind();
    ended = true;
  });
  while (!stop && !ended) std::this_thread::sleep_for(kLook);
  // A server that has not come as far as running would not hear it.
  while (!ended && !server_.is_running()) std::this_thread::sleep_for(kLook);
  server_.stop();
  listener.join();
  if (!stop) throw std::runtime_error("the server on " + std::string(kLoopback) + " has ended");
}

ReportServer::ReportServer(const std::filesystem::path& folder, int port)
    : impl_(std::make_unique<Impl>(folder, port)) {}

ReportServer::~ReportServer() = default;

std::string ReportServer::address() const {
  return "http://" + std::string(kLoopback) + ":" + std::to_string(impl_->port()) + "/";
}

void ReportServer::serve(const std::atomic<bool>& stop) {
  impl_->serve(stop);
}

}  // namespace limitgauge::app
