#pragma once

#include <array>
#include <limits>

#include "bioprint/predict/ladder.hpp"

// Made by tools/make-trade from data/trade.json.
namespace bioprint {

// clang-format off
inline constexpr std::array<RungRecord, 33> ladder_table{{
    {QuestionKind::exit_flow, Rung::steady, 0.0, std::numeric_limits<double>::infinity(), 0.233, 8.37e-06, 2.23e-05, 6, 0},
    {QuestionKind::exit_flow, Rung::ellipsoid, 0.0, std::numeric_limits<double>::infinity(), 0.233, 0.00135, 0.00159, 6, 0},
    {QuestionKind::exit_flow, Rung::draft, 0.0, std::numeric_limits<double>::infinity(), 0.00134, 0.28, 0.339, 6, 0},
    {QuestionKind::exit_flow, Rung::standard, 0.0, std::numeric_limits<double>::infinity(), 0.000368, 1.57, 2.05, 6, 0},
    {QuestionKind::exit_flow, Rung::fine, 0.0, std::numeric_limits<double>::infinity(), 0.000263, 13.6, 15.9, 6, 0},
    {QuestionKind::channel, Rung::steady, 0.0, 0.1, 0.124, 6.26e-06, 6.92e-06, 5, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.0, 0.1, 0.124, 0.00241, 0.00865, 5, 0},
    {QuestionKind::channel, Rung::draft, 0.0, 0.1, 0.0624, 0.0174, 0.0253, 5, 0},
    {QuestionKind::channel, Rung::standard, 0.0, 0.1, 0.0127, 0.131, 1.02, 5, 0},
    {QuestionKind::channel, Rung::fine, 0.0, 0.1, 0.005, 1.18, 2.88, 5, 0},
    {QuestionKind::channel, Rung::steady, 0.1, 1.0, 0.0757, 6.82e-06, 2.45e-05, 6, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.1, 1.0, 0.0757, 0.00152, 0.00205, 6, 0},
    {QuestionKind::channel, Rung::draft, 0.1, 1.0, 0.0629, 0.0674, 0.68, 6, 0},
    {QuestionKind::channel, Rung::standard, 0.1, 1.0, 0.0418, 0.436, 5.09, 6, 0},
    {QuestionKind::channel, Rung::fine, 0.1, 1.0, 0.0139, 3.69, 31.8, 6, 0},
    {QuestionKind::channel, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.491, 1.54e-05, 2.5e-05, 7, 4},
    {QuestionKind::channel, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.491, 0.00124, 0.00178, 7, 4},
    {QuestionKind::channel, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.681, 1.22, 1.93, 7, 4},
    {QuestionKind::channel, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.674, 10.8, 17.2, 7, 4},
    {QuestionKind::channel, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.00736, 47.5, 47.5, 5, 4},
    {QuestionKind::exit, Rung::steady, 0.0, 0.1, 0.426, 4.76e-06, 6.02e-06, 6, 0},
    {QuestionKind::exit, Rung::ellipsoid, 0.0, 0.1, 0.0636, 0.000798, 0.0015, 6, 0},
    {QuestionKind::exit, Rung::draft, 0.0, 0.1, 0.256, 0.225, 0.275, 6, 0},
    {QuestionKind::exit, Rung::standard, 0.0, 0.1, 0.0439, 2.06, 4.1, 6, 0},
    {QuestionKind::exit, Rung::fine, 0.0, 0.1, 0.036, 18.1, 23.7, 6, 0},
    {QuestionKind::exit, Rung::steady, 0.1, 1.0, 1.52, 6.43e-06, 2e-05, 5, 1},
    {QuestionKind::exit, Rung::ellipsoid, 0.1, 1.0, 0.0245, 0.000279, 0.000352, 5, 0},
    {QuestionKind::exit, Rung::draft, 0.1, 1.0, 0.0785, 0.402, 2.42, 5, 0},
    {QuestionKind::exit, Rung::standard, 0.1, 1.0, 0.0164, 2.82, 17.1, 5, 0},
    {QuestionKind::exit, Rung::fine, 0.1, 1.0, 0.00982, 26.1, 26.1, 3, 0},
    {QuestionKind::exit, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.712, 0.000158, 0.00024, 7, 4},
    {QuestionKind::exit, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.448, 2.02, 6.43, 7, 4},
    {QuestionKind::exit, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.112, 19.5, 52.5, 7, 4},
}};
// clang-format on

}  // namespace bioprint
