#pragma once

#include <array>
#include <limits>

#include "bioprint/predict/ladder.hpp"

// Made by tools/make-trade from data/trade.json.
namespace bioprint {

// clang-format off
inline constexpr std::array<RungRecord, 64> ladder_table{{
    {QuestionKind::exit_flow, Rung::steady, 0.0, std::numeric_limits<double>::infinity(), 0.23344, 7.99414e-06, 2.14314e-05, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::ellipsoid, 0.0, std::numeric_limits<double>::infinity(), 0.23344, 0.00113668, 0.00126968, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::draft, 0.0, std::numeric_limits<double>::infinity(), 0.00134066, 0.280073, 0.339299, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::standard, 0.0, std::numeric_limits<double>::infinity(), 0.000368174, 1.57143, 2.05361, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::fine, 0.0, std::numeric_limits<double>::infinity(), 0.000263112, 13.5742, 15.8951, 6, 0, 0},
    {QuestionKind::channel, Rung::steady, 0.0, 0.1, 0.123618, 5.75806e-06, 6.22949e-06, 5, 0, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.0, 0.1, 0.123618, 0.00492082, 0.00541567, 5, 0, 0},
    {QuestionKind::channel, Rung::draft, 0.0, 0.1, 0.0623947, 0.017413, 0.025306, 5, 0, 0},
    {QuestionKind::channel, Rung::standard, 0.0, 0.1, 0.0127297, 0.130826, 1.01904, 5, 0, 0},
    {QuestionKind::channel, Rung::fine, 0.0, 0.1, 0.005, 1.18084, 2.87991, 5, 0, 0},
    {QuestionKind::channel, Rung::steady, 0.1, 1.0, 0.0757174, 7.65979e-06, 2.15166e-05, 6, 0, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.1, 1.0, 0.0757174, 0.00122004, 0.00170297, 6, 0, 0},
    {QuestionKind::channel, Rung::draft, 0.1, 1.0, 0.0628728, 0.067362, 0.679787, 6, 0, 0},
    {QuestionKind::channel, Rung::standard, 0.1, 1.0, 0.0417576, 0.435923, 5.09163, 6, 0, 0},
    {QuestionKind::channel, Rung::fine, 0.1, 1.0, 0.0139192, 3.69138, 31.7631, 6, 0, 0},
    {QuestionKind::channel, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.458817, 1.58758e-05, 2.17376e-05, 7, 4, 0},
    {QuestionKind::channel, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.458817, 0.00103761, 0.00107898, 7, 4, 0},
    {QuestionKind::channel, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.282712, 1.22272, 1.9302, 7, 4, 4},
    {QuestionKind::channel, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.0220784, 10.8116, 17.2217, 7, 4, 4},
    {QuestionKind::channel, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.00735948, 47.4848, 47.4848, 5, 4, 4},
    {QuestionKind::exit, Rung::steady, 0.0, 0.1, 0.425783, 5.76892e-06, 6.73535e-06, 6, 0, 0},
    {QuestionKind::exit, Rung::ellipsoid, 0.0, 0.1, 0.0783069, 0.00380612, 0.00548267, 6, 0, 0},
    {QuestionKind::exit, Rung::draft, 0.0, 0.1, 0.255638, 0.2246, 0.275144, 6, 0, 0},
    {QuestionKind::exit, Rung::standard, 0.0, 0.1, 0.0438603, 2.0604, 4.09777, 6, 0, 0},
    {QuestionKind::exit, Rung::fine, 0.0, 0.1, 0.0360031, 18.1491, 23.6599, 6, 0, 0},
    {QuestionKind::exit, Rung::steady, 0.1, 1.0, 1.51717, 7.93799e-06, 2.07608e-05, 5, 1, 1},
    {QuestionKind::exit, Rung::ellipsoid, 0.1, 1.0, 0.058271, 0.00117351, 0.00129758, 5, 0, 0},
    {QuestionKind::exit, Rung::draft, 0.1, 1.0, 0.0785349, 0.40208, 2.42353, 5, 0, 0},
    {QuestionKind::exit, Rung::standard, 0.1, 1.0, 0.0164474, 2.81635, 17.1306, 5, 0, 0},
    {QuestionKind::exit, Rung::fine, 0.1, 1.0, 0.00981597, 26.0513, 26.1139, 3, 0, 0},
    {QuestionKind::exit, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.60295, 0.001051, 0.00114927, 7, 4, 0},
    {QuestionKind::exit, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.448041, 2.02264, 6.43456, 7, 4, 4},
    {QuestionKind::exit, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.11201, 19.4516, 52.4715, 7, 4, 4},
    {QuestionKind::channel_off_axis, Rung::steady, 0.0, 0.1, 0.0967855, 7.22681e-06, 7.33325e-06, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.0967855, 0.00274717, 0.0046208, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.0, 0.1, 0.12196, 0.119887, 0.386938, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.0, 0.1, 0.121118, 1.64602, 13.2173, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 0.1, 1.0, 0.121852, 5.44067e-06, 9.51611e-06, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.1, 1.0, 0.121852, 0.00115352, 0.00135741, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.1, 1.0, 0.119482, 1.17148, 17.6635, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.1, 1.0, 0.0821326, 22.1645, 34.8748, 4, 0, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.150672, 6.01635e-06, 1.11095e-05, 8, 7, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.150672, 0.000918918, 0.00134686, 8, 7, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.0237271, 3.37984, 3.37984, 8, 7, 7},
    {QuestionKind::channel_off_axis, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.025, 126.132, 126.132, 8, 7, 7},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.32654, 0.003188, 0.00475867, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::draft, 0.0, 0.1, 0.151104, 7.80908, 11.1602, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::standard, 0.0, 0.1, 0.151104, 40.4795, 141.452, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 0.1, 1.0, 0.15897, 0.00114636, 0.00132889, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::draft, 0.1, 1.0, 0.0854485, 5.18357, 9.64722, 5, 1, 1},
    {QuestionKind::exit_off_axis, Rung::standard, 0.1, 1.0, 0.0854485, 49.7412, 1659.08, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.148852, 0.000930918, 0.0011675, 8, 7, 0},
    {QuestionKind::exit_off_axis, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.0588267, 15.3492, 15.3492, 8, 7, 7},
    {QuestionKind::exit_off_axis, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.0588266, 212.649, 212.649, 8, 7, 7},
    {QuestionKind::shear, Rung::steady, 0.0, 0.1, 0.0, 4.56812e-06, 4.56812e-06, 1, 0, 0},
    {QuestionKind::shear, Rung::ellipsoid, 0.0, 0.1, 0.00572063, 0.00360318, 0.00360318, 1, 0, 0},
    {QuestionKind::shear, Rung::draft, 0.0, 0.1, 0.0911386, 0.376844, 0.376844, 1, 0, 0},
    {QuestionKind::shear, Rung::standard, 0.0, 0.1, 0.000653179, 48.6823, 48.6823, 1, 0, 0},
    {QuestionKind::shear, Rung::steady, 0.1, 1.0, 0.0, 3.69592e-06, 4.3457e-06, 2, 0, 0},
    {QuestionKind::shear, Rung::ellipsoid, 0.1, 1.0, 0.0161766, 0.000801882, 0.000818984, 2, 0, 0},
    {QuestionKind::shear, Rung::draft, 0.1, 1.0, 0.0670163, 0.452142, 0.605074, 2, 0, 0},
    {QuestionKind::shear, Rung::standard, 0.1, 1.0, 0.0125603, 21.2648, 24.422, 2, 0, 0},
    {QuestionKind::shear, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.0, 5.46191e-06, 5.59204e-06, 3, 0, 0},
    {QuestionKind::shear, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.0246575, 0.000768406, 0.000810613, 3, 0, 0},
}};
// clang-format on

}  // namespace bioprint
