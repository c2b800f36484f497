#pragma once

#include <array>
#include <limits>

#include "bioprint/predict/ladder.hpp"

// Made by tools/make-trade from data/trade.json.
namespace bioprint {

// clang-format off
inline constexpr std::array<RungRecord, 63> ladder_table{{
    {QuestionKind::exit_flow, Rung::steady, 0.0, std::numeric_limits<double>::infinity(), 0.233, 7.99e-06, 2.14e-05, 6, 0},
    {QuestionKind::exit_flow, Rung::ellipsoid, 0.0, std::numeric_limits<double>::infinity(), 0.233, 0.00114, 0.00127, 6, 0},
    {QuestionKind::exit_flow, Rung::draft, 0.0, std::numeric_limits<double>::infinity(), 0.00134, 0.28, 0.339, 6, 0},
    {QuestionKind::exit_flow, Rung::standard, 0.0, std::numeric_limits<double>::infinity(), 0.000368, 1.57, 2.05, 6, 0},
    {QuestionKind::exit_flow, Rung::fine, 0.0, std::numeric_limits<double>::infinity(), 0.000263, 13.6, 15.9, 6, 0},
    {QuestionKind::channel, Rung::steady, 0.0, 0.1, 0.124, 5.76e-06, 6.23e-06, 5, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.0, 0.1, 0.124, 0.00492, 0.00542, 5, 0},
    {QuestionKind::channel, Rung::draft, 0.0, 0.1, 0.0624, 0.0174, 0.0253, 5, 0},
    {QuestionKind::channel, Rung::standard, 0.0, 0.1, 0.0127, 0.131, 1.02, 5, 0},
    {QuestionKind::channel, Rung::fine, 0.0, 0.1, 0.005, 1.18, 2.88, 5, 0},
    {QuestionKind::channel, Rung::steady, 0.1, 1.0, 0.0757, 7.66e-06, 2.15e-05, 6, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.1, 1.0, 0.0757, 0.00122, 0.0017, 6, 0},
    {QuestionKind::channel, Rung::draft, 0.1, 1.0, 0.0629, 0.0674, 0.68, 6, 0},
    {QuestionKind::channel, Rung::standard, 0.1, 1.0, 0.0418, 0.436, 5.09, 6, 0},
    {QuestionKind::channel, Rung::fine, 0.1, 1.0, 0.0139, 3.69, 31.8, 6, 0},
    {QuestionKind::channel, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.459, 1.59e-05, 2.17e-05, 7, 4},
    {QuestionKind::channel, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.459, 0.00104, 0.00108, 7, 4},
    {QuestionKind::channel, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.283, 1.22, 1.93, 7, 4},
    {QuestionKind::channel, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.0221, 10.8, 17.2, 7, 4},
    {QuestionKind::channel, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.00736, 47.5, 47.5, 5, 4},
    {QuestionKind::exit, Rung::steady, 0.0, 0.1, 0.426, 5.77e-06, 6.74e-06, 6, 0},
    {QuestionKind::exit, Rung::ellipsoid, 0.0, 0.1, 0.0783, 0.00381, 0.00548, 6, 0},
    {QuestionKind::exit, Rung::draft, 0.0, 0.1, 0.256, 0.225, 0.275, 6, 0},
    {QuestionKind::exit, Rung::standard, 0.0, 0.1, 0.0439, 2.06, 4.1, 6, 0},
    {QuestionKind::exit, Rung::fine, 0.0, 0.1, 0.036, 18.1, 23.7, 6, 0},
    {QuestionKind::exit, Rung::steady, 0.1, 1.0, 1.52, 7.94e-06, 2.08e-05, 5, 1},
    {QuestionKind::exit, Rung::ellipsoid, 0.1, 1.0, 0.0583, 0.00117, 0.0013, 5, 0},
    {QuestionKind::exit, Rung::draft, 0.1, 1.0, 0.0785, 0.402, 2.42, 5, 0},
    {QuestionKind::exit, Rung::standard, 0.1, 1.0, 0.0164, 2.82, 17.1, 5, 0},
    {QuestionKind::exit, Rung::fine, 0.1, 1.0, 0.00982, 26.1, 26.1, 3, 0},
    {QuestionKind::exit, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.603, 0.00105, 0.00115, 7, 4},
    {QuestionKind::exit, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.448, 2.02, 6.43, 7, 4},
    {QuestionKind::exit, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.112, 19.5, 52.5, 7, 4},
    {QuestionKind::channel_off_axis, Rung::steady, 0.0, 0.1, 0.0968, 7.23e-06, 7.33e-06, 5, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.0968, 0.00275, 0.00462, 5, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.0, 0.1, 0.122, 0.12, 0.387, 5, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.0, 0.1, 0.121, 1.65, 13.2, 5, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 0.1, 1.0, 0.122, 5.44e-06, 9.52e-06, 5, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.1, 1.0, 0.122, 0.00115, 0.00136, 5, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.1, 1.0, 0.119, 1.17, 17.7, 5, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.1, 1.0, 0.0821, 22.2, 34.9, 4, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.151, 6.02e-06, 1.11e-05, 8, 7},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.151, 0.000919, 0.00135, 8, 7},
    {QuestionKind::channel_off_axis, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.0237, 3.38, 3.38, 8, 7},
    {QuestionKind::channel_off_axis, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.025, 126.0, 126.0, 8, 7},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.309, 0.00319, 0.00476, 5, 0},
    {QuestionKind::exit_off_axis, Rung::draft, 0.0, 0.1, 0.145, 7.81, 11.2, 5, 0},
    {QuestionKind::exit_off_axis, Rung::standard, 0.0, 0.1, 0.145, 40.5, 40.5, 1, 0},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 0.1, 1.0, 0.0529, 0.00115, 0.00133, 5, 1},
    {QuestionKind::exit_off_axis, Rung::draft, 0.1, 1.0, 0.1, 5.18, 9.65, 5, 1},
    {QuestionKind::exit_off_axis, Rung::standard, 0.1, 1.0, 0.0854, 41.3, 49.7, 2, 0},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.085, 0.000931, 0.00117, 8, 7},
    {QuestionKind::exit_off_axis, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.1, 15.3, 15.3, 8, 7},
    {QuestionKind::shear, Rung::steady, 0.0, 0.1, 0.0, 4.57e-06, 4.57e-06, 1, 0},
    {QuestionKind::shear, Rung::ellipsoid, 0.0, 0.1, 0.00572, 0.0036, 0.0036, 1, 0},
    {QuestionKind::shear, Rung::draft, 0.0, 0.1, 0.0911, 0.377, 0.377, 1, 0},
    {QuestionKind::shear, Rung::standard, 0.0, 0.1, 0.000653, 48.7, 48.7, 1, 0},
    {QuestionKind::shear, Rung::steady, 0.1, 1.0, 0.0, 3.7e-06, 4.35e-06, 2, 0},
    {QuestionKind::shear, Rung::ellipsoid, 0.1, 1.0, 0.0162, 0.000802, 0.000819, 2, 0},
    {QuestionKind::shear, Rung::draft, 0.1, 1.0, 0.067, 0.452, 0.605, 2, 0},
    {QuestionKind::shear, Rung::standard, 0.1, 1.0, 0.0126, 21.3, 24.4, 2, 0},
    {QuestionKind::shear, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.0, 5.46e-06, 5.59e-06, 3, 0},
    {QuestionKind::shear, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.0247, 0.000768, 0.000811, 3, 0},
}};
// clang-format on

}  // namespace bioprint
