// Throughput of the CSV reader and writer and of the parser of quantities, on a file made in memory.

#include <chrono>
#include <cstdio>
#include <string>

#include "bioprint/io/number_format.hpp"
#include "bioprint/io/quantity.hpp"
#include "io/csv.hpp"

using namespace bioprint;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string make_file(int rows) {
    std::string text = "sample,radius [um],flow rate,alpha\n";
    for (int i = 0; i < rows; ++i) {
        text += "\"run, " + std::to_string(i) + "\"," + format_shortest(40.0 + i % 100 * 0.1) + "um,";
        text += format_shortest(100.0 + i % 37) + " uL/h," + format_shortest(i % 100 * 0.01) + "\n";
    }
    return text;
}

}  // namespace

int main() {
    constexpr int rows = 500'000;
    const std::string text = make_file(rows);
    const double megabytes = static_cast<double>(text.size()) / 1e6;

    MemoryBytes bytes(text);
    CsvReader reader(bytes, "bench");
    auto start = Clock::now();
    std::size_t fields = 0;
    while (reader.next()) fields += reader.record().fields.size();
    double time = seconds_since(start);
    std::printf("read      %7.0f MB/s  %6.2f million rows/s  (%zu fields)\n", megabytes / time,
                rows / time / 1e6, fields);

    MemoryBytes again(text);
    CsvReader parsed(again, "bench");
    start = Clock::now();
    double sum = 0.0;
    while (parsed.next()) {
        const auto& row = parsed.record().fields;
        sum += parse_quantity(row[1], Dimension::length, "radius");
        sum += parse_quantity(row[2], Dimension::volume_flow, "flow rate");
        sum += parse_quantity(row[3], Dimension::dimensionless, "alpha");
    }
    time = seconds_since(start);
    std::printf("and parse %7.0f MB/s  %6.2f million rows/s  (sum %g)\n", megabytes / time, rows / time / 1e6,
                sum);

    CsvWriter writer{CsvDialect{}};
    start = Clock::now();
    std::size_t written = 0;
    for (int i = 0; i < rows; ++i) {
        writer.add_raw("\"run, 17\",43.2um,120 uL/h,0.75");
        for (int k = 1; k <= 10; ++k) writer.add_number(i * 1.2345e-7 / k);
        writer.end_row();
        if (writer.text().size() > 1'000'000) {
            written += writer.text().size();
            writer.clear();
        }
    }
    time = seconds_since(start);
    written += writer.text().size();
    std::printf("write     %7.0f MB/s  %6.2f million rows/s of 10 numbers\n",
                static_cast<double>(written) / 1e6 / time, rows / time / 1e6);
    return 0;
}
