// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/write.hpp>
#include <boost/process/args.hpp>
#include <boost/process/async_pipe.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/environment.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/group.hpp>
#include <boost/process/io.hpp>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <carom/collision/expects.hpp>
#include <carom/subjects/protocol/child.hpp>
#include <carom/subjects/protocol/mark.hpp>

namespace carom::subjects::protocol {
namespace {

namespace asio = boost::asio;
namespace process = boost::process;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds glance{50};

/// Resets the child's signals to their defaults. On Linux, the child also ends if the thread that started it ends.
struct AsProgramsExpect : process::extend::handler {
  template <class Executor>
  void on_exec_setup(Executor& /*unused*/) const {
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ}) {
      std::signal(signal, SIG_DFL);
    }
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  }
};

/// Serialises starts, because a child that inherits the pipes of another child keeps them open.
std::mutex& start_mutex() {
  static std::mutex mutex;
  return mutex;
}

void keep_to_this_process(process::async_pipe& pipe) {
  for (const int end : {pipe.native_source(), pipe.native_sink()}) {
    if (end >= 0) {
      fcntl(end, F_SETFD, FD_CLOEXEC);
    }
  }
}

std::string program_path(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    return name;
  }
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::string candidate = (folder.empty() ? "." : folder) + '/' + name;
    if (access(candidate.c_str(), X_OK) == 0 && std::filesystem::is_regular_file(candidate)) {
      return candidate;
    }
  }
  throw ChildError("'" + name + "' was not found on PATH; check the name, or give a path");
}

/// A write to a child that has ended must not end this process.
void ignore_broken_pipes() {
  struct sigaction current {};
  sigaction(SIGPIPE, nullptr, &current);
  if (current.sa_handler == SIG_DFL) {
    std::signal(SIGPIPE, SIG_IGN);
  }
}

std::string end_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

class ChildProcess::State {
 public:
  State(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop)
      : limits_(limits), stop_(std::move(stop)) {
    const std::lock_guard lock(start_mutex());
    ignore_broken_pipes();
    for (std::optional<process::async_pipe>* pipe : {&input_, &output_, &errors_}) {
      pipe->emplace(context_);
      keep_to_this_process(**pipe);
    }
    std::error_code failure;
    const std::vector<std::string> arguments(words.begin() + 1, words.end());
    process::environment environment = boost::this_process::environment();
    environment.set(mark_of_children(), "1");  // operator[] of Boost 1.74 reads past the end of shorter entries
    child_ = process::child(process::exe = program_path(words[0]), process::args = arguments, environment,
                            process::std_in<*input_, process::std_out> * output_, process::std_err > *errors_, group_,
                            AsProgramsExpect(), failure);
    if (failure) {
      throw ChildError("'" + words[0] + "' cannot be run: " + failure.message() +
                       "; check the path and its permissions");
    }
    read_errors();
  }

  ~State() {
    kill();
    std::error_code ignored;
    child_.wait(ignored);
  }

  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void exchange(const std::string& text, std::size_t count, const std::function<void(std::string_view)>& on_line) {
    write(text);
    deadline_ = Clock::now() + limits_.timeout;
    while (count > 0) {
      if (const std::optional<std::string> line = next_line()) {
        --count;
        on_line(*line);
        deadline_ = Clock::now() + limits_.timeout;  // time spent in on_line does not count
      } else if (output_ended_) {
        throw ChildError(how_it_ended());
      } else {
        read_output();
        wait("wrote no line within ", "; it must write one line for each request and flush it");
      }
    }
    while (is_writing_) {  // the child may reply before it has read the whole text
      wait("did not read its standard input within ");
    }
  }

  void finish(const std::string& text) {
    write(text);
    deadline_ = Clock::now() + limits_.timeout;
    while (is_writing_) {
      wait("did not read its standard input within ");
    }
    input_->close();
    while (!output_ended_) {
      if (!unread_.empty()) {
        throw ChildError("wrote more lines than there were requests: " + beginning(unread_));
      }
      read_output();
      wait("did not end within ", " after the request to stop");
    }
    if (!unread_.empty()) {
      throw ChildError("wrote more lines than there were requests: " + beginning(unread_));
    }
    while (is_running()) {
      wait("did not end within ", " after the request to stop");
    }
    if (child_.native_exit_code() != 0) {
      throw ChildError(end_of(child_.native_exit_code()) + " after the request to stop");
    }
  }

  std::string standard_error() {
    // Waits briefly for text that is already written.
    const auto until = Clock::now() + glance;
    while (!errors_ended_ && Clock::now() < until) {
      run_one(until - Clock::now());
    }
    return kept_errors_;
  }

 private:
  static std::string beginning(const std::string& text) {
    constexpr std::size_t most = 80;
    const std::string line = text.substr(0, text.find('\n'));
    return line.size() > most ? line.substr(0, most) + "…" : line;
  }

  void write(const std::string& text) {
    text_ = text;
    is_writing_ = true;
    asio::async_write(*input_, asio::buffer(text_), [this](const boost::system::error_code&, std::size_t) {
      // A failed write is no error, because a process that stops reading also stops replying.
      is_writing_ = false;
    });
  }

