// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <array>
#include <cerrno>
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
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <boost/system/system_error.hpp>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <carom/collision/expects.hpp>
#include <carom/subjects/protocol/child.hpp>
#include <carom/subjects/protocol/shortage.hpp>

namespace carom::subjects::protocol {
namespace {

namespace asio = boost::asio;
namespace process = boost::process;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds glance{50};

/// Puts the child into a group of its own, and undoes what this process did to its signals. A signal that the parent of
/// this process left ignored, as nohup does, stays ignored. On Linux, the child also ends if the thread that started it
/// ends.
struct AsProgramsExpect : process::extend::handler {
  template <class Executor>
  void on_exec_setup(Executor& /*unused*/) const {
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const int signal : {SIGPIPE, SIGXFSZ}) {
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

/// While an object lives, a write to a closed pipe on this thread fails, and sends no SIGPIPE. The host's own handling
/// of the signal stays as it is.
class NoSignalOfBrokenPipes {
 public:
  NoSignalOfBrokenPipes() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
  }
  ~NoSignalOfBrokenPipes() {
    const timespec at_once{};
    if (!was_pending_) {
      while (sigtimedwait(&pipe_, nullptr, &at_once) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoSignalOfBrokenPipes(const NoSignalOfBrokenPipes&) = delete;
  NoSignalOfBrokenPipes& operator=(const NoSignalOfBrokenPipes&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

}  // namespace

/// A child process that this process has not waited for. While it is such a child, running or ended, the system gives
/// its number to no other process and to no other group.
class UnreapedChild {
 public:
  explicit UnreapedChild(pid_t process) : process_(process) {}
  /// Kills the group that the child leads, and the child itself, which may have left the group. Then waits for it. If
  /// somebody else has waited for the child, nothing is killed, because the number may be another process's.
  ~UnreapedChild() {
    siginfo_t ignored{};
    if (waitid(P_PID, id(), &ignored, WEXITED | WNOHANG | WNOWAIT) != 0) {
      return;
    }
    ::kill(-process_, SIGKILL);
    ::kill(process_, SIGKILL);
    while (waitid(P_PID, id(), &ignored, WEXITED) != 0 && errno == EINTR) {
    }
  }
  UnreapedChild(const UnreapedChild&) = delete;
  UnreapedChild& operator=(const UnreapedChild&) = delete;

  [[nodiscard]] bool is_running() {
    return end_.si_pid == 0 && waitid(P_PID, id(), &end_, WEXITED | WNOHANG | WNOWAIT) == 0 && end_.si_pid == 0;
  }

  /// Precondition: it does not run.
  [[nodiscard]] bool has_succeeded() const { return end_.si_code == CLD_EXITED && end_.si_status == 0; }

  /// The end of a sentence about its end. Precondition: it does not run.
  [[nodiscard]] std::string how_it_ended() const {
    if (end_.si_pid == 0) {
      return "ended, and another part of this process took its status";
    }
    if (end_.si_code == CLD_EXITED) {
      return "ended with status " + std::to_string(end_.si_status);
    }
    return "was ended by signal " + std::to_string(end_.si_status) + " (" + strsignal(end_.si_status) + ")";
  }

 private:
  [[nodiscard]] id_t id() const { return static_cast<id_t>(process_); }

  pid_t process_;
  siginfo_t end_{};  // si_pid is 0 as long as no end is known
};

class ChildProcess::State {
 public:
  State(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop)
      : limits_(limits), stop_(std::move(stop)) {
    const std::lock_guard lock(start_mutex());
    for (std::optional<process::async_pipe>* pipe : {&input_, &output_, &errors_}) {
      pipe->emplace(context_);
      keep_to_this_process(**pipe);
    }
    std::error_code failure;
    const std::vector<std::string> arguments(words.begin() + 1, words.end());
    process::child started(process::exe = program_path(words[0]), process::args = arguments,
                           process::std_in<*input_, process::std_out> * output_, process::std_err > *errors_,
                           AsProgramsExpect(), failure);
    if (failure) {
      throw ChildError("'" + words[0] + "' cannot be run: " + message_of(failure) +
                       (shortage(failure).empty() ? "; check the path and its permissions" : ""));
    }
    child_.emplace(started.id());
    started.detach();
    read_errors();
  }

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
        wait("wrote no line within ",
             "; it must write one line for each request and flush it (--timeout gives it more time)");
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
    while (child_->is_running()) {
      wait("did not end within ", " after the request to stop");
    }
    if (!child_->has_succeeded()) {
      throw ChildError(child_->how_it_ended() + " after the request to stop");
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
    const NoSignalOfBrokenPipes guard;
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
    if (poll_one()) {
      return;
    }
    if (Clock::now() >= deadline_) {
      if (!child_->is_running()) {
        throw ChildError(child_->how_it_ended() + ", but another process keeps its output open");
      }
      const std::chrono::duration<double> seconds = limits_.timeout;
      std::string text = std::to_string(seconds.count());
      text.erase(text.find_last_not_of('0') + 1);
      text.erase(text.find_last_not_of('.') + 1);
      throw ChildError(too_late + text + " s" + after);
    }
    run_one(glance);
  }

  bool poll_one() {
    const NoSignalOfBrokenPipes guard;
    context_.restart();
    return context_.poll_one() > 0;
  }

  void run_one(Clock::duration at_most) {
    constexpr std::chrono::milliseconds moment{1};
    const NoSignalOfBrokenPipes guard;
    context_.restart();
    if (context_.run_one_for(at_most) == 0 && context_.stopped()) {
      std::this_thread::sleep_for(std::min<Clock::duration>(at_most, moment));  // nothing is pending
    }
  }

  std::string how_it_ended() {
    // The process may still be ending.
    const auto until = Clock::now() + std::min<Clock::duration>(limits_.timeout, std::chrono::seconds(1));
    while (child_->is_running() && Clock::now() < until) {
      run_one(std::chrono::milliseconds(1));
    }
    return child_->is_running() ? std::string("closed its standard output") : child_->how_it_ended();
  }

  ChildLimits limits_;
  std::stop_token stop_;
  asio::io_context context_;
  std::optional<process::async_pipe> input_;
  std::optional<process::async_pipe> output_;
  std::optional<process::async_pipe> errors_;
  std::optional<UnreapedChild> child_;
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

ChildProcess::ChildProcess(const std::vector<std::string>& words, const ChildLimits& limits, std::stop_token stop) {
  CAROM_EXPECTS(!words.empty());
  const auto fail = [&](const std::error_code& error) {
    throw ChildError("'" + words[0] + "' cannot be run: " + message_of(error));
  };
  try {
    state_ = std::make_unique<State>(words, limits, std::move(stop));
  } catch (const std::system_error& error) {
    fail(error.code());
  } catch (const boost::system::system_error& error) {
    fail({error.code().value(), std::generic_category()});
  }
}

ChildProcess::~ChildProcess() = default;

void ChildProcess::exchange(const std::string& text, std::size_t count,
                            const std::function<void(std::string_view)>& on_line) {
  state_->exchange(text, count, on_line);
}

void ChildProcess::finish(const std::string& text) { state_->finish(text); }

std::string ChildProcess::standard_error() { return state_->standard_error(); }

}  // namespace carom::subjects::protocol
