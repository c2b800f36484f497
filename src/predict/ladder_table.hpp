#pragma once

#include <array>
#include <limits>

#include "bioprint/predict/ladder.hpp"

// Made by tools/make-trade from data/trade.json.
namespace bioprint {

// clang-format off
inline constexpr std::array<RungRecord, 34> ladder_table{{
    {QuestionKind::exit_flow, Rung::steady, 0.0, std::numeric_limits<double>::infinity(), 0.233, 5.79e-06, 1.44e-05, 6, 0},
    {QuestionKind::exit_flow, Rung::ellipsoid, 0.0, std::numeric_limits<double>::infinity(), 0.233, 0.000204, 0.000344, 6, 0},
    {QuestionKind::exit_flow, Rung::draft, 0.0, std::numeric_limits<double>::infinity(), 0.00134, 0.216, 0.234, 6, 0},
    {QuestionKind::exit_flow, Rung::standard, 0.0, std::numeric_limits<double>::infinity(), 0.000368, 1.23, 1.66, 6, 0},
    {QuestionKind::exit_flow, Rung::fine, 0.0, std::numeric_limits<double>::infinity(), 0.000263, 10.3, 12.6, 6, 0},
    {QuestionKind::channel, Rung::steady, 0.0, 0.1, 0.175, 5.71e-06, 6.92e-06, 5, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.0, 0.1, 0.175, 0.0011, 0.0019, 5, 0},
    {QuestionKind::channel, Rung::draft, 0.0, 0.1, 0.0483, 0.0148, 0.0204, 5, 0},
    {QuestionKind::channel, Rung::standard, 0.0, 0.1, 0.0222, 0.134, 0.217, 5, 0},
    {QuestionKind::channel, Rung::fine, 0.0, 0.1, 0.00741, 0.88, 4.19, 5, 0},
    {QuestionKind::channel, Rung::steady, 0.1, 1.0, 0.14, 6.9e-06, 2.08e-05, 6, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.1, 1.0, 0.14, 0.00027, 0.000359, 6, 0},
    {QuestionKind::channel, Rung::draft, 0.1, 1.0, 0.0507, 0.0303, 0.0631, 6, 0},
    {QuestionKind::channel, Rung::standard, 0.1, 1.0, 0.0349, 0.272, 0.471, 6, 0},
    {QuestionKind::channel, Rung::fine, 0.1, 1.0, 0.0116, 1.97, 6.63, 6, 0},
    {QuestionKind::channel, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.748, 1.59e-05, 2.22e-05, 7, 0},
    {QuestionKind::channel, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.748, 0.000152, 0.000262, 7, 0},
    {QuestionKind::channel, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.698, 0.357, 0.489, 7, 0},
    {QuestionKind::channel, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 1.25, 1.77, 2.15, 7, 2},
    {QuestionKind::channel, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.415, 8.96, 10.9, 7, 3},
    {QuestionKind::exit, Rung::steady, 0.0, 0.1, 0.423, 4.76e-06, 6.02e-06, 6, 0},
    {QuestionKind::exit, Rung::ellipsoid, 0.0, 0.1, 0.062, 0.000798, 0.0015, 6, 0},
    {QuestionKind::exit, Rung::draft, 0.0, 0.1, 0.314, 0.181, 0.223, 6, 0},
    {QuestionKind::exit, Rung::standard, 0.0, 0.1, 0.0444, 1.42, 2.8, 6, 0},
    {QuestionKind::exit, Rung::fine, 0.0, 0.1, 0.0443, 11.4, 23.8, 6, 0},
    {QuestionKind::exit, Rung::steady, 0.1, 1.0, 1.53, 6.43e-06, 2e-05, 5, 1},
    {QuestionKind::exit, Rung::ellipsoid, 0.1, 1.0, 0.0683, 0.000279, 0.000352, 5, 0},
    {QuestionKind::exit, Rung::draft, 0.1, 1.0, 0.0824, 0.278, 1.18, 5, 0},
    {QuestionKind::exit, Rung::standard, 0.1, 1.0, 0.0164, 2.29, 9.66, 5, 0},
    {QuestionKind::exit, Rung::fine, 0.1, 1.0, 0.0109, 18.0, 40.6, 4, 0},
    {QuestionKind::exit, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.975, 0.000158, 0.00024, 7, 0},
    {QuestionKind::exit, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 17.6, 1.03, 2.31, 7, 0},
    {QuestionKind::exit, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 1.31, 6.15, 19.9, 7, 1},
    {QuestionKind::exit, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.54, 37.1, 39.0, 4, 3},
}};
// clang-format on

}  // namespace bioprint
