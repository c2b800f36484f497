#include "io/sweep_title.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/ink_text.hpp"

namespace bioprint {
namespace {

bool swept(const Sweep& sweep, std::initializer_list<Key> keys) {
    return std::any_of(keys.begin(), keys.end(), [&](Key key) {
        return std::find(sweep.swept().begin(), sweep.swept().end(), key) != sweep.swept().end();
    });
}

/// The first row that is a case, for what all have in common.
std::optional<Case> a_case(const Sweep& sweep) {
    for (std::size_t i = 0; i < sweep.size(); ++i) {
        try {
            return sweep.row(i).make_case();
        } catch (const Error&) {
            continue;
        }
    }
    return std::nullopt;
}

std::string drive_text(const Case& question) {
    switch (question.drive) {
        case Drive::flow_rate:
            return lab_text(question.drive_value, Dimension::volume_flow, 3);
        case Drive::velocity:
            return lab_text(question.drive_value, Dimension::velocity, 3) + " on average";
        case Drive::pressure_gradient:
            return lab_text(question.drive_value, Dimension::pressure_gradient, 3);
        case Drive::pressure:
            return lab_text(question.drive_value, Dimension::pressure, 3);
    }
    return {};
}

}  // namespace

std::string sweep_title(const Sweep& sweep) {
    std::string title = "Over ";
    for (std::size_t i = 0; i < sweep.swept().size(); ++i) {
        if (i > 0) title += i + 1 == sweep.swept().size() ? " and " : ", ";
        title += info_of(sweep.swept()[i]).option;
    }
    return title;
}

std::string sweep_subtitle(const Sweep& sweep) {
    const std::optional<Case> question = a_case(sweep);
    if (!question) return {};
    std::string text;
    const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
    if (!swept(sweep, {Key::radius, Key::diameter, Key::needle, Key::tip})) {
        add((question->needle ? question->needle->name + ", " : "") + "R " +
            lab_text(question->radius, Dimension::length, 3));
    }
    if (!swept(sweep, {Key::flow_rate, Key::velocity, Key::pressure_gradient, Key::pressure})) {
        add(drive_text(*question));
    }
    if (!swept(sweep, {Key::ink})) {
        const bool parameters =
            swept(sweep, {Key::law, Key::eta0, Key::eta_inf, Key::time_constant, Key::alpha, Key::consistency,
                          Key::flow_index, Key::yield_stress, Key::transition});
        add("ink " + question->ink.name + (parameters ? "" : ": " + ink_text(question->ink.law)));
    }
    if (!swept(sweep, {Key::cell, Key::cell_radius, Key::shear_modulus})) {
        add("cell " + question->cell.name + ": R " + lab_text(question->cell.radius, Dimension::length, 3) +
            ", " + lab_text(question->cell.shear_modulus, Dimension::pressure, 3));
    }
    return text;
}

}  // namespace bioprint
