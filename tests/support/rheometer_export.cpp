#include "support/rheometer_export.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace bioprint::test {
namespace {

std::string number(double value, char mark) {
    std::array<char, 40> text{};
    // Six digits, as instruments export.
    std::snprintf(text.data(), text.size(), "%.6g", value);
    std::string result(text.data());
    std::replace(result.begin(), result.end(), '.', mark);
    return result;
}

std::string join(const std::vector<std::string>& fields, const std::string& separator,
                 const std::string& end) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const bool quoted = fields[i].find(separator) != std::string::npos;
        line += (i == 0 ? "" : separator) + (quoted ? "\"" + fields[i] + "\"" : fields[i]);
    }
    return line + end;
}

struct RheoCompassWords {
    std::string project, test, result, points, data, number, rate, stress, viscosity, torque, state,
        temperature;
};

std::string rheocompass(const std::vector<ExportPoint>& points, const RheoCompassWords& w,
                        const std::string& separator, char mark) {
    const std::string end = "\r\n";
    const auto row = [&](const std::vector<std::string>& fields) { return join(fields, separator, end); };
    const std::string heads =
        row({w.data, w.number, w.rate, w.stress, w.viscosity, w.torque, w.temperature, w.state});
    const std::string units = row({"", "", "[1/s]", "[Pa]", "[mPa·s]", "[mN·m]", "[°C]", "[]"});
    std::string text = row({w.project, "Bioinks"}) + row({w.test, "Alginate 2.5 %"}) + end +
                       row({w.result, "Flow curve 1"}) + end;
    // A rest at one rate comes first: not a flow curve.
    text += row({w.points, "1", "5"}) + heads + row({"", "", "", "", "", "", "", ""}) + units;
    for (int i = 1; i <= 5; ++i) {
        text += row({"", std::to_string(i), number(1.0, mark), number(77.0 + i, mark),
                     number(77000.0 + 1000.0 * i, mark), number(0.5, mark), number(25.0, mark), "Dy_auto"});
    }
    text += end + row({w.points, "2", std::to_string(points.size())}) + heads +
            row({"", "", "", "", "", "", "", ""}) + units;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ExportPoint& p = points[i];
        text += row({"", std::to_string(i + 1), number(p.rate, mark), number(p.rate * p.viscosity, mark),
                     number(1000.0 * p.viscosity, mark), number(0.01 * p.rate * p.viscosity, mark),
                     number(25.01, mark), i % 7 == 3 ? "M-, Dy_auto" : "Dy_auto"});
    }
    return text;
}

std::string trios(const std::vector<ExportPoint>& points) {
    std::string text =
        "Filename\tC:\\data\\alginate.tri\r\nInstrument serial number\t5343-0000\r\nInstrument "
        "name\tDHR\r\noperator\tlab\r\n"
        "rundate\t11/22/2026\r\nSample name\talginate\r\nGeometry name\t40mm parallel plate\r\nProcedure "
        "name\tFlow sweep\r\n"
        "proceduresegments\t2\r\n\r\n[step]\r\nConditioning Sample - 1\r\nStep "
        "time\tTemperature\r\ns\t\u00b0C\r\n"
        "0.5\t24.9\r\n60.5\t25.0\r\n\r\n[step]\r\nFlow sweep - 2\r\n"
        "Stress\tShear rate\tViscosity\tStep time\tTemperature\tNormal "
        "stress\r\nPa\t1/s\tPa.s\ts\t\u00b0C\tPa\r\n";
    double time = 10.0;
    for (const ExportPoint& p : points) {
        time += 12.0;
        text += join({number(p.rate * p.viscosity, '.'), number(p.rate, '.'), number(p.viscosity, '.'),
                      number(time, '.'), number(25.0, '.'), number(-3.2, '.')},
                     "\t", "\r\n");
    }
    return text;
}

std::string malvern(const std::vector<ExportPoint>& points) {
    std::string text =
        "Action Name,Time (action) (s),Shear stress(Pa),Shear rate(s-1),Shear viscosity(Pa "
        "s),Temperature(\u00b0C)\n";
    for (const ExportPoint& p : points) {
        text += join({"Shear rate table", number(10.0, '.'), number(p.rate * p.viscosity, '.'),
                      number(p.rate, '.'), number(p.viscosity, '.'), number(25.0, '.')},
                     ",", "\n");
    }
    return text;
}

std::string german_excel(const std::vector<ExportPoint>& points) {
    // Windows-1252: \xE4 is a-umlaut.
    std::string text = "Messung vom 22.11.2026;;\r\nScherrate;Schubspannung;Viskosit\xE4t\r\n1/s;Pa;Pas\r\n";
    for (const ExportPoint& p : points) {
        text += join({number(p.rate, ','), number(p.rate * p.viscosity, ','), number(p.viscosity, ',')}, ";",
                     "\r\n");
    }
    return text;
}

}  // namespace

std::string_view kind_name(ExportKind kind) {
    static constexpr std::array<std::string_view, 7> names = {"RheoCompass (German, UTF-16)",
                                                              "RheoCompass (CSV)",
                                                              "TRIOS",
                                                              "Malvern",
                                                              "German Excel",
                                                              "plain",
                                                              "plain with names"};
    return names.at(static_cast<std::size_t>(kind));
}

std::string as_utf16(std::string_view utf8) {
    std::string out = "\xFF\xFE";
    for (std::size_t i = 0; i < utf8.size();) {
        const auto first = static_cast<unsigned char>(utf8[i]);
        const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : 3;
        std::uint32_t c = length == 1 ? first : length == 2 ? first & 0x1FU : first & 0x0FU;
        for (std::size_t k = 1; k < length; ++k)
            c = (c << 6U) | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
        out += static_cast<char>(c & 0xFFU);
        out += static_cast<char>(c >> 8U);
        i += length;
    }
    return out;
}

std::string rheometer_export(ExportKind kind, const std::vector<ExportPoint>& points) {
    switch (kind) {
        case ExportKind::rheocompass_german:
            return as_utf16(rheocompass(
                points,
                {"Projekt:", "Test:", "Ergebnis:", "Intervall und Messpunkte:", "Intervalldaten:", "Pkt.Nr.",
                 "Scherrate", "Schubspannung", "Viskosit\u00e4t", "Drehmoment", "Status", "Temperatur"},
                "\t", ','));
        case ExportKind::rheocompass_english:
            return "\xEF\xBB\xBF" + rheocompass(points,
                                                {"Project:", "Test:", "Result:", "Interval and data points:",
                                                 "Interval data:", "Point No.", "Shear Rate", "Shear Stress",
                                                 "Viscosity", "Torque", "Status", "Temperature"},
                                                ",", '.');
        case ExportKind::trios:
            return trios(points);
        case ExportKind::malvern:
            return malvern(points);
        case ExportKind::german_excel:
            return german_excel(points);
        case ExportKind::plain:
        case ExportKind::plain_named:
            break;
    }
    std::string text = kind == ExportKind::plain_named ? "rate viscosity\n" : "";
    for (const ExportPoint& p : points) text += number(p.rate, '.') + " " + number(p.viscosity, '.') + "\n";
    return text;
}

}  // namespace bioprint::test
