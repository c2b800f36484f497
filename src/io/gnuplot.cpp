#include "io/gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

constexpr const char* program = "gnuplot";

/// A file without a name, gone when it is closed.
class Scratch {
  public:
    Scratch() : file_(std::tmpfile(), &std::fclose) {
        if (!file_) {
            throw DataError("a temporary file cannot be made: " + std::generic_category().message(errno) +
                            "; make room in /tmp");
        }
    }
    [[nodiscard]] int handle() const { return ::fileno(file_.get()); }

    void fill(std::string_view bytes) {
        if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
            std::fflush(file_.get()) != 0 || ::lseek(handle(), 0, SEEK_SET) != 0) {
            throw DataError("a temporary file cannot be written: " + std::generic_category().message(errno) +
                            "; make room in /tmp");
        }
    }

    [[nodiscard]] std::string content() {
        std::string text;
        std::array<char, 65536> buffer{};
        off_t at = 0;
        for (ssize_t count = 1; count > 0; at += count) {
            count = ::pread(handle(), buffer.data(), buffer.size(), at);
            if (count < 0) throw DataError("a temporary file cannot be read");
            text.append(buffer.data(), static_cast<std::size_t>(count));
        }
        return text;
    }

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// What gnuplot may see of the environment: not its own settings, and no locale.
std::vector<char*> environment() {
    static char locale[] = "LC_ALL=C.UTF-8";
    std::vector<char*> kept = {locale};
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        if (!text.starts_with("GNU") && !text.starts_with("LC_") && !text.starts_with("LANG"))
            kept.push_back(*entry);
    }
    kept.push_back(nullptr);
    return kept;
}

struct Outcome {
    int status;
    std::string out;
    std::string err;
};

Outcome run_gnuplot(const std::string& script) {
    Scratch in;
    Scratch out;
    Scratch err;
    in.fill(script);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.handle(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.handle(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.handle(), STDERR_FILENO);
    std::string name = program;
    std::string defaults = "-d";
    std::array<char*, 3> arguments = {name.data(), defaults.data(), nullptr};
    std::vector<char*> variables = environment();
    pid_t child = 0;
    const int failure = posix_spawnp(&child, program, &actions, nullptr, arguments.data(), variables.data());
    posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) {
        throw DataError("gnuplot cannot be started: " + std::generic_category().message(failure) +
                        "; apt-get install gnuplot-nox");
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out.content(), err.content()};
}

/// The line of gnuplot's complaint that says why: the last one that is not blank.
std::string reason_in(const std::string& text) {
    std::string reason;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (line.find_first_not_of(" \t^") != std::string::npos) reason = line;
        begin = end + 1;
    }
    return reason.substr(std::min(reason.find_first_not_of(" \t"), reason.size()));
}

/// Puts `prefix` before the names inside the tags of an SVG, so that several can stand in one page.
std::string with_own_ids(std::string_view svg, std::string_view prefix) {
    constexpr std::array<std::string_view, 5> before_a_name = {" id=\"", " id='", "href=\"#", "href='#",
                                                               "url(#"};
    std::string out;
    bool in_tag = false;
    while (!svg.empty()) {
        std::size_t taken = 1;
        if (svg.front() == '<') in_tag = true;
        if (svg.front() == '>') in_tag = false;
        for (const std::string_view mark : before_a_name) {
            if (!in_tag || !svg.starts_with(mark)) continue;
            taken = mark.size();
        }
        out += svg.substr(0, taken);
        if (taken > 1) out.append(prefix).append("-");
        svg.remove_prefix(taken);
    }
    return out;
}

/// A terminal's picture without the blanks at the ends of its lines, and without a form feed between two panels.
std::string tidy_lines(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        while (!line.empty() && (line.back() == ' ' || line.back() == '\f')) line.remove_suffix(1);
        if (!line.empty() || !(out.empty() || out.ends_with("\n\n"))) out.append(line).append("\n");
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    while (out.ends_with("\n\n")) out.pop_back();
    return out;
}

}  // namespace

bool gnuplot_installed() {
    const char* const path = std::getenv("PATH");
    const std::string_view folders = path != nullptr ? path : "/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        const std::string folder(folders.substr(begin, end - begin));
        if (::access(((folder.empty() ? "." : folder) + "/" + program).c_str(), X_OK) == 0) return true;
        begin = end + 1;
    }
    return false;
}

void require_gnuplot(const std::string& asker) {
    if (gnuplot_installed()) return;
    throw DataError(asker + ": gnuplot draws the pictures and is not installed; apt-get install gnuplot-nox");
}

std::string draw(const Picture& picture, Canvas canvas, const CanvasSize& size) {
    Outcome outcome = run_gnuplot(gnuplot_script(picture, canvas, size));
    if (outcome.status != 0 || outcome.out.empty()) {
        const std::string reason = reason_in(outcome.err);
        throw DataError("gnuplot could not draw the picture" + (reason.empty() ? "" : ": " + reason) +
                        "; is it gnuplot 5.4 or newer?");
    }
    if (canvas == Canvas::terminal) return tidy_lines(outcome.out);
    return canvas == Canvas::svg ? with_own_ids(outcome.out, picture.name) : std::move(outcome.out);
}

}  // namespace bioprint
