#include "bioprint/predict/prediction.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

// Predictions a second on one core, without input and output, beside the parts they are made of. A bound for
// the whole is the time of its flow and its three ellipsoids.

using namespace bioprint;

namespace {

Case paper_case() {
    return {.radius = 50e-6,
            .length = std::nullopt,
            .drive = Drive::velocity,
            .drive_value = 5e-3,
            .ink = {.name = "alginate-2.5",
                    .source = "",
                    .law = CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75}},
            .cell = {.name = "reference", .source = "", .radius = 8e-6, .shear_modulus = 1e3},
            .positions = {},
            .needle = std::nullopt,
            .transient = false};
}

/// Median of the time a call takes [µs], over runs of many calls each.
template <class Call>
double microseconds(const Call& call) {
    constexpr int runs = 15;
    constexpr int calls = 1000;
    std::vector<double> times;
    for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i) call(i);
        const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
        times.push_back(time.count() / calls);
    }
    std::sort(times.begin(), times.end());
    return times[runs / 2];
}

}  // namespace

int main() {
    double sum = 0.0;
    Case question = paper_case();
    const double radius = microseconds([&](int i) {
        question.drive_value = 5e-3 * (1.0 + 1e-5 * i);
        sum += predict(question).nozzle.stress_max;
    });
    const double ink = microseconds([&](int i) {
        std::get<CrossInk>(question.ink.law).alpha = 0.5 + 1e-5 * i;
        sum += predict(question).nozzle.stress_max;
    });
    question = paper_case();
    question.positions = {{0.0}};
    const double centred = microseconds([&](int i) {
        question.drive_value = 5e-3 * (1.0 + 1e-5 * i);
        sum += predict(question).nozzle.stress_max;
    });
    question = paper_case();
    question.transient = true;
    const double carried = microseconds([&](int i) {
        question.drive_value = 5e-3 * (1.0 + 1e-5 * i);
        sum += predict(question).nozzle.stress_max;
    });
    std::printf("the same with the ellipsoid in time       %7.2f us  %8.0f a second and core\n", carried,
                1e6 / carried);
    std::printf("prediction, four positions, same ink      %7.2f us  %8.0f a second and core\n", radius,
                1e6 / radius);
    std::printf("prediction, four positions, new ink       %7.2f us  %8.0f a second and core\n", ink,
                1e6 / ink);
    std::printf("prediction, centred cell alone            %7.2f us  %8.0f a second and core\n", centred,
                1e6 / centred);
    return sum > 0.0 ? 0 : 1;
}