  void read_output() {
    if (is_reading_ || output_ended_) {
      return;
    }
    is_reading_ = true;
    output_->async_read_some(asio::buffer(chunk_), [this](const boost::system::error_code& failure, std::size_t size) {
      is_reading_ = false;
      output_ended_ = static_cast<bool>(failure);
      unread_.append(chunk_.data(), size);
    });
  }

  void read_errors() {
    errors_->async_read_some(asio::buffer(errors_chunk_),
                             [this](const boost::system::error_code& failure, std::size_t size) {
                               kept_errors_.append(errors_chunk_.data(), size);
                               if (kept_errors_.size() > limits_.standard_error) {
                                 kept_errors_.erase(0, kept_errors_.size() - limits_.standard_error);
                               }
                               errors_ended_ = static_cast<bool>(failure);
                               if (!errors_ended_) {
                                 read_errors();
                               }
                             });
  }

  std::optional<std::string> next_line() {
    const std::size_t end = unread_.find('\n', searched_);
    if (end == std::string::npos) {
      unread_.erase(0, begin_);
      begin_ = 0;
      searched_ = unread_.size();
      if (searched_ > limits_.line) {
        throw ChildError("wrote a line of more than " + std::to_string(limits_.line) + " bytes: " + beginning(unread_));
      }
      return std::nullopt;
    }
    std::string line = unread_.substr(begin_, end - begin_);
    begin_ = searched_ = end + 1;
    if (line.size() > limits_.line) {
      throw ChildError("wrote a line of more than " + std::to_string(limits_.line) + " bytes: " + beginning(line));
    }
    if (begin_ == unread_.size()) {
      unread_.clear();
      begin_ = searched_ = 0;
    }
    return line;
  }

  /// Handles one event, or waits for at most `glance`. Throws ChildError if the user asks for a stop, or if no event is
  /// ready and the deadline has passed.
  void wait(const char* too_late, const char* after = "") {
    if (stop_.stop_requested()) {
      throw ChildError("was stopped by the user");
    }
    context_.restart();
    if (context_.poll_one() > 0) {
      return;
    }
    if (Clock::now() >= deadline_) {
      if (!is_running()) {
        throw ChildError(end_of(child_.native_exit_code()) + ", but another process keeps its output open");
      }
      const std::chrono::duration<double> seconds = limits_.timeout;
      std::string text = std::to_string(seconds.count());
      text.erase(text.find_last_not_of('0') + 1);
      text.erase(text.find_last_not_of('.') + 1);
      throw ChildError(too_late + text + " s" + after);
    }
    run_one(glance);
  }

  void run_one(Clock::duration at_most) {
    constexpr std::chrono::milliseconds moment{1};
    context_.restart();
    if (context_.run_one_for(at_most) == 0 && context_.stopped()) {
      std::this_thread::sleep_for(std::min<Clock::duration>(at_most, moment));  // nothing is pending
    }
  }

  bool is_running() {
    std::error_code ignored;
    return child_.running(ignored);
  }

  std::string how_it_ended() {
    // The process may still be ending.
    const auto until = Clock::now() + std::min<Clock::duration>(limits_.timeout, std::chrono::seconds(1));
    while (is_running() && Clock::now() < until) {
      run_one(std::chrono::milliseconds(1));
    }
    return is_running() ? std::string("closed its standard output") : end_of(child_.native_exit_code());
  }

  /// Kills the process group, and the child itself, which may have left the group.
  void kill() {
    std::error_code ignored;
    group_.terminate(ignored);
    child_.terminate(ignored);
  }

  ChildLimits limits_;
  std::stop_token stop_;
  asio::io_context context_;
  std::optional<process::async_pipe> input_;
  std::optional<process::async_pipe> output_;
  std::optional<process::async_pipe> errors_;
  process::group group_;
  process::child child_;
  Clock::time_point deadline_;

  std::string text_;
  bool is_writing_ = false;

  std::array<char, 65536> chunk_{};
  bool is_reading_ = false;
  bool output_ended_ = false;
  std::string unread_;        // standard output that was not returned yet
  std::size_t begin_ = 0;     // start of the next line in unread_
  std::size_t searched_ = 0;  // no line end between begin_ and here

  std::array<char, 65536> errors_chunk_{};
  bool errors_ended_ = false;
  std::string kept_errors_;
};

ChildProcess::ChildProcess(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop)
    : state_((CAROM_EXPECTS(!words.empty()), std::make_unique<State>(words, limits, std::move(stop)))) {}

ChildProcess::~ChildProcess() = default;

void ChildProcess::exchange(const std::string& text, std::size_t count,
                            const std::function<void(std::string_view)>& on_line) {
  state_->exchange(text, count, on_line);
}

void ChildProcess::finish(const std::string& text) { state_->finish(text); }

std::string ChildProcess::standard_error() { return state_->standard_error(); }

}  // namespace carom::subjects::protocol
