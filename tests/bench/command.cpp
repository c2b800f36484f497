#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// The command as a whole process: its start beside an empty program linked to the same libraries, rows of CSV
// a second, and memory against the number of rows.

extern char** environ;

namespace {

struct Run {
    double seconds;
    long peak_kib;
};

Run run(const std::vector<std::string>& command) {
    std::vector<char*> argv;
    for (const std::string& part : command) argv.push_back(const_cast<char*>(part.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    const auto begin = std::chrono::steady_clock::now();
    pid_t child = 0;
    if (posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) != 0) std::abort();
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    posix_spawn_file_actions_destroy(&actions);
    return {.seconds = time.count(), .peak_kib = usage.ru_maxrss};
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void write_rows(const std::filesystem::path& path, int rows) {
    std::ofstream out(path);
    out << "id,radius,velocity,alpha\n";
    for (int i = 0; i < rows; ++i) {
        out << i << ',' << 20 + i % 180 << "um," << 1 + i % 19 << "mm/s,0." << 5 * (i % 16) + 10 << '\n';
    }
}

}  // namespace

int main() {
    const std::string program = BIOPRINT_PROGRAM;
    const std::string empty = BIOPRINT_EMPTY;
    std::vector<double> ours;
    std::vector<double> bare;
    for (int i = 0; i < 101; ++i) {  // in turn, so that a busy machine slows both alike
        ours.push_back(run({program}).seconds);
        bare.push_back(run({empty}).seconds);
    }
    std::printf("one query, whole process     %6.2f ms (median of 101)\n", 1e3 * median(ours));
    std::printf("an empty program, same libs  %6.2f ms; ratio %.2f\n", 1e3 * median(bare),
                median(ours) / median(bare));

    const auto table = std::filesystem::temp_directory_path() / "bioprint-bench.csv";
    for (const auto& [model, rows] :
         {std::pair{"ellipsoid", 10000}, {"steady", 10000}, {"steady", 100000}, {"steady", 1000000}}) {
        write_rows(table, rows);
        const Run batch = run({program, "--quiet", "--model", model, "--batch", table.string()});
        std::printf("%7d rows of CSV, %-9s  %6.2f s  %7.0f rows/s  peak %ld MiB\n", rows, model,
                    batch.seconds, rows / batch.seconds, batch.peak_kib / 1024);
    }
    std::filesystem::remove(table);
    return 0;
}
