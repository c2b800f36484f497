#pragma once

#include <array>
#include <limits>

#include "bioprint/predict/ladder.hpp"

// Made by tools/make-trade from data/trade.json.
namespace bioprint {

// clang-format off
inline constexpr std::array<RungRecord, 65> ladder_table{{
    {QuestionKind::exit_flow, Rung::steady, 0.0, std::numeric_limits<double>::infinity(), 0.23344, 4.62306e-06, 1.32089e-05, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::ellipsoid, 0.0, std::numeric_limits<double>::infinity(), 0.23344, 0.000553794, 0.000699364, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::draft, 0.0, std::numeric_limits<double>::infinity(), 0.00134246, 0.148201, 0.190995, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::standard, 0.0, std::numeric_limits<double>::infinity(), 0.000368309, 0.94271, 1.1436, 6, 0, 0},
    {QuestionKind::exit_flow, Rung::fine, 0.0, std::numeric_limits<double>::infinity(), 0.000263112, 8.21815, 9.58307, 6, 0, 0},
    {QuestionKind::channel, Rung::steady, 0.0, 0.1, 0.123618, 3.79053e-06, 4.10327e-06, 5, 0, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.0, 0.1, 0.123618, 0.00137809, 0.00238946, 5, 0, 0},
    {QuestionKind::channel, Rung::draft, 0.0, 0.1, 0.0683043, 0.009575, 0.0175345, 5, 0, 0},
    {QuestionKind::channel, Rung::standard, 0.0, 0.1, 0.0128938, 0.074078, 0.520682, 5, 0, 0},
    {QuestionKind::channel, Rung::fine, 0.0, 0.1, 0.0117732, 0.611386, 1.64583, 5, 0, 0},
    {QuestionKind::channel, Rung::steady, 0.1, 1.0, 0.0757073, 4.70901e-06, 1.32657e-05, 6, 0, 0},
    {QuestionKind::channel, Rung::ellipsoid, 0.1, 1.0, 0.0757073, 0.000611286, 0.000812437, 6, 0, 0},
    {QuestionKind::channel, Rung::draft, 0.1, 1.0, 0.0674191, 0.0414515, 0.418697, 6, 0, 0},
    {QuestionKind::channel, Rung::standard, 0.1, 1.0, 0.0417534, 0.298955, 3.42717, 6, 0, 0},
    {QuestionKind::channel, Rung::fine, 0.1, 1.0, 0.022807, 1.95899, 19.3786, 6, 0, 0},
    {QuestionKind::channel, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.848227, 9.67832e-06, 1.31278e-05, 7, 4, 0},
    {QuestionKind::channel, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.848227, 0.000513167, 0.000578387, 7, 4, 0},
    {QuestionKind::channel, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.394574, 0.725371, 1.65362, 7, 4, 4},
    {QuestionKind::channel, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.0452464, 6.46674, 10.1062, 7, 4, 4},
    {QuestionKind::channel, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.0124222, 43.0617, 58.8614, 6, 4, 4},
    {QuestionKind::exit, Rung::steady, 0.0, 0.1, 0.741501, 6.15199e-06, 6.54023e-06, 6, 0, 0},
    {QuestionKind::exit, Rung::ellipsoid, 0.0, 0.1, 0.0849599, 0.00169194, 0.00345563, 6, 0, 0},
    {QuestionKind::exit, Rung::draft, 0.0, 0.1, 0.255654, 0.180405, 0.216175, 6, 0, 0},
    {QuestionKind::exit, Rung::standard, 0.0, 0.1, 0.0438305, 1.62914, 3.32078, 6, 0, 0},
    {QuestionKind::exit, Rung::fine, 0.0, 0.1, 0.0402458, 13.2688, 18.667, 6, 0, 0},
    {QuestionKind::exit, Rung::steady, 0.1, 1.0, 1.52113, 6.71436e-06, 2.06379e-05, 5, 1, 1},
    {QuestionKind::exit, Rung::ellipsoid, 0.1, 1.0, 0.0836486, 0.000833784, 0.00112744, 5, 0, 0},
    {QuestionKind::exit, Rung::draft, 0.1, 1.0, 0.0785432, 0.319069, 2.04315, 5, 0, 0},
    {QuestionKind::exit, Rung::standard, 0.1, 1.0, 0.0402458, 2.75124, 16.046, 5, 0, 0},
    {QuestionKind::exit, Rung::fine, 0.1, 1.0, 0.0402458, 20.5759, 108.065, 5, 0, 0},
    {QuestionKind::exit, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 1.2892, 0.000690519, 0.000917222, 7, 4, 0},
    {QuestionKind::exit, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.558733, 1.77767, 5.84542, 7, 4, 4},
    {QuestionKind::exit, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.162337, 16.1756, 50.0547, 7, 4, 4},
    {QuestionKind::exit, Rung::fine, 1.0, std::numeric_limits<double>::infinity(), 0.0402458, 112.038, 360.25, 7, 4, 4},
    {QuestionKind::channel_off_axis, Rung::steady, 0.0, 0.1, 0.121118, 7.22681e-06, 7.33325e-06, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.121118, 0.00274717, 0.0046208, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.0, 0.1, 0.12196, 0.119887, 0.386938, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.0, 0.1, 0.121118, 1.64602, 13.2173, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 0.1, 1.0, 0.121852, 5.44067e-06, 9.51611e-06, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 0.1, 1.0, 0.121852, 0.00115352, 0.00135741, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 0.1, 1.0, 0.135695, 1.17148, 17.6635, 5, 0, 0},
    {QuestionKind::channel_off_axis, Rung::standard, 0.1, 1.0, 0.0821326, 22.1645, 34.8748, 4, 0, 0},
    {QuestionKind::channel_off_axis, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.150672, 6.01635e-06, 1.11095e-05, 8, 7, 0},
    {QuestionKind::channel_off_axis, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.150672, 0.000918918, 0.00134686, 8, 7, 0},
    {QuestionKind::channel_off_axis, Rung::draft, 1.0, std::numeric_limits<double>::infinity(), 0.025, 3.37984, 3.37984, 8, 7, 7},
    {QuestionKind::channel_off_axis, Rung::standard, 1.0, std::numeric_limits<double>::infinity(), 0.025, 126.132, 126.132, 8, 7, 7},
    {QuestionKind::exit_off_axis, Rung::ellipsoid, 0.0, 0.1, 0.484869, 0.003188, 0.00475867, 5, 0, 0},
    {QuestionKind::exit_off_axis, Rung::draft, 0.0, 0.1, 0.169478, 7.80908, 11.1602, 5, 0, 0},
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
    {QuestionKind::shear, Rung::standard, 0.1, 1.0, 0.0127201, 21.2648, 24.422, 2, 0, 0},
    {QuestionKind::shear, Rung::steady, 1.0, std::numeric_limits<double>::infinity(), 0.0, 5.46191e-06, 5.59204e-06, 3, 0, 0},
    {QuestionKind::shear, Rung::ellipsoid, 1.0, std::numeric_limits<double>::infinity(), 0.0246575, 0.000768406, 0.000810613, 3, 0, 0},
}};
// clang-format on

}  // namespace bioprint
