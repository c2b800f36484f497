// The population by an independent route: random cells in proportion to the flux, each followed by the
// general model (three-dimensional, six numbers) straight through the field, without tables, without the
// start-up's short cut, without interpolation over the radius.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/transient.hpp"
#include "bioprint/predict/population.hpp"
#include "cell/planar_cell.hpp"
#include "predict/exit_field.hpp"
#include "predict/size_effect.hpp"

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;
constexpr double cell_radius = 8e-6;
constexpr double modulus = 1000.0;
constexpr double length = 2e-3;

PlanarStrain planar(const Tensor& b) {
    return {.xx = b[0][0], .xr = b[0][1], .rr = b[1][1], .tt = b[2][2]};
}

double stress(const PlanarStrain& b, double linear) {
    const PlanarStress s = planar_stress(b);
    return combined_stress(modulus * s.von_mises, linear, s.shear_part);
}

struct Way {
    double peak = 0.0;
    double exposure = 0.0;
};

/// One cell from the entrance into the strand.
Way follow(const NozzleFlow& flow, const ExitField& field, const SizeEffect& size, double r) {
    const TransientCell cell{.shear_modulus = modulus, .viscosity_ratio = 1.0};
    const TransientOptions options{.tolerance = 1e-7, .max_steps = 200000, .samples = 8};
    Way way;
    double time = 0.0;
    double before = 0.0;
    const auto add = [&](double now, double value) {
        way.peak = std::fmax(way.peak, value);
        way.exposure += 0.5 * (value + before) * (now - time);
        time = now;
        before = value;
    };
    const double rate = flow.shear_rate(r);
    const double eta = viscosity(flow.ink(), rate);
    const AmbientFlow shear{.gradient = {{{0.0, -rate, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}},
                            .viscosity = eta};
    const double stay = (length - 4.0 * radius) / SizeEffect::velocity(flow.velocity(r), size.nozzle_slip());
    Deformation deformation{};
    // In pieces, so that the observer is called often where nothing changes any more.
    constexpr int pieces = 40;
    for (int i = 0; i < pieces; ++i) {
        deformation =
            carry_cell([&](double) { return shear; }, cell, deformation, stay * i / pieces,
                       stay * (i + 1) / pieces, options,
                       [&](const TransientState& s) {
                           add(s.time, stress(planar(strain_of(s.deformation)),
                                              size.nozzle_linear() * bullet_growth(s.time * modulus / eta)));
                       })
                .deformation;
    }
    const auto along = [&](double x) {
        const ExitField::Point p = field.at(x, field.streamline(r, x));
        Tensor gradient = p.gradient;
        for (auto& row : gradient) {
            for (double& v : row) v /= p.axial_velocity;
        }
        return AmbientFlow{.gradient = gradient,
                           .viscosity = viscosity(flow.ink(), p.rate) * p.axial_velocity};
    };
    double x_before = -4.0 * radius;
    double now = stay;
    double slowness_before = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double from = radius * (-4.0 + 11.5 * i / pieces);
        const double to = radius * (-4.0 + 11.5 * (i + 1) / pieces);
        deformation = carry_cell(along, cell, deformation, from, to, options, [&](const TransientState& s) {
                          const ExitField::Point p = field.at(s.time, field.streamline(r, s.time));
                          const SizeEffect::Effect effect = size.at(s.time);
                          const double slowness = 1.0 / SizeEffect::velocity(p.axial_velocity, effect.slip);
                          if (slowness_before > 0.0)
                              now += 0.5 * (slowness + slowness_before) * (s.time - x_before);
                          slowness_before = slowness;
                          x_before = s.time;
                          add(now, stress(SizeEffect::lengthened(
                                              planar(strain_of(s.deformation)),
                                              std::expm1(2.0 * (1.0 - p.shear_share) * effect.log_stretch)),
                                          effect.linear));
                      }).deformation;
    }
    return way;
}

/// The radius within which a part of the flux to the outermost cell flows.
double radius_of(const ExitField& field, double part) {
    const double whole = field.nozzle_flux(radius - cell_radius);
    double low = 0.0;
    double high = radius - cell_radius;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (field.nozzle_flux(middle) < part * whole ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

TEST_CASE(
    "population: cells drawn at random and followed by the general model have its mean and percentiles") {
    for (const double alpha : {0.0, 0.75}) {
        CAPTURE(alpha);
        const NozzleFlow flow = NozzleFlow::from_velocity(
            CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, radius, 5e-3);
        const Population all =
            population(flow, {.cell_radius = cell_radius, .shear_modulus = modulus, .length = length});
        const ExitField field(flow);
        const SizeEffect size(flow, {.radius = cell_radius, .shear_modulus = modulus});
        // One cell in each of equal parts of the flux, at a random place within: the mean's error falls as
        // n^(−3/2).
        constexpr int cells = 120;
        std::mt19937 random(7);
        std::uniform_real_distribution<double> within(0.0, 1.0);
        std::vector<double> peaks;
        double mean = 0.0;
        double exposure = 0.0;
        for (int i = 0; i < cells; ++i) {
            const Way way = follow(flow, field, size, radius_of(field, (i + within(random)) / cells));
            peaks.push_back(way.peak);
            mean += way.peak / cells;
            exposure += way.exposure / cells;
        }
        std::sort(peaks.begin(), peaks.end());
        const auto quantile = [&](double part) { return peaks[static_cast<std::size_t>(part * cells)]; };
        MESSAGE("alpha " << alpha << ": mean " << all.peak_stress.mean / mean - 1.0 << ", exposure "
                         << all.exposure->mean / exposure - 1.0 << ", median "
                         << all.peak_stress.median / quantile(0.5) - 1.0);
        // 120 strata leave about 3e-4 of the mean.
        CHECK(all.peak_stress.mean == doctest::Approx(mean).epsilon(1e-3));
        CHECK(all.exposure->mean == doctest::Approx(exposure).epsilon(1e-3));
        // A quantile is one cell of 120, itself somewhere in its part of the flux.
        CHECK(all.peak_stress.median == doctest::Approx(quantile(0.5)).epsilon(1.5e-2));
        CHECK(all.peak_stress.percentile_95 == doctest::Approx(quantile(0.95)).epsilon(1.5e-2));
    }
}
